// The page of a virtual brick that runs in another process and sends its changes over a WebSocket.

import { showBrick } from "./brick.js";

// The token is in the cookie now; keep it out of the address bar and the history.
history.replaceState(null, "", "/");

const socket = new WebSocket(`ws://${location.host}/live`);
const place = document.getElementById("brick");
const shown = showBrick(place, place, (action) => {
  if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(action));
});
socket.onmessage = (event) => shown.take(JSON.parse(event.data));
socket.onclose = () => {
  document.getElementById("gone").textContent = "The brick has been switched off.";
  shown.silence();
};
