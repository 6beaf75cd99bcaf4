// The examples, one program a feature, each in every language: what topics/examples.md says of them, and their files.
import { readFileSync } from "node:fs";

const ROOT = new URL("../../../", import.meta.url).pathname;
const FILES = {
  c: "c/examples/NAME.c",
  cpp: "cpp/examples/NAME.cpp",
  python: "python/examples/NAME.py",
  js: "js/examples/NAME.js",
  rust: "rust/carom/examples/NAME.rs",
};

/** @returns [{ name, title, summary, says, files: { c: path, ... } }] in the page's order */
export function examples() {
  const page = readFileSync(`${ROOT}src/site/docs/topics/examples.md`, "utf8");
  return [...page.matchAll(/^## (.+)\n\n@example (\w+)\n\n {4}(.*)$/gm)].map(([, title, name, says]) => {
    const files = Object.fromEntries(
      Object.entries(FILES).map(([language, file]) => [language, `${ROOT}bindings/${file.replace("NAME", name)}`]),
    );
    const summary = /^\/\/ (.+)$/m.exec(readFileSync(files.js, "utf8"))[1];
    return { name, title, summary, says, files };
  });
}
