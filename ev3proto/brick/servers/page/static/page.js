// Shows what the brick sends, and sends what is done to it. Every name and text is set as text, never as markup.

const WIDTH = 178, HEIGHT = 128, ROW_BYTES = 23;
const LIGHT = [210, 217, 195], DARK = [30, 36, 30];
const HOME = "/home/root/lms2012";
const MOST_LINES = 1000;

const find = (id) => document.getElementById(id);
const make = (tag, text = "", className = "") => {
  const element = document.createElement(tag);
  element.textContent = text;
  element.className = className;
  return element;
};

// The token is in the cookie now; it need not stay in the address, the history and what others see of the screen.
history.replaceState(null, "", "/");

const socket = new WebSocket(`ws://${location.host}/live`);
const send = (action) => { if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(action)); };
socket.onclose = () => { find("gone").textContent = "The brick has been switched off."; silence(); };

let facts = null;
let folder = HOME;
const show = {};

socket.onmessage = (event) => {
  const message = JSON.parse(event.data);
  for (const [key, value] of Object.entries(message)) if (show[key]) show[key](value);
};

show.facts = (value) => { facts = value; list(HOME); };
show.error = (text) => { find("gone").textContent = text; };
show.name = (text) => { find("name").textContent = document.title = text; };
show.battery = (battery) => { find("battery").textContent = `${battery.volt} V`; };
show.clients = (names) => { find("clients").textContent = names.length ? `Clients: ${names.join(", ")}` : "No client"; };

show.terminal = (text) => {
  find("terminal").hidden = !text;
  find("terminal").textContent = text;
};

// The display

show.display = (text) => {
  const bytes = Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
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

// Light and buttons

show.light = (number) => {
  const name = facts.leds[number] || "";
  find("light").textContent = name;
  const words = name.toLowerCase().split("_");
  for (const word of ["green", "red", "orange", "flash", "pulse"]) {
    find("pad").classList.toggle(word, words.includes(word));
  }
};

show.down = (names) => {
  for (const button of document.querySelectorAll("[data-button]")) {
    button.classList.toggle("down", names.includes(button.dataset.button));
  }
};

for (const button of document.querySelectorAll("[data-button]")) {
  const name = button.dataset.button;
  let isDown = false;
  const press = () => { if (!isDown) send({ do: "press", button: name }); isDown = true; };
  const release = () => { if (isDown) send({ do: "release", button: name }); isDown = false; };
  button.onpointerdown = press;
  button.onpointerup = button.onpointerleave = button.onblur = release;
  button.onkeydown = (event) => { if (event.key === " " || event.key === "Enter") press(); };
  button.onkeyup = release;
}

// Motors and sensors

const typeOf = (number) => facts.types.find((type) => type.number === number);

const chooser = (port, isMotor, chosen) => {
  const select = document.createElement("select");
  select.setAttribute("aria-label", `Port ${port}`);
  for (const type of facts.types) {
    if (type.motor !== isMotor && type.number !== facts.none) continue;
    const option = make("option", type.number === facts.none ? "(nothing)" : type.name);
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
      box.append(make("div", motor.port), chooser(motor.port, true, motor.type), wheel, text);
      if (shown) shown.box.replaceWith(box); else find("motors").append(box);
      shown = motors[motor.port] = { type: motor.type, box, wheel, text };
    }
    shown.wheel.classList.toggle("none", motor.type === facts.none);
    shown.wheel.style.transform = `rotate(${motor.angle}deg)`;
    shown.text.textContent = `${Math.round(motor.angle)}°, ${motor.speed} %${motor.busy ? " …" : ""}`;
  }
};

const sensors = {};
show.sensors = (values) => {
  for (const sensor of values) {
    let shown = sensors[sensor.port];
    if (!shown || shown.type !== sensor.type || shown.mode !== sensor.mode) {
      const box = sensorBox(sensor);
      if (shown) shown.box.replaceWith(box.box); else find("sensors").append(box.box);
      shown = sensors[sensor.port] = box;
    }
    sensor.values.forEach((value, index) => {
      const slider = shown.sliders[index];
      if (!slider) return;
      if (!slider.isDragged) slider.input.value = value ?? 0;
      slider.output.textContent = value === null ? "–" : value;
    });
  }
};

const sensorBox = (sensor) => {
  const box = make("div", "", "sensor");
  const mode = typeOf(sensor.type)?.modes[sensor.mode];
  const values = make("div");
  const sliders = [];
  for (let index = 0; mode && index < mode.datasets; index++) {
    const label = make("label");
    const input = document.createElement("input");
    input.type = "range";
    input.min = mode.least;
    input.max = mode.most;
    input.setAttribute("aria-label", `Port ${sensor.port}, value ${index + 1}`);
    const slider = { input, output: make("output"), isDragged: false };
    input.onpointerdown = () => { slider.isDragged = true; };
    input.onpointerup = input.onblur = () => { slider.isDragged = false; };
    input.oninput = () => send({
      do: "read", port: sensor.port, mode: sensor.mode, values: sliders.map((each) => Number(each.input.value)),
    });
    sliders.push(slider);
    label.append(input, slider.output, make("span", mode.symbol));
    values.append(label);
  }
  box.append(make("b", sensor.port), chooser(sensor.port, false, sensor.type), make("span", mode?.name ?? ""), values);
  return { type: sensor.type, mode: sensor.mode, box, sliders };
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
const isWanted = (line) => line.textContent.toLowerCase().includes(find("filter").value.toLowerCase());
show.talks = (talks) => {
  const box = find("talks");
  const isAtEnd = box.scrollTop + box.clientHeight >= box.scrollHeight - 4;
  for (const talk of talks) {
    const line = make("li", "", talk.wrong ? "wrong" : "");
    line.append(make("time", talk.time.toFixed(3)), make("b", talk.client), make("span", talk.text));
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
show.left_out = (count) => { find("left-out").textContent = count ? `${count} came too fast to be shown` : ""; };
find("filter").oninput = () => { for (const line of lines.values()) line.hidden = !isWanted(line); };

// Files

const list = (path) => { folder = path; send({ do: "list", path }); };
show.folder = (found) => {
  if (found.path !== folder) return;
  const path = find("path");
  path.replaceChildren(make("span", found.path));
  if (found.path !== HOME) {
    const up = make("button", "up");
    up.onclick = () => list(found.path.slice(0, found.path.lastIndexOf("/")));
    path.append(" ", up);
  }
  find("files").replaceChildren(...found.entries.map((entry) => {
    const item = make("li");
    const below = `${found.path}/${entry.name}`;
    if (entry.size === null) {
      const into = make("button", `${entry.name}/`);
      into.onclick = () => list(below);
      item.append(into);
    } else {
      const link = make("a", entry.name);
      link.href = `/file?path=${encodeURIComponent(below)}`;
      link.download = entry.name;
      item.append(link, ` ${entry.size}`);
    }
    return item;
  }));
};
setInterval(() => list(folder), 2000);
