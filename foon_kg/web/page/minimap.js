// A small picture of the whole beside what is seen of it: a frame shows where that is, and a pointer moves it there.

const most = () => (matchMedia("(max-width: 760px)").matches ? { w: 70, h: 110 } : { w: 120, h: 180 }); // pixels

export const minimap = (svg, look) => {
  const small = svg.cloneNode(true);
  small.querySelectorAll("text, title, defs").forEach((one) => one.remove()); // they would be too small, and named twice
  small.querySelectorAll("[marker-end], [data-step], [data-foods]").forEach((one) => ["marker-end", "data-step", "data-foods"].forEach((name) => one.removeAttribute(name)));
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  const { w: wide, h: high } = most();
  const scale = Math.min(wide / width, high / height);
  const frame = document.createElementNS(svg.namespaceURI, "rect");
  const set = (attributes, one = frame) => { for (const [name, value] of Object.entries(attributes)) one.setAttribute(name, value); };
  set({ class: "minimap", width: width * scale, height: height * scale, "aria-hidden": "true", role: "none" }, small);
  set({ class: "frame", "vector-effect": "non-scaling-stroke" });
  small.append(frame);
  const follow = () => {
    const [x, y, w, h] = svg.getAttribute("viewBox").split(" ").map(Number);
    small.classList.toggle("whole", x <= 0 && y <= 0 && x + w >= width && y + h >= height); // all of it is seen
    const [left, top] = [Math.max(0, x), Math.max(0, y)];
    set({ x: left, y: top, width: Math.max(0, Math.min(width, x + w) - left), height: Math.max(0, Math.min(height, y + h) - top) });
  };
  new MutationObserver(follow).observe(svg, { attributes: true, attributeFilter: ["viewBox"] });
  follow();
  const go = (event) => {
    const at = small.getBoundingClientRect();
    look(((event.clientX - at.left) / at.width) * width, ((event.clientY - at.top) / at.height) * height);
  };
  small.addEventListener("pointerdown", (event) => { small.setPointerCapture(event.pointerId); go(event); });
  small.addEventListener("pointermove", (event) => { if (event.buttons) go(event); });
  return small;
};
