// A field that gathers words as chips: typed and added, completed or pasted (a line each); × takes one away.

import { combobox } from "./combobox.js";
import { element } from "./element.js";

const clean = (text) => text.replace(/#.*/, "").replace(/^\s*[-*•]\s/, "").split(/\s+/).join(" ").trim();
const named = (text) => text.replaceAll(",", "").trim();

export const chip = (text, remove) =>
  element("li", {}, text, element("button", { type: "button", "aria-label": `Remove ${text}`, onclick: remove }, "×"));

// After one of some chips is gone the focus stays near.
export const focusNear = (chips, place, input) => {
  const left = chips.querySelectorAll("button");
  (left[Math.min(place, left.length - 1)] ?? input).focus();
};

export const chipField = (input, chips, { most, say, changed }) => {
  let words = [];
  const show = () => {
    chips.replaceChildren(...words.map((word) => chip(word, () => remove(word))));
    changed?.();
  };
  const set = (some) => {
    words = [...new Set(some)].slice(0, most);
    show();
  };
  const add = (text = input.value) => {
    const found = text.split("\n").map(clean).filter(named);
    if (!found.length) return false;
    const full = new Set([...words, ...found]).size > most;
    set([...words, ...found]);
    input.value = "";
    typed.close();
    say(full ? `No more than ${most}.` : `${found.join(", ")} is added: ${words.length} in all.`);
    return true;
  };
  const remove = (word) => {
    const place = words.indexOf(word);
    set(words.filter((other) => other !== word));
    say(`${word} is removed.`);
    focusNear(chips, place, input);
  };
  const typed = combobox(input, (text) => add(text));
  const click = () => { add(); input.focus(); };
  const name = `Add to ${chips.getAttribute("aria-label").toLowerCase()}`;
  input.closest(".row").append(element("button", { type: "button", "aria-label": name, onclick: click }, "Add"));
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" || event.ctrlKey || event.metaKey || !named(input.value)) return;
    event.preventDefault();
    add();
  });
  input.addEventListener("paste", (event) => {
    const text = event.clipboardData.getData("text/plain");
    if (!text.includes("\n")) return;
    event.preventDefault();
    add(text);
  });
  return { add, set, words: () => words };
};
