// Where it is seen what a brick does: beside the input; in a narrow window under the headline, once something was sent.

import { find } from "./elements.js";

const effect = find("effect"), isWide = matchMedia("(min-width: 1000px)");
let isSent = false;

const place = () => {
  const isUnder = isSent && !isWide.matches;
  if (effect.parentElement?.id === (isUnder ? "write" : "bench")) return;
  if (isUnder) find("remedies").after(effect); else find("bench").prepend(effect);
};
isWide.onchange = place;

/** Has the effect of what was sent in sight, in a narrow window together with the headline. */
export const showEffect = () => {
  isSent = true;
  place();
  find("bench").scrollTop = 0;
  if (!isWide.matches) (find("say").hidden ? effect : find("say")).scrollIntoView();
};
