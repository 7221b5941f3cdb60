// One row of a draft: what was said on one side, the unit made of it on the other, why it is asked, and what to do with it.

import { element, list } from "../element.js";

const FIELDS = [["motion", "Motion"], ["inputs", "Inputs"], ["outputs", "Outputs"], ["dish", "Dish type"]];
const KINDS = { "doubt": "Doubt", "no unit": "No unit", "from nowhere": "From nowhere", "unknown": "Unknown word" };

const when = (row) => (row.at
  ? element("a", { href: row.at, target: "_blank", rel: "noreferrer" }, `video at ${row.moment}`)
  : row.moment ? element("span", { class: "aside" }, row.moment) : null);

const saidView = (row) =>
  element("div", { class: "said" }, element("p", {}, row.said || element("span", { class: "aside" }, "Nobody says anything here.")), when(row));

const unitView = (row) => element("div", { class: "unit" },
  element("p", {}, row.sentence === null ? element("em", {}, "No unit.") : element("strong", {}, row.sentence)),
  row.cells.motion ? element("dl", {}, ...FIELDS.filter(([name]) => row.cells[name]).flatMap(([name, label]) => [element("dt", {}, label), element("dd", {}, row.cells[name])])) : null);

const reasonsView = (row) => (row.reasons.length
  ? list(row.reasons.map((reason) => [element("strong", {}, `${KINDS[reason.kind]}: `), reason.text]), { class: "reasons" }) : null);

const editor = (row, decide, closed) => {
  const boxes = FIELDS.map(([name, label]) => {
    const id = `edit-${row.place}-${name}`;
    return [name, element("div", { class: "field" }, element("label", { for: id }, label), element("input", { id, value: row.cells[name], autocapitalize: "off", spellcheck: "false" }))];
  });
  return element("form", {
    class: "editor",
    onsubmit: (event) => {
      event.preventDefault();
      const cells = Object.fromEntries(boxes.map(([name, field]) => [name, field.querySelector("input").value.trim()]));
      decide(row.place, "edit", cells);
    },
    onkeydown: (event) => { if (event.key === "Escape") closed(); },
  }, ...boxes.map(([, field]) => field),
  element("p", { class: "aside" }, "Things stand between semicolons: onion (chopped; peeled) {salt} on cutting board"),
  element("div", { class: "actions" }, element("button", { type: "submit", class: "main" }, "Keep"), element("button", { type: "button", onclick: closed }, "Cancel")));
};

export const rowView = (row, decide) => {
  const open = row.reasons.length > 0;
  const about = ` row ${row.place + 1}`;
  const named = (text) => ({ "aria-label": `${text}${about}` });
  const actions = element("div", { class: "actions" });
  const made = element("li", { "data-place": row.place, "data-open": open },
    element("div", { class: "sides" }, saidView(row), unitView(row)), reasonsView(row), actions);
  const shut = () => { actions.hidden = false; made.querySelector(".editor")?.remove(); edit.focus(); };
  const edit = element("button", {
    type: "button", ...named("Edit"),
    onclick: () => { actions.hidden = true; made.append(editor(row, decide, shut)); made.querySelector("input").focus(); },
  }, "Edit");
  actions.append(
    ...(open ? [element("button", { type: "button", class: "main", ...named(row.sentence === null ? "Leave out" : "Accept"), onclick: () => decide(row.place, "accept") }, row.sentence === null ? "Leave out" : "Accept")] : []),
    edit,
    ...(row.sentence === null && open ? [] : [element("button", { type: "button", ...named("Leave out"), onclick: () => decide(row.place, "drop") }, "Leave out")]),
    element("span", { class: "aside" }, row.reviewed ? "decided" : row.sentence === null ? "" : `${row.confidence.toFixed(2)} sure`));
  return made;
};
