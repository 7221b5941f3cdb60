// A plan beside another one: the same recipe with another wish, in another kitchen, as another dish. What differs is
// marked. Both questions are in the address.

import { fromAddress, toAddress } from "./address.js";
import { plan as planned, Refusal } from "./api.js";
import { rivals } from "./compare_with.js";
import { alike, beside, words } from "./differences.js";
import { counted, element, errorNotice, heading, list } from "./element.js";
import { buying, madeLike } from "./steps.js";

export const compareView = (plan, { asked, to }) => {
  const body = element("div", {});
  const said = element("p", { class: "differs", role: "status" });
  const all = element("button", { type: "button", class: "small", "aria-pressed": "false", onclick: () => {
    all.setAttribute("aria-pressed", String(body.classList.toggle("only")));
  } }, "Only what differs");
  const bar = element("div", { class: "titled" }, said, all);
  const cards = element("div", {});
  const part = element("section", {}, cards, bar, body);
  const known = new Map(); // the other plans, by their addresses
  let turn = 0;
  const told = (address, question) => {
    if (!known.has(address)) known.set(address, planned(question, false));
    return known.get(address);
  };
  const shown = async (_, address) => {
    const mine = ++turn;
    part.setAttribute("aria-busy", String(Boolean(address)));
    [bar.hidden, all.hidden, said.textContent] = [!address, true, ""];
    cards.replaceChildren();
    if (!address) return body.replaceChildren(...rivals(plan, asked, to));
    const { question } = fromAddress(address);
    const sides = [{ letter: "A", plan, question: asked, name: apart(asked, question) }, { letter: "B", question, name: apart(question, asked) }];
    cards.replaceChildren(...heads(sides, to));
    body.replaceChildren();
    try {
      sides[1].plan = await told(address, question);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      known.delete(address);
      sides[1].error = error;
    }
    if (mine !== turn) return;
    const [differs, tables] = sides[1].plan ? rows(sides) : ["", []];
    cards.replaceChildren(...heads(sides, to));
    body.replaceChildren(...tables);
    [all.hidden, said.textContent] = [!tables.length, differs];
    part.setAttribute("aria-busy", "false");
  };
  return { part, shown };
};

// What a question asks that the other one does not.
const apart = (one, other) => {
  const only = (name, list) => one[name].filter((word) => !other[name].includes(word)).slice(0, 4).map((word) => `${list} ${word}`);
  const likes = ({ substitutes }) => substitutes.map(({ food, like }) => `${food} like ${like}`);
  const kitchen = String(one.kitchen) === String(other.kitchen) ? [] : [one.kitchen.length ? `with ${one.kitchen.slice(0, 6).join(", ")}${one.kitchen.length > 6 ? ", …" : ""} at hand` : "with everything at hand"];
  return [...(one.dish_type === other.dish_type ? [] : [`as ${one.dish_type || "any dish"}`]), ...only("ingredients", "with"), ...only("avoid", "without"),
    ...likes(one).filter((word) => !likes(other).includes(word)), ...kitchen, ...((one.title ?? "") === (other.title ?? "") ? [] : [one.title ? `called ${one.title}` : "without a name"]), ...(one.after === other.after ? [] : [one.after ? `after ${one.after}` : "after the dish that suits best"]), ...(one.with_drafts === other.with_drafts ? [] : [one.with_drafts ? "drafts, too" : "videos alone"])].join(", ") || "as asked";
};

const heads = (sides, to) => [
  element("p", {}, element("a", { href: to("compare") }, "Compare with something else")),
  element("div", { class: "sides" }, ...sides.map(({ letter, plan, question, name, error }) => element("div", { class: "card" },
    element("h2", {}, element("span", { class: "sign" }, letter), ` ${name}`),
    ...(plan ? figures(plan) : []),
    error ? errorNotice(error) : plan ? "" : element("p", { class: "aside" }, "Planning …"),
    element("p", {}, element("a", { href: toAddress(question) }, "Open this plan"))))),
];

