// Pages of the Python and JavaScript packages, written from their docstrings and types: no file has them.
import { execFileSync } from "node:child_process";
import { readFileSync } from "node:fs";

const PYTHON = process.env.PYTHON ?? "python3";

/** Of a file of types: each export under a heading, with its comment as prose.   @returns Markdown */
function typed(file, heading) {
  const text = readFileSync(file, "utf8"),
    out = [];
  const exports = new RegExp(
    [
      String.raw`(?:^/\*\*((?:(?!\*/)[\s\S])*)\*/\n)?`,
      String.raw`(?:^export (?:class|interface) (\w+)[\s\S]*?^\}|^export (?:function|type) (\w+)[\s\S]*?;)$`,
    ].join(""),
    "gm",
  );
  for (const [whole, comment, one, other] of text.matchAll(exports)) {
    const name = one ?? other;
    const code = comment === undefined ? whole : whole.slice(whole.indexOf("*/\n") + 3);
    out.push(`${heading} ${name}`, "");
    if (comment)
      out.push(
        comment
          .replace(/^\s*\* ?/gm, "")
          .replace(/\s*@param (\w+)\s+/g, "\n\n`$1`: ")
          .replace(/\s*@returns\s+/g, "\n\nGives ")
          .trim(),
        "",
      );
    out.push("```ts", code.trim(), "```", "");
  }
  if (!out.length) throw new Error(`${file} exports nothing that is understood`);
  return out.join("\n");
}

/** @param root  of the repository, with / at its end   @returns [{ file, text }]: as if they were files of it */
export function apiPages(root) {
  const js = `${root}bindings/js/src/`;
  const javascript = [
    "# The JavaScript package, name by name",
    "",
    "Written from the types of `bindings/js/src`. Fields of structs have the names of the C headers.",
    "",
    "## carom",
    "",
    typed(`${js}index.d.ts`, "###"),
    "## carom/three",
    "",
    typed(`${js}three.d.ts`, "###"),
  ].join("\n");
  const python = execFileSync(PYTHON, [`${root}src/site/docs/api_python.py`, `${root}bindings/python/carom`], {
    encoding: "utf8",
    maxBuffer: 1 << 26,
  });
  return [
    { file: "bindings/js/API.md", text: javascript },
    { file: "bindings/python/API.md", text: python },
  ];
}
