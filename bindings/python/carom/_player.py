"""The page that plays a film: a scene as JSON, drawn on a canvas."""

PLAYER = r"""<!doctype html><meta charset="utf-8"><title>Carom</title><style>
:root{color-scheme:light dark}html,body{height:100%;margin:0;font:13px system-ui,sans-serif}
body{display:flex;flex-direction:column}canvas{flex:1;min-height:0;width:100%;touch-action:none;cursor:grab;border-radius:6px}
div{display:flex;gap:8px;align-items:center;padding:6px 2px}input{flex:1;min-width:0}output{min-width:9ch;font-variant-numeric:tabular-nums}
</style><canvas aria-label="The scene; draw along it to turn the camera"></canvas>
<div><button type="button">Pause</button><input type="range" min="0" value="0" aria-label="Time"><output></output></div>
<script>
const S = SCENE;
const bytes = Uint8Array.from(atob(S.poses), (c) => c.charCodeAt(0)), poses = new Float32Array(bytes.buffer);
const frames = poses.length / (7 * S.bodies) || 1, canvas = document.querySelector("canvas"), g = canvas.getContext("2d");
const button = document.querySelector("button"), slider = document.querySelector("input"), told = document.querySelector("output");
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2], minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => { const l = Math.hypot(...a) || 1; return a.map((x) => x / l); };
const light = unit(S.light), shade = (c, by) =>
  "rgb(" + [1, 3, 5].map((i) => Math.min(255, Math.round(parseInt(c.slice(i, i + 2), 16) * by))) + ")";
function placed(at, v) {
  const u = [poses[at + 3], poses[at + 4], poses[at + 5]], w = poses[at + 6], t = cross(u, v).map((x) => 2 * x), k = cross(u, t);
  return [0, 1, 2].map((i) => poses[at + i] + v[i] + w * t[i] + k[i]);
}
function hull(points) {
  points.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const half = (list) => {
    const out = [];
    for (const p of list) {
      while (out.length > 1 && (out.at(-1)[0] - out.at(-2)[0]) * (p[1] - out.at(-2)[1]) <=
        (out.at(-1)[1] - out.at(-2)[1]) * (p[0] - out.at(-2)[0])) out.pop();
      out.push(p);
    }
    return out.slice(0, -1);
  };
  return half(points).concat(half(points.slice().reverse()));
}
let around = Math.atan2(S.camera[0], S.camera[2]), above = Math.asin(unit(S.camera)[1]), zoom = 1, frame = 0, from = 0, playing = true;
function draw() {
  const ratio = devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (canvas.width !== Math.round(w * ratio) || canvas.height !== Math.round(h * ratio))
    (canvas.width = Math.round(w * ratio)), (canvas.height = Math.round(h * ratio));
  g.setTransform(ratio, 0, 0, ratio, 0, 0);
  const back = [Math.sin(around) * Math.cos(above), Math.sin(above), Math.cos(around) * Math.cos(above)];
  const right = unit(cross([0, 1, 0], back)), up = cross(back, right), half = Math.min(w, h) / 2;
  const far = (S.size * Math.sqrt(1 + S.focal ** 2) * S.close) / zoom, eye = S.target.map((x, i) => x + far * back[i]);
  const seen = (p) => {
    const d = minus(p, eye), scale = (S.focal * half) / Math.max(-dot(back, d), 0.05 * far);
    return [w / 2 + scale * dot(right, d), h / 2 - scale * dot(up, d)];
  };
  const fill = (points, colour, line) => {
    g.beginPath();
    points.forEach(([x, y], i) => (i ? g.lineTo(x, y) : g.moveTo(x, y)));
    g.closePath(), (g.fillStyle = colour), g.fill();
    if (line) (g.strokeStyle = "#00000055"), g.stroke();
  };
  (g.fillStyle = "#e3e8ee"), g.fillRect(0, 0, w, h);
  if (S.floor !== null) {
    const horizon = Math.max(0, Math.min(h, h / 2 - (S.focal * half * back[1]) / Math.hypot(back[0], back[2])));
    (g.fillStyle = "#d6d7d4"), g.fillRect(0, horizon, w, h - horizon);
  }
  const shapes = [];
  for (const part of S.parts) {
    const at = 7 * (Math.floor(frame) * S.bodies + part.body);
    if (!Number.isFinite(poses[at])) continue;
    const points = part.points.map((p) => placed(at, p)), n = points.length;
    const middle = [0, 1, 2].map((i) => points.reduce((sum, p) => sum + p[i], 0) / n);
    const radius = Math.max(...points.map((p) => Math.hypot(...minus(p, middle))));
    shapes.push({ part, points, middle, radius, depth: -dot(back, minus(middle, eye)) + (part.fixed && radius > S.size ? 1e9 : 0) });
    if (S.floor === null || part.fixed) continue;
    const fallen = points.map((p) => p.map((x, i) => x - (light[i] / light[1]) * (p[1] - S.floor)));
    fill(hull(fallen.map(seen)), "#00000030");
  }
  shapes.sort((a, b) => b.depth - a.depth);
  g.lineJoin = "round";
  for (const { part, points, middle, radius } of shapes) {
    if (!part.faces) {
      fill(hull(points.map(seen)), shade(part.colour, 0.95), true);
      const glow = points.map((p) => p.map((x, i) => middle[i] + 0.55 * (x - middle[i]) + 0.25 * radius * light[i]));
      fill(hull(glow.map(seen)), shade(part.colour, 1.12));
      const mark = points.filter((_, i) => i % 4 === 0).map(seen); // that it turns
      g.fillStyle = "#00000022";
      for (const [x, y] of mark.slice(0, 3)) g.fillRect(x - 1, y - 1, 2, 2);
    } else
      for (const face of part.faces) {
        const normal = unit(cross(minus(points[face[1]], points[face[0]]), minus(points[face[2]], points[face[0]])));
        if (dot(normal, minus(eye, points[face[0]])) > 0)
          fill(face.map((k) => seen(points[k])), shade(part.colour, 0.7 + 0.4 * Math.max(0, dot(normal, light))), true);
      }
  }
  (slider.value = Math.floor(frame)), (told.textContent = (Math.floor(frame) / S.rate).toFixed(2) + " s");
}
function play(on) { (playing = on), (button.textContent = on ? "Pause" : "Play"), (from = performance.now() - (1000 * frame) / S.rate); }
slider.max = frames - 1;
button.onclick = () => { if (!playing && frame >= frames - 1) frame = 0; play(!playing); };
slider.oninput = () => { play(false), (frame = Number(slider.value)), draw(); };
canvas.onpointerdown = (e) => canvas.setPointerCapture(e.pointerId);
canvas.onpointermove = (e) => {
  if (!e.buttons) return;
  around -= 0.008 * e.movementX, (above = Math.min(1.5, Math.max(-0.2, above + 0.008 * e.movementY))), draw();
};
canvas.addEventListener("wheel", (e) => { e.preventDefault(), (zoom *= Math.exp(-0.001 * e.deltaY)), draw(); }, { passive: false });
new ResizeObserver(draw).observe(canvas);
if (matchMedia("(prefers-reduced-motion: reduce)").matches) play(false);
else play(true);
(function tick(now) {
  requestAnimationFrame(tick);
  if (!playing) return;
  frame = ((now ?? performance.now()) - from) * S.rate / 1000;
  if (frame > frames - 1 + S.rate) (from = performance.now()), (frame = 0); // a second at its end, then again
  frame = Math.max(0, Math.min(frames - 1, frame)), draw();
})();
</script>"""
