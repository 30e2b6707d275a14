// Fakes for navigator.hid and navigator.serial, by their specifications. Behind them is the brick of the test's server.
// `fake` steers them, and notes what was sent.

(() => {
  const fake = globalThis.fake = {
    isRefused: false, isSilent: false, isUnplugged: false, isBusy: false, isHeld: false, isStrange: false, sent: [], requests: 0,
  };
  // Tests say themselves whether the page asks for battery and ports every second.
  try {
    if (localStorage.getItem("quiet") === null && !sessionStorage.getItem("talks")) localStorage.setItem("quiet", "yes");
  } catch { /* a page without an origin */ }
  const REPORT = 1024;
  const hexOf = (bytes) => [...bytes].map((byte) => byte.toString(16).padStart(2, "0")).join("");
  const bytesOf = (hex) => Uint8Array.from(hex.match(/../g) ?? [], (each) => parseInt(each, 16));
  const needActivation = () => {
    if (!navigator.userActivation.isActive) throw new DOMException("Must be handling a user gesture", "SecurityError");
  };

  /** Gives a frame to the brick; calls a function with each reply. */
  const give = async (frame, reply) => {
    fake.sent.push(hexOf(frame));
    if (fake.isUnplugged) {
      unplug();
      return;
    }
    if (fake.isSilent) return;
    if (fake.isStrange) {
      reply(new TextEncoder().encode("ERROR: unknown command\r\n"));
      return;
    }
    const answer = await fetch("/brick", { method: "POST", body: hexOf(frame) });
    const replies = await answer.json();
    if (fake.isHeld) await new Promise((resolve) => { fake.release = resolve; });
    for (const each of replies) reply(bytesOf(each));
  };

  // USB

  class Device extends EventTarget {
    vendorId = 0x0694;
    productId = 0x0005;
    productName = "EV3 brick";
    opened = false;
    collections = [{ usagePage: 0xff00, usage: 1 }];
    async open() {
      if (this.opened) throw new DOMException("The device is already open.", "InvalidStateError");
      if (fake.isBusy) throw new DOMException("Failed to open the device.", "NotAllowedError");
      this.opened = true;
    }
    async close() { this.opened = false; }
    async sendReport(number, data) {
      if (!this.opened) throw new DOMException("The device must be opened first.", "InvalidStateError");
      const bytes = new Uint8Array(data.buffer ?? data);
      if (number !== 0 || bytes.length !== REPORT) throw new DOMException("Failed to write the report.", "NotAllowedError");
      const size = bytes[0] + 256 * bytes[1] + 2;
      if (bytes.subarray(size).some((byte) => byte)) throw new Error("the rest of a report is zeros");
      give(bytes.slice(0, size), (reply) => {
        // What is behind a frame is left over from earlier ones.
        const report = new Uint8Array(REPORT).fill(0x4b);
        report.set(reply);
        this.dispatchEvent(Object.assign(new Event("inputreport"), { device: this, reportId: 0, data: new DataView(report.buffer) }));
      });
    }
  }
  class Hid extends EventTarget {
    device = new Device();
    permitted = [];
    async getDevices() { return [...this.permitted]; }
    async requestDevice({ filters }) {
      needActivation();
      fake.requests++;
      const isWanted = filters.some(({ vendorId, productId }) => vendorId === 0x0694 && productId === 0x0005);
      if (fake.isRefused || !isWanted) return [];
      this.permitted = [this.device];
      return [this.device];
    }
  }

  // Bluetooth

  class Port extends EventTarget {
    readable = null;
    writable = null;
    #replies = null;
    getInfo() { return { bluetoothServiceClassId: "00001101-0000-1000-8000-00805f9b34fb" }; }
    async open({ baudRate }) {
      if (!Number.isInteger(baudRate) || baudRate <= 0) throw new TypeError("baudRate");
      if (this.readable) throw new DOMException("The port is already open.", "InvalidStateError");
      if (fake.isBusy) throw new DOMException("Failed to open serial port.", "NetworkError");
      let buffer = new Uint8Array();
      this.readable = new ReadableStream({ start: (controller) => { this.#replies = controller; } });
      this.writable = new WritableStream({
        write: (chunk) => {
          buffer = new Uint8Array([...buffer, ...chunk]);
          while (buffer.length > 1 && buffer.length >= buffer[0] + 256 * buffer[1] + 2) {
            const size = buffer[0] + 256 * buffer[1] + 2;
            give(buffer.slice(0, size), (reply) => this.#pieces(reply));
            buffer = buffer.slice(size);
          }
        },
      });
    }
    #pieces(reply) {
      for (let at = 0, size = 1; at < reply.length; at += size, size = (size * 5) % 64 + 1) {
        this.#replies.enqueue(reply.slice(at, at + size));
      }
    }
    async close() {
      if (!this.readable) throw new DOMException("The port is already closed.", "InvalidStateError");
      await this.readable.cancel();
      await this.writable.abort();
      this.readable = this.writable = null;
    }
    lose() {
      this.#replies?.error(new DOMException("The device has been lost.", "NetworkError"));
      this.readable = this.writable = null;
      this.dispatchEvent(new Event("disconnect", { bubbles: true }));
    }
  }
  class Serial extends EventTarget {
    port = new Port();
    permitted = [];
    async getPorts() { return [...this.permitted]; }
    async requestPort() {
      needActivation();
      fake.requests++;
      if (fake.isRefused) throw new DOMException("No port selected by the user.", "NotFoundError");
      this.permitted = [this.port];
      return this.port;
    }
  }

  const hid = new Hid(), serial = new Serial();
  const unplug = () => {
    if (hid.device.opened) {
      hid.device.opened = false;
      hid.permitted = [];
      hid.dispatchEvent(Object.assign(new Event("disconnect"), { device: hid.device }));
    }
    if (serial.port.readable) {
      serial.permitted = [];
      serial.port.lose();
    }
  };
  fake.unplug = unplug;
  Object.defineProperty(navigator, "hid", { value: hid, configurable: true });
  Object.defineProperty(navigator, "serial", { value: serial, configurable: true });
})();
