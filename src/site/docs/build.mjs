// The documentation as dist/docs: npm run docs. The page itself links to it.
import { Eleventy } from "@11ty/eleventy";
import { build } from "esbuild";
import { rmSync } from "node:fs";
import * as pagefind from "pagefind";

const out = new URL("../dist/docs/", import.meta.url).pathname;
process.chdir(new URL("..", import.meta.url).pathname);
rmSync(out, { recursive: true, force: true });
const eleventy = new Eleventy("docs/start", out, { configPath: "docs/eleventy.config.mjs", quietMode: true });
await eleventy.write();
await build({
  entryPoints: ["docs/curves/curve.js"],
  outfile: `${out}curve.js`,
  bundle: true,
  format: "esm",
  minify: true,
  target: "es2022",
  alias: { carom: new URL("../../../bindings/js/src/index.js", import.meta.url).pathname },
  external: ["node:*"],
});
const { index } = await pagefind.createIndex();
const { page_count, errors } = await index.addDirectory({ path: out });
if (errors?.length) throw new Error(errors.join("\n"));
await index.writeFiles({ outputPath: `${out}pagefind` });
await pagefind.close();
console.log(`${out}: ${page_count} pages`);
