// Accuracy scenes with their truth as a ghost: how far off they are, where the ghosts stand, and when they go.
import { strict as assert } from "node:assert";
import { readFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { Browser, skip } from "./browser.mjs";

let browser, scenes;
before(async () => {
  if (skip) return;
  const index = JSON.parse(await readFile(new URL("../dist/scenes/index.json", import.meta.url)));
  scenes = index.filter((row) => row.truth);
  browser = await Browser.start();
});
after(() => browser?.end());

const look = (page) =>
  page.evaluate(() => {
    const [picture] = caromViewer.state.pictures;
    picture.update();
    return {
      error: picture.error(),
      visible: picture.ghosts.group.visible,
      bodies: picture.ghosts.places.filter((place) => place >= 0).length,
      drawn: picture.ghosts.meshes.reduce((n, mesh) => n + mesh.count, 0),
      told: document.getElementById("off").textContent,
    };
  });

test("every scene with a truth starts in it and draws a ghost of each body", { skip, timeout: 600000 }, async (t) => {
  const page = await browser.visit("?scene=accuracy_slide&step=0", { viewport: { width: 420, height: 320 } });
  assert.ok(scenes.length >= 20, `${scenes.length} scenes`);
  for (const row of scenes) {
    await page.selectOption("#scene", row.name);
    await page.waitForFunction((name) => caromViewer.state.row.name === name, row.name);
    await page.evaluate(() => caromViewer.seek(0));
    const first = await look(page);
    // Where a scene starts is rounded once on each side.
    assert.ok(first.error < 1e-12, `${row.name} starts ${first.error} m off`);
    assert.equal(first.bodies, row.truth.bodies.length, row.name);
    assert.ok(first.drawn >= first.bodies && first.visible, `${row.name}: ${first.drawn} of ${first.bodies} drawn`);
  }
  t.diagnostic(`${scenes.length} scenes`);
  await page.close();
});

test("the distance is that from the closed form", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=accuracy_freefall&step=240");
  // carom accuracy run freefall: below 1e-9 m, the scene's bound
  let seen = await look(page);
  assert.ok(seen.error < 1e-9, `${seen.error}`);
  assert.match(seen.told, /m off the truth/);
  await page.selectOption("#scene", "accuracy_slide");
  await page.waitForFunction(() => caromViewer.state.row.name === "accuracy_slide");
  await page.evaluate(() => caromViewer.seek(60));
  seen = await look(page);
  assert.ok(seen.error > 0 && seen.error < 0.1, `${seen.error}`);
  // The ghost stands where v t - mu g t^2 / 2 has it: at 1 s both blocks stand, 25 / (2 0.5 9.81) m along.
  const way = await page.evaluate(() => {
    const { truth } = caromViewer.state.row;
    const [from, to] = [truth.at(0)[0], truth.at(120)[0]];
    return to - from;
  });
  assert.ok(Math.abs(way - 25 / 9.81) < 1e-12, `${way}`);
  await page.close();
});

test("ghosts go by their switch, where the truth ends, and with their body", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=accuracy_slide&step=10");
  await page.evaluate(() => (caromViewer.state.pictures[0].shown.truth = false));
  assert.equal((await look(page)).visible, false);
  await page.evaluate(() => (caromViewer.state.pictures[0].shown.truth = true));
  assert.equal((await look(page)).visible, true);
  await page.evaluate(() => {
    const [sim] = caromViewer.state.sims;
    const body = sim.bodies.findIndex((b) => b.type === "dynamic");
    sim.do({ do: "remove", body });
    caromViewer.state.pictures[0].update();
  });
  assert.equal((await look(page)).bodies, 1);
  await page.evaluate(() => caromViewer.seek(130)); // the scene's 2 s are over
  const end = await look(page);
  assert.ok(Number.isNaN(end.error) && !end.visible, JSON.stringify(end));
  assert.match(end.told, /not known/);
  await page.close();
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
