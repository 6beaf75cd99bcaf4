// Frames a second by the clock, as the page draws them in headless Chromium without a graphics card: node fps.mjs [SCENE...].
// Says the size, the quality that the page chose (0 is best), processor time of a frame in all of the browser's processes,
// and how busy the machine was with other work.
import { readdirSync, readFileSync } from "node:fs";
import { loadavg } from "node:os";
import { Browser, skip } from "./test/browser.mjs";

const SETTLES = 5000, // ms, until the quality is found
  COUNTED = 6000;
/** ms of processor time that this process's children took, and theirs. */
function taken() {
  const children = new Map(),
    spent = new Map();
  for (const id of readdirSync("/proc").filter((name) => /^\d+$/.test(name)))
    try {
      const stat = readFileSync(`/proc/${id}/stat`, "utf8"),
        fields = stat.slice(stat.lastIndexOf(")") + 2).split(" ");
      children.set(fields[1], [...(children.get(fields[1]) ?? []), id]);
      spent.set(id, 10 * (Number(fields[11]) + Number(fields[12])));
    } catch {
      // It has ended since.
    }
  const all = (id) => (children.get(id) ?? []).reduce((sum, child) => sum + spent.get(child) + all(child), 0);
  return all(String(process.pid));
}

if (skip) throw new Error(skip);
const scenes = process.argv.slice(2),
  browser = await Browser.start([]); // as a visitor's, who has no graphics card
try {
  for (const scene of scenes.length
    ? scenes
    : ["accuracy_stack10", "seesaw", "wall", "ragdoll", "stacks", "drive", "arm", "quoits"]) {
    const before = loadavg()[0];
    const page = await browser.visit(`?scene=${scene}`, {
      viewport: { width: 1280, height: 800 },
      deviceScaleFactor: 1,
    });
    await page.waitForTimeout(SETTLES);
    const began = taken();
    const found = await page.evaluate(
      (ms) =>
        new Promise((done) => {
          const begun = performance.now(),
            gaps = [],
            { step } = caromViewer;
          let last = begun;
          const count = (now) => {
            gaps.push(now - last);
            last = now;
            if (now < begun + ms) return requestAnimationFrame(count);
            const view = document.getElementById("view");
            return done({
              count: gaps.length,
              frames: gaps.length / ((now - begun) / 1000),
              slow: gaps.toSorted((a, b) => a - b)[Math.floor(0.95 * gaps.length)],
              quality: caromViewer.quality,
              size: `${view.width}x${view.height}`,
              steps: caromViewer.step - step,
            });
          };
          requestAnimationFrame(count);
        }),
      COUNTED,
    );
    const each = (taken() - began) / found.count;
    console.log(
      `${scene.padEnd(18)} ${found.frames.toFixed(1).padStart(5)} frames/s, 95 of 100 within ${found.slow.toFixed(0)} ms, ${each.toFixed(0)} ms of processor time each, quality ${found.quality}, ` +
        `${found.size}, load before ${before.toFixed(1)}`,
    );
    await page.close();
  }
} finally {
  await browser.end();
}
