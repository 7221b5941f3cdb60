// Two plans laid beside each other: which of their steps and things go together, and what differs in those that do.

// The longest list of pairs [place in a, place in b] that `same` puts together, in the order of both.
export const common = (a, b, same) => {
  const lengths = Array.from({ length: a.length + 1 }, () => new Uint16Array(b.length + 1));
  for (let i = a.length - 1; i >= 0; i -= 1) {
    for (let j = b.length - 1; j >= 0; j -= 1) {
      lengths[i][j] = same(a[i], b[j]) ? lengths[i + 1][j + 1] + 1 : Math.max(lengths[i + 1][j], lengths[i][j + 1]);
    }
  }
  const pairs = [];
  for (let [i, j] = [0, 0]; i < a.length && j < b.length;) {
    if (same(a[i], b[j])) pairs.push([i++, j++]);
    else if (lengths[i + 1][j] >= lengths[i][j + 1]) i += 1;
    else j += 1;
  }
  return pairs;
};

// Rows [place in a, place in b], null where one has nothing: what is the same stands side by side, and between two such
// rows what is `near` each other.
export const beside = (a, b, same, near) => {
  const rows = [];
  const between = ([from, to], [i, j]) => {
    const gap = [a.slice(from, i), b.slice(to, j)];
    let [x, y] = [0, 0];
    for (const [p, q] of [...common(...gap, near), [gap[0].length, gap[1].length]]) {
      while (x < p) rows.push([from + x++, null]);
      while (y < q) rows.push([null, to + y++]);
      if (p < gap[0].length) rows.push([from + x++, to + y++]);
    }
  };
  let last = [0, 0];
  for (const [i, j] of common(a, b, same)) {
    between(last, [i, j]);
    rows.push([i, j]);
    last = [i + 1, j + 1];
  }
  between(last, [a.length, b.length]);
  return rows;
};

const bare = (word) => word.replace(/[,.]$/, "");

// The words of two sentences, each with whether the other one has it at its place too.
export const words = (one, other) => {
  const [a, b] = [one, other].map((text) => text.split(" "));
  const pairs = common(a, b, (x, y) => bare(x) === bare(y));
  return [a, b].map((all, side) => {
    const both = new Set(pairs.map((pair) => pair[side]));
    return all.map((word, place) => ({ word, both: both.has(place) }));
  });
};

// Whether two sentences have half of their words in common, in one order.
export const alike = (one, other) => {
  const [a, b] = words(one, other);
  return 2 * a.filter(({ both }) => both).length >= Math.max(a.length, b.length);
};
