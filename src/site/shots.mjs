// The pictures of README.md, taken of the built page by headless Chromium: node shots.mjs (npm run shots).
import { writeFileSync } from "node:fs";
import { Browser, skip } from "./test/browser.mjs";

const FRAMES = 40,
  STEPS = 3, // from one frame to the next
  WIDTH = 720,
  QUALITY = 0.42;

/** An animation of still WebP pictures: each becomes an ANMF chunk of one file.
 *  @param stills [Buffer]   @param ms  how long each is seen */
function animated(stills, width, height, ms) {
  const u24 = (x) => Buffer.from([x & 255, (x >> 8) & 255, x >> 16]);
  const chunk = (name, content) => {
    const size = Buffer.alloc(4);
    size.writeUInt32LE(content.length);
    return Buffer.concat([Buffer.from(name), size, content, Buffer.alloc(content.length & 1)]);
  };
  const canvas = [u24(width - 1), u24(height - 1)];
  const frames = stills.map((still) => {
    // "RIFF", size, "WEBP", then chunks; of a still without alpha VP8 alone is needed.
    for (let at = 12; at < still.length;) {
      const name = still.toString("latin1", at, at + 4),
        size = still.readUInt32LE(at + 4);
      if (name === "VP8 ") {
        const picture = chunk(name, still.subarray(at + 8, at + 8 + size));
        return chunk("ANMF", Buffer.concat([u24(0), u24(0), ...canvas, u24(ms), Buffer.from([2]), picture]));
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
try {
  const still = await browser.visit("?scene=wall&step=84", options);
  await soft(still);
  writeFileSync(`${here}page.png`, await still.screenshot());
  await still.close();

  const page = await browser.visit("?scene=ragdoll&step=1&dials=accuracy_place:0.001,accuracy_turn:0.001", options);
  await page.evaluate(() => (document.getElementById("accuracy-list").open = true));
  await soft(page);
  const studio = await (await browser.browser.newContext()).newPage();
  const stills = [];
  let height;
  for (let i = 0; i < FRAMES; ++i) {
    if (i === 14) {
      await page.click('[data-tool="throw"]');
      const box = await page.locator("#view").boundingBox();
      await page.mouse.click(box.x + box.width * 0.45, box.y + box.height * 0.5);
    }
    await page.evaluate((steps) => {
      for (let k = 1; k < steps; ++k) caromViewer.state.sims[0].advance();
      document.getElementById("step").click();
    }, STEPS);
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
  const bytes = animated(stills, WIDTH, height, 1000 / 20);
  writeFileSync(`${here}page.webp`, bytes);
  console.log(`page.png, and page.webp of ${bytes.length} bytes`);
} finally {
  await browser.end();
}
