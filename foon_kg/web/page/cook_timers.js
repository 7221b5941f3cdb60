// Timers that go on whatever step is in sight, and over a reload: what is kept is when each ends.

import { element } from "./element.js";
import { minutes } from "./nodes.js";

const ring = () => {
  if (!navigator.userActivation?.hasBeenActive) return; // a page that nobody touched since it came back may not
  navigator.vibrate?.([300, 150, 300, 150, 300]);
  const sound = new AudioContext();
  [0, 0.5, 1].forEach((start) => {
    const tone = sound.createOscillator();
    tone.connect(sound.destination);
    tone.start(start);
    tone.stop(start + 0.25);
  });
};

// `named` tells a step in words and `go` leads to it; `kept` keeps them.
export const timers = (kept, named, go) => {
  const part = element("ul", { class: "timers", "aria-label": "Timers" });
  let [going, rung] = [0, new Set()];
  const left = ({ until }) => Math.max(0, Math.ceil((until - Date.now()) / 1000));
  const words = (one) => (left(one) ? `${named(one.step)}: ${minutes(left(one))}` : `${named(one.step)}: time is up`);
  const stop = (one) => { kept.timers = kept.timers.filter((other) => other.until !== one.until); show(); };
  const tell = () => {
    if (!part.isConnected) return clearInterval(going);
    return kept.timers.forEach((one, i) => {
      const link = part.children[i].firstChild;
      if (link.textContent !== words(one)) link.textContent = words(one);
      if (left(one) || rung.has(one.until)) return;
      rung.add(one.until);
      part.children[i].setAttribute("role", "alert");
      ring();
    });
  };
  const show = () => {
    part.replaceChildren(...kept.timers.map((one) => element("li", {},
      element("button", { type: "button", class: "small", onclick: () => go(one.step) }, words(one)),
      element("button", { type: "button", class: "small", "aria-label": `Stop the timer of step ${one.step}`, onclick: () => stop(one) }, "×"))));
    part.hidden = !kept.timers.length;
    clearInterval(going);
    if (kept.timers.length) going = setInterval(tell, 250);
  };
  const setter = (step, seconds) => {
    let set = 0;
    const start = element("button", { type: "button", onclick: () => { kept.timers = [...kept.timers, { step, until: Date.now() + set * 1000 }]; show(); } });
    const add = (more) => {
      set += more;
      start.textContent = `Start ${minutes(set)}`;
      start.disabled = !set;
    };
    add(seconds);
    const more = (count) => element("button", { type: "button", onclick: () => add(60 * count) }, `+${count} min`);
    return element("div", { class: "bar", role: "group", "aria-label": "Timer" }, more(1), more(5), start);
  };
  show();
  return { part, show, setter };
};
