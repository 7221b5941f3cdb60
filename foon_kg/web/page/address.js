// A question as the part of an address after #, which is never sent to a server: to go back to, to keep, to pass on.
// `view` is how its plan is shown, `step` (from 1) the step that is looked at, `other` the address of a plan beside it.

export const toAddress = ({ dish_type, ingredients, substitutes = [], avoid = [], kitchen = [], after = "", title = "", with_drafts = false }, view = "", step = null, other = "") => {
  const fields = new URLSearchParams();
  if (dish_type) fields.append("dish", dish_type);
  ingredients.forEach((one) => fields.append("with", one));
  avoid.forEach((one) => fields.append("without", one));
  kitchen.forEach((one) => fields.append("have", one));
  substitutes.forEach(({ food, like }) => { fields.append("for", food); fields.append("like", like); });
  if (after) fields.append("after", after);
  if (title) fields.append("title", title);
  if (with_drafts) fields.append("drafts", "yes");
  if (view) fields.append("view", view);
  if (step) fields.append("step", step);
  if (other) fields.append("other", other.replace(/^#/, ""));
  return `#${fields}`;
};

export const fromAddress = (address = location.hash) => {
  const fields = new URLSearchParams(address.replace(/^#/, ""));
  const likes = fields.getAll("like");
  const substitutes = fields.getAll("for").map((food, i) => ({ food, like: likes[i] })).filter(({ like }) => like);
  const [after, title] = ["after", "title"].map((name) => fields.get(name) ?? "");
  const with_drafts = fields.has("drafts");
  const [ingredients, avoid, kitchen] = ["with", "without", "have"].map((name) => fields.getAll(name));
  return {
    view: fields.get("view") ?? "",
    step: Number.parseInt(fields.get("step"), 10) || null,
    other: fields.get("other") ?? "",
    ingredients,
    question: { dish_type: fields.get("dish") ?? "", ingredients, avoid, kitchen, substitutes, after, title, with_drafts },
    wishes: { foods: avoid, things: kitchen, choices: substitutes.map(({ food, like }) => [food, like]), after, title, with_drafts },
  };
};
