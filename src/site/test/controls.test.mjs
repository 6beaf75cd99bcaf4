// Every control of the page, at four widths, light and dark: it acts without an error, nothing is cut off, and it has a
// name for readers of screens.
import { strict as assert } from "node:assert";
import { after, before, test } from "node:test";
import { Browser, skip } from "./browser.mjs";

let browser;
before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());

/** What is cut off, reaches out of its box or of the page, or is covered. */
const cut = (page) =>
  page.evaluate(() => {
    const wrong = [],
      shown = (e) => e.getClientRects().length > 0 && getComputedStyle(e).visibility !== "hidden",
      name = (e) =>
        `${e.tagName.toLowerCase()}${e.id ? `#${e.id}` : ""} "${(e.textContent || e.value || "").trim().slice(0, 30)}"`;
    if (document.documentElement.scrollWidth > innerWidth)
      wrong.push(`the page is ${document.documentElement.scrollWidth} px wide`);
    for (const e of document.querySelectorAll(
      "button, select, input, label, summary, canvas, td, th, dd, dt, h1, h2, output, p, code",
    )) {
      if (!shown(e) || e.closest(".file")) continue;
      const box = e.getBoundingClientRect();
      if (box.width && (box.left < -0.5 || box.right > innerWidth + 0.5)) wrong.push(`${name(e)} leaves the page`);
      const around = e.closest("aside > *");
      if (around) {
        const outer = around.getBoundingClientRect();
        if (box.right > outer.right + 0.5)
          wrong.push(`${name(e)} leaves its box by ${Math.round(box.right - outer.right)} px`);
      }
      // Letters that do not fit. What is long on purpose says so by dots, and is told whole elsewhere.
      const style = getComputedStyle(e);
      if (
        e.scrollWidth > e.clientWidth + 1 &&
        e.clientWidth &&
        style.overflowX !== "visible" &&
        style.textOverflow !== "ellipsis" &&
        e.tagName !== "CANVAS"
      )
        wrong.push(`${name(e)} is ${e.scrollWidth - e.clientWidth} px too long`);
    }
    return wrong;
  });

/** Use all controls that there are, as a visitor's hand would change them.   @returns how many of which kind */
const useAll = (page) =>
  page.evaluate(async () => {
    for (const box of document.querySelectorAll("details")) box.open = true;
    const shown = (e) => e.getClientRects().length > 0 && !e.disabled;
    const count = { range: 0, number: 0, checkbox: 0, select: 0, button: 0 },
      fire = (e, kind) => e.dispatchEvent(new Event(kind, { bubbles: true })),
      nameless = [],
      breath = () => new Promise((done) => setTimeout(done));
    for (const e of document.querySelectorAll("input, select, button")) {
      if (!shown(e) || e.type === "file") continue;
      if (!(e.ariaLabel || e.getAttribute("aria-labelledby") || e.labels?.length || e.textContent.trim()))
        nameless.push(e.id || e.outerHTML.slice(0, 60));
      if (e.matches("#scene, #trials, #save, #shot, #film, #code, #theme")) continue; // another scene, a download; tried by themselves
      if (e.textContent === "Make the scene anew") continue; // by `carom view`: command.test.mjs
      if (e.type === "range") {
        const was = e.value;
        for (const share of [0.2, 0.6]) {
          e.value = String(Number(e.min) + share * (Number(e.max) - Number(e.min)));
          fire(e, "input");
        }
        ((e.value = was), fire(e, "input")); // or steps would take for ever
        ++count.range;
      } else if (e.type === "number") {
        const was = e.value;
        for (const value of ["", "nonsense", "1e400", was]) ((e.value = value), fire(e, "change"));
        ++count.number;
      } else if (e.type === "checkbox") {
        (e.click(), await breath(), e.click());
        ++count.checkbox;
      } else if (e.tagName === "SELECT") {
        const was = e.value;
        for (const { value } of [...e.options]) ((e.value = value), fire(e, "change"));
        ((e.value = was), fire(e, "change"));
        ++count.select;
      } else {
        e.click();
        ++count.button;
      }
      // A scene that plays takes the time; that it does is tried elsewhere.
      if (caromViewer.state.playing) document.getElementById("play").click();
      await breath();
    }
    return { count, nameless };
  });

