// The API of the explorer, as functions.

import { ask } from "../api.js";

const post = (path, body) =>
  ask(`explore/${path}`, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(body) });

export const begin = () => ask("explore/begin");
export const search = (text, signal) => ask(`explore/search?${new URLSearchParams({ text, limit: 14 })}`, { signal });
export const around = (id, how) => post("around", { id, ...how });
export const way = (start, end, filters) => post("way", { start, end, ...filters });
export const questions = () => ask("explore/questions");
export const cypher = (text, parameters) => post("cypher", { text, parameters });
