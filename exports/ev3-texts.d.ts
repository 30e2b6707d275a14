/**
 * What operations, parameters and messages of the EV3 are, in words. Licence: MIT.
 *
 *     import { texts } from "./ev3-texts.mjs";
 *
 *     texts.operations["SOUND.TONE"].text; // Plays one tone and returns at once
 *
 * This file is made by ev3proto 0.2.0 from its tables (ev3proto export javascript --texts): change those, not this.
 */

/** One line about each message type, daisy sub-command and operation, by name, and about each system command, by number. */
export declare const texts: {
  readonly message_types: Readonly<Record<string, string>>;
  readonly system_commands: Readonly<Record<number, string>>;
  readonly daisy_commands: Readonly<Record<string, string>>;
  readonly operations: Readonly<Record<string, {
    /** Of the firmware, such as "sound": the name of a page of the reference. */
    readonly area: string;
    readonly text: string;
    /** Of each parameter in its place. */
    readonly parameters: readonly string[];
    /** Of each value in the list at its end, if that is not the text of its parameter. */
    readonly each?: string;
    /** Single values with a meaning of their own, of each parameter. */
    readonly special: readonly Readonly<Record<string, string>>[];
  }>>;
};
