// The page: what is wanted, and what comes of it.

import * as api from "./api.js";
import { aroundView } from "./around.js";
import { combobox } from "./combobox.js";
import { element, errorNotice } from "./element.js";
import { planView, suggestionsView } from "./plan.js";

const at = (id) => document.getElementById(id);
const [dish, ingredient, wanted, result, status] = ["dish", "ingredient", "wanted", "result", "status"].map(at);
const MOST = 60;
let foods = [];
let chosen = new Map(); // food -> the known one that the person wants it to be handled like
let turn = 0;

const showFoods = () => {
  wanted.replaceChildren(...foods.map((food) => element("li", {}, food,
    element("button", { type: "button", "aria-label": `Remove ${food}`, onclick: () => remove(food) }, "×"))));
};

const add = (text = ingredient.value) => {
  const food = text.split(/\s+/).join(" ").trim();
  if (!food.replaceAll(",", "").trim()) return false;
  if (!foods.includes(food) && foods.length < MOST) foods = [...foods, food];
  ingredient.value = "";
  typed.close();
  showFoods();
  status.textContent = `${food} is added: ${foods.length} in all.`;
  return true;
};

const remove = (food) => {
  const place = foods.indexOf(food);
  foods = foods.filter((other) => other !== food);
  showFoods();
  status.textContent = `${food} is removed.`;
  (wanted.querySelectorAll("button")[Math.min(place, foods.length - 1)] ?? ingredient).focus();
};

const typed = combobox(ingredient, at("ingredient-list"), "ingredient", (text) => add(text));
const looked = combobox(at("object"), at("object-list"), "object", (text) => { location.hash = `look=${encodeURIComponent(text)}`; });

// Only the answer to the last question is shown, whatever comes late.
const answer = async (words, question, view) => {
  const mine = ++turn;
  status.textContent = words;
  result.setAttribute("aria-busy", "true");
  let shown;
  try {
    const told = await question();
    if (mine !== turn) return;
    status.textContent = "Done.";
    shown = view(told);
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    if (mine !== turn) return;
    status.textContent = "";
    shown = [errorNotice(error)];
    if (error.status === 401) askToken();
  }
  result.replaceChildren(...shown.filter(Boolean));
  result.setAttribute("aria-busy", "false");
  result.focus({ preventScroll: true });
  result.scrollIntoView({ block: "start" });
};

const ready = () => {
  add();
  if (foods.length) return true;
  result.replaceChildren(errorNotice({ message: "Name an ingredient first", hint: "For example: chopped onion." }));
  ingredient.focus();
  return false;
};

const plan = () => {
  if (!ready()) return;
  const substitutes = [...chosen].map(([food, like]) => ({ food, like }));
  const question = { dish_type: dish.value, ingredients: foods, substitutes };
  answer("Planning …", () => api.plan(question), (told) => planView(told, chosen, choose));
};

const choose = (food, like) => {
  if (like === null) chosen.delete(food);
  else chosen.set(food, like);
  plan();
};

const suggest = () => {
  if (!ready()) return;
  const take = (dishType) => { dish.value = dishType; plan(); };
  answer("Looking at every dish …", () => api.suggest(foods), (told) => suggestionsView(told, take));
};

const look = async () => {
  const label = new URLSearchParams(location.hash.slice(1)).get("look");
  if (!label) return;
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

const askToken = () => {
  at("token").hidden = false;
  at("token-text").focus();
};

const begin = async () => {
  try {
    const told = await api.summary();
    at("token").hidden = true;
    at("summary").textContent = `${told.units} steps of ${told.videos} videos, ${told.foods} foods`;
    dish.replaceChildren(dish.options[0], ...told.dish_types.map((name) => element("option", { value: name }, name)));
    if (!told.units) result.replaceChildren(errorNotice({ message: "This FOON is empty", hint: "Load one: foon load foon PATH." }));
    look();
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    if (error.status === 401) askToken();
    else result.replaceChildren(errorNotice(error));
  }
};

ingredient.addEventListener("keydown", (event) => {
  if (event.key !== "Enter") return;
  event.preventDefault();
  if (event.ctrlKey || event.metaKey) plan();
  else if (!add() && foods.length) plan();
});
at("add").addEventListener("click", () => { add(); ingredient.focus(); });
at("ask").addEventListener("submit", (event) => { event.preventDefault(); plan(); });
at("suggest").addEventListener("click", suggest);
at("clear").addEventListener("click", () => {
  foods = [];
  chosen = new Map();
  showFoods();
  status.textContent = "All ingredients are removed.";
  ingredient.focus();
});
at("find").addEventListener("submit", (event) => {
  event.preventDefault();
  const label = at("object").value.trim();
  if (!label) return;
  const hash = `#look=${encodeURIComponent(label)}`;
  if (location.hash === hash) look();
  else location.hash = hash;
});
at("token-form").addEventListener("submit", (event) => {
  event.preventDefault();
  api.keepToken(at("token-text").value.trim());
  begin();
});
addEventListener("hashchange", look);
api.tokenFromAddress();
begin();
