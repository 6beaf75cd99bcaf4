// Measurements as pictures: Carom beside other engines, of the table that tests/bench/compare_engines wrote; and a table of the pages
// that hold measurements, with the newest date in each.
import { readdirSync, readFileSync } from "node:fs";
import { posix } from "node:path";

const ROOT = new URL("../../../", import.meta.url).pathname;
const PEERS = "tests/bench/ENGINES.md";
const WIDTH = 860,
  LEFT = 250,
  RIGHT = 20,
  ROW = 22,
  TOP = 30,
  LEAST = 0.35; // what is less is drawn at the edge, with its figure
// A mark and a colour for each engine: they stay apart for the colour-blind, and without colour.
const LOOKS = [
  ["#d55e00", "M-5,-5H5V5H-5Z"],
  ["#0072b2", "M0,-5L5,4H-5Z"],
  ["#009e73", "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0"],
  ["#cc79a7", "M0,-6L5,0L0,6L-5,0Z"],
  ["#b8860b", "M-5,-4H5L0,5Z"],
  ["#56b4e9", "M-5,-1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z"],
];

const cells = (line) =>
  line
    .split("|")
    .slice(1, -1)
    .map((cell) => cell.trim());
/** The rows of the table whose head has these first columns. */
function table(text, head) {
  const lines = text.split("\n"),
    at = lines.findIndex((line) => line.startsWith(`| ${head} |`));
  if (at < 0) throw new Error(`${PEERS} has no table that begins with ${head}`);
  const end = lines.findIndex((line, i) => i > at && !line.startsWith("|"));
  return [cells(lines[at]), ...lines.slice(at + 2, end < 0 ? lines.length : end).map(cells)];
}

/** @returns { when, engines: [name], rows: [{ name, what, best, unit, figures: [{ engine, value, holds }] }] } of the peers' page,
 *  where best is the figure of the best peer that holds */
export function peers(text = readFileSync(ROOT + PEERS, "utf8")) {
  const when = /^(\d{4}-\d\d-\d\d), .*$/m.exec(text)?.[0];
  if (!when) throw new Error(`${PEERS} has no line that begins with a date`);
  const about = new Map(
    table(text, "row | scene")
      .slice(1)
      .map(([row, scene, , best]) => [
        row,
        { what: scene, best: Number(/^[\d,.]+/.exec(best)?.[0].replaceAll(",", "")) },
      ]),
  );
  const [[, ...engines], ...rows] = table(text, "row | Carom f64");
  const read = (cell, engine) => {
    const [, number, fault] = /^([\d,.e-]+)(?: (fails|cut))?$/.exec(cell) ?? [];
    return number && { engine, value: Number(number.replaceAll(",", "")), holds: !fault };
  };
  return {
    when,
    engines,
    rows: rows.map(([name, ...values]) => {
      const unit = name.startsWith("S11") ? "bytes a body" : name === "S10" ? "ms of all rays" : "ms a step";
      const figures = values.map((value, i) => read(value, engines[i])).filter(Boolean);
      if (!about.get(name)?.best) throw new Error(`${PEERS} names no best peer of ${name}`);
      return { name, ...about.get(name), unit, figures };
    }),
  };
}

const mark = ([colour, path], holds, x, y, title) =>
  `<path transform="translate(${x.toFixed(1)},${y})" d="${path}" stroke="${colour}" stroke-width="1.5" ` +
  `fill="${holds ? colour : "none"}"><title>${title}</title></path>`;

