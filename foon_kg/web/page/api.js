// The API of this service, as functions. What it refuses is thrown as a Refusal, with what to do about it.

const HANDS = [1, 2]; // for so many pairs a schedule is shown
const KEPT = "foon-token";

export class Refusal extends Error {
  constructor(status, told, notes = []) { // notes: what had to be decided to read the question
    super(told.message);
    this.status = status;
    this.code = told.code;
    this.hint = told.hint;
    this.missing = told.missing ?? [];
    this.notes = notes;
  }
}

const keepToken = (token) => sessionStorage.setItem(KEPT, token);
const at = (id) => document.getElementById(id);

// Ask for the token, and say so if there is one that is not it.
export const askToken = () => {
  at("token-wrong").textContent = sessionStorage.getItem(KEPT) ? "That is not its token." : "";
  at("token").hidden = false;
  at("token-text").focus();
  at("token-text").select();
};

export const onToken = (then) => at("token-form").addEventListener("submit", (event) => {
  event.preventDefault();
  keepToken(at("token-text").value.trim());
  then();
});

// The part of an address after # is never sent to a server, and it is taken away before anybody reads it here.
export const tokenFromAddress = () => {
  const token = new URLSearchParams(location.hash.slice(1)).get("token");
  if (!token) return;
  keepToken(token);
  history.replaceState(null, "", location.pathname);
};

export const ask = async (path, options = {}) => {
  const token = sessionStorage.getItem(KEPT);
  const headers = { ...options.headers, ...(token ? { Authorization: `Bearer ${token}` } : {}) };
  let answer;
  try {
    answer = await fetch(`api/${path}`, { ...options, headers });
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Refusal(0, { code: "offline", message: "The service does not answer.", hint: "Is foon serve still running?" });
  }
  const told = await answer.json().catch(() => ({}));
  if (!answer.ok) throw new Refusal(answer.status, told.error ?? { code: "http", message: answer.statusText, hint: "" }, told.notes ?? []);
  return told;
};

const query = (fields) => new URLSearchParams(fields).toString();
const post = (path, body) =>
  ask(path, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });

export const summary = () => ask("summary");
export const examples = () => ask("examples");
export const complete = (kind, text, signal) => ask(`complete?${query({ kind, text, limit: 12 })}`, { signal });
export const plan = (question, pictures = true) => post("plan", { ...question, explain: true, hands: HANDS, pictures, picture_width: matchMedia("(max-width: 700px)").matches ? 326 : 1100 });
export const exported = async (question, form) => (await post("plan", { ...question, export: form })).files;
export const suggest = (foods, kitchen) => post("suggest", { foods, kitchen });
