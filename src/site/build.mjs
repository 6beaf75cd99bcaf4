// The page as a folder of files: dist/. Wants carom.wasm and the scenes, which README.md says how to make.
import { build } from "esbuild";
import { cpSync, existsSync, mkdirSync, rmSync, writeFileSync } from "node:fs";
import { basename } from "node:path";
import { examples } from "./docs/examples.mjs";

const here = new URL(".", import.meta.url).pathname;
const wasm = `${here}../../bindings/js/dist/carom.wasm`;
const threads = `${here}../../bindings/js/dist/carom.threads.wasm`;
const scenes = process.env.CAROM_SCENES ?? `${here}../../out/scenes`;
for (const [file, remedy] of [
  [wasm, "cmake --preset wasm && cmake --build --preset wasm"],
  [`${scenes}/index.json`, "build/demo/bin/carom pack out/scenes"],
])
  if (!existsSync(file)) {
    console.error(`${file} is missing.\n  what to do: in the root of the repository: ${remedy}`);
    process.exit(2);
  }
rmSync(`${here}dist`, { recursive: true, force: true });
mkdirSync(`${here}dist`, { recursive: true });
await build({
  // Workers of a page with threads are a file of their own, beside the code that starts them.
  entryPoints: [`${here}src/main.js`, `${here}src/run_worker.js`, `${here}../../bindings/js/src/thread_worker.js`],
  entryNames: "[name]",
  outdir: `${here}dist`,
  splitting: true, // readers of files come when they are needed
  bundle: true,
  format: "esm",
  minify: true,
  target: "es2022",
  alias: { carom: `${here}../../bindings/js/src/index.js` },
  external: ["node:*"],
  legalComments: "linked",
});
for (const file of ["index.html", "style.css"]) cpSync(`${here}${file}`, `${here}dist/${file}`);
// The examples' own files, with what the page of examples says of them.
const all = examples();
for (const { name, files } of all)
  for (const [language, file] of Object.entries(files)) {
    files[language] = `${language}/${basename(file)}`;
    cpSync(file, `${here}dist/examples/${files[language]}`);
  }
writeFileSync(`${here}dist/examples/index.json`, JSON.stringify(all));
cpSync(wasm, `${here}dist/carom.wasm`);
if (existsSync(threads)) cpSync(threads, `${here}dist/carom.threads.wasm`); // for ?threads=
cpSync(scenes, `${here}dist/scenes`, { recursive: true });
console.log(`${here}dist is ready: npm run view`);
