// Elements from plain text only: no word of a FOON ever becomes markup.

export const element = (name, attributes = {}, ...children) => {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key.startsWith("on")) made.addEventListener(key.slice(2), value);
    else if (value !== false && value !== null && value !== undefined) made.setAttribute(key, value === true ? "" : value);
  }
  made.append(...children.filter((child) => child !== null && child !== undefined && child !== ""));
  return made;
};

export const heading = (level, text) => element(`h${level}`, {}, text);
export const list = (items, attributes = {}, name = "ul") =>
  element(name, attributes, ...items.map((item) => (item instanceof HTMLLIElement ? item : element("li", {}, ...[item].flat()))));

export const counted = (count, word) => `${count} ${word}${count === 1 ? "" : "s"}`;

export const errorNotice = (error, ...remedies) =>
  element("div", { class: "notice error", role: "alert" },
    element("p", {}, element("strong", {}, sentence(error.message))),
    error.hint ? element("p", {}, error.hint) : null,
    ...(error.notes ?? []).map((note) => element("p", { class: "aside" }, sentence(note))), ...remedies);

export const sentence = (text) => {
  const begun = text.charAt(0).toUpperCase() + text.slice(1);
  return /[.!?]$/.test(begun) ? begun : `${begun}.`;
};
