// Serves folders one after the other, opens each in a browser, and prints the first line that its page says.
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { existsSync } from "node:fs";
import { extname, join, normalize } from "node:path";
import { chromium } from "playwright-core";

const TYPES = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };
const executablePath = ["/usr/bin/chromium", "/usr/bin/google-chrome"].find(existsSync);
const browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
for (const folder of process.argv.slice(2)) {
  const server = createServer(async (request, response) => {
    const path = normalize(new URL(request.url, "http://x").pathname);
    try {
      const bytes = await readFile(join(folder, path === "/" ? "index.html" : path));
      response.writeHead(200, { "content-type": TYPES[extname(path)] ?? "text/html" }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  }).listen(0);
  const page = await browser.newPage();
  const said = new Promise((resolve, reject) => {
    page.on("console", (message) => message.type() === "log" && resolve(message.text()));
    page.on("pageerror", (error) => reject(error));
    setTimeout(() => reject(new Error(`${folder}: the page said nothing for a minute`)), 60000).unref();
  });
  await page.goto(`http://localhost:${server.address().port}/`);
  console.log(await said);
  await page.close();
  server.close();
}
await browser.close();
