// A picture that is moved and zoomed by its viewBox: what stays sharp is the browser's own drawing.

import { element } from "./element.js";

const HELP = "Arrow keys move the picture, + and - zoom, 0 shows all of it.";

export const stage = (svg, name) => {
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  const view = { x: 0, y: 0, w: width, h: height };
  svg.removeAttribute("width");
  svg.removeAttribute("height");
  const box = element("div", { class: "stage", tabindex: "0", role: "group", "aria-label": `${name}. ${HELP}` }, svg);

  const show = () => svg.setAttribute("viewBox", [view.x, view.y, view.w, view.h].map((v) => v.toFixed(2)).join(" "));
  const fit = () => Object.assign(view, { x: 0, y: 0, w: width, h: height });
  const legible = () => { // one pixel a pixel, from the first step on
    const w = box.clientWidth;
    Object.assign(view, { w, h: (w * box.clientHeight) / box.clientWidth, x: Math.max(0, (width - w) / 2), y: 0 });
  };
  const zoom = (factor, fx = 0.5, fy = 0.5) => {
    const w = Math.min(Math.max(view.w * factor, 120), Math.max(width, height) * 2);
    const h = view.h * (w / view.w);
    Object.assign(view, { x: view.x + (view.w - w) * fx, y: view.y + (view.h - h) * fy, w, h });
  };
  const move = (dx, dy) => Object.assign(view, { x: view.x + dx * view.w, y: view.y + dy * view.h });

  const keys = {
    ArrowLeft: () => move(-0.15, 0), ArrowRight: () => move(0.15, 0),
    ArrowUp: () => move(0, -0.15), ArrowDown: () => move(0, 0.15), Home: legible,
    "+": () => zoom(0.8), "=": () => zoom(0.8), "-": () => zoom(1.25), "0": fit,
  };
  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !Object.hasOwn(keys, event.key)) return;
    event.preventDefault();
    keys[event.key]();
    show();
  });
  box.addEventListener("wheel", (event) => {
    if (!event.ctrlKey && !event.metaKey) return; // who only scrolls past is not held up
    event.preventDefault();
    const at = box.getBoundingClientRect();
    zoom(event.deltaY < 0 ? 0.85 : 1.18, (event.clientX - at.left) / at.width, (event.clientY - at.top) / at.height);
    show();
  }, { passive: false });
  box.addEventListener("pointermove", (event) => {
    if (!event.buttons) return;
    const scale = Math.max(view.w / box.clientWidth, view.h / box.clientHeight);
    Object.assign(view, { x: view.x - event.movementX * scale, y: view.y - event.movementY * scale });
    show();
  });

  const button = (sign, label, act) =>
    element("button", { type: "button", class: "small", "aria-label": label, onclick: () => { act(); show(); } }, sign);
  const bar = element("div", { class: "bar" },
    button("+", "Larger", keys["+"]), button("−", "Smaller", keys["-"]), button("All", "Show all of it", fit),
    button("1:1", "Show it at its own size", legible), element("span", { class: "aside" }, HELP));
  requestAnimationFrame(() => {
    if (height > 1.5 * box.clientHeight || width > 1.5 * box.clientWidth) legible();
    show();
  });
  return [bar, box];
};
