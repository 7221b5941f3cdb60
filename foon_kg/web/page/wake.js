// The screen stays on while it is wanted and the page is in sight, where the browser can do that (and the page is its
// own: on this machine, or over TLS). `told` hears whether it does.

export const awake = (told) => {
  let [wanted, lock] = [false, null];
  const ask = async () => {
    if (!wanted || document.visibilityState !== "visible") return;
    try {
      lock = (await navigator.wakeLock?.request("screen")) ?? null;
    } catch {
      lock = null; // the battery is low
    }
    if (lock && !wanted) await lock.release(); // it is not wanted any more
    told(Boolean(lock));
  };
  return {
    on: () => { if (!wanted) { wanted = true; document.addEventListener("visibilitychange", ask); ask(); } },
    off: () => { wanted = false; document.removeEventListener("visibilitychange", ask); lock?.release(); lock = null; },
  };
};
