// Several versions of the site side by side: the newest at the root, a selector on every page of the documentation.
import { strict as assert } from "node:assert";
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { chromium } from "playwright-core";
import { serve } from "../serve.mjs";
import { skip } from "./browser.mjs";
import { keepVersion } from "../versions.mjs";

const DIST = new URL("../dist/", import.meta.url).pathname;

/** A site as an older version had it: with its number on one page. */
function older(folder, version) {
  cpSync(join(DIST, "docs"), join(folder, "docs"), { recursive: true });
  writeFileSync(join(folder, "index.html"), `the page of ${version}`);
  const readme = join(folder, "docs/readme/index.html"),
    text = readFileSync(readme, "utf8");
  writeFileSync(readme, text.replace(/(class="version">)[\d.]+/, `$1${version}`));
}

test("versions are kept side by side, the newest at the root", { skip, timeout: 120000 }, async () => {
  const work = mkdtempSync(join(tmpdir(), "carom-versions-")),
    keep = join(work, "kept/");
  for (const version of ["0.9.0", "0.10.0"]) {
    older(join(work, version), version);
    keepVersion(join(work, version), keep, version);
  }
  // 0.10 is newer than 0.9; what is built later does not move the root back.
  assert.deepEqual(keepVersion(join(work, "0.9.0"), keep, "0.9.0"), ["0.10.0", "0.9.0"]);
  assert.equal(readFileSync(join(keep, "index.html"), "utf8"), "the page of 0.10.0");
  assert.equal(readFileSync(join(keep, "0.9.0/index.html"), "utf8"), "the page of 0.9.0");
  assert.throws(() => keepVersion(DIST, keep, "../elsewhere"), /no version/);
  // A folder of other files stays as it is.
  assert.throws(() => keepVersion(DIST, join(work, "0.9.0/docs"), "1.0.0"), /has other files/);
  assert.ok(existsSync(join(work, "0.9.0/docs/readme/index.html")));
  const server = await serve(0, keep),
    base = `http://localhost:${server.address().port}/`;
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
    args: ["--no-sandbox"],
  });
  const page = await browser.newPage(),
    select = page.locator('select[aria-label="Version of the documentation"]');
  await page.goto(`${base}docs/readme/`);
  assert.deepEqual(await select.locator("option").allTextContents(), ["0.10.0", "0.9.0"]);
  await select.selectOption("0.9.0");
  await page.waitForURL(`${base}0.9.0/docs/readme/`);
  assert.equal(await select.evaluate((s) => s.selectedOptions[0].textContent), "0.9.0");
  await select.selectOption("0.10.0");
  await page.waitForURL(`${base}0.10.0/docs/readme/`);
  // A page that the other version does not have: its first page instead.
  rmSync(join(keep, "0.9.0/docs/readme"), { recursive: true });
  await select.selectOption("0.9.0");
  await page.waitForURL(`${base}0.9.0/docs/`);
  await browser.close();
  server.close();
  rmSync(work, { recursive: true });
  assert.ok(!existsSync(work));
});

test("a build alone is one version, and no selector is shown", { skip }, () => {
  const [only, ...others] = JSON.parse(readFileSync(join(DIST, "versions.json"), "utf8"));
  assert.match(only.version, /^\d+\.\d+\.\d+$/);
  assert.deepEqual(others, []);
});
