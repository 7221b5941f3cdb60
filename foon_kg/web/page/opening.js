// The opening: what this FOON knows, dishes of its own to click, and what was planned in this browser lately.

import { toAddress } from "./address.js";
import { placeIn } from "./cook_place.js";
import { counted, element, heading, list } from "./element.js";

const KEPT = "foon-recent";
const MOST = 6;

export const recent = () => {
  try {
    return JSON.parse(localStorage.getItem(KEPT) ?? "[]").filter(({ address, name, words }) => [address, name, words].every((one) => typeof one === "string"));
  } catch {
    return []; // what another version kept
  }
};
export const remember = (address, name, words) =>
  localStorage.setItem(KEPT, JSON.stringify([{ address, name, words }, ...recent().filter((one) => one.address !== address)].slice(0, MOST)));

const card = (address, name, beside, words) =>
  element("li", {}, element("a", { class: "card dish", href: address }, element("strong", {}, name), " ",
    element("span", { class: "aside" }, beside), element("span", { class: "foods" }, words)));

const cards = (items) => list(items, { class: "cards" });

export const knows = ({ videos, dish_types: types, foods, units }) =>
  `This FOON knows ${counted(foods, "food")} and ${counted(types.length, "type")} of dishes, from ${counted(units, "step")} of ${counted(videos, "video")}.`;

export const examplesView = (examples) => (!examples.length ? [] : [
  heading(2, "Begin with one of its dishes"),
  cards(examples.map((one) => card(toAddress({ dish_type: one.dish_type, ingredients: one.ingredients }), one.name,
    counted(one.units, "step"), one.foods.join(", ")))),
]);

export const recentView = (forgotten) => {
  const found = recent();
  if (!found.length) return [];
  const forget = () => { localStorage.removeItem(KEPT); forgotten(); };
  return [
    heading(2, "Planned here lately"),
    cards(found.map((one) => {
      const step = placeIn(one.address);
      return step ? card(`${one.address}&view=cook`, one.name, `go on at step ${step}`, one.words) : card(one.address, one.name, "", one.words);
    })),
    element("p", { class: "aside" }, "Kept in this browser alone. ", element("button", { type: "button", class: "small quiet", onclick: forget }, "Forget them")),
  ];
};
