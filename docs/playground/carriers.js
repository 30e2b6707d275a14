// USB and Bluetooth as browsers have them. Bytes are moved here; what they mean is decided in Python.

const VENDOR = 0x0694, PRODUCT = 0x0005;
const REPORT_NUMBER = 0, REPORT = 1024;
const BAUD_RATE = 115200;

/** Milliseconds for a write to end before the port is closed. */
const PATIENCE = 1000;

/** Milliseconds that are too short for a choice by hand. */
const HUMAN = 100;
const BLOCKED = " If the browser showed no list at all, an administrator has blocked WebHID, as schools do on managed Chromebooks:"
  + " ask for this address to be allowed (policy WebHidAskForUrls)";

const UNPLUGGED = "the brick was unplugged or switched off";

/** @typedef {{heard: (bytes: Uint8Array, at: number) => void, gone: (reason: string) => void}} To  takes what happens */
/**
 * @typedef {object} Wire  a connection
 * @property {"usb" | "bluetooth"} kind
 * @property {string} label  which brick, as sentences call it
 * @property {(frame: Uint8Array) => Promise<void>} send
 * @property {() => Promise<void>} close
 */

/** Why a connection is not there: a sentence for the page. */
export class Refused extends Error {}

/** @param {unknown} error */
const messageOf = (error) => (error instanceof Error ? error.message : String(error));

/**
 * Opens the brick on USB.
 *
 * @param {boolean} isNew  ask which one, even if one is known
 * @param {To} to
 * @returns {Promise<Wire>}
 */
export const openUsb = async (isNew, to) => {
  const hid = navigator.hid;
  if (!hid) throw new Refused("This browser has no WebHID");
  const device = await chosenDevice(hid, isNew);
  try {
    if (!device.opened) await device.open();
  } catch (error) {
    throw new Refused(`The brick cannot be opened (${messageOf(error)}). Does another tab or program use it? On Linux, its udev rule is needed`);
  }
  /** @param {HIDInputReportEvent} event */
  const onReport = ({ data, timeStamp }) => {
    to.heard(new Uint8Array(data.buffer, data.byteOffset, data.byteLength).slice(), timeStamp || performance.now());
  };
  /** @param {HIDConnectionEvent} event */
  const onDisconnect = (event) => { if (event.device === device) end(UNPLUGGED); };
  let isOpen = true;
  /** @param {string} reason */
  const end = (reason) => {
    if (!isOpen) return;
    isOpen = false;
    device.removeEventListener("inputreport", onReport);
    hid.removeEventListener("disconnect", onDisconnect);
    if (reason) to.gone(reason);
  };
  device.addEventListener("inputreport", onReport);
  hid.addEventListener("disconnect", onDisconnect);
  return {
    kind: "usb",
    label: device.productName || "EV3",
    send: async (frame) => {
      const report = new Uint8Array(REPORT);
      report.set(frame);
      try {
        await device.sendReport(REPORT_NUMBER, report);
      } catch {
        end(UNPLUGGED);
      }
    },
    close: async () => {
      end("");
      await device.close().catch(() => {});
    },
  };
};

/** @param {HID} hid @param {boolean} isNew */
const chosenDevice = async (hid, isNew) => {
  /** @param {HIDDevice} device */
  const isBrick = ({ vendorId, productId }) => vendorId === VENDOR && productId === PRODUCT;
  const known = isNew ? [] : (await hid.getDevices()).filter(isBrick);
  if (known.length === 1) return known[0];
  let chosen;
  const asked = performance.now();
  try {
    chosen = await hid.requestDevice({ filters: [{ vendorId: VENDOR, productId: PRODUCT }] });
  } catch (error) {
    throw new Refused(`The browser did not allow it: ${messageOf(error)}`);
  }
  if (!chosen.length) {
    const isBlocked = performance.now() - asked < HUMAN;
    throw new Refused(`No brick was chosen. Is it switched on, and its cable in the port marked PC?${isBlocked ? BLOCKED : ""}`);
  }
  return chosen[0];
};

/** Opens the serial port of a paired brick, with the arguments of `openUsb`. @type {typeof openUsb} */
export const openBluetooth = async (isNew, to) => {
  const serial = navigator.serial;
  if (!serial) throw new Refused("This browser has no Web Serial");
  const port = await chosenPort(serial, isNew);
  try {
    await port.open({ baudRate: BAUD_RATE });
  } catch (error) {
    throw new Refused(`The serial port cannot be opened (${messageOf(error)}). Is the brick on, and does no other tab or program use the port?`);
  }
  let isOpen = true;
  /** @type {ReadableStreamDefaultReader<Uint8Array> | null} */
  let reader = null;
  /** @param {Event} event */
  const onDisconnect = (event) => { if (event.target === port || event.target === serial) end(UNPLUGGED); };
  /** @param {string} reason */
  const end = (reason) => {
    if (!isOpen) return;
    isOpen = false;
    port.removeEventListener("disconnect", onDisconnect);
    serial.removeEventListener("disconnect", onDisconnect);
    if (reason) to.gone(reason);
  };
  port.addEventListener("disconnect", onDisconnect);
  serial.addEventListener("disconnect", onDisconnect);
  const reading = (async () => {
    // After an error that is not the end, the port has another stream.
    for (let before = /** @type {ReadableStream | null} */ (null); isOpen && port.readable && port.readable !== before;) {
      before = port.readable;
      reader = before.getReader();
      try {
        for (;;) {
          const { done, value } = await reader.read();
          if (done) break;
          to.heard(value, performance.now());
        }
      } catch {
        // The next stream, or none, tells.
      } finally {
        reader.releaseLock();
      }
    }
    if (!isOpen) return;
    end(UNPLUGGED);
    await port.close().catch(() => {});
  })();
  let writing = Promise.resolve();
  /** @param {Uint8Array} frame */
  const write = async (frame) => {
    try {
      const writer = /** @type {WritableStream} */ (port.writable).getWriter();
      try {
        await writer.write(frame);
      } finally {
        writer.releaseLock();
      }
    } catch {
      end(UNPLUGGED);
    }
  };
  return {
    kind: "bluetooth",
    label: "EV3",
    send: (frame) => (writing = writing.then(() => write(frame))),
    close: async () => {
      end("");
      await Promise.race([writing, pause(PATIENCE)]);
      await reader?.cancel().catch(() => {});
      await reading;
      await port.close().catch(() => {});
    },
  };
};

/** @param {number} duration */
const pause = (duration) => new Promise((resolve) => { setTimeout(resolve, duration); });

/** @param {Serial} serial @param {boolean} isNew */
const chosenPort = async (serial, isNew) => {
  const known = isNew ? [] : await serial.getPorts();
  if (known.length === 1) return known[0];
  try {
    return await serial.requestPort();
  } catch (error) {
    if (error instanceof DOMException && error.name === "NotFoundError") throw new Refused("No serial port was chosen. Is the brick paired with this computer, and switched on?");
    throw new Refused(`The browser did not allow it: ${messageOf(error)}`);
  }
};
