// The documentation: every link and anchor leads somewhere, plain pages too, search finds, three widths fit.
import { strict as assert } from "node:assert";
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, skip } from "./browser.mjs";

const DIST = new URL("../dist/", import.meta.url).pathname,
  DOCS = join(DIST, "docs");
const unbuilt = !existsSync(join(DOCS, "index.html")) && "not built: npm run build";
let browser;

before(async () => {
  if (!skip && !unbuilt) browser = await Browser.start();
});
after(() => browser?.end());

function* files(folder, ending) {
  for (const entry of readdirSync(folder, { withFileTypes: true })) {
    const path = join(folder, entry.name);
    if (entry.isDirectory()) entry.name !== "pagefind" && entry.name !== "files" && (yield* files(path, ending));
    else if (entry.name.endsWith(ending)) yield path;
  }
}
const ids = new Map();
function idsOf(file) {
  if (!ids.has(file))
    ids.set(file, new Set([...readFileSync(file, "utf8").matchAll(/ id="([^"]*)"/g)].map((m) => m[1])));
  return ids.get(file);
}
/** @returns what is wrong with a link, or null */
function broken(from, href) {
  if (/^(https?:|mailto:|data:)/.test(href)) return null;
  const [, path, anchor] = /^([^?#]*)(?:\?[^#]*)?(?:#(.*))?$/.exec(href);
  let file = path ? join(dirname(from), decodeURIComponent(path)) : from;
  if (!file.startsWith(DIST.slice(0, -1))) return "leads out of the site";
  if (existsSync(file) && statSync(file).isDirectory()) {
    if (!path.endsWith("/") && path !== "." && path !== "..") return "a folder without / at its end";
    file = join(file, "index.html");
  }
  if (!existsSync(file)) return "leads nowhere";
  if (anchor && file.endsWith(".html") && !idsOf(file).has(decodeURIComponent(anchor))) return "has no such anchor";
  return null;
}

test("every link of every page leads somewhere", { skip: unbuilt }, (t) => {
  const wrong = [];
  let links = 0,
    pages = 0;
  for (const page of files(DOCS, ".html")) {
    ++pages;
    for (const [, href] of readFileSync(page, "utf8").matchAll(/<[^>]* (?:href|src)="([^"]*)"/g)) {
      ++links;
      const why = broken(page, href);
      if (why) wrong.push(`${page.slice(DOCS.length)}: ${href} ${why}`);
    }
  }
  t.diagnostic(`${pages} pages, ${links} links`);
  assert.deepEqual([...new Set(wrong)], []);
  assert.ok(pages > 70 && links > 5000);
  // The check can fail.
  assert.ok(broken(join(DOCS, "index.html"), "nowhere/") && broken(join(DOCS, "index.html"), "#nothing"));
});

test("plain Markdown of every page, listed in llms.txt", { skip: unbuilt }, () => {
  const listed = [...readFileSync(join(DOCS, "llms.txt"), "utf8").matchAll(/^- \[.+?\]\((\S+?)\)(?:: .+)?$/gm)].map(
    (m) => m[1],
  );
  const pages = [...files(DOCS, "index.html")].map((page) =>
    page.slice(DOCS.length + 1).replace("index.html", "index.md"),
  );
  assert.deepEqual([...listed].sort(), pages.sort());
  const wrong = [];
  for (const file of listed) {
    const path = join(DOCS, file),
      text = readFileSync(path, "utf8").replace(/^```[\s\S]*?^```$/gm, "");
    assert.match(text, /^# /m, file);
    for (const [, href] of text.replace(/`[^`\n]*`/g, "").matchAll(/\]\(([^)\s]+)\)/g)) {
      const why = broken(path, href.split("#")[0] || "index.md");
      if (why) wrong.push(`${file}: ${href} ${why}`);
    }
  }
  assert.deepEqual(wrong, []);
});

test(
  "search finds, pages fit three widths, start pages have live scenes",
  { skip: skip || unbuilt, timeout: 180000 },
  async () => {
    for (const width of [360, 800, 1600]) {
      const context = await browser.browser.newContext({ viewport: { width, height: 800 } });
      const page = await browser.tab(context);
      for (const path of [
        "docs/",
        "docs/include/pages/body/",
        "docs/src/tools/accuracy/CHOOSING/",
        "docs/readme/",
        "docs/topics/accuracy/",
        "docs/topics/gallery/",
        "docs/start/film/",
        "docs/bindings/js/API/",
        "docs/bindings/python/API/",
      ]) {
        await page.goto(new URL(path, browser.base).href, { waitUntil: "domcontentloaded" });
        const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
        assert.ok(wide <= 0, `${path} at ${width} px is ${wide} px too wide`);
      }
      await page.waitForSelector("#search input");
      const hint = await page.evaluate(() => {
        const style = getComputedStyle(document.querySelector("#search input"), "::placeholder"),
          dim = getComputedStyle(document.querySelector(".version")).color;
        return { opacity: style.opacity, color: style.color, dim };
      });
      assert.deepEqual([hint.opacity, hint.color], ["1", hint.dim]); // what the field is for can be read
      await page.fill("#search input", "restitution");
      await page.waitForSelector(".pagefind-ui__result-link");
      await page.click(".pagefind-ui__result-link >> nth=0");
      await page.waitForFunction(() => /restitution/i.test(document.querySelector("main")?.textContent ?? ""));
      assert.match(page.url(), /\/docs\/.+/);
      await context.close();
    }
    const context = await browser.browser.newContext({ viewport: { width: 1000, height: 900 } });
    const page = await context.newPage();
    await page.goto(new URL("docs/start/games/", browser.base).href);
    await page.locator("iframe.live[src*=pyramid]").scrollIntoViewIfNeeded();
    const frame = await (await page.waitForSelector("iframe.live[src*=pyramid]")).contentFrame();
    await frame.waitForFunction(() => globalThis.caromViewer?.state.row.name === "pyramid", null, { timeout: 60000 });
    await frame.waitForFunction(() => document.getElementById("native").dataset.same === "true");
    await context.close();
  },
);

test(
  "every frame of the documentation plays by itself, in sight alone",
  { skip: skip || unbuilt, timeout: 300000 },
  async (t) => {
    const context = await browser.browser.newContext({ viewport: { width: 1000, height: 700 } });
    const page = await browser.tab(context);
    let frames = 0;
    for (const folder of ["start", "topics"])
      for (const name of readdirSync(join(DOCS, folder), { withFileTypes: true }).filter((entry) =>
        entry.isDirectory(),
      )) {
        await page.goto(new URL(`docs/${folder}/${name.name}/`, browser.base).href, { waitUntil: "domcontentloaded" });
        for (const element of await page.locator("iframe.live").all()) {
          await element.scrollIntoViewIfNeeded();
          const frame = await (await element.elementHandle()).contentFrame();
          await frame.waitForFunction(() => globalThis.caromViewer?.step > 3, null, { timeout: 60000 });
          assert.ok(await frame.evaluate(() => document.getElementById("message").hidden), name.name);
          ++frames;
          await page.evaluate(() => scrollTo(0, 0));
          if (await element.evaluate((e) => e.getBoundingClientRect().top > innerHeight))
            await frame.waitForFunction(() => !caromViewer.state.inSight);
        }
      }
    t.diagnostic(`${frames} frames`);
    assert.ok(frames >= 10);
    await context.close();
  },
);

const topics = (unbuilt ? [] : readdirSync(join(DOCS, "topics"))).filter((topic) =>
  readFileSync(join(DOCS, "topics", topic, "index.html"), "utf8").includes('class="curve"'),
);

test(
  "topics measure error against cost, where they are read",
  { skip: skip || unbuilt, timeout: 600000 },
  async (t) => {
    const context = await browser.browser.newContext({ viewport: { width: 1000, height: 900 } });
    const page = await browser.tab(context);
    // The scenes beside the curves are other tests' business: here they would share the processor.
    await page.route(/\?scene=/, (route) => route.fulfill({ body: "", contentType: "text/html" }));
    assert.ok(topics.length >= 6);
    for (const topic of topics) {
      await page.goto(new URL(`docs/topics/${topic}/`, browser.base).href, { waitUntil: "domcontentloaded" });
      const box = page.locator(".curve");
      await box.locator("button").click();
      await page.waitForFunction(() => /done|failed/.test(document.querySelector(".curve").dataset.state), null, {
        timeout: 120000,
      });
      assert.equal(await box.getAttribute("data-state"), "done", await box.locator("[role=status]").innerText());
      const { errors, inside, series, rows } = await box.evaluate((e) => {
        const points = [...e.querySelectorAll(".point")],
          picture = e.querySelector(".picture > svg").getBoundingClientRect();
        const within = (r) => r.left >= picture.left && r.right <= picture.right && r.bottom <= picture.bottom;
        return {
          errors: points.map((p) => Number(p.dataset.error)),
          inside: points.every((p) => within(p.getBoundingClientRect())),
          series: e.querySelectorAll(".legend li").length,
          rows: e.querySelectorAll("tbody tr").length,
        };
      });
      assert.ok(errors.every((x) => Number.isFinite(x) && x >= 0) && inside, `${topic}: ${errors}`);
      assert.ok(series >= 3 && errors.length >= 15 && rows === errors.length, topic);
      assert.ok(Math.min(...errors) < 1e-5 && Math.max(...errors) > 1e-4, `${topic}: ${errors}`);
      t.diagnostic(`${topic}: ${errors.length} points in ${series} series`);
    }
    await context.close();
  },
);

test("programs stand in three languages behind tabs", { skip: skip || unbuilt, timeout: 240000 }, async () => {
  const context = await browser.browser.newContext({ viewport: { width: 1000, height: 900 } });
  const page = await context.newPage();
  page.on("pageerror", (e) => browser.errors.push(e.message));
  const seen = () => page.locator(".tabs section:visible").evaluateAll((all) => all.map((e) => e.ariaLabel));
  for (const [path, first] of [
    ["docs/start/games/", "C"],
    ["docs/start/robotics/", "Python"],
    ["docs/start/web/", "JavaScript"],
    ["docs/start/research/", "Python"],
  ]) {
    await page.goto(new URL(path, browser.base).href, { waitUntil: "domcontentloaded" });
    await page.waitForSelector("[role=tab]");
    assert.deepEqual([...new Set(await seen())], [first], path);
    assert.ok((await seen()).length >= 3, path);
  }
  const only = async (name) =>
    assert.ok(
      (await seen()).every((one) => one === name),
      name,
    );
  await page.locator("[role=tab]", { hasText: "Python" }).first().click();
  await only("Python");
  await page.keyboard.press("ArrowRight");
  assert.ok((await seen()).every((one) => one !== "Python"));
  await page.locator("[role=tab]", { hasText: "Python" }).first().click();
  await page.goto(new URL("docs/topics/accuracy/", browser.base).href, { waitUntil: "domcontentloaded" });
  await page.waitForSelector("[role=tab]");
  assert.deepEqual(await seen(), ["Python"]); // it is remembered
  await page.goto(new URL("docs/topics/examples/", browser.base).href, { waitUntil: "domcontentloaded" });
  await page.waitForSelector("[role=tab]");
  await page.locator("[role=tab]", { hasText: "Rust" }).first().click();
  assert.deepEqual(await seen(), Array(15).fill("Rust"));
  await page.locator("[role=tab]", { hasText: "JavaScript" }).first().click();
  const some = await seen();
  assert.ok(some.length === 15 && some.every((name) => name === "JavaScript"));
  await context.grantPermissions(["clipboard-read", "clipboard-write"]);
  const first = page.locator(".tabs section:visible").first();
  await first.locator("button", { hasText: "Copy" }).click();
  assert.equal(
    (await page.evaluate(() => navigator.clipboard.readText())).trimEnd(),
    readFileSync(new URL("../../../bindings/js/examples/stack.js", import.meta.url), "utf8").trimEnd(),
  );
  await context.close();
});

test(
  "the gallery: each card runs a scene, words leave those that have them; search finds scenes and functions",
  {
    skip: skip || unbuilt,
    timeout: 120000,
  },
  async () => {
    const context = await browser.browser.newContext({ viewport: { width: 1000, height: 900 } });
    const page = await browser.tab(context);
    await page.goto(new URL("docs/topics/gallery/", browser.base).href);
    const cards = page.locator(".gallery section");
    const all = await cards.count();
    assert.ok(all >= 60);
    assert.equal(
      await page.locator(".gallery img").evaluateAll((i) => i.filter((e) => e.complete && !e.naturalWidth).length),
      0,
    );
    await page.fill(".sieve", "cube tower");
    const left = await page.locator(".gallery section:visible").allTextContents();
    assert.ok(
      left.length >= 1 && left.length < all / 4 && left.every((text) => /cube/i.test(text) && /tower/i.test(text)),
    );
    await page.fill(".sieve", "");
    assert.equal(await page.locator(".gallery section:visible").count(), all);
    await page.locator(".gallery section", { hasText: "pyramid" }).locator("a").first().click();
    await page.waitForFunction(() => globalThis.caromViewer?.state.row.name === "pyramid", null, { timeout: 60000 });
    for (const [word, leads] of [
      ["turntable", /\?scene=accuracy_turntable$/],
      ["carom_body_set_velocity", /include\/pages\/body\/.*#carom_body_set_velocity$/],
    ]) {
      await page.goto(new URL("./", browser.base).href);
      await page.waitForFunction(() => globalThis.caromViewer);
      await page.fill('header input[name="q"]', word);
      await page.keyboard.press("Enter");
      await page.waitForSelector(".pagefind-ui__result-link");
      const found = await page
        .locator(".pagefind-ui__result-link")
        .evaluateAll((links) => links.map((link) => link.href));
      assert.ok(
        found.some((href) => leads.test(href)),
        `${word}: ${found.join(" ")}`,
      );
    }
    await context.close();
  },
);

test("names of the Python and JavaScript packages, and the version, are on their pages", { skip: unbuilt }, () => {
  const text = (path) => readFileSync(join(DOCS, path, "index.html"), "utf8");
  for (const [path, names] of [
    ["bindings/js/API", ["measureGrowth", "islands", "CaromPhysics", "CaromError", "Vehicle", "castShape"]],
    ["bindings/python/API", ["measure_growth", "islands", "contact_array", "StaleHandle", "film", "picture"]],
  ])
    for (const name of names) assert.ok(text(path).includes(name), `${path}: ${name}`);
  const version = /<span class="version">([\d.]+)</.exec(text("readme"))[1];
  const cited = readFileSync(new URL("../../../CITATION.cff", import.meta.url), "utf8");
  assert.equal(/^version: (.+)$/m.exec(cited)[1], version);
  for (const page of files(DOCS, "index.html"))
    assert.match(readFileSync(page, "utf8"), new RegExp(`Carom ${version} ·`));
});

test("no console error in all of this", { skip: skip || unbuilt }, () => assert.deepEqual(browser.complaints(), []));
