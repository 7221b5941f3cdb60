// To cook by: one step at a time. Where one is, what is done and what is bought are kept in this browser, so that a
// screen that locks or a page that is closed costs nothing; while it is in sight the screen stays on, where it can.

import { meanwhile, needs } from "./cook_needs.js";
import { keeper } from "./cook_place.js";
import { timers } from "./cook_timers.js";
import { element, heading, list } from "./element.js";
import { thingWords } from "./nodes.js";
import { besides, buying, evidence, marked } from "./steps.js";
import { awake } from "./wake.js";

const PHASES = { prepare: "making ready", heat: "cooking", finish: "serving" };
const SWIPE = 50; // pixels

const about = ({ low, high }) => (Math.round(low) === Math.round(high) ? `${Math.round(low)} s` : `${Math.round(low)} to ${Math.round(high)} s`);

export const cookView = (plan, { key, unseen, to }) => {
  const last = plan.units.length + 1; // 0 is what to have ready, and this one the end
  const kept = keeper(key, plan.units.length);
  const timing = new Map(plan.schedules[0].steps.map((one) => [one.unit, one]));
  const clock = timers(kept, (step) => `${step}. ${plan.units[step - 1].motion_node}`, (step) => go(step));
  const said = element("div", { "aria-live": "polite" });
  const rest = element("div", {});
  const bar = element("progress", { max: plan.units.length, "aria-label": "Steps that are done" });
  const button = (attributes, words, does) => element("button", { type: "button", ...attributes, onclick: does }, words);
  const back = button({ "aria-label": "Step before" }, "‹", () => go(kept.place - 1));
  const next = button({ "aria-label": "Next step" }, "›", () => go(kept.place + 1));
  const tick = button({ class: "main" }, "", () => {
    if (kept.place === 0) return go(1);
    if (kept.place === last) return anew();
    const did = kept.toggle("done", kept.place);
    return did ? go(kept.place + 1) : show();
  });
  const screen = element("p", { class: "aside" });
  const card = element("div", { class: "card now-doing" }, said, rest);
  const part = element("section", { class: "cook" }, clock.part, bar, card,
    element("div", { class: "controls" }, back, tick, next),
    element("p", { class: "aside fine" }, "Arrow keys and swipes go from step to step."), screen);

  const words = (node) => thingWords(node, unseen);
  const row = (title, items) => (items.length ? [heading(2, title), list(items, { class: "things" })] : []);
  const jump = (i) => element("a", { href: to("cook", i + 1) }, `${i + 1}. ${plan.sentences[i]}`);

  // A video shows how long somebody's own work takes; of what cooks or goes on by itself only a recipe says how long.
  const timer = (i) => {
    const { duration, hands } = timing.get(i);
    const said = duration && !duration.sightings ? duration.median : 0;
    if (hands !== null && !said) return duration ? [element("p", { class: "aside" }, `Takes ${about(duration)} in videos.`)] : [];
    const others = hands === null ? meanwhile(plan.units, i).map((j) => element("li", {}, jump(j))) : [];
    return [heading(2, hands === null ? "It goes on by itself" : "How long"), clock.setter(i + 1, said),
      said ? "" : element("p", { class: "aside" }, "Videos cut this short: set the time that you know."),
      ...(others.length ? [heading(2, "Meanwhile"), list(others, { class: "plain" })] : [])];
  };

  const stepShown = (i) => {
    const [fresh, there] = needs(plan.units, i);
    const after = i + 1 < plan.units.length ? plan.sentences[i + 1] : "That was the last step.";
    said.replaceChildren(
      element("p", { class: "count" }, `Step ${i + 1} of ${plan.units.length}`, PHASES[plan.units[i].phase] ? ` · ${PHASES[plan.units[i].phase]}` : "", kept.has("done", i + 1) ? " · ✓ done" : ""),
      element("p", { class: "big" }, ...marked(plan.sentences[i], unseen)));
    rest.replaceChildren(
      ...row("Take", fresh.map(words)), ...row("At hand", there.map(words)),
      ...timer(i),
      element("p", { class: "aside" }, ...evidence(plan, i), " · ", element("a", { href: to("tree", i + 1) }, "in the tree")),
      element("p", { class: "next" }, element("strong", {}, "Next: "), after));
  };
  const readyShown = () => {
    said.replaceChildren(element("p", { class: "count" }, "Before you begin"), element("p", { class: "big" }, "Have this ready."));
    const box = (told, i) => element("label", { class: "tick" }, element("input", { type: "checkbox", checked: kept.has("bought", i), onchange: () => kept.toggle("bought", i) }), element("span", {}, ...told));
    rest.replaceChildren(heading(2, "Shopping list"), list(buying(plan, words).map((told, i) => element("li", {}, box(told, i))), { class: "plain columns" }),
      ...row("Utensils, and what is always there", besides(plan).map(words)));
  };
  const endShown = () => {
    const open = plan.units.map((_, i) => i).filter((i) => !kept.has("done", i + 1));
    said.replaceChildren(element("p", { class: "count" }, "The end"), element("p", { class: "big" }, open.length ? "Not all steps are ticked off." : `The ${plan.goal.label} is ready. Enjoy it!`));
    rest.replaceChildren(list(open.map(jump), { class: "plain" }));
  };
  const show = () => {
    const { place } = kept;
    if (place === 0) readyShown();
    else if (place === last) endShown();
    else stepShown(place - 1);
    bar.value = kept.count("done");
    back.setAttribute("aria-disabled", String(place === 0));
    next.setAttribute("aria-disabled", String(place === last));
    tick.textContent = place === 0 ? "Begin" : place === last ? "Cook it again" : kept.has("done", place) ? "Not done after all" : "✓ Done";
  };
  const go = (place) => {
    kept.place = Math.min(Math.max(place, 0), last);
    show();
    card.scrollTop = 0;
    if (document.body.dataset.view === "cook") history.replaceState(null, "", to("cook", kept.place || null));
  };
  const anew = () => { kept.clear(); clock.show(); go(0); };

  const light = awake((stays) => { screen.textContent = stays ? "The screen stays on while this is in sight." : "The screen may go dark: your place is kept."; });
  const keys = { ArrowRight: 1, ArrowLeft: -1 };
  const pressed = (event) => {
    if (!keys[event.key] || event.altKey || event.ctrlKey || event.metaKey || event.target.matches("input")) return;
    event.preventDefault();
    go(kept.place + keys[event.key]);
  };
  let finger = null;
  card.addEventListener("touchstart", ({ touches }) => { finger = touches.length === 1 ? touches[0] : null; }, { passive: true });
  card.addEventListener("touchend", ({ changedTouches: [end] }) => {
    const [dx, dy] = finger ? [end.clientX - finger.clientX, end.clientY - finger.clientY] : [0, 0];
    if (Math.abs(dx) > SWIPE && Math.abs(dx) > 2 * Math.abs(dy)) go(kept.place - Math.sign(dx));
  });
  const shown = (step) => {
    document.addEventListener("keydown", pressed);
    light.on();
    go(step ?? (kept.place === last ? 0 : kept.place));
  };
  const left = () => {
    document.removeEventListener("keydown", pressed);
    light.off();
  };
  show();
  return { part, shown, left };
};
