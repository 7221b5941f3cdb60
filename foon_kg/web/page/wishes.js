// What is at hand, what is to be left out, what shall stand for what, and which recorded dish to follow. The first two
// are kept in this browser.

import { chip, chipField, focusNear } from "./chips.js";
import { combobox } from "./combobox.js";

const at = (id) => document.getElementById(id);
const KEPT = "foon-wishes";

export const wishes = (say) => {
  let chosen = new Map(); // food -> the known one that the person wants it to be handled like

  const kitchen = chipField(at("thing"), at("at-hand"), { most: 200, say, changed: () => told() });
  const avoided = chipField(at("avoid"), at("avoided"), { most: 20, say, changed: () => told() });

  const after = combobox(at("after"), () => { at("after").focus(); told(); });
  for (const id of ["after", "called"]) at(id).addEventListener("change", () => told());
  at("with-drafts").addEventListener("change", () => told());

  const told = () => {
    const [things, foods] = [kitchen?.words() ?? [], avoided?.words() ?? []];
    const parts = [at("called").value.trim() && `called ${at("called").value.trim()}`, things.length && `${things.length} at hand`, foods.length && `without ${foods.join(", ")}`,
      chosen.size && [...chosen].map(([food, like]) => `${food} like ${like}`).join(", "), at("after").value.trim() && `after ${at("after").value.trim()}`,
      at("with-drafts").checked && "drafts, too"];
    at("wishes-told").textContent = parts.filter(Boolean).join(" · ") || "everything is at hand, nothing is left out";
    localStorage.setItem(KEPT, JSON.stringify({ things, foods }));
  };
  const showChosen = () => {
    at("chosen").replaceChildren(...[...chosen].map(([food, like], place) => chip(`${food} like ${like}`, () => {
      choose(food, null);
      focusNear(at("chosen"), place, at("food"));
    })));
    told();
  };
  const choose = (food, like) => {
    if (like === null) chosen.delete(food);
    else chosen.set(food, like);
    showChosen();
  };

  const [food, like] = ["food", "like"].map((id) => combobox(at(id), () => at(id).focus()));
  const addChoice = () => {
    const [one, other] = [at("food"), at("like")].map((input) => input.value.trim());
    if (!one || !other) return say("Name both: the food, and the known one to handle it like.");
    choose(one, other);
    for (const id of ["food", "like"]) at(id).value = "";
    food.close();
    like.close();
    at("food").focus();
    say(`${one} is handled like ${other}.`);
  };
  at("add-choice").addEventListener("click", addChoice);
  for (const id of ["food", "like"]) {
    at(id).addEventListener("keydown", (event) => {
      if (event.key !== "Enter" || event.ctrlKey || event.metaKey) return;
      event.preventDefault();
      addChoice();
    });
  }

  const set = ({ things, foods, choices, after: dish = "", title = "", with_drafts: drafts = false }) => {
    at("after").value = dish;
    at("called").value = title;
    at("with-drafts").checked = drafts;
    after.close();
    kitchen.set(things);
    avoided.set(foods);
    chosen = new Map(choices);
    showChosen();
    at("wishes").open = things.length + foods.length + dish.length + title.length > 0 || drafts;
  };
  const kept = () => {
    try {
      const { things = [], foods = [] } = JSON.parse(localStorage.getItem(KEPT) ?? "{}");
      return { things: [...things].map(String), foods: [...foods].map(String), choices: [] };
    } catch {
      return { things: [], foods: [], choices: [] }; // what another version kept
    }
  };
  set(kept());
  return {
    set,
    choose,
    follow: (dish) => { at("after").value = dish; told(); },
    drafts: (too) => { at("with-drafts").checked = too; told(); },
    chosen: () => chosen,
    question: () => ({ substitutes: [...chosen].map(([one, other]) => ({ food: one, like: other })), avoid: avoided.words(), kitchen: kitchen.words(), after: at("after").value.trim(), title: at("called").value.trim(), with_drafts: at("with-drafts").checked }),
    have: (thing) => kitchen.add(thing),
    gather: () => [kitchen, avoided].forEach((field) => field.add()), // what is typed and not yet entered
  };
};
