// Shows a virtual brick and controls it, wherever it runs. Every name and text is set as text, never as markup.

const WIDTH = 178, HEIGHT = 128, ROW_BYTES = 23;
const LIGHT = [210, 217, 195], DARK = [30, 36, 30];
const HOME = "/home/root/lms2012";
const MOST_LINES = 1000;

const FRONT = `
<section class="front" aria-label="Virtual brick">
  <h2><span id="name">EV3</span> <small id="battery"></small></h2>
  <div class="face">
    <canvas id="display" width="${WIDTH}" height="${HEIGHT}" role="img" aria-label="Display of the brick"></canvas>
    <div id="pad" role="group" aria-label="Buttons of the brick">
      <button data-button="back" aria-label="Back">&#8617;</button>
      <button data-button="up" aria-label="Up">&#9650;</button>
      <span></span>
      <button data-button="left" aria-label="Left">&#9664;</button>
      <button data-button="enter" aria-label="Enter">&#9632;</button>
      <button data-button="right" aria-label="Right">&#9654;</button>
      <span></span>
      <button data-button="down" aria-label="Down">&#9660;</button>
      <span></span>
    </div>
    <div id="motors" role="group" aria-label="Motors"></div>
  </div>
  <p>Light: <span id="leds"></span></p>
  <p id="waiting" role="status"></p>
  <p id="running" role="status" hidden>A program is running. <button id="stop">Stop it</button></p>
  <pre id="terminal" hidden></pre>
</section>`;
const MORE = `
<section aria-label="Sensors">
  <h2>Sensors</h2>
  <div id="sensors"></div>
  <p><label><input type="checkbox" id="sound"> Sound</label> <button id="save">Save the display</button></p>
</section>
<section class="talk" aria-label="Dialogue">
  <h2>Dialogue</h2>
  <p><input id="talk-filter" type="search" placeholder="filter lines by text" aria-label="Show only lines with this text">
  <span id="clients"></span> <span id="left-out"></span></p>
  <ol id="talks" tabindex="0" aria-label="Commands and replies"></ol>
</section>
<section aria-label="Files">
  <h2>Files</h2>
  <p id="path"></p>
  <ul id="files"></ul>
  <p id="wrong" role="status"></p>
  <details><summary>Where it differs from a real brick</summary><ul id="deviations"></ul></details>
</section>`;

/** Makes an element with a text in it. */
export const make = (tag, text = "", className = "") => {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = className;
  return element;
};

/** Calls one function when a button is pressed, by pointer or key, and another one when it is released. */
const onHold = (button, press, release) => {
  let isDown = false;
  const begin = () => { if (!isDown) press(); isDown = true; };
  const end = () => { if (isDown) release(); isDown = false; };
  button.onpointerdown = begin;
  button.onpointerup = button.onpointerleave = button.onblur = end;
  button.onkeydown = (event) => { if (event.key === " " || event.key === "Enter") begin(); };
  button.onkeyup = end;
};

/** Has the browser save bytes as a file. */
export const saveAs = (name, blob) => {
  const link = make("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

const bytesOf = (base64) => Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));

/**
 * Shows a brick.
 *
 * @param {HTMLElement} front  where its face is shown: display, buttons, light, motors
 * @param {HTMLElement} more  where the rest is shown: sensors, dialogue, files; may be the same
 * @param {(action: object) => void} send  has the brick do something
 * @returns {{take: (message: object) => void, silence: () => void}}  takes what the brick says
 */
