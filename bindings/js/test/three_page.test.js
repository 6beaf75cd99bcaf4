// examples/three.html as a person opens it: in headless Chromium, a ball knocks a wall over, nothing is complained of.
//   CHROMIUM names the browser where it is not /usr/bin/chromium
import { strict as assert } from "node:assert";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { serve } from "../../../src/site/serve.mjs";

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const playwright = await import("playwright-core").catch(() => null);
const skip =
  (!playwright && "playwright-core is not installed: npm install") ||
  (!existsSync(executablePath) && `no browser at ${executablePath}`);
const page = new URL("../examples/three.html", import.meta.url);

test("the page of thirty lines runs in Chromium", { skip, timeout: 120000 }, async () => {
  const lines = (await readFile(page, "utf8")).trimEnd().split("\n");
  assert.ok(lines.length <= 30, `${lines.length} lines`);
  const server = await serve(0, new URL("../", import.meta.url).pathname),
    browser = await playwright.chromium.launch({
      executablePath,
      args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
    }),
    errors = [];
  try {
    const tab = await browser.newPage({ viewport: { width: 320, height: 240 } });
    tab.on("console", (m) => m.type() === "error" && errors.push(m.text()));
    tab.on("pageerror", (e) => errors.push(e.message));
    await tab.goto(`http://localhost:${server.address().port}/examples/three.html`);
    await tab.waitForFunction(() => globalThis.physics?.world.report().steps > 60n, null, { timeout: 60000 });
    const heights = await tab.evaluate(() => [...physics.meshes.keys()].map((mesh) => mesh.position.toArray()));
    assert.equal(heights.length, 32);
    assert.ok(heights.at(-1)[2] < 6, "the ball flies");
    assert.ok(heights.every((p) => p.every(Number.isFinite) && p[1] > -1));
    assert.deepEqual(
      errors.filter((e) => !/favicon|GPU stall|WebGL/i.test(e)),
      [],
    );
  } finally {
    await browser.close();
    server.close();
  }
});
