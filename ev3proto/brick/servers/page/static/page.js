// The page of a virtual brick that runs elsewhere: what happens comes over a socket.

import { showBrick } from "./brick.js";

// The token is in the cookie now; it need not stay in the address, the history and what others see of the screen.
history.replaceState(null, "", "/");

const socket = new WebSocket(`ws://${location.host}/live`);
const shown = showBrick(document.getElementById("brick"), (action) => {
  if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(action));
});
socket.onmessage = (event) => shown.take(JSON.parse(event.data));
socket.onclose = () => {
  document.getElementById("gone").textContent = "The brick has been switched off.";
  shown.silence();
};
