// The box for questions in Cypher: the named ones with their parameters, or one's own; the answer as a table or drawn.

import { counted, element, errorNotice } from "../element.js";
import { Refusal } from "../api.js";
import { cypher, questions } from "./asking.js";

const at = (id) => document.getElementById(id);
const READ = { STRING: (text) => text, INTEGER: Number, "LIST<STRING>": (text) => text.split(",").map((word) => word.trim()).filter(Boolean) };

// A value of the graph as words: a node is its name, an edge its type.
const words = (value) => {
  if (value === null) return "";
  if (Array.isArray(value)) return value.map(words).join(", ");
  if (typeof value !== "object") return String(value);
  if (value.nodes) return value.nodes.map(words).join(" – ");
  if (value.type && value.properties) return value.type;
  const own = value.labels ? value.properties : value;
  if (value.labels) return [own.label ?? own.verb ?? own.name ?? value.labels.join(":"), own.states?.length ? `(${own.states.join(", ")})` : ""].filter(Boolean).join(" ");
  return Object.entries(own).map(([key, one]) => `${key}: ${words(one)}`).join("; ");
};

const table = ({ columns, rows }) => {
  const side = columns.map((_, i) => (rows.every((row) => row[i] === null || typeof row[i] === "number") ? "number" : null));
  return element("div", { class: "table", tabindex: "0", role: "region", "aria-label": "Answer" },
    element("table", {},
      element("thead", {}, element("tr", {}, ...columns.map((name, i) => element("th", { scope: "col", class: side[i] }, name)))),
      element("tbody", {}, ...rows.map((row) => element("tr", {}, ...row.map((value, i) => element("td", { class: side[i] }, words(value))))))));
};

export const cypherBox = (draw) => {
  let named = [];
  let answered = null;
  const chosen = () => named.find(({ name }) => name === at("question").value);

  const choose = () => {
    const one = chosen();
    at("question-told").textContent = one?.answers ?? "";
    if (one) at("statement").value = one.text;
    at("parameters").replaceChildren(...Object.entries(one?.parameters ?? {}).map(([name, type]) =>
      element("div", { class: "field" },
        element("label", { for: `parameter-${name}` }, name),
        element("input", { id: `parameter-${name}`, "data-name": name, "data-type": type, inputmode: type === "INTEGER" ? "numeric" : null, value: one.examples[name] ?? "" }))));
  };
  const parameters = () => Object.fromEntries([...at("parameters").querySelectorAll("input")].map((input) => [input.dataset.name, READ[input.dataset.type](input.value)]));

  const ask = async () => {
    const text = at("statement").value.trim();
    if (!text) return at("statement").focus();
    at("answer").replaceChildren(element("p", { class: "aside" }, "Asking …"));
    at("draw").hidden = true;
    try {
      answered = await cypher(text, parameters());
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      return at("answer").replaceChildren(errorNotice(error));
    }
    const { rows, cut, things } = answered;
    at("draw").hidden = !things.length;
    const told = rows.length ? `${counted(rows.length, "row")}${cut ? ", and there are more" : ""}.` : "Nothing in this graph answers that.";
    at("answer").replaceChildren(element("p", { class: "aside" }, told), ...(rows.length ? [table(answered)] : []));
    return at("answer").focus({ preventScroll: true });
  };

  at("question").addEventListener("change", choose);
  at("ask").addEventListener("submit", (event) => { event.preventDefault(); ask(); });
  at("ask").addEventListener("keydown", (event) => {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) { event.preventDefault(); ask(); }
  });
  at("draw").addEventListener("click", () => draw(answered));
  return {
    begin: async () => {
      const told = await questions();
      named = told.questions;
      at("cypher").hidden = !told.allowed;
      at("question").replaceChildren(at("question").options[0], ...named.map(({ name }) => element("option", { value: name }, name.replaceAll("_", " "))));
    },
  };
};
