// tests/determinism and tests/platform, compiled to WebAssembly: every golden hash of the repository, by this machine's
// engine of JavaScript.
import { strict as assert } from "node:assert";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { imports } from "../src/wasi.js";

for (const [name, last] of [
  ["same_bits", /so_are_those_of_heaps/],
  ["every", /every shape, joint and solver: [0-9a-f]{16}/],
]) {
  const file = new URL(`../dist/${name}.wasm`, import.meta.url);
  test(`golden hashes: ${name}`, { skip: !existsSync(file) && "not built: cmake --build --preset wasm" }, async (context) => {
    const said = [];
    let instance = null;
    const needs = imports(
      () => instance.exports.memory,
      (text) => said.push(text),
    );
    let code = 0;
    class Exit extends Error {}
    needs.wasi_snapshot_preview1.proc_exit = (c) => {
      code = c;
      throw new Exit();
    };
    ({ instance } = await WebAssembly.instantiate(await readFile(file), needs));
    try {
      instance.exports._start();
    } catch (error) {
      if (!(error instanceof Exit)) throw error;
    }
    assert.equal(code, 0, said.join("\n"));
    assert.match(said.join("\n"), last);
    context.diagnostic(said.find((text) => last.test(text)) ?? said.at(-1));
  });
}
