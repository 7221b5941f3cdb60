// An input that completes from the graph, after the combobox pattern of the ARIA Authoring Practices. What the page
// says of it: data-completes, the kind of words, and data-known, what the list of them is called.

import { complete } from "./api.js";
import { element } from "./element.js";

const PAUSE = 90; // milliseconds without a key before the graph is asked
const TYPED = {
  type: "text", role: "combobox", "aria-expanded": "false", "aria-autocomplete": "list", autocomplete: "off", autocapitalize: "none",
  spellcheck: "false", maxlength: "100",
};

// The list of words below an input, in a box around both.
const listed = (input) => {
  const listbox = element("ul", { id: `${input.id}-list`, role: "listbox", "aria-label": input.dataset.known, hidden: true });
  const box = element("div", { class: "combobox" });
  input.replaceWith(box);
  box.append(input, listbox);
  for (const [name, value] of Object.entries({ ...TYPED, "aria-controls": listbox.id })) input.setAttribute(name, value);
  return listbox;
};

export const combobox = (input, chosen) => {
  const listbox = listed(input);
  let active = -1;
  let asking = null;
  let timer = 0;

  const options = () => [...listbox.children];
  const close = () => {
    clearTimeout(timer);
    asking?.abort();
    listbox.hidden = true;
    active = -1;
    input.setAttribute("aria-expanded", "false");
    input.removeAttribute("aria-activedescendant");
  };
  const activate = (place) => {
    const all = options();
    active = all.length ? (place + all.length) % all.length : -1;
    all.forEach((option, i) => option.setAttribute("aria-selected", String(i === active)));
    if (active < 0) return;
    input.setAttribute("aria-activedescendant", all[active].id);
    all[active].scrollIntoView({ block: "nearest" });
  };
  const take = (text) => {
    input.value = text;
    close();
    chosen(text);
  };
  const show = (words) => {
    const made = words.map((word, i) =>
      element("li", { role: "option", id: `${listbox.id}-${i}`, "aria-selected": "false" }, word));
    listbox.replaceChildren(...made);
    listbox.hidden = !words.length;
    input.setAttribute("aria-expanded", String(words.length > 0));
    active = -1;
    input.removeAttribute("aria-activedescendant");
  };
  const look = async () => {
    asking?.abort();
    if (!input.value.trim()) return close();
    asking = new AbortController();
    try {
      const words = await complete(input.dataset.completes, input.value, asking.signal);
      if (document.activeElement === input) show(words);
    } catch (error) {
      if (error.name !== "AbortError") close(); // one can type on without completion
    }
  };

  const keys = {
    ArrowDown: () => (listbox.hidden ? look() : activate(active + 1)),
    ArrowUp: () => (listbox.hidden ? look() : activate(active < 0 ? -1 : active - 1)),
    Escape: () => (listbox.hidden ? (input.value = "") : close()),
  };
  input.addEventListener("keydown", (event) => {
    if (event.key === "Enter" && !event.ctrlKey && !event.metaKey && active >= 0) {
      event.preventDefault();
      event.stopImmediatePropagation();
      take(options()[active].textContent);
    } else if (keys[event.key] && !event.altKey) {
      event.preventDefault();
      keys[event.key]();
    }
  });
  input.addEventListener("input", () => {
    clearTimeout(timer);
    timer = setTimeout(look, PAUSE);
  });
  input.addEventListener("blur", close);
  listbox.addEventListener("pointerdown", (event) => event.preventDefault()); // the input keeps the focus
  listbox.addEventListener("click", (event) => {
    const option = event.target.closest("[role=option]");
    if (option) take(option.textContent);
  });
  return { close };
};
