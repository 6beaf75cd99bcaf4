// The code beside the picture: the examples' own files, in five languages; each program's world is shown, with the bits of its
// own run; one that a visitor changed runs, and what is wrong with it is told.
import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { after, before, test } from "node:test";
import { examples } from "../docs/examples.mjs";
import { gallery } from "../docs/gallery.mjs";
import { Browser, now, skip } from "./browser.mjs";

let browser;
before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());

test(
  "every example is a scene, and its world is that of the program, step by step",
  { skip, timeout: 600000 },
  async (t) => {
    let hashes = 0;
    for (const { name, says } of examples()) {
      const page = await browser.visit(`?scene=example_${name}&step=1`);
      assert.equal((await now(page)).message, "", name);
      const { steps, same } = await page.evaluate(() => {
        const { state } = caromViewer,
          [sim] = state.sims,
          all = Object.keys(state.row.hashes);
        let same = 0;
        for (const step of all.slice(0, 400))
          (caromViewer.seek(Number(step)), (same += sim.hash() === state.row.hashes[step]));
        return { steps: Math.min(400, all.length), same };
      });
      assert.ok(steps >= 60 && same === steps, `${name}: ${same} of ${steps} steps`);
      hashes += same;
      assert.deepEqual(await page.evaluate(() => caromViewer.state.row.printed), [says], name);
      assert.ok((await page.locator("#about").textContent()).includes(says), name);
      await page.close();
    }
    t.diagnostic(`${hashes} hashes`);
  },
);

test(
  "the code is the examples' files, and is copied; what a visitor changed runs",
  { skip, timeout: 180000 },
  async () => {
    const page = await browser.visit("?scene=example_stack&step=1&code=1", {
      permissions: ["clipboard-read", "clipboard-write"],
    });
    const box = page.locator("#code-box"),
      printed = box.locator('[data-code="printed"]'),
      { files } = examples().find(({ name }) => name === "stack");
    for (const [language, name] of Object.entries({
      c: "C",
      cpp: "C++",
      python: "Python",
      rust: "Rust",
      js: "JavaScript",
    })) {
      await box.getByRole("tab", { name, exact: true }).click();
      await page.waitForFunction(
        (text) =>
          [...document.querySelectorAll("#code-box pre, #code-box textarea")].some(
            (e) => (e.value ?? e.textContent) === text,
          ),
        readFileSync(files[language], "utf8"),
      );
      await box.getByRole("button", { name: "Copy" }).click();
      assert.equal(
        await page.evaluate(() => navigator.clipboard.readText()),
        readFileSync(files[language], "utf8"),
        name,
      );
      await page.waitForFunction(() => document.querySelector('[data-code="copy"]').textContent === "Copy");
    }
    const edit = box.locator("textarea"),
      run = box.getByRole("button", { name: "Run" });
    const text = await edit.inputValue();
    await edit.fill(text.replace("i < 10", "i < 4").replace("boxes[9]", "boxes[3]").replace("y - 9.5", "y - 3.5"));
    await run.click();
    await page.waitForFunction(() => /y = 3\.50/.test(document.querySelector('[data-code="printed"]').textContent));
    assert.equal(await page.evaluate(() => caromViewer.state.sims[0].bodies.length), 5);
    for (const [program, told] of [
      [text.replace("y - 9.5", "y - 9"), /stopped: an assertion is false/],
      ["let a = ;", /SyntaxError/],
      ['import fs from "node:fs";', /not node:fs/],
      [text.replace("0.5, 0.5, 0.5", "-1, 1, 1"), /CaromError.*between|CaromError/],
    ]) {
      await edit.fill(program);
      await run.click();
      await page.waitForFunction(
        ([source, flags]) =>
          new RegExp(source, flags).test(document.querySelector('[data-code="printed"]').textContent),
        [told.source, told.flags],
      );
    }
    await edit.fill("for (;;);");
    await run.click();
    await page.waitForFunction(
      () => /did not end/.test(document.querySelector('[data-code="printed"]').textContent),
      null,
      {
        timeout: 60000,
      },
    );
    await edit.fill(text);
    await run.click();
    await page.waitForFunction(() => /y = 9\.50/.test(document.querySelector('[data-code="printed"]').textContent));
    assert.ok(await printed.isVisible());
    await page.close();
  },
);

test(
  "each scene has the code of its kind; the list of scenes and the gallery are one",
  { skip, timeout: 120000 },
  async () => {
    const page = await browser.visit("?scene=ragdoll&step=1&code=1");
    const listed = await page.locator("#scene option").evaluateAll((all) => all.map((one) => one.value));
    const shown = gallery().flatMap(({ scenes }) => scenes.map(({ name }) => name));
    assert.deepEqual(listed.sort(), shown.sort());
    for (const [scene, title] of [
      ["drive", "A car"],
      ["accuracy_arch", "An accuracy that is asked for"],
      ["weather", "Saving and loading"],
    ]) {
      await page.selectOption("#scene", scene);
      await page.waitForFunction((t) => document.querySelector('[data-code="title"]').textContent === t, title);
    }
    await page.close();
  },
);

test("the code at four widths: nothing leaves the page", { skip, timeout: 120000 }, async () => {
  for (const width of [360, 820, 1440, 1920]) {
    const page = await browser.visit("?scene=example_car&step=1&code=1", { viewport: { width, height: 800 } });
    for (const name of ["C", "JavaScript"]) {
      await page.locator("#code-box").getByRole("tab", { name, exact: true }).click();
      const over = await page.evaluate(() => [
        document.documentElement.scrollWidth - innerWidth,
        ...[...document.querySelectorAll("#code-box *, header *")]
          .filter((e) => e.getClientRects().length)
          .map((e) => e.getBoundingClientRect().right - innerWidth),
      ]);
      assert.ok(Math.max(...over) <= 0.5, `${name} at ${width} px: ${Math.max(...over)}`);
    }
    await page.close();
  }
});

test("a picture and a film are files", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=5");
  const [picture] = await Promise.all([page.waitForEvent("download"), page.click("#shot")]);
  assert.equal(picture.suggestedFilename(), "stacks-5.png");
  const png = readFileSync(await picture.path());
  assert.ok(png.length > 5000 && png.subarray(1, 4).toString() === "PNG");
  await page.click("#film");
  assert.equal(await page.getAttribute("#film", "aria-pressed"), "true");
  await page.waitForTimeout(1500);
  const [film] = await Promise.all([page.waitForEvent("download"), page.click("#film")]);
  assert.match(film.suggestedFilename(), /^stacks-\d+\.(webm|mp4)$/);
  assert.ok(readFileSync(await film.path()).length > 5000);
  await page.close();
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
