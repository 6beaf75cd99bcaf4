// tests/determinism, compiled to WebAssembly: every golden hash of the repository, by this machine's engine of
// JavaScript.
import { strict as assert } from "node:assert";
import { existsSync } from "node:fs";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { imports } from "../src/wasi.js";

const file = new URL("../dist/same_bits.wasm", import.meta.url);

test(
  "golden hashes of tests/determinism",
  { skip: !existsSync(file) && "not built: cmake --build --preset wasm" },
  async () => {
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
    assert.match(said.join("\n"), /so_are_those_of_heaps/);
  },
);
