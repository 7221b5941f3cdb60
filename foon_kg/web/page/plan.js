// A plan: the tree, its steps with their videos, what stands for what (and what could), progress lines, reasons.

import { counted, element, heading, list, sentence } from "./element.js";
import { nodeWords, seenWords, unitWords } from "./nodes.js";
import { picture, staged } from "./picture.js";
import { scheduleView } from "./schedule.js";

const sure = (confidence) => element("span", { class: "score" }, confidence.toFixed(2));

export const planView = (plan, chosen, choose) => {
  const unseen = new Map(plan.substitutions.filter((one) => one.kind === "object").map((one) => [one.object, one]));
  const wanted = plan.recipe.ingredients.map((one) => `${one.state} ${one.object}`.trim()).join(", ");
  return [
    heading(2, `${plan.goal.label}: ${counted(plan.units.length, "step")}`),
    element("p", {}, `${sentence(`${plan.recipe.dish_type} with ${wanted}`).slice(0, -1)}, made like the ${plan.reference.goal.label} of `
      + `${counted(plan.reference.units, "step")}, which takes ${plan.reference.overlap} of these foods or their like`
      + (plan.reference.exact ? "." : " (the best that was found in time).")),
    notes(plan.notes),
    ...substitutions(plan, chosen, choose),
    heading(3, "Task tree"),
    ...staged(plan.pictures.tree, "The task tree, from the kitchen down to the dish"),
    heading(3, "Steps"),
    list(plan.units.map((unit, i) => step(unit, plan.videos[i], unseen)), { class: "steps" }, "ol"),
    heading(3, "What to buy"),
    list(plan.shopping.map((node) => nodeWords(node, unseen)), { class: "columns" }),
    heading(3, "Utensils, and what is always there"),
    list(besides(plan).map((node) => nodeWords(node, unseen)), { class: "columns" }),
    assumptions(plan, unseen),
    passedOver(plan),
    ...scheduleView(plan),
    heading(3, "Progress of each ingredient"),
    element("div", { class: "wide", tabindex: "0", role: "group", "aria-label": "Progress lines" }, picture(plan.pictures.progress)),
    reasons(plan),
  ];
};

const notes = (told) => (told.length ? element("div", { class: "notice" }, ...told.map((note) => element("p", {}, sentence(note)))) : null);

const besides = (plan) => {
  const bought = new Set(plan.shopping.map((node) => node.label));
  return plan.kitchen.filter((node) => !bought.has(node.label));
};

const step = (unit, address, unseen) => {
  const seen = seenWords(unit.seen_in, address);
  const origin = { adapted: "as the FOON does it to a like food" }[unit.origin];
  const where = [seen, origin].filter(Boolean).flatMap((one, i) => (i ? [" · ", one] : [one]));
  return element("li", {}, ...unitWords(unit, unseen), element("div", { class: "where" }, ...where));
};

const substitutions = (plan, chosen, choose) => {
  if (!plan.substitutions.length && !chosen.size) return [];
  const items = plan.substitutions.map((one) => (one.kind === "object" ? food(one, chosen, choose) : word(one)));
  return [heading(3, "What stands for what"), list(items, { class: "plain" })];
};

const food = (one, chosen, choose) => {
  const own = chosen.get(one.object);
  const said = element("p", {}, element("span", { class: "unseen" }, `~${one.object}`), " is handled like ",
    element("strong", {}, one.equivalent), " ", sure(one.confidence), own ? " (your choice)" : "");
  const others = one.alternatives.map((other) =>
    element("button", { type: "button", class: "small", "data-like": other.name, onclick: () => choose(one.object, other.name),
      "aria-label": `${other.name} ${other.confidence.toFixed(2)}: handle ${one.object} like it instead` }, other.name, " ", sure(other.confidence)));
  const back = own ? [element("button", { type: "button", class: "small quiet", onclick: () => choose(one.object, null) }, "undo my choice")] : [];
  if (!others.length && !back.length) return said;
  return [said, element("div", { class: "choices", role: "group", "aria-label": `Instead of ${one.equivalent} for ${one.object}` },
    others.length ? element("span", { class: "aside" }, "or like") : null, ...others, ...back)];
};

const word = (one) =>
  element("p", {}, `${one.object}: `, element("span", { class: one.kind === "motion" ? "motion" : "state" }, one.required),
    ` where the FOON has ${one.equivalent} `, sure(one.confidence),
    one.alternatives.length ? ` (or ${one.alternatives.map((other) => other.name).join(", ")})` : "");

const assumptions = (plan, unseen) => {
  if (!plan.assumptions.length) return null;
  const told = plan.assumptions.map((one) => [...nodeWords(one.node, unseen), `: ${one.why}`]);
  return element("div", {}, heading(3, "Taken to be there"), list(told));
};

const passedOver = (plan) => {
  if (!plan.passed_over.length) return null;
  const told = plan.passed_over.map((one) => [element("strong", {}, one.goal.label), ` ${one.similarity.toFixed(2)}: ${one.why}`]);
  return element("div", {}, heading(3, "Nearer by their foods, and passed over"), list(told));
};

const HOW = {
  played: (one) => `has a place in the recorded dish, and is handled as the FOON handles ${one.label === one.want.object ? "it" : one.label}`,
  made: (one) => `is made ready as the FOON makes ${one.label === one.want.object ? "it" : one.label}`,
  sold: () => "joins as it is sold",
  assumed: () => "is assumed to be there: nothing in this FOON makes it so",
  missing: () => "does not get into this dish",
};

const reasons = (plan) => {
  const told = plan.explanations.map((one) => {
    const where = one.videos.length ? ` (${one.videos.join(", ")})` : "";
    const joins = one.joins?.step ? `; it joins the others in step ${one.joins.step} (${one.joins.motion})` : "";
    const other = one.passed_over.map((o) => `${o.state} ${o.label}`.trim() + ` ${o.confidence.toFixed(2)}: ${o.why}`);
    return [element("strong", {}, `${one.want.state} ${one.want.object}`.trim()), ` ${HOW[one.how](one)}${where}${joins}.`,
      other.length ? element("span", { class: "aside" }, ` Not like ${other.join("; ")}.`) : null].filter(Boolean);
  });
  return element("details", {}, element("summary", {}, "Why each ingredient is made so"), list(told));
};

export const suggestionsView = (answer, take) => [
  heading(2, "What these foods could make"),
  notes(answer.notes),
  list(answer.suggestions.map((one) => element("li", {},
    element("p", {}, element("strong", {}, one.goal.label), ` (${one.dish_type}), ${counted(one.units, "step")}, ${Math.round(one.share * 100)} % is there`),
    element("p", { class: "aside" }, `takes ${one.taken.map((t) => (t.own === t.food ? t.food : `${t.own} for ${t.food}`)).join(", ")}`
      + (one.missing.length ? `; missing: ${one.missing.join(", ")}` : "; nothing is missing")),
    element("button", { type: "button", class: "small", onclick: () => take(one.dish_type) }, `Plan it as ${one.dish_type}`))), { class: "plain" }),
];
