// The page: what its address asks is shown (the opening, a plan in one of its views, what could be made), and
// whatever is asked by hand becomes an address first.

import { fromAddress, toAddress } from "./address.js";
import * as api from "./api.js";
import { chipField } from "./chips.js";
import { element, errorNotice } from "./element.js";
import { examplesView, knows, recentView, remember } from "./opening.js";
import { planPage, suggestionsView } from "./plan.js";
import { wishes } from "./wishes.js";

const at = (id) => document.getElementById(id);
const [dish, ingredient, result, status] = ["dish", "ingredient", "result", "status"].map(at);
const say = (text) => { status.textContent = text; };
const foods = chipField(ingredient, at("wanted"), { most: 60, say });
const wished = wishes(say);
const goTo = (address) => { if (location.hash === address) follow(true); else location.hash = address; };
let turn = 0;
let [examples, empty] = [null, false];
let shown = { key: "", show: () => {}, leave: () => {} }; // the answer that is there, by what was asked

// Only the answer to the last question is shown, whatever comes late.
const answer = async (words, key, question, view) => {
  const mine = ++turn;
  say(words);
  result.setAttribute("aria-busy", "true");
  let made;
  try {
    const told = await question();
    if (mine !== turn) return;
    made = { key, ...view(told) };
    say("Done.");
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    if (mine !== turn) return;
    say("");
    made = { key: "", parts: [errorNotice(error, ...remedies(error.missing))] };
    if (error.status === 401) api.askToken();
  }
  shown.leave?.();
  shown = made;
  at("asking").open = !made.show;
  result.replaceChildren(...made.parts.filter(Boolean));
  result.setAttribute("aria-busy", "false");
  made.show?.(fromAddress());
  result.focus({ preventScroll: true });
  scrollTo({ top: 0 });
};

// What a named kitchen lacks is there after all: a button for each.
const remedies = (missing) => {
  const plain = missing.filter(({ node, remedy }) => /^(get|buy) /.test(remedy) && !node.ingredients.length);
  const things = new Map(wished.question().kitchen.length ? plain.map(({ node, remedy }) => [node.label, remedy.replace(/^(get|buy) /, "")]) : []);
  const have = (thing) => () => { wished.have(thing); plan(); };
  const buttons = [...things].slice(0, 8).map(([thing, words]) => element("button", { type: "button", class: "small", onclick: have(thing) }, `I have ${words}`));
  return buttons.length ? [element("div", { class: "choices" }, ...buttons)] : [];
};

const question = () => ({ dish_type: dish.value, ingredients: foods.words(), ...wished.question() });

// What is typed and not yet entered is asked too.
const ask = (view) => {
  foods.add();
  wished.gather();
  if (foods.words().length) return goTo(toAddress(question(), view));
  result.hidden = false;
  result.replaceChildren(errorNotice({ message: "Name an ingredient first", hint: "For example: chopped onion." }));
  ingredient.focus();
};
const plan = () => ask("");
const choose = (food, like) => {
  wished.choose(food, like);
  ask(fromAddress().view);
};

const makePlan = (key) => {
  const words = foods.words().join(", ");
  const tell = (type) => { at("asked").textContent = `${type} with ${words}`; };
  tell(dish.value || "something");
  return answer("Planning …", key, () => api.plan(question()), (told) => {
    tell(told.recipe.dish_type);
    remember(key, told.goal.label, words);
    return planPage(told, { key, asked: question(), chosen: wished.chosen(), choose });
  });
};

const suggest = (key) => answer("Looking at every dish …", key, () => api.suggest(foods.words(), wished.question().kitchen), (told) => {
  document.title = "What these foods could make · foon";
  return { parts: suggestionsView(told, (dishType) => { dish.value = dishType; plan(); }) };
});

const openingShown = async () => {
  result.replaceChildren();
  document.title = "foon: task trees for cooking";
  at("asking").open = true;
  at("recent").replaceChildren(...recentView(openingShown));
  if (examples || empty) return;
  examples = api.examples(); // asked once, and only by who sees them
  const shownAs = await examples.then((told) => examplesView(told.examples), (error) => [errorNotice(error)]);
  at("examples").replaceChildren(...shownAs);
  at("examples").setAttribute("aria-busy", "false");
};

// Show what the address asks; `again`: ask it again, though its answer is there.
const follow = (again = false) => {
  const asked = fromAddress();
  const page = asked.ingredients.length ? "plan" : "home";
  document.body.dataset.page = page;
  at("opening").hidden = page !== "home";
  result.hidden = page !== "plan";
  if (page !== "plan") {
    turn += 1; // what still comes is for a page that is no longer there
    shown.leave?.();
    shown = { key: "" };
    return openingShown();
  }
  const key = toAddress(asked.question, asked.view === "make" ? "make" : "");
  if (!again && key === shown.key) return shown.show?.(asked);
  dish.value = [...dish.options].some((option) => option.value === asked.question.dish_type) ? asked.question.dish_type : "";
  foods.set(asked.ingredients);
  wished.set(asked.wishes);
  return asked.view === "make" ? suggest(key) : makePlan(key);
};

const begin = async () => {
  try {
    const told = await api.summary();
    at("token").hidden = true;
    at("lead").hidden = empty = !told.units;
    at("knows").textContent = knows(told);
    dish.replaceChildren(dish.options[0], ...told.dish_types.map((name) => element("option", { value: name }, name)),
      ...told.drafted_types.map((name) => element("option", { value: name, "data-drafted": true }, `${name} (drafts alone)`)));
    at("drafts").hidden = !told.drafts;
    at("drafts-help").textContent = `Make it after one of ${told.drafts} dishes, too, that were drafted from the words of recipes: nobody has seen or reviewed them.`;
    if (empty) {
      at("examples").replaceChildren(errorNotice({ message: "This FOON is empty", hint: "Load one: foon load foon PATH. Then load this page anew." }));
      at("examples").setAttribute("aria-busy", "false");
    }
    follow(true);
  } catch (error) {
    if (!(error instanceof api.Refusal)) throw error;
    if (error.status === 401) api.askToken();
    else at("examples").replaceChildren(errorNotice(error));
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
dish.addEventListener("change", () => { if ("drafted" in dish.selectedOptions[0].dataset) wished.drafts(true); });
at("suggest").addEventListener("click", () => ask("make"));
at("clear").addEventListener("click", () => {
  foods.set([]);
  wished.follow("");
  wished.drafts(false);
  wished.question().substitutes.forEach(({ food }) => wished.choose(food, null));
  say("All ingredients are removed.");
  ingredient.focus();
});
api.onToken(begin);
at("skip").addEventListener("click", (event) => { // an address of its own would lead away from the plan
  event.preventDefault();
  at(result.hidden ? "opening" : "result").focus();
});
addEventListener("hashchange", () => follow());
api.tokenFromAddress();
begin();
