// Error against cost as a picture: two logarithmic axes, a line and a mark of its own for each series.
const SVG = "http://www.w3.org/2000/svg";
const WIDTH = 640,
  HEIGHT = 380,
  LEFT = 72,
  RIGHT = 24,
  TOP = 12,
  BOTTOM = 46;
// Okabe and Ito's colours, told apart by all kinds of sight; marks tell them apart without colour.
const COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#b8860b", "#56b4e9", "#777777"];
const MARKS = [
  "M-4,0a4,4 0 1,0 8,0a4,4 0 1,0 -8,0",
  "M-4,-4H4V4H-4Z",
  "M0,-5L5,4H-5Z",
  "M0,-5L5,0L0,5L-5,0Z",
  "M-5,-4H5L0,5Z",
  "M-5,-1.5H-1.5V-5H1.5V-1.5H5V1.5H1.5V5H-1.5V1.5H-5Z",
];
const LEAST = 1e-16; // an error of none is drawn here

function element(parent, name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}

/** An axis over whole decades, or thirds of them where there are few.   @returns { low, high, ticks } of log10 */
function axis(values) {
  const logs = values.map((v) => Math.log10(Math.max(v, LEAST))),
    low = Math.floor(Math.min(...logs) - 0.05),
    high = Math.max(low + 1, Math.ceil(Math.max(...logs) + 0.05)),
    stride = Math.ceil((high - low) / 8);
  const ticks = [];
  for (let k = low; k <= high; k += stride) ticks.push(k);
  return { low, high, ticks };
}
const power = (k) => (k >= -2 && k <= 3 ? String(Number((10 ** k).toPrecision(1))) : `1e${k}`);

/** @param series [{ name, points: [{ label, error, ms }] }]   @param unit  of errors   @returns an SVG element */
export function diagram(series, unit, title) {
  const points = series.flatMap((s) => s.points.filter((p) => Number.isFinite(p.error)));
  const svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", `${title}: error against cost; the table below has the numbers`);
  if (!points.length) return svg;
  const across = axis(points.map((p) => p.ms)),
    up = axis(points.map((p) => p.error));
  const x = (ms) =>
    LEFT + ((WIDTH - LEFT - RIGHT) * (Math.log10(Math.max(ms, LEAST)) - across.low)) / (across.high - across.low);
  const y = (error) =>
    HEIGHT - BOTTOM - ((HEIGHT - TOP - BOTTOM) * (Math.log10(Math.max(error, LEAST)) - up.low)) / (up.high - up.low);
  for (const k of across.ticks) {
    element(svg, "path", { class: "grid", d: `M${x(10 ** k)},${TOP}V${HEIGHT - BOTTOM}` });
    element(svg, "text", { x: x(10 ** k), y: HEIGHT - BOTTOM + 16, "text-anchor": "middle" }, power(k));
  }
  for (const k of up.ticks) {
    element(svg, "path", { class: "grid", d: `M${LEFT},${y(10 ** k)}H${WIDTH - RIGHT}` });
    element(svg, "text", { x: LEFT - 6, y: y(10 ** k) + 4, "text-anchor": "end" }, power(k));
  }
  const middle = (WIDTH + LEFT - RIGHT) / 2;
  element(svg, "text", { x: middle, y: HEIGHT - 8, "text-anchor": "middle" }, "ms of computing by simulated second");
  const turned = { transform: `translate(14 ${(HEIGHT - BOTTOM) / 2}) rotate(-90)`, "text-anchor": "middle" };
  element(svg, "text", turned, `error, ${unit}`);
  series.forEach(({ name, points: all }, i) => {
    const colour = COLOURS[i % COLOURS.length],
      seen = all.filter((p) => Number.isFinite(p.error));
    const line = seen.map((p, k) => `${k ? "L" : "M"}${x(p.ms).toFixed(1)},${y(p.error).toFixed(1)}`).join("");
    element(svg, "path", { d: line, fill: "none", stroke: colour, "stroke-width": 1.5 });
    for (const p of seen) {
      const at = `translate(${x(p.ms).toFixed(1)} ${y(p.error).toFixed(1)})`;
      const mark = element(svg, "path", { class: "point", d: MARKS[i % MARKS.length], fill: colour, transform: at });
      mark.dataset.error = p.error;
      element(mark, "title", {}, `${name}, ${p.label}: ${p.error.toExponential(1)} ${unit}, ${p.ms.toPrecision(2)} ms`);
    }
  });
  return svg;
}

/** Names of the series, with their colours and marks. */
export function legend(series) {
  const list = Object.assign(document.createElement("ul"), { className: "legend" });
  series.forEach(({ name }, i) => {
    const item = document.createElement("li"),
      svg = document.createElementNS(SVG, "svg");
    (svg.setAttribute("viewBox", "-7 -7 14 14"), svg.setAttribute("aria-hidden", "true"));
    element(svg, "path", { d: MARKS[i % MARKS.length], fill: COLOURS[i % COLOURS.length] });
    item.append(svg, ` ${name}`);
    list.append(item);
  });
  return list;
}
