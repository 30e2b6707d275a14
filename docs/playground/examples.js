// What an empty page offers.

/** @type {readonly (readonly [title: string, text: string])[]} */
export const EXAMPLES = [
  ["A frame that plays a tone", "0x|0E:00|2A:00|80|00:00|94:01:01:82:B8:01:82:E8:03|"],
  ["A log with a mistake in it", `# What a program sent and received
09:12:31.011558 Sent 0x|0B:00|2A:00|00|04:00|81:01:60:81:12:64|
09:12:31.014092 Recv 0x|07:00|2A:00|02|66:66:F6:40|
09:12:31.520417 Sent 0x|0A:00|2B:00|00|04:00|81:01:60|
`],
  ["A program that blinks", `vmthread MAIN
{
  DATA32 Timer
  DATA8 Round
  MOVE8_8(0, Round)
Again:
  UI_WRITE(LED, LED_ORANGE)
  TIMER_WAIT(500, Timer)
  TIMER_READY(Timer)
  UI_WRITE(LED, LED_GREEN)
  TIMER_WAIT(500, Timer)
  TIMER_READY(Timer)
  ADD8(Round, 1, Round)
  JR_LT8(Round, 20, Again)
}
`],
];
