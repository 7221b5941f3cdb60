// What a step needs now, and what may be done while it goes on by itself. Things are told apart by the numbers that a plan
// gives them.

const numbers = (nodes) => nodes.map((node) => node.thing);
const touched = (unit) => [...numbers(unit.input_nodes), ...numbers(unit.output_nodes)];

// The things of step `i` that nothing had to do with before (a food and not the packet it comes in), and the others (a
// bowl and not also all that is in it).
export const needs = (units, i) => {
  const before = new Set(units.slice(0, i).flatMap(touched));
  const { input_nodes: nodes } = units[i];
  const [fresh, there] = [nodes.filter((node) => !before.has(node.thing)), nodes.filter((node) => before.has(node.thing))];
  const packed = new Set(fresh.map((node) => node.container_thing));
  const holds = (node) => nodes.some((other) => other.thing === node.container_thing && other.ingredients.length);
  return [fresh.filter((node) => !packed.has(node.thing)), there.filter((node) => !holds(node))];
};

// What may be done while step `i` goes on by itself: the next three steps that have nothing to do with what it is about.
export const meanwhile = (units, i) => {
  const taken = new Set(touched(units[i]));
  return units.map((_, j) => j).filter((j) => {
    if (j <= i) return false;
    const waits = numbers(units[j].input_nodes).some((thing) => taken.has(thing));
    if (waits) touched(units[j]).forEach((thing) => taken.add(thing));
    return !waits;
  }).slice(0, 3);
};