/** A row a scene: time over that of the best peer that holds, on a logarithmic axis. */
export function peersPicture({ when, engines, rows } = peers()) {
  const lines = rows.map((row) => ({ ...row, figures: row.figures.map((f) => ({ ...f, ratio: f.value / row.best })) }));
  const ticks = [0.5, 1, 2, 5, 10],
    all = lines.flatMap(({ figures }) => figures.map(({ ratio }) => ratio));
  const low = Math.log(Math.max(Math.min(...all) * 0.8, LEAST)),
    high = Math.log(Math.max(...all) * 1.2);
  const at = (ratio) => LEFT + ((Math.log(Math.max(ratio, LEAST * 1.1)) - low) / (high - low)) * (WIDTH - LEFT - RIGHT);
  const bottom = TOP + ROW * lines.length;
  const grid = ticks
    .filter((tick) => Math.log(tick) > low && Math.log(tick) < high)
    .map(
      (tick) =>
        `<path class="grid" d="M${at(tick).toFixed(1)},${TOP - 6}V${bottom}" stroke-width="${tick === 1 ? 2 : 1}"/>` +
        `<text x="${at(tick).toFixed(1)}" y="${TOP - 12}" text-anchor="middle">${tick}</text>`,
    );
  const drawn = lines.map(({ name, what, unit, figures }, i) => {
    const y = TOP + ROW * (i + 0.5);
    const marks = figures.map(({ engine, value, holds, ratio }) =>
      mark(
        LOOKS[engines.indexOf(engine) % LOOKS.length],
        holds,
        at(ratio),
        y,
        `${name}, ${engine}: ${value} ${unit}, ${ratio.toPrecision(2)} of the best peer${holds ? "" : "; it does not hold"}`,
      ),
    );
    const line = `<path class="grid" d="M${LEFT},${y}H${WIDTH - RIGHT}" stroke-dasharray="1 3"/>`;
    const beyond = figures
      .filter(({ ratio }) => ratio < LEAST)
      .map(({ ratio }) => `<text x="${LEFT + 32}" y="${y + 4}">${ratio.toPrecision(1)}</text>`);
    return `<text x="${LEFT - 10}" y="${y + 4}" text-anchor="end">${name}: ${what}</text>${line}${marks.join("")}${beyond.join("")}`;
  });
  const legend = engines.map(
    (engine, i) =>
      `<li><svg viewBox="-7 -7 14 14" aria-hidden="true">${mark(LOOKS[i], true, 0, 0, engine)}</svg> ${engine}</li>`,
  );
  const head = `<text x="${LEFT}" y="${bottom + 20}">time, or memory, over the best peer that holds: left is better</text>`;
  return [
    '<figure class="drawn"><div class="wide" tabindex="0" role="region" aria-label="Picture">',
    `<svg viewBox="0 0 ${WIDTH} ${bottom + 30}" style="min-width: 600px" role="img" aria-label="Cost of each engine over that of the best peer, by scene">`,
    ...grid,
    ...drawn,
    head,
    "</svg></div>",
    `<ul class="legend">${legend.join("")}</ul>`,
    `<figcaption>${when} A hollow mark: the engine loses a body, or what should stand falls. A peer left of 1: its joints gape farther than Carom's.</figcaption>`,
    "</figure>",
  ].join("\n");
}

function* pagesOf(folder) {
  for (const entry of readdirSync(ROOT + folder, { withFileTypes: true })) {
    const path = posix.join(folder, entry.name);
    if (entry.isDirectory() && !["node_modules", "dist", "build"].includes(entry.name)) yield* pagesOf(path);
    else if (entry.name.endsWith(".md") && entry.name !== "NOTES.md") yield path;
  }
}

/** @returns [{ file, title, date }] of pages with measurements that have a date, the newest first */
export function dated(folders = ["tests", "packages", "src", "bindings"]) {
  const found = [];
  for (const folder of folders)
    for (const file of pagesOf(folder)) {
      const text = readFileSync(ROOT + file, "utf8"),
        dates = text.match(/\b20\d\d-\d\d-\d\d\b/g);
      if (dates) found.push({ file, title: /^# (.+)$/m.exec(text)?.[1] ?? file, date: dates.sort().at(-1) });
    }
  return found.sort((a, b) => (a.date === b.date ? (a.file < b.file ? -1 : 1) : a.date < b.date ? 1 : -1));
}

export const datedTable = () =>
  [
    "| page | newest measurement |",
    "|---|---|",
    ...dated().map(({ file, title, date }) => `| [${title}](${file}) | ${date} |`),
  ].join("\n");
