// Pages made of tables and notes: nothing that stands there is lost, and what is not as it should be is told of.
import { strict as assert } from "node:assert";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { dated, datedTable, peers, peersPicture } from "../docs/benchmarks.mjs";
import { releases, releasesPage } from "../docs/release.mjs";

const ROOT = new URL("../../../", import.meta.url).pathname;
const changelog = readFileSync(`${ROOT}CHANGELOG.md`, "utf8"),
  engines = readFileSync(`${ROOT}tests/bench/ENGINES.md`, "utf8");

test("every note of the change log is in the release page, once", () => {
  const page = releasesPage(),
    wanted = changelog.match(/^- /gm).length;
  const notes = releases().flatMap(({ parts }) => parts.flatMap((part) => part.notes));
  assert.equal(notes.length, wanted);
  assert.ok(wanted > 200);
  for (const note of notes) assert.ok(page.split(`- ${note}\n`).length >= 2, note);
  assert.equal(page.match(/^<details>/gm).length, changelog.match(/^### /gm).length);
});

test("two releases, and one without parts", () => {
  const text = "# Changes\n\n## 1.1\n\n### New\n- b\n  goes on\n\n## 1.0, 2027-01-01\n\n### Mended\n- a\n- c\n";
  assert.deepEqual(
    releases(text).map(({ title, parts }) => [title, parts.flatMap((p) => p.notes)]),
    [
      ["1.1", ["b goes on"]],
      ["1.0, 2027-01-01", ["a", "c"]],
    ],
  );
  assert.throws(() => releases("## 2.0\n\n- a\n"), /2.0 has no part/);
  assert.throws(() => releases("# Changes\n"), /no release/);
  assert.throws(() => releases("## 2.0\n### New\n"), /New has no note/);
});

test("a mark for each figure of the peers' table, at its place", () => {
  const read = peers(),
    marks = [
      ...peersPicture().matchAll(
        /translate\(([\d.]+),[\d.]+\)" [^>]*fill="([^"]*)"><title>(\S+?), (.*?): ([\d.e-]+) /g,
      ),
    ];
  const wanted = read.rows.flatMap(({ name, figures }) => figures.map((f) => ({ name, ...f })));
  assert.equal(marks.length, wanted.length);
  assert.ok(marks.length > 100 && read.engines.length === 6);
  wanted.forEach(({ name, engine, value, holds }, i) => {
    const [, , fill, row, who, figure] = marks[i];
    assert.deepEqual([row, who, Number(figure)], [name, engine, value]);
    assert.equal(fill !== "none", holds, `${row} ${who}`);
  });
  assert.ok(wanted.some(({ holds }) => !holds));
  for (const { name, figures } of read.rows) {
    const at = marks.filter((m) => m[3] === name).map((m) => Number(m[1]));
    figures.forEach((a, i) =>
      figures.forEach(
        (b, k) => a.value < b.value && assert.ok(at[i] <= at[k], `${name}: ${a.engine} is left of ${b.engine}`),
      ),
    );
  }
  // Where the table says that another engine is best, its mark is at 1.
  const s8 = read.rows.find(({ name }) => name === "S8");
  assert.equal(s8.best, s8.figures.find(({ engine }) => engine === "Box3D 0.1.0").value);
  const inside = marks.every((m) => Number(m[1]) > 250 && Number(m[1]) < 860);
  assert.ok(inside);
  assert.match(peersPicture(), /20\d\d-\d\d-\d\d, .*commit/);
});

test("a table without a date, or without engines, is told of", () => {
  assert.throws(() => peers(engines.replace(/^20\d\d-.*$/m, "yesterday")), /no line that begins with a date/);
  assert.throws(
    () => peers(engines.replace("| row | Carom f64 |", "| row | ? |")),
    /no table that begins with row \| Carom f64/,
  );
});

test("pages with measurements, the newest first", () => {
  const all = dated();
  assert.ok(all.some(({ file }) => file === "tests/bench/ENGINES.md"));
  assert.ok(all.every(({ date }, i) => !i || date <= all[i - 1].date));
  assert.equal(datedTable().split("\n").length, all.length + 2);
});
