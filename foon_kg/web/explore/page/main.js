// The page /explore: what is asked for, the picture of it, and what is told beside it.

import { Refusal, askToken, onToken, tokenFromAddress } from "../api.js";
import { combobox } from "../combobox.js";
import { counted, element, errorNotice } from "../element.js";
import * as asking from "./asking.js";
import { cypherBox } from "./cypher.js";
import { beginView, thingView, wayView } from "./panel.js";
import { picture } from "./picture.js";
import { searchBox } from "./search.js";
import { fullName, kindOf } from "./words.js";

const FIRST = (id) => ({ depth: id.startsWith("utensil:") ? 3 : 2, most: matchMedia("(max-width: 800px)").matches ? 12 : 22 }); // a knife says little without what it cuts
const GROWTH = { depth: 1, most: 12 };
const MOST = 400; // things in one picture
const FILTERS = [["video", "videos"], ["motion", "motions"], ["dish", "dish_types"]];

const at = (id) => document.getElementById(id);
const say = (text) => { at("status").textContent = text; };
let begun = [];
let turn = 0;

const filters = () => ({ ...Object.fromEntries(FILTERS.map(([id, name]) => [name, at(id).value ? [at(id).value] : []])), utensils: at("utensils").checked });
const filtersTold = () => {
  const told = [...FILTERS.map(([id]) => at(id).value), at("utensils").checked ? "empty utensils too" : ""].filter(Boolean);
  at("filters-told").textContent = told.join(" · ");
};

// Only the answer to the last question is shown, whatever comes late.
const answer = async (question, shown) => {
  const mine = ++turn;
  at("picture").setAttribute("aria-busy", "true");
  try {
    const told = await question();
    if (mine === turn) shown(told);
  } catch (error) {
    if (mine === turn) failed(error);
  } finally {
    if (mine === turn) at("picture").removeAttribute("aria-busy");
  }
};
const failed = (error) => {
  if (!(error instanceof Refusal)) throw error;
  say("");
  at("about").replaceChildren(errorNotice(error));
  if (error.status === 401) askToken();
};

const drawing = picture(at("picture"), {
  chosen: (thing, { grow }) => (grow ? act.grow(thing) : act.choose(thing)),
  removed: (thing) => act.remove(thing),
});
const counts = () => { at("count").textContent = `${counted(drawing.ids().length, "thing")} in the picture`; };

const tell = (thing, about) => {
  at("about").replaceChildren(...thingView(thing, about, { next: drawing.next(thing.id), more: drawing.more(thing.id), act }));
  at("about").scrollTop = 0;
  counts();
};
const words = (thing) => (thing.kind === "step" ? fullName(thing) : `${fullName(thing)}: ${kindOf(thing)}.`);

// What is known of a thing: a node of the graph that has no place in the explorer is only what the answer said of it.
const known = async (thing) => (thing.kind === "other"
  ? { things: [thing], about: { text: thing.note, facts: [], links: [], places: [] } }
  : asking.around(thing.id, { ...filters(), depth: 1, most: 1, shown: drawing.ids().filter((id) => !id.startsWith("node:")) }));

const act = {
  // A new picture around a thing.
  show: (thing) => {
    const hash = address({ at: thing.id });
    if (location.hash === hash) follow();
    else location.hash = hash;
  },
  // More around a thing in the picture, or a thing that was not there, with what is around it.
  grow: (thing) => {
    if (thing.kind === "other") return act.choose(thing);
    const shown = drawing.ids().filter((id) => !id.startsWith("node:"));
    if (shown.length >= MOST) return say(`The picture is full with ${MOST} things: take some out, or begin anew.`);
    return answer(() => asking.around(thing.id, { ...GROWTH, ...filters(), shown }), (told) => {
      const count = drawing.grow(told, thing.id);
      tell(told.things[0], told.about);
      say(`${words(thing)} ${count ? `${counted(count, "new thing")} around it.` : "Nothing else is around it."}`);
    });
  },
  // What a thing in the picture is, and nothing more.
  choose: (thing) => answer(() => known(thing), (told) => {
    drawing.look(thing.id);
    tell(told.things[0], told.about);
    say(words(thing));
  }),
  remove: (thing) => {
    const next = drawing.remove(thing.id);
    say(`${fullName(thing)} is taken out.`);
    counts();
    if (next) act.choose(next);
    else at("about").replaceChildren();
  },
  end: (side, thing) => {
    at(side).value = thing.kind === "object" ? [...thing.states, thing.name].join(" ") : thing.name;
    const other = at(side === "start" ? "end" : "start");
    if (other.value.trim()) at("way").requestSubmit();
    else { other.focus(); say(side === "start" ? "And where does it lead?" : "And where does it begin?"); }
  },
};

