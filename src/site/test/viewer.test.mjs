// The page in headless Chromium: every control used, hashes before pixels, no console error, hostile files refused.
//   npm run build && npm test
//   CAROM_SITE_STEPS=240 npm test        as many steps of every scene are compared; 30 by default
import { strict as assert } from "node:assert";
import { mkdtemp, readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, field, now, skip, title } from "./browser.mjs";

const STEPS = Number(process.env.CAROM_SITE_STEPS ?? 30);
let browser, scenes;

before(async () => {
  if (skip) return;
  scenes = JSON.parse(await readFile(new URL("../dist/scenes/index.json", import.meta.url)));
  browser = await Browser.start();
});
after(() => browser?.end());
const visit = (query, viewport) => browser.visit(query, viewport && { viewport });

test("every scene has the native build's bits", { skip, timeout: 1800000 }, async (t) => {
  const page = await visit("?scene=wall&step=1", { width: 420, height: 320 });
  let compared = 0;
  for (const row of scenes) {
    await page.selectOption("#scene", row.name);
    await page.waitForFunction((name) => caromViewer.state.row.name === name, row.name);
    // Without a picture of each step: a browser that draws by its processor takes a second for one. Then back.
    const got = await page.evaluate((most) => {
      const [sim] = caromViewer.state.sims,
        hashes = [sim.hash()];
      for (let step = 1; step <= most; ++step) (sim.advance(), hashes.push(sim.hash()));
      sim.seek(most - 5);
      return [...hashes, sim.hash()];
    }, STEPS);
    const wanted = Array.from({ length: STEPS + 1 }, (_, step) => row.hashes[step]);
    assert.deepEqual(got, [...wanted, row.hashes[STEPS - 5]], row.name);
    compared += got.length;
  }
  await page.click("#step");
  assert.equal((await now(page)).native, "true");
  t.diagnostic(`${scenes.length} scenes, ${compared} hashes`);
  await page.close();
});

test("time: play, pause, step, back, scrub, reset, keys", { skip, timeout: 120000 }, async () => {
  const page = await visit("?scene=stacks&step=5"),
    row = scenes.find((r) => r.name === "stacks");
  assert.deepEqual((await now(page)).hash, row.hashes[5]);
  (await page.click("#step"), assert.equal((await now(page)).step, 6));
  (await page.click("#back"), await page.click("#back"), assert.equal((await now(page)).hash, row.hashes[4]));
  (await page.fill("#scrub", "2"), assert.equal((await now(page)).hash, row.hashes[2]));
  await page.focus("#view");
  (await page.keyboard.press("ArrowRight"), assert.equal((await now(page)).hash, row.hashes[3]));
  (await page.keyboard.press("ArrowLeft"), assert.equal((await now(page)).hash, row.hashes[2]));
  await page.selectOption("#speed", "2");
  (await page.click("#play"), await page.waitForFunction(() => caromViewer.step > 8), await page.click("#play"));
  const { step, hash } = await now(page);
  if (row.hashes[step]) assert.equal(hash, row.hashes[step]);
  (await page.click("#reset"), assert.equal((await now(page)).hash, row.hashes[0]));
  (await page.click("#theme"), await page.click("#theme"));
  await page.close();
});

