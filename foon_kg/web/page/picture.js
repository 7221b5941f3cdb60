// A picture of the service as elements, to look at or to move and zoom.

import { element } from "./element.js";
import { minimap } from "./minimap.js";
import { stage } from "./stage.js";

const KEYS = "Arrow keys move the picture, + and - zoom, 0 shows all of it.";
const BUTTONS = [["larger", "Larger", "+"], ["smaller", "Smaller", "−"], ["all", "Show all of it", "All"], ["own", "1:1, its own size", "1:1"]];

// An SVG text as elements, without its style sheet: the page has the same one as a file of its own (picture.css), and
// its policy allows no other.
export const picture = (text) => {
  const plain = text.replace(/<style>[^<]*<\/style>/, "");
  return document.importNode(new DOMParser().parseFromString(plain, "image/svg+xml").documentElement, true);
};

export const staged = (text, name) => {
  const svg = picture(text);
  svg.removeAttribute("width");
  svg.removeAttribute("height");
  const box = element("div", { class: "stage", tabindex: "0", role: "group", "aria-label": `${name}. ${KEYS}` }, svg);
  const act = stage(box);
  const buttons = BUTTONS.map(([does, label, sign]) =>
    element("button", { type: "button", class: "small", "aria-label": label, onclick: act[does] }, sign));
  const hint = element("p", { class: "aside" }, element("span", { class: "fine" }, `Drag to move, Ctrl and the wheel zoom. ${KEYS}`),
    element("span", { class: "coarse" }, "Two fingers move and zoom; after a tap one finger moves."));
  return { parts: [element("div", { class: "bar" }, ...buttons), element("div", { class: "staged" }, box, minimap(svg, act.look)), hint], box, centre: act.centre };
};
