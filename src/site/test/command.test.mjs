// The page as `carom view` serves it: what a newcomer does first. The command is CAROM, or that of a build folder.
import { strict as assert } from "node:assert";
import { spawn } from "node:child_process";
import { existsSync } from "node:fs";
import { after, before, test } from "node:test";
import { fileURLToPath } from "node:url";
import { Browser, field, now, skip as unseen, title } from "./browser.mjs";

const here = (path) => fileURLToPath(new URL(path, import.meta.url));
const command =
  process.env.CAROM ?? [here("../../../build/demo/bin/carom"), here("../../../build/test/bin/carom")].find(existsSync);
const skip = unseen || (!command && "no carom command: cmake --preset demo && cmake --build --preset demo");
let browser;
before(async () => {
  if (!skip) browser = await Browser.start();
});
const served = []; // a test that fails leaves its command running: node would wait for it
after(() => (served.forEach((child) => child.kill("SIGINT")), browser?.end()));

/** Its address, and how it is ended. */
function view(...words) {
  const child = spawn(command, ["view", "--site", here("../dist"), "--port", "0", ...words]);
  served.push(child);
  return new Promise((ready, fail) => {
    let said = "";
    const hear = (some) => {
      said += some;
      const address = /http:\S+/.exec(said)?.[0];
      if (address) ready({ address, end: () => child.kill("SIGINT") });
    };
    (child.stdout.on("data", hear), child.stderr.on("data", hear));
    child.on("exit", () => fail(new Error(`carom view ${words.join(" ")}: ${said}`)));
  });
}

test("carom view: throw a ball, drag a dial, compare", { skip, timeout: 180000 }, async () => {
  const { address, end } = await view();
  const page = await browser.visit(address);
  await page.waitForFunction(() => caromViewer.step > 3); // it plays by itself
  const bodies = () => page.evaluate(() => caromViewer.state.sims[0].bodies.length);
  const before = await bodies(),
    box = await page.locator("#view").boundingBox();
  await page.click('[data-tool="throw"]');
  await page.mouse.click(box.x + box.width / 2, box.y + box.height / 2);
  assert.equal(await bodies(), before + 1);
  await page.click("#play");
  await title(page, "Settings").click();
  const dial = () => page.evaluate(() => caromViewer.state.sims[0].world.dial("substeps"));
  const was = await dial(),
    slider = await field(page, /^substeps/)
      .first()
      .locator('[type="range"]')
      .boundingBox();
  await page.mouse.move(slider.x + slider.width * 0.1, slider.y + slider.height / 2);
  await page.mouse.down();
  await page.mouse.move(slider.x + slider.width * 0.6, slider.y + slider.height / 2, { steps: 4 });
  await page.mouse.up();
  assert.notEqual(await dial(), was, "the dial went along");
  await page.check("#compare");
  for (let i = 0; i < 3; ++i) await page.click("#step");
  assert.deepEqual(await page.evaluate(() => caromViewer.state.sims.map((sim) => sim.bodies.length)), [
    before + 1,
    before + 1,
  ]);
  assert.equal((await now(page)).message, "");
  (await page.close(), end());
});

test("the Scene button makes scenes of other numbers, with native bits", { skip, timeout: 900000 }, async (t) => {
  const { address, end } = await view("stacks");
  const page = await browser.visit(`${address}?scene=stacks&step=1`);
  const rows = await page.evaluate(async () => (await fetch("scenes/index.json")).json()),
    numbered = rows.filter((row) => row.knobs?.length);
  await title(page, "Settings").click();
  await title(page, "Scene: its own numbers").click();
  for (const { name } of numbered) {
    await page.selectOption("#scene", name);
    await page.waitForFunction((n) => caromViewer.state.row.name === n && !caromViewer.state.row.made, name);
    await page.locator("#panel button", { hasText: "Make the scene anew" }).click();
    // The command packs it, with its hashes: on a machine that does other work that takes its time.
    await page.waitForFunction(() => caromViewer.state.row.made || !document.getElementById("message").hidden, null, {
      timeout: 120000,
    });
    assert.equal((await now(page)).message, "", name);
    await page.click("#step");
    assert.equal((await now(page)).native, "true", name);
  }
  t.diagnostic(`${numbered.length} scenes`);
  // Another number: fewer bodies.
  await page.selectOption("#scene", "stacks");
  await page.waitForFunction(() => caromViewer.state.row.name === "stacks" && !caromViewer.state.row.made);
  const count = () => page.evaluate(() => caromViewer.state.sims[0].bodies.length);
  const before = await count();
  const n = field(page, /^n\b/).first().locator('[type="number"]');
  (await n.fill("2"), await n.press("Enter"));
  await page.locator("#panel button", { hasText: "Make the scene anew" }).click();
  await page.waitForFunction(() => caromViewer.state.row.made?.n === 2);
  assert.ok((await count()) < before, `${await count()} bodies, ${before} before`);
  (await page.close(), end());
});

