// What the page looks like: golden pictures, a telephone, and that pictures of before are given back.
//   CAROM_GOLDEN=write npm test        writes the golden pictures anew: look at them before they are committed
import { strict as assert } from "node:assert";
import { readFile, writeFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { Browser, now, skip } from "./browser.mjs";

const MEAN = 2; // of 255: how far the mean pixel may be from the golden one; drivers differ in edges and shadows
const FAR = 0.02; // share of pixels that may be off by more than 48 of 255
let browser;

before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());

/** Both decoded by the browser.   @returns { mean: of 255, far: share of pixels } */
const difference = (page, a, b) =>
  page.evaluate(
    async (pictures) => {
      const [x, y] = await Promise.all(
        pictures.map(async (base64) => {
          const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${base64}`)).blob());
          const canvas = new OffscreenCanvas(bitmap.width, bitmap.height),
            context = canvas.getContext("2d");
          context.drawImage(bitmap, 0, 0);
          return context.getImageData(0, 0, bitmap.width, bitmap.height);
        }),
      );
      if (x.width !== y.width || x.height !== y.height) return { mean: 255, far: 1 };
      let sum = 0,
        far = 0;
      for (let i = 0; i < x.data.length; i += 4) {
        const off = Math.max(...[0, 1, 2].map((k) => Math.abs(x.data[i + k] - y.data[i + k])));
        ((sum += off), (far += off > 48));
      }
      return { mean: (sum * 4) / x.data.length, far: (far * 4) / x.data.length };
    },
    [a, b].map((bytes) => bytes.toString("base64")),
  );

test("golden pictures, light and dark", { skip, timeout: 180000 }, async (t) => {
  const drawn = {};
  for (const [name, query, colorScheme] of [
    ["stacks-light", "?scene=stacks&step=1", "light"],
    ["stacks-dark", "?scene=stacks&step=1", "dark"],
    ["ragdoll-light", "?scene=ragdoll&step=40", "light"],
  ]) {
    const page = await browser.visit(query, {
      viewport: { width: 700, height: 480 },
      colorScheme,
      deviceScaleFactor: 1,
    });
    // The picture alone: letters differ from machine to machine.
    drawn[name] = Buffer.from(
      await page.evaluate(() => {
        const canvas = Object.assign(document.createElement("canvas"), { width: 240, height: 160 });
        canvas.getContext("2d").drawImage(document.getElementById("view"), 0, 0, 240, 160);
        return canvas.toDataURL("image/png").split(",")[1];
      }),
      "base64",
    );
    const file = new URL(`golden/${name}.png`, import.meta.url);
    if (process.env.CAROM_GOLDEN === "write") await writeFile(file, drawn[name]);
    const off = await difference(page, drawn[name], await readFile(file));
    t.diagnostic(`${name}: mean ${off.mean.toFixed(2)} of 255, ${(100 * off.far).toFixed(2)} % far off`);
    assert.ok(off.mean <= MEAN && off.far <= FAR, name);
    await page.close();
  }
  // The measure tells pictures apart: themes by their colours, scenes by what stands in them.
  const page = await browser.visit("?scene=stacks&step=1");
  for (const other of ["stacks-dark", "ragdoll-light"]) {
    const off = await difference(page, drawn["stacks-light"], drawn[other]);
    assert.ok(off.mean > 2 * MEAN || off.far > 2 * FAR, `${other}: ${JSON.stringify(off)}`);
  }
  await page.close();
});

test("on a telephone: fits, and fingers throw and grab", { skip, timeout: 180000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=1", {
    viewport: { width: 390, height: 844 },
    isMobile: true,
    hasTouch: true,
    deviceScaleFactor: 1,
  });
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  const box = await page.locator("#view").boundingBox();
  assert.ok(box.width > 340 && box.height > 240, `the picture is ${box.width} by ${box.height}`);
  const small = await page.evaluate(() =>
    [...document.querySelectorAll("#tools button:not([hidden]), #transport button, #transport select, header select")]
      .map((e) => [e.textContent.slice(0, 20), e.getBoundingClientRect().height])
      .filter(([, height]) => height < 24),
  );
  assert.deepEqual(small, [], "what fingers press is 24 px high at least");
  const bodies = () => page.evaluate(() => caromViewer.state.sims[0].bodies.length);
  const before = await bodies();
  await page.tap('[data-tool="throw"]');
  await page.touchscreen.tap(box.x + box.width / 2, box.y + box.height * 0.6);
  assert.equal(await bodies(), before + 1);
  await page.tap("#step");
  assert.equal((await now(page)).step, 2);
  await page.close();
});

test("scenes that were shown before are given back", { skip, timeout: 300000 }, async (t) => {
  const page = await browser.visit("?scene=stacks&step=1", { viewport: { width: 420, height: 320 } });
  const round = async () => {
    for (const name of ["bullet", "ragdoll", "stacks"]) {
      await page.selectOption("#scene", name);
      await page.waitForFunction((n) => caromViewer.state.row.name === n, name);
    }
    return page.evaluate(() => ({
      ...caromViewer.held,
      module: caromViewer.state.sims[0].world.module.buffer.byteLength,
    }));
  };
  const first = await round();
  for (let i = 0; i < 3; ++i) assert.deepEqual(await round(), first, `round ${i + 2}`);
  t.diagnostic(JSON.stringify(first));
  await page.close();
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
