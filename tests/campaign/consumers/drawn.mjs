// Draw the DOT of standard input with Graphviz and write its SVG.
import { readFileSync } from "node:fs";
import { instance } from "@viz-js/viz";

const viz = await instance();
const drawn = viz.render(readFileSync(0, "utf8"), { format: "svg" });
if (drawn.status !== "success" || drawn.errors.length) {
  console.error(JSON.stringify(drawn.errors));
  process.exit(1);
}
process.stdout.write(drawn.output);
