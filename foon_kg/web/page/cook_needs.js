// What a step needs now, and what goes on or may be done while something stands in the heat by itself. Things are told
// apart by the numbers that a plan gives them.

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

const alone = (timing, i) => timing.get(i).hands === null;

// The steps after `i` that have nothing to do with what it is about.
const free = (units, i) => {
  const taken = new Set(touched(units[i]));
  return units.map((_, j) => j).filter((j) => {
    if (j <= i) return false;
    const waits = numbers(units[j].input_nodes).some((thing) => taken.has(thing));
    if (waits) touched(units[j]).forEach((thing) => taken.add(thing));
    return !waits;
  });
};

// What may be done while step `i` goes on by itself: the steps that do not wait for it, the next three of them.
export const meanwhile = (units, timing, i) => (alone(timing, i) ? free(units, i).slice(0, 3) : []);

// The steps before `i` that still go on by themselves: whatever came since has nothing to do with them.
export const underWay = (units, timing, i) =>
  units.map((_, j) => j).filter((j) => j < i && alone(timing, j) && free(units, j).filter((k) => k <= i).length === i - j);
