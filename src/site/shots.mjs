// The films of both READMEs, taken of the built page by headless Chromium: node shots.mjs (npm run shots).
import { writeFileSync } from "node:fs";
import { Browser, skip } from "./test/browser.mjs";

const WIDTH = 720,
  MS = 50, // that a frame is seen
  REST = 2000, // likewise of the last one
  QUALITY = 0.42;

/** An animation of still WebP pictures: each becomes an ANMF chunk of one file.
 *  @param stills [Buffer] */
function animated(stills, width, height) {
  const u24 = (x) => Buffer.from([x & 255, (x >> 8) & 255, x >> 16]);
  const chunk = (name, content) => {
    const size = Buffer.alloc(4);
    size.writeUInt32LE(content.length);
    return Buffer.concat([Buffer.from(name), size, content, Buffer.alloc(content.length & 1)]);
  };
  const canvas = [u24(width - 1), u24(height - 1)];
  const frames = stills.map((still, i) => {
    // "RIFF", size, "WEBP", then chunks; of a still without alpha VP8 alone is needed.
    for (let at = 12; at < still.length;) {
      const name = still.toString("latin1", at, at + 4),
        size = still.readUInt32LE(at + 4);
      if (name === "VP8 ") {
        const picture = chunk(name, still.subarray(at + 8, at + 8 + size));
        return chunk("ANMF", Buffer.concat([u24(0), u24(0), ...canvas, u24(i + 1 < stills.length ? MS : REST), Buffer.from([2]), picture]));
      }
      at += 8 + size + (size & 1);
    }
    throw new Error("the browser's WebP has no VP8 picture");
  });
  const content = Buffer.concat([
    Buffer.from("WEBP"),
    chunk("VP8X", Buffer.concat([Buffer.from([2, 0, 0, 0]), ...canvas])),
    chunk("ANIM", Buffer.alloc(6)), // for ever
    ...frames,
  ]);
  return chunk("RIFF", content);
}

if (skip) throw new Error(skip);
const browser = await Browser.start(),
  here = new URL(".", import.meta.url).pathname;
/** As a graphics card draws it: a browser without one begins with cheaper shadows. */
const soft = (page) =>
  page.evaluate(() => {
    caromViewer.stage.quality = 1;
    caromViewer.stage.render(caromViewer.state.pictures);
  });
const options = { viewport: { width: 1280, height: 800 }, colorScheme: "light" };
const studio = await (await browser.browser.newContext()).newPage();

/** Write what a tab shows, step by step, as a film.   @param steps  from one frame to the next   @param before(frame)  is done first */
async function film(page, name, frames, steps, before = () => {}) {
  const stills = [];
  let height;
  for (let i = 0; i < frames; ++i) {
    await before(i);
    await page.evaluate((n) => {
      for (let k = 1; k < n; ++k) for (const sim of caromViewer.state.sims) sim.advance();
      document.getElementById("step").click();
    }, steps);
    const png = (await page.screenshot()).toString("base64");
    const made = await studio.evaluate(
      async ([picture, width, quality]) => {
        const bitmap = await createImageBitmap(await (await fetch(`data:image/png;base64,${picture}`)).blob());
        const canvas = new OffscreenCanvas(width, Math.round((bitmap.height * width) / bitmap.width)),
          context = canvas.getContext("2d", { alpha: false });
        context.imageSmoothingQuality = "high";
        context.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
        const bytes = await (await canvas.convertToBlob({ type: "image/webp", quality })).bytes();
        return { height: canvas.height, base64: bytes.toBase64() };
      },
      [png, WIDTH, QUALITY],
    );
    height = made.height;
    stills.push(Buffer.from(made.base64, "base64"));
  }
  const bytes = animated(stills, WIDTH, height);
  writeFileSync(`${here}${name}`, bytes);
  console.log(`${name}: ${bytes.length} bytes`);
}

try {
  // A tower at its limit: a rough step beside an accuracy that is asked for.
  const tower = await browser.visit("?scene=accuracy_overhang&step=1", options);
  await tower.locator("#accuracy-slider").fill("4");
  await tower.click("#accuracy-duel");
  await tower.click("#play");
  await tower.evaluate(() => caromViewer.seek(0));
  await soft(tower);
  await film(tower, "limit.webp", 36, 2);
  writeFileSync(`${here}limit.png`, await tower.screenshot());
  await tower.close();

  const page = await browser.visit("?scene=ragdoll&step=1&dials=accuracy_place:0.001,accuracy_turn:0.001", options);
  await page.evaluate(() => (document.getElementById("accuracy-list").open = true));
  await soft(page);
  await film(page, "page.webp", 40, 3, async (i) => {
    if (i !== 14) return;
    await page.click('[data-tool="throw"]');
    const box = await page.locator("#view").boundingBox();
    await page.mouse.click(box.x + box.width * 0.45, box.y + box.height * 0.5);
  });
} finally {
  await browser.end();
}
