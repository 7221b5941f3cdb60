// The page /teach: a draft row by row, each beside what was said; what is decided is kept in this browser until it is closed.

import { Refusal, ask, askToken, onToken, tokenFromAddress } from "../api.js";
import { download } from "../download.js";
import { counted, errorNotice } from "../element.js";
import { rowView } from "./row.js";

const KEPT = "foon-teach";
const MOST_UNDONE = 50;

const at = (id) => document.getElementById(id);
const say = (text) => { at("status").textContent = text; };
const post = (path, body) =>
  ask(path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });

let review = null; // the last answer
let before = []; // the tables before it

const keep = () => {
  try {
    localStorage.setItem(KEPT, JSON.stringify({ name: review.name, table: review.table }));
  } catch {
    say("This browser keeps nothing: download the draft before you leave.");
  }
};

const failed = (error) => {
  if (!(error instanceof Refusal)) throw error;
  at("trouble").replaceChildren(errorNotice(error));
  if (error.status === 401) askToken();
};

const look = async (question) => {
  at("rows").setAttribute("aria-busy", "true");
  try {
    const told = await post("teach/review", question);
    at("trouble").replaceChildren();
    return told;
  } catch (error) {
    failed(error);
    return null;
  } finally {
    at("rows").removeAttribute("aria-busy");
  }
};

const shown = (row) => row.reasons.length > 0 || at("all").checked;

const draw = () => {
  at("draft").hidden = !review;
  at("open").hidden = !!review;
  if (!review) return;
  at("draft-title").textContent = review.name;
  at("told").textContent = review.open
    ? `${counted(review.open, "row")} to decide, ${counted(review.units, "unit")}`
    : `All is decided: ${counted(review.units, "unit")}. foon load foon ${review.name}.txt brings them into the FOON.`;
  at("undo").disabled = !before.length;
  at("done").disabled = !review.units || review.open > 0;
  at("rows").replaceChildren(...review.rows.filter(shown).map((row) => rowView(row, decide)));
};

// The row that stands there next, or the last one, or what is left to do.
const focusOn = (place) => {
  const rows = [...at("rows").querySelectorAll("li[data-open]")];
  const next = rows.find((row) => Number(row.dataset.place) >= place) ?? rows[0];
  (next?.querySelector("button") ?? at(review.open ? "rows" : "done")).focus();
};

const WORDS = { accept: "Accepted", edit: "Changed", drop: "Left out" };
const decide = async (place, what, cells) => {
  const told = await look({ name: review.name, table: review.table, decision: { place, what, ...(cells ? { cells } : {}) } });
  if (!told) return false;
  before = [...before, review.table].slice(-MOST_UNDONE);
  review = told;
  keep();
  draw();
  focusOn(place);
  say(`${WORDS[what]}. ${told.open ? `${counted(told.open, "row")} left.` : "All is decided."}`);
  return true;
};

const begin = async (name, table) => {
  const told = await look({ name, table });
  if (!told) return;
  review = told;
  before = [];
  keep();
  draw();
  say("");
  focusOn(0);
};

at("file").addEventListener("change", async () => {
  const [file] = at("file").files;
  if (!file) return;
  const name = file.name.replace(/\.csv$/i, "").replace(/[^\w.-]+/g, "_").slice(0, 100) || "draft";
  await begin(name, await file.text());
  at("file").value = "";
});
at("open").addEventListener("submit", (event) => event.preventDefault());
at("undo").addEventListener("click", async () => {
  const table = before.at(-1);
  const told = await look({ name: review.name, table });
  if (!told) return;
  before = before.slice(0, -1);
  review = told;
  keep();
  draw();
  focusOn(0);
  say("Undone.");
});
at("keep").addEventListener("click", () => download(`${review.name}.csv`, review.table, "text/csv"));
at("done").addEventListener("click", async () => {
  try {
    const told = await post("teach/subgraph", { name: review.name, table: review.table });
    download(told.file, told.text, "text/plain");
    say(`${told.file} is downloaded.`);
  } catch (error) {
    failed(error);
  }
});
at("close").addEventListener("click", () => {
  localStorage.removeItem(KEPT);
  review = null;
  before = [];
  draw();
  say("");
  at("file").focus();
});
at("all").addEventListener("change", draw);
onToken(() => {
  at("token").hidden = true;
  at("trouble").replaceChildren();
  resume();
});

const resume = () => {
  const kept = JSON.parse(localStorage.getItem(KEPT) ?? "null");
  if (kept) begin(kept.name, kept.table);
};

tokenFromAddress();
resume();
