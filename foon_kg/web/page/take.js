// To take a plan along: its address, on paper, and as files of every export.

import { exported, Refusal } from "./api.js";
import { download } from "./download.js";
import { element, sentence } from "./element.js";

const FORMS = { markdown: "recipe (Markdown)", foon: "FOON text", json: "FOON JSON", mermaid: "Mermaid", dot: "DOT", graphml: "GraphML",
  "behaviour-tree": "behaviour tree (XML)", pddl: "PDDL" };

export const takeAlong = (asked) => {
  const said = element("span", { class: "aside", role: "status" });
  const form = element("select", { "aria-label": "Form of the download" }, ...Object.entries(FORMS).map(([value, words]) => element("option", { value }, words)));
  const button = (words, does) => element("button", { type: "button", class: "small", onclick: does }, words);
  const share = async () => {
    try {
      if (navigator.share) return await navigator.share({ title: document.title, url: location.href });
      await navigator.clipboard.writeText(location.href);
      said.textContent = "The address is copied.";
    } catch {
      said.textContent = "Copy the address of this page: it leads to this plan."; // refused, or given up
    }
    return undefined;
  };
  const save = async () => {
    said.textContent = "Writing …";
    try {
      const files = await exported(asked, form.value);
      files.forEach(({ name, text }) => download(name, text));
      said.textContent = `${files.map(({ name }) => name).join(", ")} is in your downloads.`;
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      said.textContent = sentence(error.message);
    }
  };
  return element("div", { class: "bar take" }, button("Share", share), button("Print", () => print()), form, button("Download", save), said);
};
