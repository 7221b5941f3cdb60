// A question as the part of an address after #, which is never sent to a server: to go back to, to keep, to pass on.

export const toAddress = ({ dish_type, ingredients, substitutes, avoid, kitchen }) => {
  const fields = new URLSearchParams();
  if (dish_type) fields.append("dish", dish_type);
  ingredients.forEach((one) => fields.append("with", one));
  avoid.forEach((one) => fields.append("without", one));
  kitchen.forEach((one) => fields.append("have", one));
  substitutes.forEach(({ food, like }) => { fields.append("for", food); fields.append("like", like); });
  return `#${fields}`;
};

export const fromAddress = () => {
  const fields = new URLSearchParams(location.hash.slice(1));
  const likes = fields.getAll("like");
  return {
    look: fields.get("look"),
    dish: fields.get("dish") ?? "",
    ingredients: fields.getAll("with"),
    wishes: {
      foods: fields.getAll("without"),
      things: fields.getAll("have"),
      choices: fields.getAll("for").map((food, i) => [food, likes[i]]).filter(([, like]) => like),
    },
  };
};
