// The picture: things and what joins them, drawn by Cytoscape.js and placed by dagre. It knows nothing of the API.

import cytoscape from "./vendor/cytoscape.esm.min.mjs";
import { Graph, layout } from "./vendor/dagre.esm.js";
import { markOf } from "./words.js";

const SHAPES = { food: "ellipse", object: "ellipse", vessel: "round-rectangle", step: "rectangle", motion: "hexagon", video: "triangle", dish: "diamond", other: "octagon" };
const NARROW = 620; // pixels: below this a way leads down, else to the right
const READABLE = .75; // no smaller of itself
const MARGIN = 24;
const APART = { x: 128, y: 118 }; // pixels between two things of a way
const LINE = 17; // pixels of a line of a label
const calm = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const styles = () => [
  { selector: "node", style: {
    label: "data(label)", "text-valign": "bottom", "text-margin-y": 4, "text-wrap": "wrap", "text-max-width": 124, "font-size": 14, "line-height": 1.15,
    color: colour("ink"), "text-background-color": colour("paper"), "text-background-opacity": .85, "text-background-padding": 1, "border-width": 1, "border-color": colour("edge"),
    "background-color": colour("vessel"), shape: "octagon", width: "data(size)", height: "data(size)" } },
  ...Object.entries(SHAPES).map(([kind, shape]) => ({ selector: `node[mark="${kind}"]`, style: { shape, "background-color": colour(kind) || colour("vessel") } })),
  { selector: "edge", style: {
    width: 1.5, "line-color": colour("edge"), "target-arrow-color": colour("edge"), "target-arrow-shape": "triangle", "curve-style": "bezier", "arrow-scale": .9 } },
  { selector: "edge[!flows]", style: { width: 1, "line-style": "dashed", "target-arrow-shape": "none", opacity: .45 } },
  { selector: "edge[?back]", style: { "line-style": "solid", opacity: .7 } },
  { selector: "edge.near", style: { "line-color": colour("halo"), "target-arrow-color": colour("halo"), opacity: 1 } },
  { selector: "edge.near[?flows]", style: { width: 3 } },
  { selector: "node.chosen", style: { "border-width": 4, "border-color": colour("halo"), "font-weight": "bold" } },
];

const label = (thing, more) => [thing.name, [thing.kind === "motion" ? thing.note : thing.states.join(", "), more ? `+${more}` : ""].filter(Boolean).join(" ")].filter(Boolean).join("\n");
const size = (thing) => Math.round(({ step: 20, video: 26, motion: 32, dish: 34, food: 32, utensil: 32 }[thing.kind] ?? 22) + 3 * Math.log2(1 + Math.min(thing.steps, 64)));
const FLOWS = new Set(["takes", "makes"]);
const BEHIND = new Set(["called", "seen in", "motion", "contains"]); // what leads to a name or a video is drawn from there on

// Where everything has its place, by id: what is made of it is to the right of a thing, or below it.
const places = (cy) => {
  const graph = new Graph().setGraph({ rankdir: cy.width() < NARROW ? "TB" : "LR", nodesep: 18, ranksep: 46, marginx: 10, marginy: 10 });
  graph.setDefaultEdgeLabel(() => ({}));
  const tall = (node) => LINE * (1 + (node.data("label").split("\n")[1] ? Math.ceil(node.data("label").split("\n")[1].length / 17) : 0)) + 6;
  const width = (node) => Math.max(node.data("size"), Math.min(124, 7.5 * Math.max(...node.data("label").split("\n").map((line) => line.length))));
  cy.nodes().forEach((node) => { graph.setNode(node.id(), { width: width(node), height: node.data("size") + tall(node) }); });
  cy.edges().forEach((edge) => {
    const ends = [edge.data("source"), edge.data("target")];
    if (BEHIND.has(edge.data("kind"))) ends.reverse();
    graph.setEdge(...ends, { weight: edge.data("flows") ? 8 : 1 });
  });
  layout(graph);
  return (node) => {
    const { x, y } = graph.node(node.id());
    return { x, y: y - tall(node) / 2 }; // its name is below it
  };
};

