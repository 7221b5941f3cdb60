// What is told of a thing or of a way, beside the picture.

import { counted, element, heading, list } from "../element.js";
import { minutes } from "../nodes.js";
import { fullName, kindOf, mark, thingButton } from "./words.js";

// What an edge says of the other thing: as its target, and as its source.
const SAID = {
  takes: ["Is taken by", "Takes"], makes: ["Makes", "Is made by"], called: ["Is called", "Seen as"], contains: ["Is made of", "Is part of"],
  motion: ["Is the motion", "Done in the steps"], "seen in": ["Seen in", "Shows the steps"], type: ["Is of the type", "Dishes"], shows: ["Shows how to make", "Made in"],
};
const LONG = 24; // letters: longer words stand in lines of their own

const place = ({ video, step, start, address }) => {
  const words = `${video}, ${start === null ? `step ${step + 1}` : `at ${minutes(start)}`}`;
  return address ? element("a", { href: address, target: "_blank", rel: "noreferrer noopener" }, words) : words;
};

const facts = (about) => about.facts.flatMap(({ name, words }) => [
  heading(3, name), list(words, { class: words.some((word) => word.length > LONG) ? "facts long" : "facts" })]);

const neighbours = (next, choose) => {
  const groups = new Map();
  for (const { kind, inward, thing } of next) {
    const said = (SAID[kind] ?? [kind, `${kind} of`])[inward ? 1 : 0];
    groups.set(said, [...(groups.get(said) ?? []), thing]);
  }
  return [...groups].flatMap(([said, things]) => [heading(3, said), list(things.map((thing) => [thingButton(thing, () => choose(thing))]), { class: "plain" })]);
};

const belongings = (links, act) => (links.length
  ? [heading(3, "Belongs to"), list(links.map((one) => [thingButton(one, () => act.grow(one))]), { class: "plain" })] : []);

export const thingView = (thing, about, { next, more, act }) => [
  heading(2, thing.name),
  element("p", { class: "kind" }, mark(thing), " ", kindOf(thing), !["step", "other"].includes(thing.kind) && (thing.states.length || thing.note) ? `: ${[thing.states.join(", "), thing.note].filter(Boolean).join("; ")}` : ""),
  element("p", {}, about.text),
  element("div", { class: "actions" },
    more ? element("button", { type: "button", class: "small", onclick: () => act.grow(thing) }, `${counted(more, "more thing")} around it`) : null,
    thing.kind === "other" ? null : element("button", { type: "button", class: "small", onclick: () => act.show(thing) }, "Begin anew here"),
    thing.kind === "object" || thing.kind === "food" ? element("button", { type: "button", class: "small", onclick: () => act.end("start", thing) }, "Way from here") : null,
    thing.kind === "object" || thing.kind === "food" ? element("button", { type: "button", class: "small", onclick: () => act.end("end", thing) }, "Way to here") : null,
    element("button", { type: "button", class: "small", onclick: () => act.remove(thing) }, "Take it out")),
  ...facts(about),
  about.places.length ? heading(3, "Where it is seen") : null,
  about.places.length ? list(about.places.map((one) => [place(one)])) : null,
  ...belongings(about.links.filter(({ id }) => !next.some((one) => one.thing.id === id)), act),
  ...neighbours(next, act.choose),
].filter(Boolean);

export const wayView = (told, act) => [
  heading(2, `${counted(told.steps.length, "step")} from ${said(told.stops[0].thing)} to ${said(told.stops.at(-1).thing)}`),
  element("p", { class: "aside" }, "The shortest way in this FOON. It follows the food, and a vessel only where a step tells no more of what is in it."),
  list(told.steps.map(({ thing, places }, i) => [
    thingButton(thing, () => act.choose(thing)),
    element("div", { class: "aside" }, "then: ", fullName(told.stops[i + 1].thing), places.length ? " · " : "", places.length ? place(places[0]) : null),
  ]), { class: "steps" }, "ol"),
];

const said = (thing) => [...thing.states, thing.name].join(" ");

export const beginView = (things, choose) => [
  heading(2, "Where to begin"),
  element("p", {}, "Search for a food, a utensil, a motion, a video or a type of dish, or take one of these."),
  list(things.map((thing) => [thingButton(thing, () => choose(thing))]), { class: "plain" }),
];