const beginning = () => answer(() => asking.around(begun[0].id, { ...FIRST(begun[0].id), ...filters() }), (told) => {
  drawing.show(told);
  at("about").replaceChildren(...beginView(begun, act.show));
  counts();
});
const around = (id) => answer(() => asking.around(id, { ...FIRST(id), ...filters() }), (told) => {
  drawing.show(told);
  tell(told.things[0], told.about);
  say(`${words(told.things[0])} ${counted(told.things.length - 1, "thing")} around it.`);
});
const way = (start, end) => answer(() => asking.way(start, end, filters()), (told) => {
  drawing.way(told);
  at("about").replaceChildren(...wayView(told, act));
  counts();
  say(`${counted(told.steps.length, "step")}.`);
});

// What is shown as the part of the address after #, which is never sent to a server.
const address = (fields) => {
  const chosen = FILTERS.map(([id]) => [id, at(id).value]).filter(([, value]) => value);
  const asked = [...Object.entries(fields), ...chosen, ...(at("utensils").checked ? [["utensils", "1"]] : [])];
  return `#${new URLSearchParams(asked)}`;
};
const follow = () => {
  const asked = new URLSearchParams(location.hash.slice(1));
  for (const [id] of FILTERS) at(id).value = [...at(id).options].some(({ value }) => value === asked.get(id)) ? asked.get(id) : "";
  at("utensils").checked = asked.has("utensils");
  filtersTold();
  if (asked.get("from") && asked.get("to")) {
    at("start").value = asked.get("from");
    at("end").value = asked.get("to");
    return way(asked.get("from"), asked.get("to"));
  }
  if (asked.get("at")) return around(asked.get("at"));
  return beginning();
};

const asked = cypherBox((told) => {
  ++turn; // whatever comes later is of another question
  drawing.show(told);
  act.choose(told.things[0]);
  at("shown").scrollIntoView({ block: "nearest" });
});

const begin = async () => {
  try {
    const told = await asking.begin();
    await asked.begin();
    at("token").hidden = true;
    for (const [id, name] of FILTERS) at(id).replaceChildren(at(id).options[0], ...told[name].map((one) => element("option", { value: one }, one)));
    begun = told.begin;
    at("shown").hidden = !begun.length;
    if (!begun.length) at("about").replaceChildren(errorNotice({ message: "This FOON is empty", hint: "Load one: foon load foon PATH. Then load this page anew." }));
    else follow();
  } catch (error) {
    failed(error);
  }
};

searchBox(at("text"), act.show, failed);
combobox(at("start"), () => at("end").focus());
combobox(at("end"), () => at("way").requestSubmit());
at("find").addEventListener("submit", (event) => event.preventDefault());
at("way").addEventListener("submit", (event) => {
  event.preventDefault();
  const [start, end] = [at("start"), at("end")];
  const empty = [start, end].find((input) => !input.value.trim());
  if (empty) return empty.focus();
  const hash = address({ from: start.value.trim(), to: end.value.trim() });
  if (location.hash === hash) follow();
  else location.hash = hash;
  return undefined;
});
for (const id of [...FILTERS.map(([id]) => id), "utensils"]) {
  at(id).addEventListener("change", () => {
    const { at: id, from, to } = Object.fromEntries(new URLSearchParams(location.hash.slice(1)));
    filtersTold();
    if (id) location.hash = address({ at: id });
    else if (from && to) location.hash = address({ from, to });
  });
}
for (const id of ["larger", "smaller", "all", "tidy"]) at(id).addEventListener("click", () => drawing[id === "all" ? "fit" : id]());
onToken(begin);
addEventListener("hashchange", follow);
tokenFromAddress();
begin();