export const picture = (box, { chosen, removed }) => {
  const cy = cytoscape({ container: box, minZoom: .15, maxZoom: 3, boxSelectionEnabled: false, autounselectify: true, style: styles() });
  const now = () => cy.$("node.chosen").first();
  const fit = () => cy.fit(undefined, MARGIN);
  // Where the picture has to stand so that no more is empty than need be; bounds are what it fills in its own measure.
  const framed = (pan, bounds, zoom) => {
    const side = (at, from, to, length) => {
      if ((to - from) * zoom < length - 2 * MARGIN) return (length - (from + to) * zoom) / 2;
      return Math.max(length - MARGIN - to * zoom, Math.min(MARGIN - from * zoom, at));
    };
    return { x: side(pan.x, bounds.x1, bounds.x2, cy.width()), y: side(pan.y, bounds.y1, bounds.y2, cy.height()) };
  };
  const view = () => { // all of it, if that can be read, else what is chosen
    fit();
    if (cy.zoom() > 1.2) { cy.zoom(1.2); cy.center(); }
    if (cy.zoom() >= READABLE) return;
    cy.zoom(READABLE);
    cy.center(now());
    cy.pan(framed(cy.pan(), cy.elements().boundingBox(), READABLE));
  };

  const mark = (id) => {
    cy.batch(() => {
      cy.elements().removeClass("chosen near");
      cy.getElementById(id).addClass("chosen").connectedEdges().addClass("near");
    });
  };
  const put = ({ things, edges, more }, at) => {
    const fresh = things.filter(({ id }) => cy.getElementById(id).empty());
    cy.batch(() => {
      for (const thing of fresh) {
        cy.add({ group: "nodes", data: { id: thing.id, thing, mark: markOf(thing), size: size(thing), label: "" }, position: { ...at } });
      }
      const ends = (kind, from, to) => new Set(edges.filter((edge) => edge.kind === kind).map((edge) => `${edge[from]} ${edge[to]}`));
      const [taken, made] = [ends("takes", "source", "target"), ends("makes", "target", "source")];
      for (const edge of edges) { // what is taken and given back has one line without an arrow
        const back = edge.kind === "takes" && made.has(`${edge.source} ${edge.target}`);
        if (edge.kind === "makes" && taken.has(`${edge.target} ${edge.source}`)) continue;
        const id = `${edge.source} ${edge.kind} ${edge.target}`;
        if (cy.getElementById(id).empty()) cy.add({ group: "edges", data: { id, ...edge, flows: FLOWS.has(edge.kind) && !back, back } });
      }
      count(more ?? {});
    });
    return fresh.length;
  };
  const count = (more) => cy.nodes().forEach((node) => {
    if (node.id() in more || !node.data("label")) node.data({ more: more[node.id()] ?? 0, label: label(node.data("thing"), more[node.id()] ?? 0) });
  });
  const place = (slowly = false) => {
    const positions = places(cy);
    cy.layout({ name: "preset", positions, fit: false, animate: slowly && !calm(), animationDuration: 300 }).run();
    return positions;
  };
  const seen = (node) => { // into the middle if it is beyond the side
    const { x1, y1, x2, y2 } = node.renderedBoundingBox();
    if (x1 < 0 || y1 < 0 || x2 > cy.width() || y2 > cy.height()) cy.animate({ center: { eles: node }, duration: calm() ? 0 : 200 });
  };
  const seenAt = (spot) => (spot && spot.x > 0 && spot.y > 0 && spot.x < cy.width() && spot.y < cy.height() ? spot : null);
  const nearest = (x, y) => { // the thing in this direction: near, and not far aside
    const at = now().position();
    const cost = (node) => {
      const [dx, dy] = [node.position("x") - at.x, node.position("y") - at.y];
      const ahead = dx * x + dy * y;
      return ahead <= 0 ? Infinity : ahead + 2.5 * Math.abs(dx * y - dy * x);
    };
    const others = cy.nodes().difference(now()).toArray().map((node) => [cost(node), node]).filter(([far]) => far < Infinity);
    return others.sort(([a], [b]) => a - b)[0]?.[1];
  };
  const go = (x, y) => {
    const next = now().nonempty() ? nearest(x, y) : cy.nodes().first();
    if (!next?.nonempty()) return;
    mark(next.id());
    seen(next);
    chosen(next.data("thing"), { grow: false });
  };
  const zoom = (by) => cy.zoom({ level: cy.zoom() * by, renderedPosition: { x: cy.width() / 2, y: cy.height() / 2 } });
  const keys = {
    ArrowRight: () => go(1, 0), ArrowLeft: () => go(-1, 0), ArrowDown: () => go(0, 1), ArrowUp: () => go(0, -1),
    Enter: () => now().nonempty() && chosen(now().data("thing"), { grow: true }),
    Delete: () => now().nonempty() && removed(now().data("thing")),
    "+": () => zoom(1.25), "-": () => zoom(.8), 0: fit,
  };
  box.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    keys[event.key]();
  });
  cy.on("tap", "node", ({ target }) => { mark(target.id()); chosen(target.data("thing"), { grow: true }); });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => cy.style(styles()));

  return {
    fit,
    look: (id) => { mark(id); if (now().nonempty()) seen(now()); },
    larger: () => zoom(1.25),
    smaller: () => zoom(.8),
    tidy: () => { place(); fit(); },
    ids: () => cy.nodes().map((node) => node.id()),
    // What is joined with a thing in the picture, with the kind of the edge and whether it leads to the thing.
    next: (id) => cy.getElementById(id).connectedEdges().map((edge) => {
      const inward = edge.data("target") === id;
      return { kind: edge.data("kind"), inward, thing: (inward ? edge.source() : edge.target()).data("thing"), more: edge.data("more") };
    }),
    more: (id) => cy.getElementById(id).data("more") ?? 0,
    has: (id) => cy.getElementById(id).nonempty(),
    show: (told) => {
      cy.stop(true).elements().remove();
      put(told);
      place();
      mark(told.things[0]?.id);
      view();
    },
    grow: (told, id) => {
      const from = cy.getElementById(id);
      const before = from.nonempty() ? from.renderedPosition() : null;
      const count = put(told, from.nonempty() ? from.position() : { x: 0, y: 0 });
      mark(id);
      if (!count) return 0;
      const placed = place(true);
      const at = placed(cy.getElementById(id));
      const spots = cy.nodes().map(placed);
      const bounds = { x1: Math.min(...spots.map(({ x }) => x)) - 60, x2: Math.max(...spots.map(({ x }) => x)) + 60,
        y1: Math.min(...spots.map(({ y }) => y)) - 30, y2: Math.max(...spots.map(({ y }) => y)) + 70 };
      const where = seenAt(before) ?? { x: cy.width() / 2, y: cy.height() / 2 }; // it stays where it was seen
      const pan = framed({ x: where.x - at.x * cy.zoom(), y: where.y - at.y * cy.zoom() }, bounds, cy.zoom());
      if (calm()) cy.pan(pan);
      else cy.animate({ pan, duration: 300 });
      return count;
    },
    // A way: in rows to and fro, or one below the other on a narrow screen.
    way: ({ stops, steps, edges }) => {
      const things = stops.flatMap(({ thing }, i) => [thing, ...steps.slice(i, i + 1).map((step) => step.thing)]);
      const order = [...new Set(things.map(({ id }) => id))];
      cy.stop(true).elements().remove();
      put({ things, edges });
      const wide = Math.max(1, Math.floor(cy.width() / APART.x));
      cy.nodes().positions((node) => {
        const [row, place] = [Math.floor(order.indexOf(node.id()) / wide), order.indexOf(node.id()) % wide];
        return { x: (row % 2 ? wide - 1 - place : place) * APART.x, y: row * APART.y };
      });
      mark(order[0]);
      view();
    },
    remove: (id) => {
      const next = cy.getElementById(id).neighborhood("node").first();
      cy.getElementById(id).remove();
      if (next.nonempty()) mark(next.id());
      return next.nonempty() ? next.data("thing") : null;
    },
  };
};
