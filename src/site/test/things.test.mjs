// Things to do: a car, a character and an arm are steered; what is thrown, blown up and cut is felt; all of it comes back
// by going back, and by a link, to the bit.
import { strict as assert } from "node:assert";
import { after, before, test } from "node:test";
import { Browser, now, skip } from "./browser.mjs";

let browser;
before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());
const small = { viewport: { width: 700, height: 520 } };

/** What is asked of the driver from a step on, then so many steps.   @param parts  [[value, steps], ...] */
const steer = (page, parts) =>
  page.evaluate((list) => {
    const [sim] = caromViewer.state.sims;
    for (const [value, steps] of list) {
      if (value) sim.do({ do: "input", value });
      for (let i = 0; i < steps; ++i) sim.advance();
    }
    const { driver } = sim;
    return { hash: sim.hash(), step: sim.step, poses: driver.poses(), told: driver.told(), speed: driver.speed };
  }, parts);

/** Gone back to, and opened as a link, it is the same. */
async function comesBack(page, wanted) {
  const at = () =>
    page.evaluate(() => {
      const [sim] = caromViewer.state.sims;
      return [sim.hash(), JSON.stringify(sim.driver?.poses())];
    });
  const here = await at();
  assert.equal(here[0], wanted.hash);
  for (const step of [wanted.step - 7, 3, 0]) {
    await page.evaluate(([past, present]) => (caromViewer.seek(past), caromViewer.seek(present)), [step, wanted.step]);
    assert.deepEqual(await at(), here, `from step ${step}`);
  }
  await page.click("#link");
  const other = await browser.visit(new URL(page.url()).search, small);
  assert.equal((await now(other)).hash, wanted.hash, "by a link");
  await other.close();
}

test("a car drives, steers, brakes and goes back", { skip, timeout: 180000 }, async () => {
  const page = await browser.visit("?scene=drive&step=0", small);
  await steer(page, [[null, 60]]); // it settles on its springs
  const fast = await steer(page, [[[1, 0, 0], 90]]);
  assert.ok(fast.speed > 5, `${fast.speed} m/s after 1.5 s of full throttle`);
  const turned = await steer(page, [[[1, 1, 0], 40]]);
  const heading = await page.evaluate(() => caromViewer.state.sims[0].driver.heading());
  assert.ok(heading[0] > 0.2, `to the left, which is +x: ${heading}`);
  const slow = await steer(page, [[[-1, 0, 0], 150]]);
  assert.ok(slow.speed < 0.3 * turned.speed, `${slow.speed} m/s, ${turned.speed} before it braked`);
  const back = await steer(page, [[[-1, 0, 0], 120]]);
  assert.ok(back.speed < -1, `${back.speed} m/s`);
  for (const [x, y] of back.poses) assert.ok(Number.isFinite(x) && y > 0.2 && y < 0.6, "wheels stand on the ground");
  await comesBack(page, back);
  await page.close();
});

test(
  "keys and the pad steer; a held key is one action, and time's keys come back elsewhere",
  { skip, timeout: 120000 },
  async () => {
    const page = await browser.visit("?scene=drive", small);
    await page.focus("#view");
    await page.keyboard.down("w");
    await page.waitForFunction(() => caromViewer.state.sims[0].driver.speed > 2);
    await page.keyboard.up("w");
    await page.waitForFunction(() => caromViewer.state.sims[0].driver.value()[0] === 0);
    assert.equal(await page.evaluate(() => caromViewer.state.sims[0].log().length), 2, "down and up");
    const pad = await page.locator('[data-key="left"]').boundingBox();
    await page.mouse.move(pad.x + 20, pad.y + 20);
    await page.mouse.down();
    await page.waitForFunction(() => caromViewer.state.sims[0].driver.value()[1] === 1);
    await page.mouse.up();
    await page.waitForFunction(() => caromViewer.state.sims[0].driver.value()[1] === 0);
    await page.selectOption("#scene", "stacks");
    await page.waitForFunction(() => caromViewer.state.row.name === "stacks");
    assert.equal(await page.locator("#pad").isVisible(), false);
    await page.focus("#view");
    await page.keyboard.press(" ");
    assert.equal(await page.evaluate(() => caromViewer.state.playing), false);
    await page.close();
  },
);

test("a character climbs steps and 40 degrees, not 60, jumps, pushes, rides", { skip, timeout: 180000 }, async () => {
  const feet = ({ poses }) => poses[0][1] - 0.9;
  const course = () => browser.visit("?scene=walk&step=0", small);
  /** Set down somewhere, then asked for something.   @returns where it was, how high at most, and the crates */
  const from = async (position, value, steps) => {
    const page = await course();
    const seen = await page.evaluate(
      ([to, asked, n]) => {
        const [sim] = caromViewer.state.sims,
          { driver } = sim,
          crates = () =>
            sim.bodies.filter((_, i) => caromViewer.state.row.bodies[i]?.[1] === "crate").map((b) => b.position);
        driver.m.structs.write(driver.m.view, "carom_character", driver.state, { position: to, ground: 0 });
        for (let i = 0; i < 40; ++i) sim.advance(); // it lands
        sim.do({ do: "input", value: asked });
        const begin = driver.place(),
          stood = crates();
        let high = 0;
        for (let i = 0; i < n; ++i) (sim.advance(), (high = Math.max(high, driver.place()[1] - 0.9)));
        const end = driver.place(),
          pushed = crates().map((c, k) => Math.hypot(...c.map((x, j) => x - stood[k][j])));
        return { begin, end, high, pushed: Math.max(...pushed) };
      },
      [position, value, steps],
    );
    await page.close();
    return seen;
  };
  const page = await course();
  await steer(page, [[null, 20]]);
  const up = await steer(page, [[[0, 1, 0], 150]]);
  assert.ok(Math.abs(feet(up) - 1.33) < 0.03, `${feet(up)} m up`); // six steps of 0.22 m
  await comesBack(page, up);
  await page.close();
  for (const [z, climbs] of [
    [2, true],
    [5, true],
    [8, false],
  ]) {
    const { high } = await from([1.5, 1, z], [1, 0, 0], 160);
    assert.equal(high > 1, climbs, `slope at z = ${z}: ${high} m`);
  }
  // v t - g t^2 / 2 at 5 m/s is 1.27 m at most
  const { high } = await from([0, 1, 0], [0, 0, 1], 45);
  assert.ok(high > 1.15 && high < 1.3, `${high} m`);
  const { pushed } = await from([-3, 1, 1.5], [0, 1, 0], 90);
  assert.ok(pushed > 0.5, `${pushed} m`);
  const { begin, end } = await from([-5, 1.3, 6], [0, 0, 0], 90);
  assert.ok(Math.abs(end[2] - begin[2] - 1.5) < 0.05, `${end[2] - begin[2]} m`); // 1 m/s, 1.5 s
});