test("tools act, and a link brings back what was done, to the bit", { skip, timeout: 180000 }, async () => {
  const page = await visit("?scene=stacks&step=1");
  const count = () => page.evaluate(() => caromViewer.state.sims[0].bodies.length);
  const box = await page.locator("#view").boundingBox(),
    at = [box.x + box.width * 0.5, box.y + box.height * 0.55];
  const before = await count();
  (await page.click('[data-tool="throw"]'), await page.mouse.click(...at));
  assert.equal(await count(), before + 1);
  (await page.click('[data-tool="box"]'), await page.mouse.click(...at));
  assert.equal(await count(), before + 2);
  const target = await page.evaluate(() => {
    // where a dynamic body is seen
    const { state } = caromViewer,
      canvas = document.getElementById("view");
    for (let v = 0.3; v < 0.8; v += 0.02)
      for (let u = 0.2; u < 0.8; u += 0.02) {
        const p = document.elementFromPoint(
          canvas.getBoundingClientRect().left + u * canvas.clientWidth,
          canvas.getBoundingClientRect().top + v * canvas.clientHeight,
        );
        if (p !== canvas) continue;
        const hit = caromViewer.probe(u, v);
        if (hit && state.sims[0].bodies[hit.body].type === "dynamic") return [u, v];
      }
    return null;
  });
  assert.ok(target, "a body is in sight");
  const spot = [box.x + target[0] * box.width, box.y + target[1] * box.height];
  await page.click('[data-tool="grab"]');
  (await page.mouse.move(...spot), await page.mouse.down(), await page.mouse.move(spot[0] + 30, spot[1] - 60));
  for (let i = 0; i < 5; ++i) await page.evaluate(() => document.getElementById("step").click());
  await page.mouse.up();
  const log = await page.evaluate(() => caromViewer.state.sims[0].log().map(([, a]) => a.do));
  assert.equal(log.filter((d) => d === "pull").length, 5);
  (await page.click('[data-tool="follow"]'), await page.mouse.click(...spot));
  (await page.click('[data-tool="delete"]'), await page.mouse.click(...spot));
  for (let i = 0; i < 20; ++i) await page.evaluate(() => document.getElementById("step").click());
  const done = await now(page);
  await page.click("#link");
  const other = await visit(new URL(page.url()).search);
  assert.deepEqual(await now(other), { ...done, message: "" });
  await other.evaluate((s) => (caromViewer.seek(3), caromViewer.seek(s)), done.step);
  assert.equal((await now(other)).hash, done.hash, "after scrubbing back and forth");
  (await page.close(), await other.close());
});

test("dials, presets, plan, drawings, comparison", { skip, timeout: 180000 }, async () => {
  const page = await visit("?scene=pyramid&step=10&dials=substeps:2");
  assert.equal(await page.evaluate(() => caromViewer.state.sims[0].world.dial("substeps")), 2);
  await title(page, "Settings").click();
  await field(page, "preset").locator("select").selectOption({ label: "accurate" });
  assert.notEqual(await page.evaluate(() => caromViewer.state.sims[0].world.dial("substeps")), 2);
  await field(page, /^substeps/)
    .first()
    .locator('[type="number"]')
    .fill("3");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => caromViewer.state.sims[0].world.dial("substeps")), 3);
  // A dial that goes by factors, in the unit that people use: 30 Hz, then three times it by the slider.
  const stiff = field(page, /^contact frequency/);
  assert.equal(await stiff.locator("i").innerText(), "Hz");
  const hertz = () => page.evaluate(() => caromViewer.state.sims[0].world.dial("contact_frequency"));
  await stiff.locator('[type="number"]').fill("30");
  await page.keyboard.press("Enter");
  assert.equal(await hertz(), 30);
  const notch = Number(await stiff.locator('[type="range"]').inputValue());
  await stiff.locator('[type="range"]').fill(String(notch + 20));
  assert.ok((await hertz()) > 33 && (await hertz()) < 200, `${await hertz()} Hz`);
  assert.equal(Number(await stiff.locator('[type="number"]').inputValue()), Number((await hertz()).toPrecision(4)));
  // And one in mm, which the engine has in m.
  await title(page, "All dials").click();
  const near = field(page, /^contact distance/);
  assert.equal(await near.locator("i").innerText(), "mm");
  await near.locator('[type="number"]').fill("25");
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => caromViewer.state.sims[0].world.dial("contact_distance")), 0.025);
  await page.click("#step");
  await page.locator("summary", { hasText: "What a step runs" }).click();
  await page.locator('#plan select[aria-label^="friction"]').selectOption("1");
  assert.equal(await page.evaluate(() => caromViewer.state.sims[0].log().some(([, a]) => a.do === "effect")), true);
  await page.locator("summary", { hasText: "Energy by cause" }).click();
  for (let i = 0; i < 5; ++i) await page.click("#step");
  assert.match(await page.locator("#causes-table").innerText(), /contact|integrator|friction/);
  const sums = await page.evaluate(() => {
    const [sim] = caromViewer.state.sims,
      { causes, step } = sim;
    return [step, [...causes.values()].filter((list) => Number.isFinite(list[step - 1])).length];
  });
  assert.ok(sums[1] > 10, `${sums}`);
  await title(page, "Draw").click();
  for (const name of ["contacts", "bounds", "outlines", "frames", "islands"])
    await field(page, name).last().locator("input").check();
  await page.click("#step");
  assert.ok(await page.evaluate(() => caromViewer.state.pictures[0].lines.geometry.drawRange.count > 100));
  await page.check("#compare");
  assert.equal(await page.evaluate(() => caromViewer.state.sims.length), 2);
  await page.evaluate(() => caromViewer.state.sims[1].do({ do: "dial", name: "substeps", value: 1 }));
  for (let i = 0; i < 10; ++i) await page.evaluate(() => document.getElementById("step").click());
  assert.ok(await page.evaluate(() => caromViewer.state.difference.at(-1) > 0));
  await page.click("#link");
  const hashes = await page.evaluate(() => caromViewer.state.sims.map((s) => s.hash()));
  const other = await visit(new URL(page.url()).search);
  assert.deepEqual(await other.evaluate(() => caromViewer.state.sims.map((s) => s.hash())), hashes);
  (await page.close(), await other.close());
});

