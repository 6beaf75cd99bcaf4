// A film of Python's carom.film() plays in a browser that is offline: it moves, pauses, is drawn along, and turns.
//   CAROM_LIBRARY names the library, as for the tests of JavaScript
import { strict as assert } from "node:assert";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { Browser, skip } from "./browser.mjs";

const root = new URL("../../../", import.meta.url).pathname,
  library = process.env.CAROM_LIBRARY ?? `${root}build/demo/lib/libcarom.so.0.9`;
const PROGRAM = `
import carom, sys
with carom.Engine() as engine, engine.world() as world:
    world.ground()
    for i in range(8):
        world.body(engine.box(0.5, 0.25, 0.25), position=(0.3 * i, 0.25 + 0.6 * i, 0))
    world.body(engine.sphere(0.5), position=(0, 6, 2))
    film = carom.film(world, 2)
    film.save(sys.argv[1] + "/film.html")
    open(sys.argv[1] + "/cell.html", "w").write(film._repr_html_())
`;

test(
  "a film plays offline",
  { skip: skip || (!existsSync(library) && `no library at ${library}`), timeout: 120000 },
  async () => {
    const folder = mkdtempSync(join(tmpdir(), "film-")),
      browser = await Browser.start();
    try {
      const env = {
        ...process.env,
        CAROM_LIBRARY: library,
        PYTHONPATH: `${root}bindings/python`,
        PYTHONDONTWRITEBYTECODE: "1",
      };
      env.CAROM_PLUGIN_DIR ??= join(library, "../../plugins");
      execFileSync("python3", ["-c", PROGRAM, folder], { env });
      for (const file of ["film.html", "cell.html"]) {
        const context = await browser.browser.newContext({ viewport: { width: 700, height: 460 }, offline: true });
        const page = await browser.tab(context);
        const asked = [];
        page.on("request", (request) => !/^(file|about|data|blob):/.test(request.url()) && asked.push(request.url()));
        await page.goto(`file://${folder}/${file}`);
        const frame =
          file === "film.html" ? page.mainFrame() : await (await page.waitForSelector("iframe")).contentFrame();
        await frame.waitForFunction(() => Number(document.querySelector("input").value) > 5);
        const seen = () => frame.evaluate(() => document.querySelector("canvas").toDataURL());
        await frame.click("button");
        assert.equal(await frame.textContent("button"), "Play");
        const there = await seen(),
          time = await frame.textContent("output");
        await page.waitForTimeout(300);
        assert.equal(await seen(), there); // it stands still
        await frame.evaluate(() => {
          const slider = document.querySelector("input");
          ((slider.value = "0"), slider.dispatchEvent(new Event("input")));
        });
        assert.notEqual(await seen(), there);
        assert.equal(await frame.textContent("output"), "0.00 s");
        assert.notEqual(time, "0.00 s");
        const first = await seen();
        await page.mouse.move(300, 200);
        await page.mouse.down();
        await page.mouse.move(380, 200, { steps: 4 });
        await page.mouse.up();
        assert.notEqual(await seen(), first); // the camera turned
        assert.equal(await frame.evaluate(() => document.querySelector("input").max), "60");
        assert.deepEqual(asked, []);
        await context.close();
      }
      assert.deepEqual(browser.complaints(), []);
    } finally {
      await browser.end();
      rmSync(folder, { recursive: true });
    }
  },
);
