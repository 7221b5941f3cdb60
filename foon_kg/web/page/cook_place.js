// Where somebody is in a plan, and what is ticked off: kept in this browser for the plans that were cooked last.

const KEPT = "foon-cook";
const MOST = 6;

const all = () => {
  try {
    return Object.entries(JSON.parse(localStorage.getItem(KEPT) ?? "{}"));
  } catch {
    return []; // what another version kept
  }
};

// The step (from 1) that somebody is at in the plan with this address, or 0.
export const placeIn = (key) => {
  const { place = 0, size = 0 } = new Map(all()).get(key) ?? {};
  return place > size ? 0 : place;
};

// `size` is how many steps the plan has: what was kept of another plan of this question is forgotten.
export const keeper = (key, size) => {
  const begun = () => ({ size, place: 0, done: [], bought: [], timers: [] });
  const found = new Map(all()).get(key);
  let state = found?.size === size ? { ...begun(), ...found } : begun();
  const save = () => localStorage.setItem(KEPT, JSON.stringify(Object.fromEntries([[key, state], ...all().filter(([other]) => other !== key)].slice(0, MOST))));
  const set = (changes) => { state = { ...state, ...changes }; save(); };
  return {
    get place() { return state.place; },
    set place(place) { set({ place }); },
    get timers() { return state.timers; },
    set timers(some) { set({ timers: some }); },
    has: (kind, one) => state[kind].includes(one),
    count: (kind) => state[kind].length,
    toggle: (kind, one) => { // whether it is there now
      const there = state[kind].includes(one);
      set({ [kind]: there ? state[kind].filter((other) => other !== one) : [...state[kind], one] });
      return !there;
    },
    clear: () => set(begun()),
  };
};
