// A picture that is moved and zoomed by its viewBox: what stays sharp is the browser's own drawing. By keys, a mouse or
// fingers; whoever only scrolls past is not held up.

const SMALLEST = 120; // pixels of the picture across the stage
const CLICK = 4; // pixels that a hand moves while it clicks

// Where a box of a task tree stands.
const middle = (group) => {
  if (!group) return null;
  const { x, y, width, height } = group.getBBox();
  const { e, f } = group.parentNode.transform.baseVal.consolidate()?.matrix ?? { e: 0, f: 0 };
  return { x: x + width / 2 + e, y: y + height / 2 + f };
};

export const stage = (box) => {
  const svg = box.querySelector("svg");
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  const view = { x: 0, y: 0, w: width, h: height };
  const shape = () => (box.clientWidth && box.clientHeight ? box.clientHeight / box.clientWidth : height / width);
  const within = (value, least, most) => Math.min(Math.max(value, least), most);
  const paper = matchMedia("print"); // on paper nothing moves: all of it is there
  const draw = () => {
    const { x, y, w, h } = paper.matches ? { x: 0, y: 0, w: width, h: height } : view;
    svg.setAttribute("viewBox", [x, y, w, h].map((v) => v.toFixed(2)).join(" "));
  };
  const show = () => {
    view.x = within(view.x, -view.w / 2, width - view.w / 2); // the middle of the stage stays on the picture
    view.y = within(view.y, -view.h / 2, height - view.h / 2);
    draw();
  };

  const fit = () => {
    const w = Math.max(width, height / shape());
    Object.assign(view, { x: (width - w) / 2, y: 0, w, h: w * shape() });
  };
  const legible = () => { // one pixel a pixel, with the first step in sight
    const w = box.clientWidth || width;
    const h = w * shape();
    const first = middle(svg.querySelector('[data-step="1"]'));
    const x = within((first?.x ?? width / 2) - w / 2, Math.min(0, (width - w) / 2), Math.max(0, width - w));
    Object.assign(view, { w, h, x, y: first && first.y > h - 60 ? first.y - h / 2 : 0 });
  };
  const zoom = (factor, fx = 0.5, fy = 0.5) => {
    const w = within(view.w * factor, SMALLEST, Math.max(width, height / shape()) * 2);
    const h = w * shape();
    Object.assign(view, { x: view.x + (view.w - w) * fx, y: view.y + (view.h - h) * fy, w, h });
  };
  const move = (dx, dy) => Object.assign(view, { x: view.x + dx * view.w, y: view.y + dy * view.h });
  let begun = false;
  const begin = () => { // as soon as it can be seen
    if (begun || !box.clientHeight) return;
    begun = true;
    if (height > 1.5 * box.clientHeight || width > 1.5 * box.clientWidth) legible();
    else fit();
    show();
  };
  const done = (act) => (...how) => { begin(); act(...how); show(); };
  const look = (x, y) => Object.assign(view, { x: x - view.w / 2, y: y - view.h / 2 });
  const centre = (group) => {
    const { x, y } = middle(group);
    look(x, y);
  };

  const keys = {
    ArrowLeft: () => move(-0.15, 0), ArrowRight: () => move(0.15, 0), ArrowUp: () => move(0, -0.15), ArrowDown: () => move(0, 0.15),
    PageUp: () => move(0, -0.8), PageDown: () => move(0, 0.8), Home: legible,
    "+": () => zoom(0.8), "=": () => zoom(0.8), "-": () => zoom(1.25), "0": fit,
  };
  box.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || !Object.hasOwn(keys, event.key)) return;
    event.preventDefault();
    done(keys[event.key])();
  });

  box.addEventListener("wheel", (event) => {
    const zooms = event.ctrlKey || event.metaKey; // so it also comes from two fingers on a touchpad
    const before = { ...view };
    if (zooms) {
      const at = box.getBoundingClientRect();
      zoom(Math.exp(within(event.deltaY, -60, 60) / 300), (event.clientX - at.left) / at.width, (event.clientY - at.top) / at.height);
    } else if (document.activeElement === box) {
      move(event.deltaX / box.clientWidth, event.deltaY / box.clientHeight);
    } else return;
    show();
    if (zooms || view.x !== before.x || view.y !== before.y) event.preventDefault(); // at its edge the page goes on
  }, { passive: false });

  const fingers = new Map(); // or the mouse, whose button is down
  const mine = () => fingers.size > 1 || document.activeElement === box;
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return { apart: b ? Math.hypot(a.x - b.x, a.y - b.y) : 0, x: b ? (a.x + b.x) / 2 : a.x, y: b ? (a.y + b.y) / 2 : a.y };
  };
  const drag = (before, after) => {
    const at = box.getBoundingClientRect();
    move((before.x - after.x) / at.width, (before.y - after.y) / at.height);
    if (before.apart && after.apart) zoom(before.apart / after.apart, (after.x - at.left) / at.width, (after.y - at.top) / at.height);
  };
  for (const name of ["touchstart", "touchmove"]) { // else the browser would scroll, and end these fingers
    box.addEventListener(name, (event) => {
      if (event.cancelable && event.touches.length > 1) event.preventDefault();
    }, { passive: false });
  }
  box.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    const { clientX: x, clientY: y } = event;
    fingers.set(event.pointerId, { x, y, from: { x, y } });
  });
  box.addEventListener("pointermove", (event) => {
    if (!event.buttons) fingers.delete(event.pointerId); // let go of outside
    if (!fingers.has(event.pointerId)) return;
    const [before, { from }, { clientX: x, clientY: y }] = [spread(), fingers.get(event.pointerId), event];
    fingers.set(event.pointerId, { x, y, from });
    // Only now: a click that moves nothing is one on the box of a step.
    if (event.pointerType === "mouse" && Math.hypot(x - from.x, y - from.y) > CLICK) box.setPointerCapture(event.pointerId);
    if (event.pointerType !== "touch" || mine()) done(drag)(before, spread());
  });
  for (const end of ["pointerup", "pointercancel"]) box.addEventListener(end, (event) => fingers.delete(event.pointerId));

  new ResizeObserver(() => { // a phone on its side
    begin();
    if (begun && box.clientHeight && !paper.matches) view.h = view.w * shape();
    draw();
  }).observe(box);
  paper.addEventListener("change", draw);
  return { larger: done(keys["+"]), smaller: done(keys["-"]), all: done(fit), own: done(legible), centre: done(centre), look: done(look) };
};
