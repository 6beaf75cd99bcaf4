// Small line plots on a canvas: values by step, one or two of them, the present step marked.
import { theme } from "./palette.js";

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
  g.strokeStyle = colours.grid;
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
