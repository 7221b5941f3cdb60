// Why a plan is as it is: the dish it was made after, what stands for what (and what could), each food's reason, nearer
// dishes that were passed over, how near its steps are to what videos show, and what the judge says of it.

import { toAddress } from "./address.js";
import { counted, element, heading, list, sentence } from "./element.js";
import { nodeWords } from "./nodes.js";
import { foodAndState, madeLike, videos } from "./steps.js";

const sure = (confidence) => element("span", { class: "score" }, confidence.toFixed(2));
const inWords = (names) => names.join(", ").replace(/, ([^,]*)$/, " and $1");

export const whyView = (plan, { asked, unseen, to, chosen, choose }) => ({ part: element("section", {}, ...[
  heading(2, "The dish it was made after"), ...after(plan, asked),
  ...substitutions(plan, unseen, chosen, choose),
  heading(2, "Why each food is made so"), reasons(plan, to, asked),
  ...titled("Taken to be there", plan.assumptions.map((one) => [...nodeWords(one.node, unseen), `: ${one.why}`])),
  ...titled("Nearer by their foods, and passed over", others(plan, true, asked, to)),
  ...titled("Other dishes to make it after", others(plan, false, asked, to)),
  heading(2, "How near its steps are to what videos show"), evidence(plan, to),
  heading(2, "What the judge says"), ...judged(plan, to),
].filter(Boolean)) });

const titled = (title, items) => (items.length ? [heading(2, title), list(items)] : []);

// The dishes that were considered and not taken; each can be taken after all, or looked at beside this plan.
const others = ({ considered }, nearer, asked, to) => considered.filter((one) => one.nearer === nearer).map((one) => {
  const rival = { ...asked, after: one.video };
  return [element("strong", {}, one.goal.label), ` of video ${one.video} `, sure(one.similarity), nearer ? `: ${one.why}` : "",
    element("span", { class: "jumps" }, element("a", { href: toAddress(rival, "why"), "aria-label": `make it so, after the ${one.goal.label} of ${one.video}` }, "make it so"),
      " · ", element("a", { href: to("compare", null, toAddress(rival)), "aria-label": `compare with the ${one.goal.label} of ${one.video}` }, "compare"))];
});

// A food as it was asked: a state that nobody named is not told.
const asAsked = (one, { ingredients }) => (ingredients.some((text) => text.includes(one.object) && text.replace(one.object, "").includes(one.state)) ? foodAndState(one) : one.object);

const after = (plan, asked, { recipe, reference } = plan) => [
  element("p", {}, `${sentence(`${recipe.dish_type} with ${inWords(recipe.ingredients.map((one) => asAsked(one, asked)))}`).slice(0, -1)}: ${madeLike(plan).replace("Made", "made")} of ${counted(reference.units, "step")} in `, ...videos(plan), "."),
  element("p", {}, `That dish takes ${reference.overlap} of the ${recipe.ingredients.length} foods asked, or their like`,
    reference.core.length ? ` (${inWords(reference.core)})` : "", reference.exact ? ": it is proven that no way to make it takes more." : "; it is the best that was found in time."),
];

const substitutions = (plan, unseen, chosen, choose) => {
  const items = [...[...unseen.values()].map((one) => food(one, plan.substitutions, chosen, choose)), ...plan.substitutions.filter((one) => one.kind !== "object").map(word)];
  return items.length ? [heading(2, "What stands for what"), list(items, { class: "plain" }),
    element("p", { class: "aside" }, "The number says how sure it is, from 0 to 1, that a cook would accept it. ~ marks a food for which another one stands.")] : [];
};

const food = (one, all, chosen, choose) => {
  const also = all.filter((other) => other.kind === "object" && other.object === one.object && other !== one);
  const own = chosen.get(one.object) === one.equivalent;
  const said = element("p", {}, element("span", { class: "unseen" }, `~${one.object}`), " handled like ",
    element("strong", {}, one.equivalent), " ", sure(one.confidence), own ? " (your choice)" : "",
    also.length ? element("span", { class: "aside" }, `, in single steps like ${inWords(also.map((other) => `${other.equivalent} ${other.confidence.toFixed(2)}`))}`) : "");
  const others = one.alternatives.filter((other) => other.name !== one.equivalent).map((other) =>
    element("button", { type: "button", class: "small", "data-like": other.name, onclick: () => choose(one.object, other.name),
      "aria-label": `${other.name} ${other.confidence.toFixed(2)}: handle ${one.object} like it instead` }, other.name, " ", sure(other.confidence)));
  const back = chosen.has(one.object) ? [element("button", { type: "button", class: "small quiet", onclick: () => choose(one.object, null) }, "undo my choice")] : [];
  if (!others.length && !back.length) return said;
  return [said, element("div", { class: "choices", role: "group", "aria-label": `Instead of ${one.equivalent} for ${one.object}` },
    others.length ? element("span", { class: "aside" }, "or like") : null, ...others, ...back)];
};

const word = (one) =>
  element("p", {}, one.kind === "state" ? `${one.required} ${one.object} is made like ${one.equivalent} ${one.object} ` : `to ${one.required} the ${one.object} is done as to ${one.equivalent} it `, sure(one.confidence),
    one.alternatives.length ? ` (or ${one.alternatives.map((other) => other.name).join(", ")})` : "");

const HOW = {
  played: (one) => `has its place in that dish${one.label === one.want.object ? "" : `, as ${one.label} has`}`,
  made: (one) => `is made ready${one.label === one.want.object ? "" : ` like ${one.label}`}`,
  sold: () => "joins as it is sold",
  assumed: () => "is assumed to be there: nothing in this FOON makes it so",
  missing: () => "does not get into this dish",
};

const stepLink = (to, step) => element("a", { href: to("steps", step) }, `step ${step}`);

const FEW = 2;

const reasons = (plan, to, asked) => list(plan.explanations.map((one) => {
  const joins = one.joins?.step ? ["; it joins the others in ", stepLink(to, one.joins.step)] : [];
  const seen = one.videos.length ? ` Seen in ${one.videos.slice(0, FEW).join(", ")}${one.videos.length > FEW ? `, and ${one.videos.length - FEW} more` : ""}.` : "";
  return [element("strong", {}, asAsked(one.want, asked)), ` ${HOW[one.how](one)}`, ...joins, ".", element("span", { class: "aside" }, seen)];
}));

const NEAR = { food: "done so to the same food", like: "done so to a like food", kind: "done so to a food of its kind", motion: "of which the motion alone is seen" };

const evidence = (plan, to) => list(Object.entries(NEAR).map(([near, words]) =>
  [plan.units.flatMap((unit, i) => ((unit.grounding ?? "food") === near ? [i + 1] : [])), words]).filter(([steps]) => steps.length).map(([steps, words]) =>
  [`${counted(steps.length, "step")} ${words}: `, ...steps.flatMap((one, i) => [i ? ", " : "", element("a", { href: to("steps", one) }, String(one))])]));

const judged = ({ judged: told }, to) => [
  element("p", {}, `A judge that knows nothing of the planner played this plan. A robot ${told.robot ? "could" : "could not"} carry it out, a cook ${told.cook ? "would" : "would not"} serve it`
    + (told.findings.length ? ", and this was found:" : "; it found nothing to object to.")),
  told.findings.length ? list(told.findings.map((one) => [
    ...(one.unit === null ? ["in all"] : ["in ", stepLink(to, one.unit + 1)]), `: ${one.reason} `, element("span", { class: "aside" }, `(${one.level === "minor" ? "odd, yet it can be done" : "fatal"}; rule ${one.rule})`)])) : null,
];
