// What a plan can be compared with: itself with another wish, and other plans that were made in this browser.

import { toAddress } from "./address.js";
import { chipField } from "./chips.js";
import { combobox } from "./combobox.js";
import { element, heading, list } from "./element.js";
import { recent } from "./opening.js";

const without = (words, gone) => words.filter((word) => word !== gone);

export const rivals = (plan, asked, to) => {
  const address = (changes) => to("compare", null, toAddress({ ...asked, ...changes }));
  const links = [
    ...asked.avoid.map((food) => [`with ${food} allowed`, { avoid: without(asked.avoid, food) }]),
    ...(asked.kitchen.length ? [["with everything at hand", { kitchen: [] }]] : []),
    ...asked.substitutes.map((one) => [`with ${one.food} handled as the FOON thinks best`, { substitutes: without(asked.substitutes, one) }]),
    ...(asked.title ? [["without what it is called", { title: "" }]] : []),
    ...(asked.after ? [["after the dish that suits best", { after: "" }]] : []),
    ...(asked.with_drafts ? [["made after videos alone, without drafts", { with_drafts: false }]] : []),
    ...plan.considered.map((one) => [`made after the ${one.goal.label} of video ${one.video}`, { after: one.video }]),
  ].map(([words, changes]) => element("a", { href: address(changes) }, words));
  const own = toAddress(asked);
  const others = recent().filter((one) => one.address !== own).map((one) => element("a", { href: to("compare", null, one.address) }, `${one.name}: ${one.words}`));
  return [
    heading(2, "Compare this plan with"),
    ...(links.length ? [list(links, { class: "plain" })] : []),
    element("div", { class: "wishes" }, avoidField(asked, address), typeField(asked, address), kitchenField(address)),
    ...(others.length ? [heading(2, "Or with one that was planned here lately"), list(others, { class: "plain" })] : []),
  ];
};

const go = (address) => { location.hash = address; };
const button = (name) => element("button", { type: "submit", "aria-label": name }, "Compare");
const form = (label, id, row, act, ...after) => element("form", { class: "field card", novalidate: true, onsubmit: (event) => { event.preventDefault(); act(); } },
  element("label", { for: id }, label), row, ...after);

const avoidField = (asked, address) => {
  const input = element("input", { id: "compare-avoid", "data-known": "Known foods and kinds of food", "data-completes": "avoidable", placeholder: "onion; nuts" });
  const row = element("div", { class: "row" }, input, button("Compare without it"));
  combobox(input, () => input.focus());
  const act = () => { if (input.value.trim()) go(address({ avoid: [...without(asked.avoid, input.value.trim()), input.value.trim()] })); };
  return form("The same without", "compare-avoid", row, act);
};

const typeField = (asked, address) => {
  const options = [...document.getElementById("dish").options].filter(({ value }) => value && value !== asked.dish_type).map(({ value }) => element("option", { value }, value));
  const select = element("select", { id: "compare-dish" }, ...options);
  return form("The same as another dish", "compare-dish", element("div", { class: "row" }, select, button("Compare with that dish")), () => go(address({ dish_type: select.value })));
};

const kitchenField = (address) => {
  const input = element("input", { id: "compare-have", "data-completes": "thing", "data-known": "Known things", placeholder: "knife; pot; spoon", enterkeyhint: "done" });
  const chips = element("ul", { class: "chips", "aria-label": "What is at hand there" });
  const compare = button("Compare with that kitchen");
  const told = element("p", { class: "aside", role: "status" });
  const made = form("The same in another kitchen", "compare-have", element("div", { class: "row" }, input), () => {
    field.add();
    if (field.words().length) go(address({ kitchen: field.words() }));
  }, chips, element("p", { class: "aside" }, "What is at hand there. Once you name a utensil there are no others, and so with foods."), element("div", { class: "row" }, compare), told);
  const field = chipField(input, chips, { most: 200, say: (text) => { told.textContent = text; } });
  return made;
};
