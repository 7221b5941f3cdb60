// Things as people read them.

import { element } from "../element.js";

const KINDS = { food: "food", utensil: "utensil", object: "food in a state", step: "step", motion: "motion", video: "video", dish: "type of dish", other: "node" };
export const kindOf = (thing) => (thing.kind === "object" && thing.vessel ? "utensil in use" : KINDS[thing.kind]);
export const markOf = (thing) => (thing.vessel ? "vessel" : thing.kind);
export const fullName = (thing) =>
  (thing.kind === "step" ? thing.note : [thing.name, [thing.states.join(", "), thing.note].filter(Boolean).join("; ")].filter(Boolean).join(", "));

export const mark = (thing) => element("i", { class: `mark ${markOf(thing)}`, "aria-hidden": "true" });

// A thing as a button that chooses it: a step is its sentence.
export const thingButton = (thing, onclick) =>
  element("button", { type: "button", class: "thing", onclick, "data-id": thing.id }, mark(thing),
    thing.kind === "step" ? element("span", {}, thing.note) : element("span", {}, thing.name,
      thing.states.length ? element("span", { class: "state" }, ` ${thing.states.join(", ")}`) : null,
      thing.note ? element("span", { class: "aside" }, ` ${thing.note}`) : null));
