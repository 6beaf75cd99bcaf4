// Line plots on a canvas: values over time, with axes, units and, of several lines, a legend; the present step marked.
import { KINDS, theme } from "./palette.js";

const MOST_CAUSES = 6;
const LEFT = 46, // px, for the numbers of the vertical axis
  BELOW = 16, // for those of time
  ABOVE = 18,
  RIGHT = 6;
const NOTHING = 1e-12; // below it a curve over powers of ten ends

/** Round numbers that part a range into two to five. */
export function ticks(low, high) {
  const rough = (high - low) / 3 || 1,
    size = 10 ** Math.floor(Math.log10(rough)),
    step = [1, 2, 5, 10].find((k) => k * size >= rough) * size;
  const out = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high * (1 + 1e-9) + 1e-300; ++k) out.push(k * step);
  return out;
}
const PREFIXES = [
  [1e9, "G"],
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
  [1e-12, "p"],
];
/** 5700 -> "5.7k", so that a few letters are enough. */
export function short(x) {
  if (x === 0) return "0";
  if (Math.abs(x) < 1e-12) return x.toExponential(0);
  const [size, letter] = PREFIXES.find(([s]) => Math.abs(x) >= s * 0.9999) ?? PREFIXES.at(-1);
  return `${Number((x / size).toPrecision(3))}${letter}`;
}

/** @param about  { title, unit, lines: [{ name, values, colour }], at: step, dt: s, log }   Values are by step. */
export function plot(canvas, { title, unit, lines, at, dt, log = false }) {
  const ratio = devicePixelRatio || 1,
    w = canvas.clientWidth,
    h = canvas.clientHeight;
  if (!w) return;
  const g = canvas.getContext("2d"),
    colours = theme();
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio))
    ((canvas.width = Math.round(w * ratio)), (canvas.height = Math.round(h * ratio)));
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  g.clearRect(0, 0, w, h);
  const scaled = (v) => (log ? Math.log10(Math.max(v, NOTHING)) : v),
    length = Math.max(2, ...lines.map((l) => l.values.length));
  let low = log ? Infinity : 0,
    high = log ? -Infinity : 0;
  for (const { values } of lines)
    for (const v of values)
      if (Number.isFinite(v)) ((low = Math.min(low, scaled(v))), (high = Math.max(high, scaled(v))));
  if (log) ((low = Math.floor(Math.min(low, high, 0))), (high = Math.max(low + 1, Math.ceil(high))));
  if (!(high > low)) high = low + 1;
  const wide = w - LEFT - RIGHT,
    tall = h - ABOVE - BELOW,
    x = (i) => LEFT + (wide * i) / (length - 1),
    y = (v) => ABOVE + tall * (1 - (scaled(v) - low) / (high - low));
  g.font = "11px system-ui, sans-serif";
  g.fillStyle = colours.text;
  g.fillText(`${title}, ${unit}`, LEFT, 11);
  g.strokeStyle = colours.rule;
  g.lineWidth = 1;
  g.textAlign = "right";
  const marks = log
    ? ticks(low, high)
        .filter(Number.isInteger)
        .map((p) => 10 ** p)
    : ticks(low, high);
  for (const v of marks) {
    g.beginPath();
    (g.moveTo(LEFT, y(v)), g.lineTo(w - RIGHT, y(v)), g.stroke());
    g.fillText(short(v), LEFT - 4, y(v) + 4);
  }
  const end = (length - 1) * dt;
  for (const t of ticks(0, end)) {
    const last = t > 0.93 * end;
    g.textAlign = t === 0 ? "left" : last ? "right" : "center";
    g.fillText(t === 0 ? "0 s" : `${Number(t.toPrecision(3))}`, Math.min(w - RIGHT, LEFT + (wide * t) / end), h - 4);
  }
  g.textAlign = "left";
  g.save();
  g.beginPath();
  (g.rect(LEFT, ABOVE - 1, wide, tall + 2), g.clip());
  const every = Math.max(1, Math.floor(length / (2 * wide))); // more than two values a pixel are not seen
  lines.forEach(({ values, colour }) => {
    g.strokeStyle = colour;
    g.lineWidth = 1.5;
    g.beginPath();
    for (let i = 0; i < values.length; i += every) if (Number.isFinite(values[i])) g.lineTo(x(i), y(values[i]));
    g.stroke();
  });
  g.strokeStyle = colours.text;
  g.lineWidth = 1;
  (g.beginPath(),
    g.moveTo(x(Math.min(at, length - 1)), ABOVE),
    g.lineTo(x(Math.min(at, length - 1)), ABOVE + tall),
    g.stroke());
  g.restore();
  if (lines.length < 2 || lines.some((l) => !l.name)) return;
  let right = w - RIGHT;
  for (const { name, colour } of lines.toReversed()) {
    g.fillStyle = colours.text;
    right -= g.measureText(name).width;
    g.fillText(name, right, 11);
    g.fillStyle = colour;
    (g.fillRect(right - 13, 6, 10, 3), (right -= 20));
  }
}

/** All curves that stand under "Curves".   @param state  of the page   @param canvas (id) => canvas */
export function plotAll(state, canvas) {
  const { sims } = state,
    [{ step: at, dt }] = sims,
    { a, b } = theme();
  const draw = (id, title, unit, values, log) =>
    plot(canvas(id), {
      title,
      unit,
      at,
      dt,
      log,
      lines: values.map((v, k) => ({ name: values.length > 1 ? "AB"[k] : "", values: v, colour: k ? b : a })),
    });
  draw(
    "energy",
    "kinetic energy",
    "J",
    sims.map((s) => s.energy),
  );
  // The first step also makes room and finds all contacts: beside it no other would be seen.
  draw(
    "cost",
    "time of a step",
    "ms",
    sims.map((s) => s.seconds.map((x, i) => (i ? 1e3 * x : NaN))),
  );
  if (sims.length === 2) draw("difference", "A and B apart, root mean square", "m", [state.difference]);
  if (state.row.truth)
    draw(
      "error",
      "off the truth",
      "m",
      sims.map((s) => s.errors),
      true,
    );
}

/** What causes gave up to each step, J; the largest of them, with their sums in a table, which is the legend.
 *  @param causes  Map: name -> J by step */
export function plotCauses(canvas, table, { causes, step, dt }) {
  const all = [...causes].map(([name, list]) => {
    let sum = 0;
    const sums = Array.from(list, (x) => (sum += x ?? 0)); // steps before accounts were kept gave nothing
    return { name, sums, now: sums[Math.min(step, sums.length) - 1] ?? 0, size: Math.max(...sums.map(Math.abs), 0) };
  });
  const shown = all
    .filter((c) => c.size > 0)
    .sort((a, b) => b.size - a.size)
    .slice(0, MOST_CAUSES);
  plot(canvas, {
    title: "given so far",
    unit: "J",
    at: step,
    dt,
    lines: shown.map(({ sums }, k) => ({ values: sums, colour: KINDS[k % KINDS.length] })),
  });
  table.replaceChildren(
    ...shown.map(({ name, now }, k) => {
      const row = document.createElement("tr");
      const cells = ["■", name.replaceAll("_", " "), `${now.toPrecision(4)} J`].map((text, i) => {
        const cell = Object.assign(document.createElement("td"), { textContent: text });
        if (i === 0) ((cell.style.color = KINDS[k % KINDS.length]), cell.setAttribute("aria-hidden", "true"));
        if (i === 2) cell.className = "number";
        return cell;
      });
      row.append(...cells);
      return row;
    }),
  );
}