test("carom view accuracy/slide: its truth, and A beside B with ghosts", { skip, timeout: 180000 }, async () => {
  const { address, end } = await view("accuracy/slide", "--dial", "substeps=2");
  const page = await browser.visit(address);
  assert.equal(await page.evaluate(() => caromViewer.state.row.name), "accuracy_slide");
  assert.equal(await page.inputValue("#scene"), "accuracy_slide");
  await page.click("#play");
  await title(page, "Settings").click();
  await page.check("#compare");
  await page.evaluate(() => {
    caromViewer.seek(0); // it played until now
    caromViewer.state.sims[1].do({ do: "dial", name: "substeps", value: 1 });
  });
  for (let i = 0; i < 20; ++i) await page.click("#step");
  const seen = await page.evaluate(() => ({
    ghosts: caromViewer.state.pictures.map(({ ghosts }) => ghosts.group.visible && ghosts.meshes.length > 0),
    errors: caromViewer.state.pictures.map((picture) => picture.error()),
    apart: caromViewer.state.difference[caromViewer.step],
    labels: ["a", "b"].map((side) => document.getElementById(`label-${side}`).textContent),
    told: document.getElementById("off").textContent,
  }));
  assert.deepEqual(seen.ghosts, [true, true]);
  assert.ok(
    seen.errors.every((error) => error > 0 && error < 0.1),
    `${seen.errors}`,
  );
  assert.ok(seen.apart > 0, "fewer substeps end elsewhere");
  seen.labels.forEach((label, i) => assert.match(label, new RegExp(`^${"AB"[i]}: usual dials, [\\d.]+ .?m off$`)));
  assert.equal(seen.told.match(/off the truth/g)?.length, 2, seen.told);
  (await page.close(), end());
});

test("threads: the same bits, forwards, back and beside each other", { skip, timeout: 180000 }, async (t) => {
  const { address, end } = await view("falling");
  const built = existsSync(here("../dist/carom.threads.wasm")); // else the page would ask for it, and the console tell
  const page = await browser.visit(`${address}?${built ? "threads=2&" : ""}scene=falling&step=1`);
  assert.ok(await page.evaluate(() => crossOriginIsolated), "carom view isolates its page");
  if (built) {
    assert.equal(await page.evaluate(() => caromViewer.threads), 2);
    const got = await page.evaluate(() => {
      const hashes = [];
      for (let i = 0; i < 30; ++i) (caromViewer.state.sims[0].advance(), hashes.push(caromViewer.hash));
      caromViewer.seek(12);
      return [...hashes, caromViewer.hash];
    });
    const row = await page.evaluate(() => caromViewer.state.row.hashes);
    assert.deepEqual(got, [...Array.from({ length: 30 }, (_, i) => row[i + 2]), row[12]]);
    await title(page, "Settings").click();
    await page.check("#compare");
    await page.click("#step");
    assert.deepEqual(await page.evaluate(() => caromViewer.state.sims.map((sim) => sim.hash())), [row[13], row[13]]);
    const [saved] = await Promise.all([page.waitForEvent("download"), page.click("#save")]);
    assert.equal(await saved.failure(), null);
    assert.equal((await now(page)).message, "");
  } else t.diagnostic("carom.threads.wasm is not built");
  await page.close();
  const wrong = await browser.visit(`${address}?threads=many`);
  assert.match((await now(wrong)).message, /whole number.*one thread/);
  assert.equal(await wrong.evaluate(() => caromViewer.threads), 1);
  (await wrong.close(), end());
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
