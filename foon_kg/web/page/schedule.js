// Who does what when: a chart for each number of pairs of hands, one at a time, and the same as a table.

import { element, heading } from "./element.js";
import { minutes } from "./nodes.js";
import { picture } from "./picture.js";

const pairs = (hands) => (hands === 1 ? "one pair of hands" : `${hands} pairs of hands`);

export const scheduleView = (plan) => {
  const parts = plan.schedules.map((one, i) => element("div", { hidden: i > 0 }, chart(plan.pictures.schedules[i], one), table(plan, one)));
  const buttons = plan.schedules.map((one, i) =>
    element("button", { type: "button", class: "small", "aria-pressed": String(i === 0), onclick: () => show(i) },
      pairs(one.hands) + (one.untimed ? "" : `, ${minutes(one.length)}`)));
  const show = (chosen) => {
    parts.forEach((part, i) => { part.hidden = i !== chosen; });
    buttons.forEach((button, i) => button.setAttribute("aria-pressed", String(i === chosen)));
  };
  return { part: element("section", {}, heading(2, "Who does what when"), element("div", { class: "bar", role: "group", "aria-label": "How many cook" }, ...buttons), ...parts) };
};

const chart = (text, one) =>
  element("div", { class: "wide", tabindex: "0", role: "group", "aria-label": `Schedule for ${pairs(one.hands)}` }, picture(text));

const table = (plan, one) => {
  const row = (step) => {
    return element("tr", {}, ...[when(one, step.start), when(one, step.end), step.hands === null ? "by itself" : String(step.hands + 1),
      `${step.unit + 1}. ${plan.sentences[step.unit]}`, seen(step.duration)].map((words) => element("td", {}, words)));
  };
  const head = ["From", "To", "Hands", "Step", "Seen"].map((words) => element("th", { scope: "col" }, words));
  return element("details", {}, element("summary", {}, "The same as a table"),
    element("div", { class: "wide", tabindex: "0", role: "group", "aria-label": "Table of the schedule" },
      element("table", {}, element("thead", {}, element("tr", {}, ...head)), element("tbody", {}, ...one.steps.map(row)))));
};

// Behind the first step whose time nobody knows no time is known.
const when = ({ steps }, seconds) => (steps.some((step) => !step.duration && step.start < seconds) ? "unknown" : minutes(seconds));

const seen = (duration) => {
  if (!duration) return "unknown";
  if (!duration.sightings) return `${minutes(duration.median)}, as a recipe says`;
  const [low, high] = [duration.low, duration.high].map((one) => Math.round(one));
  return `${duration.sightings === 1 ? "once" : `${duration.sightings} times`}, ${low === high ? low : `${low} to ${high}`} s`;
};
