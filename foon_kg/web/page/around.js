// What the FOON has around one object.

import { counted, element, heading, list } from "./element.js";
import { nodeWords, seenWords, unitWords } from "./nodes.js";

const FIRST = 12; // the others are unfolded

const units = (title, told) => {
  if (!told.count) return [heading(3, title), element("p", { class: "aside" }, "No step.")];
  const items = told.units.map((unit, i) => element("li", {}, ...unitWords(unit), " ", seenWords(unit.seen_in.find((one) => one.start !== null) ?? unit.seen_in[0], told.videos[i])));
  const more = told.count - told.units.length;
  return [
    heading(3, `${title} (${told.count})`),
    list(items.slice(0, FIRST), { class: "units" }),
    items.length > FIRST ? element("details", {}, element("summary", {}, `${items.length - FIRST} more of them`), list(items.slice(FIRST), { class: "units" }),
      more > 0 ? element("p", { class: "aside" }, `and ${more} that are not told here`) : "") : "",
  ];
};

export const aroundView = (found) => [
  heading(2, `${found.label}${found.utensil ? " (a utensil)" : ""}`),
  element("p", { class: "aside" }, `In ${counted(found.videos.length, "video")}: ${found.videos.slice(0, 12).join(", ")}${found.videos.length > 12 ? ", …" : ""}`),
  element("details", { open: found.nodes.length <= 12 }, element("summary", {}, found.nodes.length === 1 ? "It is seen in one way" : `It is seen in ${found.nodes.length} ways`),
    list(found.nodes.map((node) => [...nodeWords(node), node.ingredients.length ? element("span", { class: "aside" }, ` with ${node.ingredients.join(", ")}`) : ""]))),
  ...units("Steps that make it", found.made_by),
  ...units("Steps that take it", found.taken_by),
].filter(Boolean);
