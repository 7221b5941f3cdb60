// The tree beside its steps: a click on a step in one shows it in the other, and its evidence; below, the life of each ingredient.

import { element, heading, list } from "./element.js";
import { follow } from "./follow.js";
import { picture, staged } from "./picture.js";
import { evidence } from "./steps.js";

export const treeView = (plan, { to, unseen }) => {
  const { parts, box, centre } = staged(plan.pictures.tree, "The task tree, from the kitchen down to the dish");
  const links = plan.sentences.map((text, i) => element("a", { href: to("tree", i + 1) }, `${i + 1}. ${text}`));
  const steps = list(links.map((link, i) => element("li", {}, link, element("div", { class: "where" }, ...evidence(plan, i)))), { class: "plain list", tabindex: "-1" }, "ol");
  const motion = (number) => box.querySelector(`[data-step="${number}"]`);
  const shown = (number) => {
    box.querySelectorAll(".now").forEach((one) => one.classList.remove("now"));
    links.forEach((link, i) => {
      if (i + 1 === number) link.setAttribute("aria-current", "step");
      else link.removeAttribute("aria-current");
    });
    const [now, link] = [motion(number), links[number - 1]];
    if (!now || !link) return;
    now.classList.add("now");
    centre(now);
    const row = link.parentNode; // the list alone is moved, and not the page
    steps.scrollTop = row.offsetTop - steps.offsetTop - (steps.clientHeight - row.clientHeight) / 2;
  };
  box.addEventListener("click", (event) => {
    const number = event.target.closest("[data-step]")?.dataset.step;
    if (number) location.hash = to("tree", number);
  });
  const foods = follow(box, plan.progress_lines.map((line) => line.ingredient), unseen);
  const keys = [["kitchen", "from the kitchen"], ["motion", "as a video has it"], ["changed", "as a video has it of another food"], unseen.size && ["unseen", "~ never seen so"]].filter(Boolean);
  const legend = list(keys.map(([kind, words]) => element("li", {}, element("span", { class: `key ${kind}` }), words)), { class: "legend aside" });
  const part = element("section", {}, foods, element("div", { class: "beside tree" }, element("div", {}, ...parts, legend), steps),
    heading(2, "The life of each ingredient"),
    element("div", { class: "wide", tabindex: "0", role: "group", "aria-label": "Progress lines" }, picture(plan.pictures.progress)));
  return { part, shown };
};
