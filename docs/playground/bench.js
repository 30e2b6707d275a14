// The bricks in a narrow window: behind a button.

import { find } from "./elements.js";
import { change, follow, state } from "./state.js";

/** Shows the bricks in place of the input, or the input. @param {boolean} isOpen */
export const showBench = (isOpen) => change({ isBenchOpen: isOpen });

follow(({ isBenchOpen }) => {
  document.body.classList.toggle("bench", isBenchOpen);
  find("show-brick").setAttribute("aria-expanded", String(isBenchOpen));
});
find("show-brick").onclick = () => showBench(!state().isBenchOpen);
