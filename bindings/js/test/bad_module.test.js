// What load() says of a module that is missing, of something else, or of another version: file and cure, and nothing is loaded.
import { strict as assert } from "node:assert";
import { createServer } from "node:http";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, test } from "node:test";
import { pathToFileURL } from "node:url";
import { CaromError, load } from "../src/index.js";

const folder = mkdtempSync(join(tmpdir(), "carom-"));
after(() => rmSync(folder, { recursive: true }));
const ours = readFileSync(new URL("../dist/carom.wasm", import.meta.url));

function written(name, bytes) {
  const file = join(folder, name);
  writeFileSync(file, bytes);
  return pathToFileURL(file);
}

/** @param options  of load()   @param said  words of the error, in this order */
async function refused(options, ...said) {
  await assert.rejects(load(options), (e) => {
    assert.ok(e instanceof CaromError, String(e));
    assert.equal(e.result, "CAROM_E_NOT_FOUND");
    assert.match(e.message, new RegExp(said.join("[^]*")));
    assert.ok(e.remedy.length > 20, e.remedy);
    return true;
  });
}

test("a wrong path", async () => {
  for (const threads of [1, 2])
    await refused(
      { source: "file:///no/such/carom.wasm", threads },
      "file:///no/such/carom.wasm",
      "no such file",
      "npm run build",
    );
});

test("a wrong address, and a server that is not there", async () => {
  const server = createServer((_, answer) => answer.writeHead(404).end("<!doctype html>"));
  await new Promise((done) => server.listen(0, "127.0.0.1", done));
  const address = `http://127.0.0.1:${server.address().port}/carom.wasm`;
  await refused(address, address, "404 Not Found", "serve it");
  await new Promise((done) => server.close(done));
  await refused(address, address, "give its address");
});

test("a page, a shared object, a module cut off", async () => {
  const elf = Buffer.concat([Buffer.from("\x7fELF\x02\x01\x01", "latin1"), Buffer.alloc(64)]);
  for (const [name, bytes] of [
    ["page.wasm", "<!doctype html>"],
    ["libcarom.so", elf],
    ["cut.wasm", ours.subarray(0, ours.length >> 1)],
  ])
    await refused(written(name, bytes), name, "is no WebAssembly", "dist/carom.wasm");
  await refused(new Uint8Array([1, 2, 3, 4]), "the module given", "is no WebAssembly");
});

test("a module of something else", async () => {
  const empty = new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0]);
  await refused(
    written("empty.wasm", empty),
    "empty.wasm",
    "no module of carom: it has no carom_abi_manifest",
    "dist/carom.wasm",
  );
});

test("a module of an older and of a newer version", async () => {
  const said = Buffer.from("carom 0.9.0\n"),
    at = ours.indexOf(said);
  assert.ok(at > 0 && ours.indexOf(said, at + 1) < 0);
  for (const version of ["0.8.9", "1.0.0"]) {
    const other = Buffer.from(ours);
    other.write(`carom ${version}\n`, at);
    await refused(written(`${version}.wasm`, other), `${version}.wasm`, `of carom ${version}, this package of 0.9.0`);
  }
});

test("an option that there is not", async () => {
  await assert.rejects(load({ wasm: "/carom.wasm" }), /load\(\) has no option wasm: source, threads/);
});
