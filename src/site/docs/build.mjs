// The documentation as dist/docs: npm run docs. The page itself links to it.
import { Eleventy } from "@11ty/eleventy";
import { build } from "esbuild";
import { rmSync } from "node:fs";
import * as pagefind from "pagefind";
import { gallery } from "./gallery.mjs";

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
// Scenes are found as well, and lead to themselves.
for (const { title, scenes } of gallery())
  for (const scene of scenes) {
    const content = `${scene.title}. ${scene.summary} ${scene.look_for}. Scene, gallery: ${title}.`;
    const meta = { title: `Scene: ${scene.title}` };
    const { errors: wrong } = await index.addCustomRecord({
      url: `/../?scene=${scene.name}`,
      content,
      language: "en",
      meta,
    });
    if (wrong?.length) throw new Error(wrong.join("\n"));
  }
await index.writeFiles({ outputPath: `${out}pagefind` });
await pagefind.close();
console.log(`${out}: ${page_count} pages`);
