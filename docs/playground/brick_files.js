// Files and programs of a real brick: listed and downloaded at once; what changes something asks first.

import { find, make, saveAs } from "./elements.js";
import { change } from "./state.js";

/** @typedef {{action: string, path: string, error: string, result?: any}} FileNews */

const HOME = "/home/root/lms2012/prjs";
const list = find("brick-list"), place = find("brick-path"), box = find("brick-files", HTMLDetailsElement), wrong = find("brick-wrong");

/**
 * Controls the files of a real brick.
 *
 * @param {() => import("./python.js").Python} python
 * @param {(reasons: string[]) => Promise<boolean>} isAllowed  asks the user
 * @returns {{take: (news: FileNews) => void}}
 */
export const brickFiles = (python, isAllowed) => {
  let folder = HOME;
  /** @param {string} action @param {string} path @param {Uint8Array} [data] */
  const act = (action, path, data = new Uint8Array()) => python().ask("real", "files", action, path, data);
  /** @param {string} path */
  const open = (path) => {
    folder = path;
    act("list", path);
  };
  /** @param {string} reason @param {string} action @param {string} path @param {Uint8Array} [data] */
  const actIfAllowed = async (reason, action, path, data) => { if (await isAllowed([reason])) await act(action, path, data); };

  /** Asks, as before a command of the input. @param {string} action @param {string} text */
  const panel = async (action, text) => {
    let said = await python().ask("real", "panel", action, text, false);
    if (said.ask && await isAllowed(said.ask)) said = await python().ask("real", "panel", action, text, true);
    change({ error: said.error ?? "" });
  };

  /** @param {string} text @param {() => void} act @param {string} [name] */
  const button = (text, act, name = "link") => {
    const made = make("button", text, name);
    made.onclick = act;
    return made;
  };
  /** @param {string} name @param {number} size */
  const fileItem = (name, size) => {
    const item = make("li"), path = `${folder}/${name}`;
    item.append(button(name, () => act("fetch", path)), ` ${size} `);
    if (name.endsWith(".rbf")) item.append(button(`Start ${name}`, () => panel("start", path), ""), " ");
    item.append(button(`Delete ${name}`, () => actIfAllowed(`Deletes ${path} on the brick.`, "delete", path), ""));
    return item;
  };
  /** @param {{folders: string[], files: [string, number][]}} found */
  const show = ({ folders, files }) => {
    place.textContent = folder;
    const above = folder.slice(0, folder.lastIndexOf("/"));
    const items = folders.map((name) => {
      const item = make("li");
      item.append(button(`${name}/`, () => open(`${folder}/${name}`)));
      return item;
    });
    if (above) {
      const up = make("li");
      up.append(button("up", () => open(above)));
      items.unshift(up);
    }
    list.replaceChildren(...items, ...files.map(([name, size]) => fileItem(name, size)));
  };

  box.ontoggle = () => { if (box.open) open(folder); };
  find("rename").onclick = () => panel("rename", find("new-name", HTMLInputElement).value);
  find("stop-program").onclick = () => panel("stop", "");
  find("upload", HTMLInputElement).onchange = async ({ target }) => {
    const chosen = target instanceof HTMLInputElement ? target.files?.[0] : null;
    if (!chosen) return;
    const path = `${folder}/${chosen.name}`;
    await actIfAllowed(`Writes ${path} on the brick.`, "put", path, new Uint8Array(await chosen.arrayBuffer()));
    find("upload", HTMLInputElement).value = "";
  };

  /** What follows from news, by what was done. @type {Record<string, (news: FileNews) => void>} */
  const shows = {
    list: ({ path, result }) => { if (path === folder) show(result); },
    fetch: ({ path, result }) => {
      saveAs(path.slice(path.lastIndexOf("/") + 1), new Blob([Uint8Array.from(atob(result), (it) => it.charCodeAt(0))]));
    },
    put: () => { if (box.open) open(folder); },
    delete: () => open(folder),
  };
  return {
    take: (news) => {
      wrong.textContent = news.error && `${news.path}: ${news.error}`;
      if (!news.error) shows[news.action](news);
    },
  };
};