const figures = (plan) => {
  const { findings } = plan.judged;
  return [element("p", {}, element("strong", {}, plan.goal.label), `, ${counted(plan.units.length, "step")}`),
    element("p", { class: "aside" }, `${madeLike(plan)} of video ${plan.reference.videos.join(", ")}. The judge `, findings.length ? `objects to ${counted(findings.length, "thing")}.` : "objects to nothing.")];
};

const rows = (sides) => {
  const [a, b] = sides.map(({ plan }) => plan);
  const found = [["ingredient", "Ingredients", byName(a, b, things)], ["substitution", "What stands for what", byName(a, b, stands)], ["step", "Steps", steps(a, b)]];
  const parts = found.filter(([, , rows]) => rows.length).map(([word, title, rows]) => [title, list(rows, { class: "compared" }), word]);
  const differ = parts.map(([, rows]) => rows.querySelectorAll(":scope > :not(.both)").length);
  const summary = parts.flatMap(([, , word], i) => (differ[i] ? [counted(differ[i], word)] : [])).join(", ");
  return [summary ? `What differs: ${summary}.` : "Nothing differs.",
    parts.flatMap(([title, rows], i) => [heading(2, title), differ[i] ? "" : element("p", { class: "aside" }, "The same in both."), rows].filter(Boolean)),
  ];
};

// A row of two cells (null: there is none). What one plan alone has says so in words: colour is not enough.
const row = (one, other, kind) => {
  const cell = (content, side) => element("div", { class: "cell" }, ...(content ?? []),
    content && kind !== "both" ? element("span", { class: "sign" }, kind === "changed" ? side : `only ${side}`) : "");
  return element("li", { class: kind }, cell(one, "A"), cell(other, "B"));
};
const kindOf = (one, other, same) => (!other ? "one" : !one ? "other" : same ? "both" : "changed");

const marked = (one, other) => {
  if (!one || !other) return [one && [one], other && [other]];
  return words(one, other).map((all) => all.flatMap(({ word, both }) => [both ? word : element("mark", {}, word), " "]));
};

const steps = (a, b) => {
  const [first, second] = [a, b].map((plan) => plan.sentences);
  const changed = (x, y) => alike(x, y) && !second.includes(x) && !first.includes(y); // what is done elsewhere is no other step
  const found = beside(first, second, (x, y) => x === y, changed);
  const alone = [0, 1].map((side) => new Map(found.filter((pair) => pair[1 - side] === null).map((pair) => [[first, second][side][pair[side]], pair[side]])));
  return found.map(([i, j]) => {
    const [one, other] = [first[i], second[j]];
    const [left, right] = marked(one, other);
    const numbered = (place, content) => content && [element("span", { class: "number" }, `${place + 1}. `), ...content];
    const elsewhere = one && !other ? alone[1].get(one) : other && !one ? alone[0].get(other) : undefined;
    const made = row(numbered(i, left), numbered(j, right), kindOf(one, other, one === other));
    if (elsewhere !== undefined) made.querySelector(".sign").textContent = `in ${one ? "B" : "A"} as step ${elsewhere + 1}`;
    return made;
  });
};

// What both plans name, by a name that tells it from others: [name, what is said of it].
const byName = (a, b, said) => {
  const [first, second] = [a, b].map((plan) => new Map(said(plan)));
  return [...new Set([...first.keys(), ...second.keys()])].sort().map((name) => {
    const [one, other] = [first.get(name), second.get(name)];
    return row(...marked(one, other), kindOf(one, other, one === other));
  });
};

const plain = (node) => [node.label + (node.states.length ? ` (${node.states.join(", ")})` : "")];
const things = (plan) => buying(plan, plain).map((told, i) => {
  const { label } = plan.shopping[i];
  return [`${label} ${plan.shopping.slice(0, i).filter((one) => one.label === label).length}`, told.join("").trim()];
});
const stands = (plan) => plan.substitutions.map((one) => [`${one.kind} ${one.object} ${one.kind === "object" ? "" : one.required}`,
  one.kind === "object" ? `${one.object} like ${one.equivalent} ${one.confidence.toFixed(2)}` : `${one.required} ${one.object} like ${one.equivalent} ${one.object} ${one.confidence.toFixed(2)}`]);
