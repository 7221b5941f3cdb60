// The page: what is wanted, and what comes of it.

import { fromAddress, toAddress } from "./address.js";
import * as api from "./api.js";
import { aroundView } from "./around.js";
import { chipField } from "./chips.js";
import { combobox } from "./combobox.js";
import { counted, element, errorNotice } from "./element.js";
import { planView, suggestionsView } from "./plan.js";
import { wishes } from "./wishes.js";

const at = (id) => document.getElementById(id);
const [dish, ingredient, result, status] = ["dish", "ingredient", "result", "status"].map(at);
const say = (text) => { status.textContent = text; };
const foods = chipField(ingredient, at("wanted"), { most: 60, say });
const wished = wishes(say);
const looked = combobox(at("object"), (text) => { location.hash = `look=${encodeURIComponent(text)}`; });
let turn = 0;

// Only the answer to the last question is shown, whatever comes late.
const answer = async (words, question, view) => {
  const mine = ++turn;
  say(words);
  result.setAttribute("aria-busy", "true");
  let shown;
  try {
    const told = await question();
    if (mine !== turn) return;
    shown = view(told);
    say("Done.");
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    if (mine !== turn) return;
    say("");
    shown = [errorNotice(error, ...remedies(error.missing))];
    if (error.status === 401) askToken();
  }
  result.replaceChildren(...shown.filter(Boolean));
  result.setAttribute("aria-busy", "false");
  result.focus({ preventScroll: true });
  result.scrollIntoView({ block: "start" });
};

// What a named kitchen lacks is there after all: a button for each.
const remedies = (missing) => {
  const plain = missing.filter(({ node, remedy }) => /^(get|buy) /.test(remedy) && !node.ingredients.length);
  const things = wished.question().kitchen.length ? [...new Set(plain.map(({ node }) => node.label))].slice(0, 8) : [];
  const buttons = things.map((thing) => element("button", { type: "button", class: "small", onclick: () => { wished.have(thing); plan(); } }, `I have ${thing}`));
  return buttons.length ? [element("div", { class: "choices" }, ...buttons)] : [];
};

const ready = () => {
  foods.add();
  wished.gather();
  if (foods.words().length) return true;
  result.replaceChildren(errorNotice({ message: "Name an ingredient first", hint: "For example: chopped onion." }));
  ingredient.focus();
  return false;
};

const plan = () => {
  if (!ready()) return;
  const question = { dish_type: dish.value, ingredients: foods.words(), ...wished.question() };
  const address = toAddress(question);
  if (location.hash !== address) history.pushState(null, "", address);
  answer("Planning …", () => api.plan(question), (told) => planView(told, wished.chosen(), choose));
};

const choose = (food, like) => {
  wished.choose(food, like);
  plan();
};

const suggest = () => {
  if (!ready()) return;
  const take = (dishType) => { dish.value = dishType; plan(); };
  answer("Looking at every dish …", () => api.suggest(foods.words(), wished.question().kitchen), (told) => suggestionsView(told, take));
};

const look = async (label) => {
  at("object").value = label;
  looked.close();
  const around = at("around");
  around.replaceChildren(element("p", { class: "aside" }, "Looking …"));
  try {
    around.replaceChildren(...aroundView(await api.around(label)));
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    around.replaceChildren(errorNotice(error));
    if (error.status === 401) askToken();
  }
  at("look").scrollIntoView({ block: "start" });
  around.focus({ preventScroll: true });
};

// What the address asks: an object to look at, or a plan.
const follow = () => {
  const asked = fromAddress();
  if (asked.look) look(asked.look);
  if (!asked.ingredients.length) return;
  dish.value = [...dish.options].some((option) => option.value === asked.dish) ? asked.dish : "";
  foods.set(asked.ingredients);
  wished.set(asked.wishes);
  plan();
};

const askToken = () => {
  at("token").hidden = false;
  at("token-text").focus();
};

const begin = async () => {
  try {
    const told = await api.summary();
    at("token").hidden = true;
    at("summary").textContent = `${counted(told.units, "step")} of ${counted(told.videos, "video")}, ${counted(told.foods, "food")}`;
    dish.replaceChildren(dish.options[0], ...told.dish_types.map((name) => element("option", { value: name }, name)));
    if (!told.units) result.replaceChildren(errorNotice({ message: "This FOON is empty", hint: "Load one: foon load foon PATH." }));
    follow();
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    if (error.status === 401) askToken();
    else result.replaceChildren(errorNotice(error));
  }
};

at("ask").addEventListener("keydown", (event) => {
  if (event.key !== "Enter" || event.defaultPrevented) return;
  if (event.ctrlKey || event.metaKey || event.target === ingredient) {
    event.preventDefault();
    if (event.ctrlKey || event.metaKey || foods.words().length) plan();
  } else if (event.target.matches("input")) event.preventDefault(); // an empty field asks nothing
});
at("ask").addEventListener("submit", (event) => { event.preventDefault(); plan(); });
at("suggest").addEventListener("click", suggest);
at("clear").addEventListener("click", () => {
  foods.set([]);
  wished.question().substitutes.forEach(({ food }) => wished.choose(food, null));
  say("All ingredients are removed.");
  ingredient.focus();
});
at("find").addEventListener("submit", (event) => {
  event.preventDefault();
  const label = at("object").value.trim();
  if (!label) return;
  const hash = `#look=${encodeURIComponent(label)}`;
  if (location.hash === hash) look(label);
  else location.hash = hash;
});
at("token-form").addEventListener("submit", (event) => {
  event.preventDefault();
  api.keepToken(at("token-text").value.trim());
  begin();
});
addEventListener("hashchange", follow);
api.tokenFromAddress();
begin();
