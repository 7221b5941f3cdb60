// Object nodes, units and where they were seen, as people read them.

import { element } from "./element.js";

const lookAt = (label) => `explore#at=${encodeURIComponent(label)}`;

export const nodeWords = (node, unseen = new Map()) => {
  const like = unseen.get(node.label);
  const name = element("a", { class: like ? "link unseen" : "link", href: lookAt(like ? like.equivalent : node.label),
    title: like ? `like ${like.equivalent} ${like.confidence.toFixed(2)}` : null }, (like ? "~" : "") + node.label);
  const place = node.container ? `${node.relation ?? "at"} ${node.container}` : "";
  if (!node.states.length && !place) return [name];
  const words = [name, " ("];
  if (node.states.length) words.push(element("span", { class: "state" }, node.states.join(", ")));
  if (node.states.length && place) words.push("; ");
  if (place) words.push(element("span", { class: "aside" }, place));
  return [...words, ")"];
};

// The same for who stands beside it: nothing to click, and what a vessel holds instead of that it is empty.
export const thingWords = (node, unseen = new Map()) => {
  const about = [...node.states.filter((state) => state !== "empty"), node.ingredients.length && `with ${node.ingredients.join(", ")}`,
    node.container && `${node.relation ?? "at"} ${node.container}`].filter(Boolean).join("; ");
  const like = unseen.get(node.label);
  return [like ? element("span", { class: "unseen", title: `like ${like.equivalent}` }, `~${node.label}`) : node.label, about ? element("span", { class: "aside" }, ` ${about}`) : ""];
};

const joined = (nodes, unseen) => nodes.flatMap((node, i) => (i ? [" + ", ...nodeWords(node, unseen)] : nodeWords(node, unseen)));

export const minutes = (seconds) => `${Math.floor(Math.round(seconds) / 60)}:${String(Math.round(seconds) % 60).padStart(2, "0")}`;

// Where a unit is seen; `address` leads there.
// A video, or the draft of a recipe.
export const named = (video) => (video.startsWith("draft:") ? `draft ${video.slice(6)}` : `video ${video}`);

export const seenWords = (seen, address) => {
  if (!seen) return null;
  const when = seen.start === null ? "" : ` at ${minutes(seen.start)}`;
  if (!address) return element("span", { class: "seen aside" }, `${named(seen.video)}${when}`);
  const link = { href: address, target: "_blank", rel: "noreferrer noopener" };
  return element("span", { class: "seen" }, element("a", link, `${named(seen.video)}${when}`));
};

export const unitWords = (unit, unseen) => [
  ...joined(unit.input_nodes, unseen), " → ", element("span", { class: "motion" }, unit.motion_node), " → ",
  ...joined(unit.output_nodes, unseen),
];
