// The search as one types: a combobox over things of every kind (https://www.w3.org/WAI/ARIA/apg/patterns/combobox/).

import { element } from "../element.js";
import { search } from "./asking.js";
import { kindOf, mark } from "./words.js";

const PAUSE = 80; // milliseconds without a key

export const searchBox = (input, chosen, failed) => {
  const listbox = element("ul", { role: "listbox", id: `${input.id}-found`, "aria-label": "Found", hidden: true });
  const box = element("div", { class: "combobox" });
  input.replaceWith(box);
  box.append(input, listbox);
  const attributes = { role: "combobox", autocomplete: "off", autocapitalize: "off", spellcheck: "false", "aria-autocomplete": "list", "aria-expanded": "false", "aria-controls": listbox.id };
  for (const [name, value] of Object.entries(attributes)) input.setAttribute(name, value);
  let found = [];
  let active = -1;
  let timer = 0;
  let asking = null;

  const close = () => {
    clearTimeout(timer);
    asking?.abort();
    listbox.hidden = true;
    active = -1;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
  };
  const activate = (place) => {
    const options = [...listbox.children];
    if (!found.length) return;
    active = (place + options.length) % options.length;
    options.forEach((option, i) => option.setAttribute("aria-selected", String(i === active)));
    input.setAttribute("aria-activedescendant", options[active].id);
    options[active].scrollIntoView({ block: "nearest" });
  };
  const take = (thing) => {
    input.value = "";
    close();
    chosen(thing);
  };
  const option = (thing, i) =>
    element("li", { role: "option", id: `${listbox.id}-${i}`, "aria-selected": "false", class: "option" },
      element("span", {}, mark(thing), " ", thing.name, thing.states.length ? element("span", {}, ` ${thing.states.join(", ")}`) : null,
        thing.note ? element("small", {}, ` ${thing.note}`) : null),
      element("small", {}, kindOf(thing)));
  const look = async () => {
    asking?.abort();
    if (!input.value.trim()) return close();
    asking = new AbortController();
    try {
      found = await search(input.value, asking.signal);
    } catch (error) {
      if (error.name !== "AbortError") { close(); failed(error); }
      return;
    }
    listbox.replaceChildren(...(found.length ? found.map(option) : [element("li", { class: "option aside" }, "Nothing in this FOON is called so.")]));
    active = -1;
    listbox.hidden = document.activeElement !== input;
    input.setAttribute("aria-expanded", String(!listbox.hidden));
  };
  const fresh = async () => { // what is found for what is typed by now
    if (!listbox.hidden && !timer) return;
    clearTimeout(timer);
    timer = 0;
    await look();
  };
  const keys = {
    ArrowDown: async () => { await fresh(); activate(active + 1); },
    ArrowUp: async () => { await fresh(); activate(active < 0 ? -1 : active - 1); },
    Escape: () => (listbox.hidden ? (input.value = "") : close()),
    Enter: async () => {
      await fresh();
      if (found.length && input.value.trim()) take(found[Math.max(active, 0)]);
    },
  };
  input.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.altKey || event.isComposing) return;
    event.preventDefault();
    keys[event.key]();
  });
  input.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(() => { timer = 0; look(); }, PAUSE);
  });
  input.addEventListener("blur", close);
  listbox.addEventListener("pointerdown", (event) => event.preventDefault()); // the input keeps the focus
  listbox.addEventListener("click", (event) => {
    const place = [...listbox.children].indexOf(event.target.closest("[role=option]"));
    if (place >= 0) take(found[place]);
  });
};
