// A plan in its views, one at a time, each with an address: steps to read, to cook, the tree, who does what when, why, and
// beside another plan.

import { toAddress } from "./address.js";
import { compareView } from "./compare.js";
import { cookView } from "./cook.js";
import { counted, element, heading, list } from "./element.js";
import { scheduleView } from "./schedule.js";
import { notes, stepsView } from "./steps.js";
import { takeAlong } from "./take.js";
import { treeView } from "./tree.js";
import { whyView } from "./why.js";

const VIEWS = [["steps", "Steps", stepsView], ["cook", "Cook", cookView], ["tree", "Tree", treeView], ["when", "When", scheduleView], ["why", "Why", whyView], ["compare", "Compare", compareView]];

// `asked` is the question, `key` its address; `choose` plans again with a food handled like another one. A view is
// its element, and what it does when it is shown (with the step and the other plan that the address names) and when it is left.
export const planPage = (plan, { asked, chosen, ...rest }) => {
  const foods = plan.substitutions.filter((one) => one.kind === "object");
  const sure = (one) => (chosen.get(one.object) === one.equivalent ? 2 : one.confidence); // what was chosen is told first
  const unseen = new Map(foods.sort((a, b) => sure(a) - sure(b)).map((one) => [one.object, one]));
  const to = (...place) => toAddress(asked, ...place);
  const views = VIEWS.map(([name, title, make]) => ({ name, title, ...make(plan, { ...rest, asked, chosen, unseen, to }) }));
  const links = views.map(({ name, title }) => element("a", { href: to(name) }, title));
  views.forEach(({ part, name, title }) => {
    part.id = `view-${name}`;
    part.classList.add("view");
    part.setAttribute("aria-label", title);
  });
  let open = null;
  const leave = () => { open?.left?.(); open = null; delete document.body.dataset.view; };
  const show = ({ view, step, other }) => {
    const now = views.find(({ name }) => name === view) ?? views[0];
    if (open !== now) leave();
    open = now;
    document.body.dataset.view = now.name;
    document.title = `${now.title}: ${plan.goal.label} · foon`;
    views.forEach((one, i) => {
      one.part.hidden = one !== now;
      if (one === now) links[i].setAttribute("aria-current", "page");
      else links[i].removeAttribute("aria-current");
    });
    now.shown?.(step, other);
  };
  const parts = [heading(1, `${plan.goal.label}: ${counted(plan.units.length, "step")}`),
    element("nav", { class: "tabs", "aria-label": "Views of this plan" }, ...links), ...views.map(({ part }) => part), takeAlong(asked)];
  return { parts, show, leave };
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
