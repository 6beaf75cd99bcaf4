// The tool "Rays": what the fan meets, and that no bit depends on it.
import { strict as assert } from "node:assert";
import { after, before, test } from "node:test";
import { across, scan } from "../src/rays.js";
import { Browser, now, skip } from "./browser.mjs";

let browser;
before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

test("two vectors across a direction are unit, and square to it and to each other", () => {
  for (const n of [
    [0, 1, 0],
    [0, -1, 0],
    [1, 0, 0],
    [0.6, 0, -0.8],
    [2 / 3, -1 / 3, 2 / 3],
  ]) {
    const [u, v] = across(n);
    for (const [a, b, wanted] of [
      [u, u, 1],
      [v, v, 1],
      [u, v, 0],
      [u, n, 0],
      [v, n, 0],
    ])
      assert.ok(Math.abs(dot(a, b) - wanted) < 1e-15, `${n}: ${dot(a, b)} is not ${wanted}`);
  }
});

/** Ground at height 0, and a round wall of a radius about an axis that stands at x, open where z is below 0 if `half`. */
function arena(radius, x = 0, half = false, up = 1) {
  return {
    castRay(origin, direction, max) {
      if (origin[1] < 0) return { outcome: 1, time: 0, normal: [0, 1, 0], point: origin, body: {} }; // within the ground
      if (Math.abs(direction[1]) > 1e-9)
        return origin[1] / -direction[1] > 0
          ? { outcome: 1, time: origin[1] / -direction[1], normal: [0, up, 0], point: [origin[0], 0, origin[2]], body: {} }
          : null;
      const p = [origin[0] - x, origin[2]],
        b = p[0] * direction[0] + p[1] * direction[2],
        time = -b + Math.sqrt(b * b - (p[0] * p[0] + p[1] * p[1] - radius * radius)),
        point = origin.map((c, i) => c + time * direction[i]);
      return time > max || (half && point[2] < -1e-9) ? null : { outcome: 1, time, point, normal: [0, 1, 0], body: {} };
    },
  };
}

test("the fan meets a round wall on all sides, half a wall on one, and none beyond its reach", () => {
  const down = [
    [0, 5, 0],
    [0, -1, 0],
  ];
  assert.ok(scan(arena(3, 0, false, -1), ...down, 10).nearest > 2.9, "whichever way the surface's normal is told");
  const whole = scan(arena(3), ...down, 10);
  assert.equal(whole.hits, 90);
  assert.ok(Math.abs(whole.nearest - 3) < 1e-12, String(whole.nearest));
  for (const [from, to] of whole.lines.slice(1)) assert.ok(Math.abs(Math.hypot(to[0] - from[0], to[2] - from[2]) - 3) < 1e-12);
  const aside = scan(arena(3, 1), ...down, 10);
  assert.ok(Math.abs(aside.nearest - 2) < 1e-2, `${aside.nearest}: the wall is 2 m off on one side`);
  const half = scan(arena(3, 0, true), ...down, 10).hits;
  assert.ok(half >= 44 && half <= 47, `half a wall: ${half}`);
  assert.deepEqual([scan(arena(30), ...down, 10).hits, scan(arena(30), ...down, 10).nearest], [0, Infinity]);
  assert.equal(scan(arena(3), [0, 5, 0], [0, 1, 0], 10), null, "the sky");
});

test("rays tell what they meet, go with the scene, and change no bit", { skip, timeout: 180000 }, async () => {
  for (const scene of ["accuracy_stack10", "wall", "seesaw"]) {
    const page = await browser.visit(`?scene=${scene}&step=1`),
      box = await page.locator("#view").boundingBox(),
      told = () => page.locator("#told").textContent();
    await page.click('[data-tool="rays"]');
    assert.match(await told(), /^Point at something$/);
    await page.mouse.move(box.x + box.width / 2, box.y + 0.75 * box.height);
    assert.match(await told(), /m from the eye; (\d+ of 90 rays around meet something|no ray around)/, scene);
    await page.mouse.move(box.x + 5, box.y + 60);
    assert.match(await told(), /^the ray meets nothing$|m from the eye/, scene);
    await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
    const first = await told(),
      nearest = /the nearest after ([-\d.e]+) m/.exec(first);
    assert.ok(!nearest || Number(nearest[1]) > 0, `${scene}: ${first}`);
    for (let i = 0; i < 20; ++i) await page.click("#step");
    assert.equal((await now(page)).native, "true", `${scene}: the native bits`);
    assert.match(first, /^.+, [\d.]+ m from the eye/);
    await page.click('[data-tool="grab"]');
    assert.doesNotMatch(await told(), /ray/);
    await page.close();
  }
  assert.deepEqual(browser.complaints(), []);
});
