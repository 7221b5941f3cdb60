// Foods followed through the tree, each in a colour of its own: by buttons, or by a click on what is made of them.

import { element } from "./element.js";

const COLOURS = 6;

const foodsOf = (one) => one.dataset.foods.split("\n");

export const follow = (box, names, unseen) => {
  const drawn = [...box.querySelectorAll("[data-foods]")];
  const there = new Set(drawn.flatMap(foodsOf));
  const foods = [...new Set(names)].filter((name) => there.has(name));
  let chosen = new Set();
  const colour = (name) => `follow-${1 + (foods.indexOf(name) % COLOURS)}`;
  const buttons = foods.map((name) => element("button", { type: "button", class: `small ${colour(name)}`, "aria-pressed": "false", onclick: () => {
    chosen = new Set(chosen.has(name) ? [...chosen].filter((other) => other !== name) : [...chosen, name]);
    show();
  } }, (unseen.has(name) ? "~" : "") + name));
  const show = () => {
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(chosen.has(foods[i]))));
    box.classList.toggle("following", chosen.size > 0);
    for (const one of drawn) {
      const own = foods.find((name) => chosen.has(name) && foodsOf(one).includes(name));
      one.classList.remove(...[...one.classList].filter((word) => word.startsWith("follow")));
      if (own) one.classList.add("followed", colour(own));
    }
  };
  box.addEventListener("click", (event) => {
    const thing = event.target.closest("g[data-foods]:not([data-step])");
    if (!thing) return;
    const own = foodsOf(thing).filter((name) => foods.includes(name));
    const same = own.length === chosen.size && own.every((name) => chosen.has(name));
    chosen = new Set(same ? [] : own);
    show();
  });
  return element("div", { class: "bar", role: "group", "aria-label": "Follow a food" }, element("span", { class: "aside" }, "Follow"), ...buttons);
};
