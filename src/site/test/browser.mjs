// Headless Chromium on the built page, for the tests: CHROMIUM names the browser where it is not /usr/bin/chromium.
import { existsSync } from "node:fs";
import { chromium } from "playwright-core";
import { ISOLATED, serve } from "../serve.mjs";

const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
const built = existsSync(new URL("../dist/index.html", import.meta.url));

/** false, or why no test can run here. */
export const skip = !existsSync(executablePath)
  ? `no browser at ${executablePath}`
  : !built && "not built: npm run build";

export class Browser {
  errors = [];

  /** @param how  it draws: by SwiftShader all through, so that pictures are the same on every machine */
  static async start(how = ["--use-gl=angle", "--use-angle=swiftshader"]) {
    const b = new Browser();
    b.server = await serve(0, undefined, ISOLATED); // as `carom view` does
    b.base = `http://localhost:${b.server.address().port}/`;
    b.browser = await chromium.launch({
      executablePath,
      args: ["--no-sandbox", ...how, "--enable-unsafe-swiftshader", "--enable-precise-memory-info"],
    });
    return b;
  }

  /** An empty tab whose errors count. */
  async tab(context) {
    const page = await context.newPage();
    page.on("console", (m) => m.type() === "error" && this.errors.push(m.text()));
    page.on("pageerror", (e) => this.errors.push(e.message));
    return page;
  }

  /** A tab of the page, once it runs.   @param options  of a browser context: viewport, isMobile, colorScheme, ... */
  async visit(query, options = {}) {
    const context = await this.browser.newContext({ viewport: { width: 1000, height: 640 }, ...options });
    const page = await this.tab(context);
    await page.goto(new URL(query, this.base).href);
    await page.waitForFunction(() => globalThis.caromViewer, null, { timeout: 60000 });
    const close = page.close.bind(page);
    page.close = async () => (await close(), await context.close());
    return page;
  }

  /** What the console said; a browser without a graphics card says so, and that is no error of the page. */
  complaints() {
    return this.errors.filter((e) => !/GPU stall|WebGL|swiftshader/i.test(e));
  }

  async end() {
    await this.browser.close();
    this.server.close();
  }
}

/** Of the panel: what a part of it is headed by, and a row of it. */
export const title = (page, text) => page.locator("#panel summary", { hasText: text });
export const field = (page, text) => page.locator("#panel .row", { hasText: text });

export const now = (page) =>
  page.evaluate(() => ({
    step: caromViewer.step,
    hash: caromViewer.hash,
    native: document.getElementById("native").dataset.same,
    message: document.getElementById("message").hidden ? "" : document.getElementById("message").textContent,
  }));
