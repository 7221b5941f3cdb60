// The tree's picture is moved and zoomed by its viewBox: what stays sharp is the browser's own drawing.
(() => {
  "use strict";
  const stage = document.getElementById("stage");
  const svg = stage.querySelector("svg");
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  const view = { x: 0, y: 0, w: width, h: height };
  const show = () => svg.setAttribute("viewBox", [view.x, view.y, view.w, view.h].map((v) => v.toFixed(2)).join(" "));

  const shape = () => stage.clientHeight / stage.clientWidth;
  const fit = () => Object.assign(view, { x: 0, y: 0, w: width, h: height });
  const legible = () => { // one pixel a pixel, from the first step on
    const w = stage.clientWidth;
    Object.assign(view, { w, h: w * shape(), x: 0, y: 0 });
  };
  const zoom = (factor, fx = 0.5, fy = 0.5) => {
    const w = Math.min(Math.max(view.w * factor, 120), Math.max(width, height) * 2);
    const h = view.h * (w / view.w);
    view.x += (view.w - w) * fx;
    view.y += (view.h - h) * fy;
    view.w = w;
    view.h = h;
  };
  const move = (dx, dy) => { view.x += dx * view.w; view.y += dy * view.h; };

  const keys = {
    ArrowLeft: () => move(-0.15, 0), ArrowRight: () => move(0.15, 0),
    ArrowUp: () => move(0, -0.15), ArrowDown: () => move(0, 0.15),
    PageUp: () => move(0, -0.8), PageDown: () => move(0, 0.8), Home: legible,
    "+": () => zoom(0.8), "=": () => zoom(0.8), "-": () => zoom(1.25), "0": fit,
  };
  stage.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !Object.hasOwn(keys, event.key)) return;
    event.preventDefault();
    keys[event.key]();
    show();
  });
  stage.addEventListener("wheel", (event) => {
    const zooms = event.ctrlKey || event.metaKey;
    if (!zooms && document.activeElement !== stage) return; // who only scrolls past is not held up
    event.preventDefault();
    const box = stage.getBoundingClientRect();
    if (zooms) {
      zoom(event.deltaY < 0 ? 0.85 : 1.18, (event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    } else {
      move(event.deltaX / box.width, event.deltaY / box.height);
    }
    show();
  }, { passive: false });

  const fingers = new Map();
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a.x - b.x, a.y - b.y);
  };
  stage.addEventListener("pointerdown", (event) => {
    stage.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
  });
  stage.addEventListener("pointermove", (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const apart = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, { x: event.clientX, y: event.clientY });
    const scale = Math.max(view.w / stage.clientWidth, view.h / stage.clientHeight);
    view.x -= ((event.clientX - before.x) * scale) / fingers.size;
    view.y -= ((event.clientY - before.y) * scale) / fingers.size;
    if (apart) zoom(apart / Math.max(spread(), 1));
    show();
  });
  for (const end of ["pointerup", "pointercancel"]) {
    stage.addEventListener(end, (event) => fingers.delete(event.pointerId));
  }
  const buttons = { in: keys["+"], out: keys["-"], fit };
  for (const button of document.querySelectorAll("[data-do]")) {
    button.addEventListener("click", () => { buttons[button.dataset.do](); show(); });
  }
  if (height > 1.5 * stage.clientHeight || width > 1.5 * stage.clientWidth) legible();
  show();
})();
