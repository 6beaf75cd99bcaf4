// What a stranger sees first: it moves by itself, all of it is in the picture at every width, and it is drawn as well as
// the machine can.
import { strict as assert } from "node:assert";
import { after, before, test } from "node:test";
import { Browser, skip } from "./browser.mjs";

const WIDTHS = [360, 820, 1440, 1920];
let browser;

before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());

const stepsIn = async (page, ms) => {
  const before = await page.evaluate(() => caromViewer.step);
  await page.waitForTimeout(ms);
  return (await page.evaluate(() => caromViewer.step)) - before;
};

test("it plays by itself, but not for people who ask for less motion", { skip, timeout: 120000 }, async () => {
  const small = { viewport: { width: 420, height: 320 } };
  for (const query of ["", "?scene=seesaw", "?scene=ragdoll&dials=substeps:2", "?scene=stacks&step=3&play=1"]) {
    const page = await browser.visit(query, small);
    await page.waitForFunction((from) => caromViewer.step > from + 3, 3);
    await page.close();
  }
  for (const [query, options] of [
    ["?scene=seesaw&step=3", small], // a link to a moment
    ["?scene=seesaw", { ...small, reducedMotion: "reduce" }],
  ]) {
    const page = await browser.visit(query, options);
    assert.equal(await stepsIn(page, 600), 0, query);
    await page.click("#play");
    await page.waitForFunction(() => caromViewer.step > 5);
    await page.close();
  }
});

test("out of sight nothing is computed", { skip, timeout: 60000 }, async () => {
  const page = await browser.visit("?scene=seesaw", { viewport: { width: 420, height: 320 } });
  await page.waitForFunction(() => caromViewer.step > 3);
  await page.evaluate(() => {
    document.body.style.paddingBottom = "3000px";
    scrollTo(0, 2500);
  });
  await page.waitForFunction(() => !caromViewer.state.inSight);
  assert.equal(await stepsIn(page, 500), 0);
  await page.evaluate(() => scrollTo(0, 0));
  await page.waitForFunction(() => caromViewer.state.inSight);
  const { step } = await page.evaluate(() => ({ step: caromViewer.step }));
  await page.waitForFunction((from) => caromViewer.step > from, step);
  await page.close();
});

test("a scene that nobody touched begins anew, one that was touched goes on", { skip, timeout: 60000 }, async () => {
  const page = await browser.visit("?scene=accuracy_cannon", { viewport: { width: 420, height: 320 } });
  const ends = await page.evaluate(() => Math.ceil((caromViewer.state.row.seconds + 1.5) / caromViewer.state.row.dt));
  await page.waitForFunction((n) => caromViewer.state.sims[0].newest >= n && caromViewer.step < n / 2, ends);
  await page.keyboard.press("Shift");
  await page.waitForFunction((n) => caromViewer.step > n + 10, ends);
  await page.close();
});

/** How far out the balls about bodies reach in the picture: 1 is its edge. */
const seen = (page) =>
  page.evaluate(() => {
    const { stage, state } = caromViewer,
      { camera } = stage,
      at = camera.position.clone();
    let most = 0;
    for (const picture of state.pictures)
      for (const [x, y, z, r] of picture.balls(true))
        for (const k of [-r, r])
          // where its ball ends above and below, in axes of the camera, and at both sides
          for (const axis of [0, 1]) {
            at.set(x, y, z).applyMatrix4(camera.matrixWorldInverse);
            at.setComponent(axis, at.getComponent(axis) + k).applyMatrix4(camera.projectionMatrix);
            most = Math.max(most, Math.abs(at.x), Math.abs(at.y));
          }
    return most;
  });

test("every body is in the picture at every width, light and dark", { skip, timeout: 300000 }, async () => {
  for (const width of WIDTHS)
    for (const colorScheme of ["light", "dark"])
      for (const scene of ["wall", "pyramid", "seesaw", "net", "accuracy_stack20", "accuracy_kapla"]) {
        const page = await browser.visit(`?scene=${scene}&step=1`, {
          viewport: { width, height: width < 700 ? 780 : 800 },
          colorScheme,
        });
        const most = await seen(page);
        assert.ok(most < 1 && most > 0.45, `${scene} at ${width} px: ${most}`);
        assert.ok(
          await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth),
          `${scene} at ${width} px`,
        );
        await page.close();
      }
});

test("the camera follows what moves, until a visitor turns it", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=accuracy_freefall&step=1", { viewport: { width: 700, height: 480 } });
  // 10 s of falling are 490 m.
  await page.evaluate(() => {
    const { state, stage } = caromViewer;
    for (let i = 0; i < 500; ++i)
      (state.sims[0].advance(), state.pictures[0].update(), stage.follow(state.pictures, 1 / 60));
    stage.render(state.pictures);
  });
  assert.ok((await seen(page)) < 1);
  const box = await page.locator("#view").boundingBox();
  await page.mouse.move(box.x + 30, box.y + box.height - 30);
  await page.mouse.down();
  await page.mouse.move(box.x + 90, box.y + box.height - 60);
  await page.mouse.up();
  await page.click("#step");
  assert.equal(await page.evaluate(() => caromViewer.stage.auto), false);
  await page.click("#fit");
  assert.equal(await page.evaluate(() => caromViewer.stage.auto), true);
  assert.ok((await seen(page)) < 1);
  await page.close();
});

test("quality falls before frames do, and comes back", { skip, timeout: 60000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=1", { viewport: { width: 420, height: 320 } });
  const told = await page.evaluate(() => {
    const { stage } = caromViewer,
      first = stage.quality;
    for (let i = 0; i < 20; ++i) stage.adapt(60);
    const worse = stage.quality;
    for (let i = 0; i < 2000; ++i) stage.adapt(60);
    const worst = stage.quality;
    stage.best = 0;
    for (let i = 0; i < 400; ++i) stage.adapt(5);
    return { first, worse, worst, better: stage.quality };
  });
  assert.equal(told.worse, told.first + 1);
  assert.ok(told.worst > told.worse && told.better < told.worst, JSON.stringify(told));
  await page.close();
});

test("a bunny is drawn by its mesh, not by the hull that collides", { skip, timeout: 60000 }, async () => {
  const page = await browser.visit("?scene=seesaw&step=1", { viewport: { width: 420, height: 320 } });
  const [corners, instances] = await page.evaluate(() => {
    const { state } = caromViewer,
      mesh = state.pictures[0].meshes.find((m) => m.userData.kind === "bunny");
    return [mesh.geometry.attributes.position.count, mesh.count];
  });
  assert.equal(instances, 1);
  assert.ok(corners > 300, `${corners}`); // the hull has 256 at most
  await page.close();
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