const WIDTHS = [360, 820, 1440, 1920],
  SCENES = ["accuracy_arch", "ragdoll", "drive"];
for (const width of WIDTHS)
  for (const colorScheme of ["light", "dark"])
    test(`every control at ${width} px, ${colorScheme}`, { skip, timeout: 300000 }, async (t) => {
      for (const scene of SCENES) {
        const page = await browser.visit(`?scene=${scene}&step=3`, {
          viewport: { width, height: width < 700 ? 780 : 900 },
          colorScheme,
          deviceScaleFactor: 1,
        });
        assert.equal(await page.evaluate(() => document.documentElement.dataset.theme), colorScheme);
        assert.deepEqual(await cut(page), [], `${scene}, as it opens`);
        if (scene !== SCENES[0] && width !== WIDTHS[0]) {
          await page.evaluate(() => document.querySelectorAll("details").forEach((box) => (box.open = true)));
          assert.deepEqual(await cut(page), [], `${scene}, all open`);
          await page.close();
          continue;
        }
        const { count, nameless } = await useAll(page);
        assert.deepEqual(nameless, [], "controls without a name");
        assert.ok(
          count.range > 25 && count.number > 25 && count.checkbox > 7 && count.select > 15 && count.button > 11,
          JSON.stringify(count),
        );
        assert.deepEqual(await cut(page), [], `${scene}, all open and used`);
        // It still goes on.
        await page.evaluate(() => (document.getElementById("reset").click(), document.getElementById("step").click()));
        assert.equal(await page.evaluate(() => caromViewer.step), 1);
        const before = await page.evaluate(() => document.documentElement.dataset.theme);
        await page.click("#theme");
        assert.notEqual(await page.evaluate(() => document.documentElement.dataset.theme), before);
        assert.deepEqual(await cut(page), [], `${scene}, the other theme`);
        if (scene === SCENES[0]) t.diagnostic(JSON.stringify(count));
        await page.close();
      }
    });

test("every scene can be chosen, and each trial", { skip, timeout: 300000 }, async (t) => {
  const page = await browser.visit("?scene=stacks&step=1", { viewport: { width: 420, height: 320 } });
  const names = await page.locator("#scene option").evaluateAll((all) => all.map((o) => o.value));
  for (const name of names) {
    await page.selectOption("#scene", name);
    await page.waitForFunction((n) => caromViewer.state.row.name === n, name);
    assert.ok(await page.evaluate(() => document.getElementById("message").hidden), name);
  }
  const trials = (await page.locator("#trials option").evaluateAll((all) => all.map((o) => o.value))).filter(Boolean);
  for (const name of trials) {
    await page.selectOption("#trials", name);
    await page.waitForFunction((n) => caromViewer.state.row.name === n && caromViewer.state.playing, name);
    assert.ok(await page.evaluate(() => caromViewer.state.pictures[0].ghosts), name);
  }
  assert.equal(trials.length, 9);
  t.diagnostic(`${names.length} scenes`);
  await page.close();
});

test(
  "a frame of the documentation: the picture, its tools and time, nothing else",
  { skip, timeout: 60000 },
  async () => {
    for (const width of [340, 700]) {
      const page = await browser.visit("?scene=seesaw&embed=1", { viewport: { width, height: 560 } });
      for (const id of ["view", "play", "scrub", "whole"]) assert.ok(await page.locator(`#${id}`).isVisible(), id);
      for (const id of ["scene", "accuracy-box", "panel", "link"])
        assert.ok(!(await page.locator(`#${id}`).isVisible()), id);
      assert.deepEqual(await cut(page), [], `${width} px`);
      assert.ok(
        await page.evaluate(() => document.documentElement.scrollHeight <= innerHeight),
        `${width} px: it scrolls`,
      );
      assert.match(await page.locator("#whole").getAttribute("href"), /\?scene=seesaw$/);
      await page.waitForFunction(() => caromViewer.step > 3);
      await page.close();
    }
  },
);

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
