// The JavaScript programs of pages run and say what they should: those of the README, and those of the site's topics.
import { strict as assert } from "node:assert";
import { execFile } from "node:child_process";
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { test } from "node:test";
import { promisify } from "node:util";

const root = new URL("../../../", import.meta.url),
  entry = new URL("../src/index.js", import.meta.url).href;
const folder = "src/site/docs/topics/";
const said = {
  "bindings/js/README.md": /y = 0\.(49[5-9]|50[0-5]) m/,
  [`${folder}accuracy.md`]: /^at x = 0\.7851 m after 2 s; \d+ substeps, error 0\./,
};

/** Whole programs of a page: blocks that load the package. */
const programs = (page) =>
  [...readFileSync(new URL(page, root), "utf8").matchAll(/^```js\n([\s\S]*?)^```$/gm)]
    .map((m) => m[1])
    .filter((text) => /from "carom"/.test(text));

async function run(program) {
  const text = program.replace('from "carom"', `from ${JSON.stringify(entry)}`);
  const { stdout, stderr } = await promisify(execFile)(process.execPath, ["--input-type=module", "--eval", text]);
  assert.equal(stderr, "");
  return stdout;
}

test("programs of pages say what they should, and the same in Python", async (t) => {
  const library = process.env.CAROM_LIBRARY,
    topics = readdirSync(new URL(folder, root)).map((file) => folder + file);
  let done = 0;
  for (const page of ["bindings/js/README.md", ...topics])
    for (const program of programs(page)) {
      const out = await run(program);
      assert.match(out, said[page], page);
      ++done;
      const python = /^```python\n([\s\S]*?)^```$/m.exec(readFileSync(new URL(page, root), "utf8"))?.[1];
      if (!python || !library || !existsSync(library)) continue;
      const env = { ...process.env, PYTHONPATH: new URL("bindings/python", root).pathname };
      const twin = await promisify(execFile)("python3", ["-c", python], { env });
      assert.equal(twin.stdout, out, page);
    }
  assert.equal(done, Object.keys(said).length);
  t.diagnostic(`${done} programs${library ? "" : "; CAROM_LIBRARY names no library, so Python was not asked"}`);
});
