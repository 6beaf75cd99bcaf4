// Small line plots on a canvas: values by step, one or two of them, the present step marked.
import { KINDS, theme } from "./palette.js";

const MOST_CAUSES = 6;

export function plot(canvas, title, unit, series, at) {
  const ratio = devicePixelRatio || 1,
    w = canvas.clientWidth,
    h = canvas.clientHeight;
  if (!w) return;
  ((canvas.width = w * ratio), (canvas.height = h * ratio));
  const g = canvas.getContext("2d"),
    colours = theme();
  g.scale(ratio, ratio);
  const length = Math.max(2, ...series.map((s) => s.length));
  let most = 0;
  for (const s of series) for (const v of s) if (Number.isFinite(v)) most = Math.max(most, v);
  const x = (i) => 4 + ((w - 8) * i) / (length - 1),
    y = (v) => h - 4 - ((h - 24) * v) / (most || 1);
  g.font = "11px system-ui, sans-serif";
  g.fillStyle = colours.text;
  g.fillText(`${title}, most ${most.toPrecision(3)} ${unit}`, 4, 12);
  g.strokeStyle = colours.rule;
  g.strokeRect(4, 18, w - 8, h - 22);
  series.forEach((s, k) => {
    g.strokeStyle = k ? colours.b : colours.a;
    g.lineWidth = 1.5;
    g.beginPath();
    for (let i = 0; i < s.length; ++i) if (Number.isFinite(s[i])) g.lineTo(x(i), y(s[i]));
    g.stroke();
  });
  g.strokeStyle = colours.text;
  g.lineWidth = 1;
  (g.beginPath(), g.moveTo(x(Math.min(at, length - 1)), 18), g.lineTo(x(Math.min(at, length - 1)), h - 4), g.stroke());
}

/** All curves that stand under "Curves".   @param state  of the page   @param canvas (id) => canvas */
export function plotAll(state, canvas) {
  const { sims } = state,
    { step } = sims[0];
  const energies = sims.map((s) => s.energy),
    costs = sims.map((s) => s.seconds.map((x) => 1e3 * x));
  plot(canvas("energy"), "kinetic energy", "J", energies, step);
  plot(canvas("cost"), "time of a step", "ms", costs, step);
  if (sims.length === 2) plot(canvas("difference"), "A and B apart", "m (rms)", [state.difference], step);
  if (state.row.truth) plot(canvas("error"), "off the truth", "m", sims.map((s) => s.errors), step);
}

/** What causes gave up to each step, J; the largest of them, with their sums in a table.
 *  @param causes  Map: name -> J by step */
export function plotCauses(canvas, table, causes, at) {
  const all = [...causes].map(([name, list]) => {
    let sum = 0;
    const sums = Array.from(list, (x) => (sum += x ?? 0)); // steps before accounts were kept gave nothing
    return { name, sums, now: sums[Math.min(at, sums.length) - 1] ?? 0, size: Math.max(...sums.map(Math.abs), 0) };
  });
  const shown = all
    .filter((c) => c.size > 0)
    .sort((a, b) => b.size - a.size)
    .slice(0, MOST_CAUSES);
  const ratio = devicePixelRatio || 1,
    w = canvas.clientWidth,
    h = canvas.clientHeight,
    g = canvas.getContext("2d");
  if (!w) return;
  ((canvas.width = w * ratio), (canvas.height = h * ratio), g.scale(ratio, ratio));
  const most = Math.max(...shown.map((c) => c.size), 1e-300),
    length = Math.max(2, ...shown.map((c) => c.sums.length));
  g.strokeStyle = theme().rule;
  g.strokeRect(4, 4, w - 8, h - 8);
  (g.beginPath(), g.moveTo(4, h / 2), g.lineTo(w - 4, h / 2), g.stroke());
  shown.forEach(({ sums }, k) => {
    g.strokeStyle = KINDS[k % KINDS.length];
    g.lineWidth = 1.5;
    g.beginPath();
    sums.forEach((v, i) => g.lineTo(4 + ((w - 8) * i) / (length - 1), h / 2 - ((h / 2 - 6) * v) / most));
    g.stroke();
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
