// The pictures of the gallery, taken of the built page by headless Chromium: node gallery.mjs (npm run gallery). With names
// of scenes only those.
import { existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { gallery } from "./docs/gallery.mjs";
import { Browser, skip } from "./test/browser.mjs";

const WIDTH = 400,
  HEIGHT = 250,
  QUALITY = 0.8;
/** Where a scene looks its best, s; else after a second. */
const WHEN = {
  wall: 1.4,
  seesaw: 1.5,
  catapult: 2.2,
  bunnies: 1.5,
  falling: 3,
  net: 2,
  particles: 2,
  ragdoll: 0.7,
  quoits: 1,
};
WHEN.accuracy_bullet = 0.03;

if (skip) throw new Error(skip);
const out = new URL("gallery/", import.meta.url).pathname,
  names = gallery().flatMap(({ scenes }) => scenes.map(({ name }) => name)),
  asked = process.argv.slice(2);
mkdirSync(out, { recursive: true });
for (const file of readdirSync(out)) if (!names.includes(file.replace(/\.webp$/, ""))) rmSync(out + file);
const browser = await Browser.start();
try {
  for (const name of asked.length ? asked : names) {
    const page = await browser.visit(`?scene=${name}&step=1&embed=1`, {
      viewport: { width: 2 * WIDTH, height: 2 * HEIGHT },
      deviceScaleFactor: 1,
      colorScheme: "light",
    });
    const made = await page.evaluate(
      async ([width, height, quality, when]) => {
        for (const id of ["tools", "transport", "whole", "pad", "told"]) document.getElementById(id).hidden = true;
        const { state, stage, seek } = caromViewer;
        seek(Math.max(1, Math.round(Math.min(when, 0.6 * (state.row.seconds ?? 9)) / state.sims[0].dt)));
        stage.quality = 1;
        stage.look(state.row, state.pictures);
        stage.render(state.pictures);
        const view = document.getElementById("view"),
          canvas = new OffscreenCanvas(width, height),
          context = canvas.getContext("2d", { alpha: false });
        context.imageSmoothingQuality = "high";
        context.drawImage(view, 0, 0, width, height);
        return (await (await canvas.convertToBlob({ type: "image/webp", quality })).bytes()).toBase64();
      },
      [WIDTH, HEIGHT, QUALITY, WHEN[name] ?? 1],
    );
    writeFileSync(`${out}${name}.webp`, Buffer.from(made, "base64"));
    await page.close();
  }
  const lacking = names.filter((name) => !existsSync(`${out}${name}.webp`));
  if (lacking.length) throw new Error(`no picture of ${lacking}`);
} finally {
  await browser.end();
}
