// A plan to read: what it is made after, what to buy, and its steps as sentences; the FOON's own words on demand.

import { element, heading, list, sentence } from "./element.js";
import { named, nodeWords, seenWords, unitWords } from "./nodes.js";

export const notes = (told) => (told.length ? element("div", { class: "notice notes" }, ...told.map((note) => element("p", {}, sentence(note)))) : null);

export const foodAndState = (one) => `${one.state} ${one.object}`.trim();

// A sentence in which foods that no video has carry their sign.
export const marked = (text, unseen) => {
  const names = [...unseen.keys()].sort((a, b) => b.length - a.length).map((name) => name.replace(/[^\w\s]/g, "\\$&"));
  if (!names.length) return [text];
  const around = new RegExp(`(?<!\\w)(${names.join("|")})(?!\\w)`, "i"); // every second part is such a food
  return text.split(around).map((part, i) => (i % 2 ? element("span", { class: "unseen", title: `like ${unseen.get(part.toLowerCase())?.equivalent}` }, `~${part}`) : part));
};

// The videos (or the draft) that a plan is made after, each a link where one of its steps has an address in it.
export const videos = (plan) => plan.reference.videos.flatMap((name, place) => {
  const i = plan.seen.findIndex((seen, at) => plan.videos[at] && seen.video === name);
  return [place ? ", " : "", i < 0 ? named(name) : element("a", { href: plan.videos[i], target: "_blank", rel: "noreferrer noopener" }, named(name))];
});

// What a plan is made after, up to the video's name: a recorded dish, or foon-kg's own tables and what is nearest.
export const madeLike = ({ reference }) => (reference.technique ? `Made as ${reference.technique}, by foon-kg's own tables: no video shows these steps in this order. Nearest is the ` : "Made like the ") + reference.goal.label;

export const besides = (plan) => {
  const bought = new Set(plan.shopping.map((node) => node.label));
  const there = plan.kitchen.filter((node) => !bought.has(node.label) && !node.ingredients.length); // no packet that a food is sold in
  return there.filter((node, i) => there.findIndex((other) => other.label === node.label) === i);
};

// How much of a food was asked, in front of its name.
export const amountOf = (plan, label) => plan.amounts[plan.recipe.ingredients.findIndex((one) => one.object === label)] ?? "";

export const buying = (plan, words) => plan.shopping.map((node) => [amountOf(plan, node.label), " ", ...words(node)]);

// How near what a video shows is to what this step does, where nothing of it stands for anything else.
const NEAR = { like: "with a like food", kind: "with a food of its kind", motion: "with something else" };

// The evidence of a step: “as in the video at 1:05” where it does what that shows, else “like it, onion for leek, 0.95”.
export const evidence = (plan, i) => {
  const unit = plan.units[i];
  const seen = seenWords(plan.seen[i], plan.videos[i]);
  if (!seen) return ["Seen in no video"];
  if (unit.origin === "foon") return ["As in ", seen];
  const stands = plan.stands[i].map((one) => `${one.equivalent} for ${one.object}, ${one.confidence.toFixed(2)}`);
  const near = stands.length ? stands.join("; ") : NEAR[unit.grounding];
  return ["Like ", seen, near ? `, ${near}` : ""];
};

const step = (plan, i, { unseen, to }) => {
  const jump = (view, words) => element("a", { href: to(view, i + 1), "aria-label": words }, view);
  return element("li", { "data-step": i + 1 },
    element("div", { class: "step" }, element("span", {}, ...marked(plan.sentences[i], unseen)), element("div", { class: "where" }, ...evidence(plan, i),
      element("span", { class: "jumps" }, jump("cook", `Cook from step ${i + 1}`), " · ", jump("tree", `Step ${i + 1} in the tree`)))),
    element("div", { class: "formula" }, ...unitWords(plan.units[i], unseen)));
};

export const stepsView = (plan, { unseen, to }) => {
  const steps = list(plan.units.map((_, i) => step(plan, i, { unseen, to })), { class: "steps" }, "ol");
  const own = element("button", { type: "button", class: "small", "aria-pressed": "false", onclick: () => {
    own.setAttribute("aria-pressed", String(steps.classList.toggle("formulas")));
  } }, "In the FOON's own words");
  const like = [...unseen].map(([name, one]) => `~${name} handled like ${one.equivalent}`).join(", ");
  const part = element("section", {},
    notes(plan.notes),
    element("p", {}, `${madeLike(plan)} of `, ...videos(plan), like ? `, with ${like}. ` : ". ", element("a", { href: to("why") }, "Why?")),
    element("div", { class: "beside" },
      element("div", {}, element("div", { class: "titled" }, heading(2, "Steps"), own), steps),
      element("div", {},
        heading(2, "What to buy"), list(buying(plan, (node) => nodeWords(node, unseen))),
        heading(2, "Utensils, and what is always there"), list(besides(plan).map((node) => nodeWords(node, unseen))))));
  const shown = (number) => {
    steps.querySelectorAll(".now").forEach((one) => one.classList.remove("now"));
    const now = number && steps.children[number - 1];
    now?.classList.add("now");
    now?.scrollIntoView({ block: "center" });
  };
  return { part, shown };
};