test("an arm brings its hand to a mark, wherever that is", { skip, timeout: 180000 }, async () => {
  const page = await browser.visit("?scene=arm&step=0", small);
  let end;
  for (const mark of [
    [1.2, 1.4, -0.4],
    [0.5, 1.9, 0.6],
    [-0.9, 0.5, -0.8],
    [0.4, 0.4, -0.9],
  ]) {
    const value = await page.evaluate((to) => {
      const { mark: reached, angles } = caromViewer.state.sims[0].driver.solve(to);
      return [...reached, ...angles];
    }, mark);
    end = await steer(page, [[value, 240]]);
    const off = await page.evaluate(() => caromViewer.state.sims[0].driver.off());
    assert.ok(off < 1e-3, `${mark}: ${off} m`);
    assert.match(end.told, /mm from the mark/);
  }
  await comesBack(page, end);
  // Out of reach the mark stays where the arm ends.
  const reached = await page.evaluate(() => caromViewer.state.sims[0].driver.solve([5, 5, 0]).mark);
  assert.ok(Math.hypot(reached[0], reached[1] - 0.9, reached[2]) < 1.9);
  await page.close();
});

/** Where in the picture a dynamic body is, or one that a joint holds. */
const spot = (page, jointed = false) =>
  page.evaluate((asked) => {
    const { state } = caromViewer,
      [sim] = state.sims,
      canvas = document.getElementById("view"),
      box = canvas.getBoundingClientRect(),
      held = new Set(asked ? sim.world.joints().flatMap(({ desc }) => [desc.body_a, desc.body_b]) : []);
    for (let v = 0.3; v < 0.9; v += 0.02)
      for (let u = 0.2; u < 0.8; u += 0.02) {
        const at = [box.left + u * box.width, box.top + v * box.height];
        if (document.elementFromPoint(...at) !== canvas) continue;
        const hit = caromViewer.probe(u, v),
          body = hit && sim.bodies[hit.body];
        if (body?.type === "dynamic" && (!asked || held.has(body.handle))) return at;
      }
    return null;
  }, jointed);

test("what is thrown is felt, whatever the scene's size", { skip, timeout: 180000 }, async (t) => {
  for (const scene of ["stacks", "pyramid", "accuracy_kapla", "accuracy_stack10", "seesaw"]) {
    const page = await browser.visit(`?scene=${scene}&step=1`, small);
    await page.click('[data-tool="throw"]');
    await page.mouse.click(...(await spot(page)));
    const moved = await page.evaluate(() => {
      const [sim] = caromViewer.state.sims,
        size = caromViewer.stage.size,
        from = sim.bodies.map((b) => b.position);
      for (let i = 0; i < 90; ++i) sim.advance();
      return sim.bodies
        .slice(0, -1)
        .filter((b, i) => Math.hypot(...b.position.map((x, k) => x - from[i][k])) > 0.02 * size).length;
    });
    t.diagnostic(`${scene}: ${moved} bodies moved`);
    assert.ok(moved >= 3, `${scene}: ${moved} bodies moved`);
    await page.close();
  }
});

test("explode and cut: they act, and a link has them", { skip, timeout: 180000 }, async () => {
  const blast = await browser.visit("?scene=stacks&step=1", small);
  await blast.click('[data-tool="explode"]');
  const energy = () => blast.evaluate(() => caromViewer.state.sims[0].energy.at(-1));
  const before = await energy();
  await blast.mouse.click(...(await spot(blast)));
  await blast.click("#step");
  assert.ok((await energy()) > before + 1000);
  await comesBack(blast, await now(blast).then(({ hash, step }) => ({ hash, step: Math.max(step, 2) })));
  await blast.close();
  for (const scene of ["ragdoll", "net"]) {
    const page = await browser.visit(`?scene=${scene}&step=10`, small);
    const joints = () => page.evaluate(() => caromViewer.state.sims[0].world.joints().length);
    const all = await joints();
    await page.click('[data-tool="cut"]');
    await page.mouse.click(...(await spot(page, true)));
    assert.ok((await joints()) < all, `${scene}: ${await joints()} of ${all} joints`);
    for (let i = 0; i < 5; ++i) await page.click("#step");
    const { hash, step } = await now(page);
    await comesBack(page, { hash, step });
    await page.close();
  }
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