test("an accuracy is asked for: it acts at once, islands tell, a link has it", { skip, timeout: 180000 }, async () => {
  const page = await visit("?scene=ragdoll&step=5");
  const asked = () => page.evaluate(() => caromViewer.state.sims[0].world.accuracy),
    slide = (stop) => page.locator("#accuracy-slider").fill(String(stop));
  assert.equal(await page.locator("#accuracy-slider").inputValue(), "1");
  assert.equal(await asked(), null);
  assert.equal(await page.locator("#accuracy-list").isVisible(), false);
  const work = {};
  for (const [stop, tolerance] of [
    [2, 1e-1],
    [6, 1e-5],
  ]) {
    await slide(stop);
    assert.deepEqual(await asked(), { place: tolerance, turn: tolerance, substeps: 256 });
    await page.click("#step");
    const islands = await page.evaluate(() =>
      caromViewer.state.sims[0].world.islands().map(({ share, work }) => ({ share, work })),
    );
    assert.ok(islands.length > 0 && islands.every(({ share }, i) => i === 0 || share <= islands[i - 1].share));
    work[stop] = islands.reduce((sum, island) => sum + island.work, 0);
    assert.match(await page.locator("#accuracy-cost").innerText(), new RegExp(`ms a step, ${work[stop]} substep`));
    assert.match(await page.locator("#accuracy-error").innerText(), /[\d.]+ \S?m a second, by the engine's estimate/);
    await page.evaluate(() => (document.getElementById("accuracy-list").open = true));
    const rows = await page.locator("#accuracy-islands tbody tr").allInnerTexts();
    assert.equal(rows.length, Math.min(12, islands.length));
    for (const text of rows)
      assert.match(text, /^\d+( \+\d+)?\s[\d.e-]+ (%|times)( bound| stalled)?\s+\d+\s+\d+\s+\d+$/);
    assert.match(
      await page.locator("#accuracy-sum").innerText(),
      new RegExp(`^${islands.length} island.* ${work[stop]} `),
    );
  }
  assert.ok(work[2] > 0 && work[6] > 0, JSON.stringify(work)); // orders differ, so more need not cost more
  await page.locator("#accuracy-islands button").first().click();
  assert.notEqual(await page.evaluate(() => caromViewer.state.following), null);
  for (let i = 0; i < 5; ++i) await page.click("#step");
  const done = await now(page);
  await page.click("#link");
  const other = await visit(new URL(page.url()).search);
  assert.deepEqual(await now(other), { ...done, message: "" });
  assert.equal(await other.locator("#accuracy-slider").inputValue(), "6");
  await other.close();
  // In a comparison each side has its own.
  await title(page, "Settings").click();
  await page.check("#compare");
  await page.selectOption("#accuracy-side", "1");
  await slide(1);
  const sides = () => page.evaluate(() => caromViewer.state.sims.map((sim) => sim.world.accuracy?.place ?? null));
  assert.deepEqual(await sides(), [1e-5, null]);
  assert.equal(await page.locator("#accuracy-list").isVisible(), false);
  // A rough step is one substep of first order; and back, the usual dials are as they were.
  const dials = () =>
    page.evaluate(() =>
      ["substeps", "solver", "integrator", "rotation", "joint_order"].map((name) =>
        caromViewer.state.sims[1].world.dial(name),
      ),
    );
  const usual = await dials();
  await slide(0);
  assert.deepEqual(await dials(), [1, 1, 1, 2, 0]);
  await slide(1);
  assert.deepEqual(await dials(), usual);
  await page.close();
});

test(
  "beside a rough step, in one click: what stands falls there, and a link has both",
  { skip, timeout: 180000 },
  async () => {
    // m, at most, after 120 steps: what stands does not move; a coin on a tray is led astray by each step's error.
    for (const [scene, most] of [
      ["accuracy_tower100", 1e-6],
      ["accuracy_overhang", 1e-6],
      ["accuracy_thin_arch", 1e-6],
      ["accuracy_massratio1e4", 1e-6],
      ["accuracy_reach", 1e-3],
      ["accuracy_tray", 1e-2],
    ]) {
      const page = await visit(`?scene=${scene}&step=1`);
      await page.locator("#accuracy-slider").fill("4");
      // What has fallen does not rise: the scene begins anew, with that setting.
      const anew = () => [caromViewer.state.sims[0].settings.length, caromViewer.state.sims[0].log().length];
      assert.deepEqual(await page.evaluate(anew), [2, 0]);
      await page.click("#accuracy-duel");
      await page.click("#play");
      await page.evaluate(() => caromViewer.seek(120));
      const off = await page.evaluate(() => caromViewer.state.sims.map((sim) => sim.errors[120]));
      assert.ok(off[0] > 0.01 && off[1] < most, `${scene}: ${off} m`);
      assert.match(await page.locator("#label-a").innerText(), /^A: a rough step, [\d.]+ c?m off$/);
      assert.match(await page.locator("#label-b").innerText(), /^B: 1 mm accepted, /);
      await page.click("#link");
      const hashes = () => caromViewer.state.sims.map((s) => s.hash());
      const other = await visit(new URL(page.url()).search);
      assert.deepEqual(await other.evaluate(hashes), await page.evaluate(hashes));
      (await other.close(), await page.close());
    }
  },
);

test("numbers of this moment, and curves with axes", { skip, timeout: 60000 }, async () => {
  const page = await visit("?scene=accuracy_tower100&step=30");
  const told = await page.locator("#numbers").innerText(),
    { bodies, contacts } = await page.evaluate(() => {
      const [sim] = caromViewer.state.sims;
      return { bodies: sim.bodies.length, contacts: Number(sim.report.contact_points) };
    });
  assert.ok(contacts > 0);
  assert.match(
    told.replace(/\s+/g, " "),
    new RegExp(`bodies ${bodies} contacts ${contacts} ms/step [\\d.e-]+ frames/s –`),
  );
  await page.click("#play");
  await page.waitForFunction(() => Number(document.getElementById("frames").textContent) > 0);
  // Ink left of the axis: numbers stand there.
  for (const id of ["energy", "cost", "error"]) {
    const ink = await page.evaluate((name) => {
      const canvas = document.getElementById(name),
        { data } = canvas.getContext("2d").getImageData(0, 0, 40, canvas.height);
      return data.filter((x, i) => i % 4 === 3 && x > 0).length;
    }, id);
    assert.ok(ink > 20, id);
  }
  await page.close();
});

test(
  "files: saved ones open, hostile ones and wrong links are told of and change nothing",
  { skip, timeout: 180000 },
  async () => {
    const page = await visit("?scene=stacks&step=7"),
      folder = await mkdtemp(join(tmpdir(), "carom-"));
    const [download] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
    const saved = join(folder, "saved.world");
    await download.saveAs(saved);
    const { hash } = await now(page),
      bytes = await readFile(saved);
    const damaged = Buffer.from(bytes);
    damaged[bytes.length >> 1] ^= 0x40;
    for (const [name, content] of [
      ["empty", Buffer.alloc(0)],
      ["text", Buffer.from("not a world at all")],
      ["damaged", damaged],
      ["cut", bytes.subarray(0, bytes.length / 2)],
      ["noise", Buffer.alloc(100000, 0xa5)],
    ]) {
      const file = join(folder, `${name}.world`);
      await writeFile(file, content);
      await page.evaluate(() => (document.getElementById("message").hidden = true));
      await page.setInputFiles("#open", file);
      await page.waitForFunction(() => !document.getElementById("message").hidden);
      const after = await now(page);
      assert.ok(after.message.length > 20, name);
      assert.equal(after.hash, hash, name);
    }
    await page.setInputFiles("#open", saved);
    await page.waitForFunction(() => caromViewer.step === 0);
    assert.equal((await now(page)).hash, hash);
    await page.close();
    for (const [query, told] of [
      ["?scene=nowhere", /no scene "nowhere"; choose one of/],
      ["?scene=wall&step=-1", /step is not a whole number/],
      ["?scene=wall&step=x", /step is not a whole number/],
      ["?scene=wall&dials=nonsense:1", /dial "nonsense" does not exist/],
      ["?scene=wall&do=%5B%5B", /actions are damaged/],
      ["?scene=wall&preset=best", /preset "best" is none of fast, balanced/],
      ["?scene=wall&dials=substeps:99999", /dial substeps is 99999: it goes from 1 to 64/],
      ["?scene=wall&dials=substeps:1e99", /dial substeps is 1e99: it goes from 1 to 64/],
      ["?scene=wall&dials=contact_frequency:-1", /contact_frequency is -1: it goes from 0 to 10000 Hz/],
      ["?scene=wall&dials=substeps", /dial substeps has no number/],
      ["?scene=wall&dials=substeps:2.5", /substeps/],
      ["?scene=wall&dials=solver:1.5", /solver/],
      ["?scen=wall", /"scen" means nothing here: scene, step/],
      ['?scene=wall&do=[[0,{"do":"constructor"}]]', /no action "constructor"/],
      ['?scene=wall&do=[[0,{"do":"dial","name":"substeps","value":99999}]]', /substeps/],
    ]) {
      const wrong = await visit(query);
      const { message } = await now(wrong);
      assert.match(message, told, query);
      assert.doesNotMatch(message, /alive/, query);
      await wrong.close();
    }
  },
);

test("10,000 steps take no more memory than 1,000", { skip, timeout: 600000 }, async (t) => {
  const page = await visit("?scene=bullet&step=1");
  const session = await page.context().newCDPSession(page);
  const run = async (n) => {
    const module = await page.evaluate((k) => {
      const [sim] = caromViewer.state.sims;
      for (let i = 0; i < k; ++i) sim.advance();
      return sim.world.module.buffer.byteLength;
    }, n);
    await session.send("HeapProfiler.collectGarbage");
    const { usedSize } = await session.send("Runtime.getHeapUsage");
    return { module, heap: usedSize };
  };
  const early = await run(1000),
    late = await run(9000);
  t.diagnostic(`module ${late.module} bytes; heap ${early.heap} bytes after 1,000 steps, ${late.heap} after 10,000`);
  assert.equal(late.module, early.module);
  // Two numbers a step for the curves, and an object for each snapshot that can be gone back to.
  assert.ok(late.heap - early.heap < 9000 * 2 * 16 + (9000 / 20) * 1000);
  await page.close();
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