export const showBrick = (front, more, send) => {
  for (const [place, shown] of [[front, FRONT], [more, MORE]]) {
    place.classList.add("brick");
    place.innerHTML += shown;
  }
  const find = (id) => document.getElementById(id);
  const show = {};
  let facts = null, folder = HOME;

  show.facts = (value) => {
    facts = value;
    find("deviations").replaceChildren(...facts.deviations.map((text) => make("li", text)));
    list(HOME);
  };
  show.error = (text) => { find("wrong").textContent = text; };
  show.name = (text) => { find("name").textContent = text; };
  show.battery = (battery) => { find("battery").textContent = `${battery.volt} V`; };
  show.clients = (names) => { find("clients").textContent = names.length ? `Clients: ${names.join(", ")}` : ""; };
  show.terminal = (text) => {
    find("terminal").hidden = !text;
    find("terminal").textContent = text;
  };

  // The display

  show.display = (text) => {
    const bytes = bytesOf(text);
    const context = find("display").getContext("2d");
    const image = context.createImageData(WIDTH, HEIGHT);
    for (let y = 0; y < HEIGHT; y++) {
      for (let x = 0; x < WIDTH; x++) {
        const isSet = bytes[y * ROW_BYTES + (x >> 3)] & (0x80 >> (x & 7));
        image.data.set([...(isSet ? DARK : LIGHT), 255], (y * WIDTH + x) * 4);
      }
    }
    context.putImageData(image, 0, 0);
  };
  show.display("");
  find("save").onclick = () => find("display").toBlob((blob) => saveAs("display.png", blob));

  // Light and buttons

  show.light = (number) => {
    const name = facts.leds[number] || "";
    find("leds").textContent = name;
    const words = name.toLowerCase().split("_");
    for (const word of ["green", "red", "orange", "flash", "pulse"]) {
      find("pad").classList.toggle(word, words.includes(word));
    }
  };
  const buttons = [...front.querySelectorAll("[data-button]")];
  show.down = (names) => {
    for (const button of buttons) button.classList.toggle("down", names.includes(button.dataset.button));
  };
  for (const button of buttons) {
    const name = button.dataset.button;
    onHold(button, () => send({ do: "press", button: name }), () => send({ do: "release", button: name }));
  }

  show.program = (isRunning) => { find("running").hidden = !isRunning; };
  find("stop").onclick = () => send({ do: "stop" });

  // Motors and sensors

  let types = [];
  show.others = (others) => {
    const numbers = others.map((type) => type.number);
    types = [...facts.types.filter((type) => !numbers.includes(type.number)), ...others];
    for (const shown of [...Object.values(motors), ...Object.values(sensors)]) shown.type = null;
  };

  const chooser = (port, isMotor, chosen) => {
    const select = make("select");
    select.setAttribute("aria-label", `Port ${port}`);
    for (const type of types) {
      if (type.motor !== isMotor && type.number !== facts.none) continue;
      const option = make("option", type.number === facts.none ? "(nothing)" : type.title);
      option.value = type.number;
      option.selected = type.number === chosen;
      select.append(option);
    }
    select.onchange = () => send({ do: "plug", port, type: Number(select.value) });
    return select;
  };

  const motors = {};
  show.motors = (values) => {
    for (const motor of values) {
      let shown = motors[motor.port];
      if (!shown || shown.type !== motor.type) {
        const box = make("div", "", "motor");
        const wheel = make("div", "", "wheel");
        wheel.append(make("i"));
        const text = make("output");
        box.append(make("strong", motor.port), chooser(motor.port, true, motor.type), wheel, text);
        if (shown) shown.box.replaceWith(box); else find("motors").append(box);
        shown = motors[motor.port] = { type: motor.type, box, wheel, text };
      }
      shown.wheel.classList.toggle("none", motor.type === facts.none);
      shown.wheel.style.transform = `rotate(${motor.angle}deg)`;
      shown.text.textContent = `${Math.round(motor.angle)}°, ${motor.speed} %${motor.busy ? " …" : ""}`;
    }
  };

  show.waiting = (text) => { find("waiting").textContent = text; };

  const sensors = {};
  show.sensors = (values) => {
    for (const sensor of values) {
      let shown = sensors[sensor.port];
      if (!shown || shown.type !== sensor.type || shown.mode !== sensor.mode) {
        const box = sensorBox(sensor);
        if (shown) shown.box.replaceWith(box.box); else find("sensors").append(box.box);
        shown = sensors[sensor.port] = box;
      }
      sensor.values.forEach((value, index) => shown.controls[index]?.show(value));
    }
  };

  const sensorBox = (sensor) => {
    const box = make("div", "", "sensor");
    const isThere = sensor.type !== facts.none;
    const mode = isThere ? types.find((type) => type.number === sensor.type)?.modes[sensor.mode] : undefined;
    const controls = [];
    const read = () => send({
      do: "read", port: sensor.port, mode: sensor.mode, values: controls.map((each) => each.value()),
    });
    const values = make("div");
    for (const [name, unit] of mode?.values ?? []) {
      const label = `Port ${sensor.port}, ${mode.name}, ${name}`;
      const control = isSwitch(mode) ? touchButton(mode, label, read) : slider(mode, unit, label, read);
      controls.push(control);
      values.append(control.element);
    }
    box.append(make("strong", sensor.port), chooser(sensor.port, false, sensor.type), make("span", mode?.name ?? ""), values);
    return { type: sensor.type, mode: sensor.mode, box, controls };
  };

  const isSwitch = (mode) => mode.values.length === 1 && !mode.values[0][1] && mode.si[0] === 0 && mode.si[1] === 1;

  const touchButton = (mode, label, read) => {
    const element = make("button", "", "touch");
    let raw = mode.raw[0];
    const put = (value) => () => { raw = value; read(); };
    onHold(element, put(mode.raw[1]), put(mode.raw[0]));
    const show = (value) => {
      const isPressed = value !== null && Math.abs(value - mode.raw[1]) < Math.abs(value - mode.raw[0]);
      element.textContent = isPressed ? "pressed" : "not pressed";
      element.setAttribute("aria-label", `${label}: ${element.textContent}`);
      element.classList.toggle("down", isPressed);
    };
    show(mode.raw[0]);
    return { element, value: () => raw, show };
  };

  const slider = (mode, unit, label, read) => {
    const element = make("label"), input = make("input"), output = make("output");
    input.type = "range";
    input.min = Math.min(...mode.raw);
    input.max = Math.max(...mode.raw);
    input.setAttribute("aria-label", label);
    let isDragged = false;
    input.onpointerdown = () => { isDragged = true; };
    input.onpointerup = input.onblur = () => { isDragged = false; };
    input.oninput = read;
    element.append(input, output);
    const show = (value) => {
      if (!isDragged) input.value = value ?? 0;
      output.textContent = value === null ? "–" : inUnits(mode, value, unit);
      input.setAttribute("aria-valuetext", output.textContent);
    };
    return { element, value: () => Number(input.value), show };
  };

  const inUnits = ({ raw, si, decimals }, value, unit) => {
    const scaled = raw[0] === raw[1] ? value : si[0] + (value - raw[0]) * (si[1] - si[0]) / (raw[1] - raw[0]);
    return `${scaled.toFixed(decimals)} ${unit}`.trim();
  };

  // Sound

  let audio = null, oscillator = null, tone = null;
  const silence = () => { oscillator?.stop(); oscillator = null; };
  const sound = () => {
    silence();
    if (!audio || !tone || !find("sound").checked) return;
    const volume = audio.createGain();
    volume.gain.value = tone.volume / 400;
    oscillator = audio.createOscillator();
    oscillator.type = "square";
    oscillator.frequency.value = tone.frequency;
    oscillator.connect(volume).connect(audio.destination);
    oscillator.start();
  };
  show.tone = (value) => { tone = value; sound(); };
  find("sound").onchange = () => { audio ??= new AudioContext(); sound(); };

  // The dialogue

  const lines = new Map();
  const isWanted = (line) => line.textContent.toLowerCase().includes(find("talk-filter").value.toLowerCase());
  show.talks = (talks) => {
    const box = find("talks");
    const isAtEnd = box.scrollTop + box.clientHeight >= box.scrollHeight - 4;
    for (const talk of talks) {
      const line = make("li", "", talk.wrong ? "wrong" : "");
      line.append(make("time", talk.time.toFixed(3)), make("strong", talk.client), make("span", talk.text));
      line.hidden = !isWanted(line);
      if (lines.has(talk.number)) lines.get(talk.number).replaceWith(line); else box.append(line);
      lines.set(talk.number, line);
    }
    for (const number of lines.keys()) {
      if (lines.size <= MOST_LINES) break;
      lines.get(number).remove();
      lines.delete(number);
    }
    if (isAtEnd) box.scrollTop = box.scrollHeight;
  };
  show.left_out = (count) => { find("left-out").textContent = count ? `${count} not shown: they came too fast` : ""; };
  find("talk-filter").oninput = () => { for (const line of lines.values()) line.hidden = !isWanted(line); };

  // Files

  const list = (path) => { folder = path; send({ do: "list", path }); };
  const link = (text, act) => {
    const button = make("button", text, "link");
    button.onclick = act;
    return button;
  };
  show.folder = (found) => {
    if (found.path !== folder) return;
    find("path").replaceChildren(make("span", found.path));
    if (found.path !== HOME) {
      find("path").append(" ", link("up", () => list(found.path.slice(0, found.path.lastIndexOf("/")))));
    }
    const listed = JSON.stringify(found);
    if (find("files").dataset.listed === listed) return;
    find("files").dataset.listed = listed;
    find("files").replaceChildren(...found.entries.map((entry) => {
      const item = make("li");
      const below = `${found.path}/${entry.name}`;
      if (entry.size === null) item.append(link(`${entry.name}/`, () => list(below)));
      else item.append(link(entry.name, () => send({ do: "fetch", path: below })), ` ${entry.size}`);
      return item;
    }));
  };
  show.file = ({ path, contents }) => saveAs(path.slice(path.lastIndexOf("/") + 1), new Blob([bytesOf(contents)]));
  let listing = 0;
  addEventListener("focus", () => { if (facts) list(folder); });

  const take = (message) => {
    for (const [key, value] of Object.entries(message)) show[key]?.(value);
    // What else happens may change the files.
    if (!listing && !message.folder) listing = setTimeout(() => { listing = 0; list(folder); }, 2000);
  };
  return { take, silence };
};
