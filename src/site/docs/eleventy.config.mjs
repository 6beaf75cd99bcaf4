// The documentation as a folder: dist/docs. build.mjs runs it; pages.mjs says what the pages are.
import anchor from "markdown-it-anchor";
import { cpSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, relative } from "node:path";
import { Pages, ROOT, slug } from "./pages.mjs";

const OUT = new URL("../dist/docs/", import.meta.url).pathname;
const version = /CAROM_VERSION_MAJOR (\d+)[\s\S]*CAROM_VERSION_MINOR (\d+)[\s\S]*CAROM_VERSION_PATCH (\d+)/
  .exec(readFileSync(`${ROOT}include/carom/base.h`, "utf8"))
  .slice(1)
  .join(".");

export default function (eleventy) {
  const all = new Pages();
  eleventy.amendLibrary("md", (md) => {
    md.set({ html: true, linkify: false });
    md.use(anchor, { slugify: slug, level: [1, 2, 3, 4], tabIndex: false });
    md.core.ruler.push("links", ({ tokens, env }) => {
      const change = (token, name) => {
        const at = token.attrIndex(name);
        if (at >= 0) token.attrs[at][1] = all.target(env.page_, token.attrs[at][1]);
      };
      for (const token of tokens)
        for (const child of token.children ?? []) {
          if (child.type === "link_open") change(child, "href");
          if (child.type === "image") change(child, "src");
          if (child.type === "html_inline")
            child.content = child.content.replace(
              /\b(href|src|srcset)="([^"]+)"/g,
              (_, name, to) => `${name}="${all.target(env.page_, to)}"`,
            );
        }
    });
    md.core.ruler.push("tabs", ({ tokens, env }) => inTabs(tokens, env.page_));
    const { table_open, table_close } = md.renderer.rules;
    md.renderer.rules.table_open = (...a) =>
      `<div class="wide" tabindex="0" role="region" aria-label="Table">${table_open?.(...a) ?? "<table>"}`;
    md.renderer.rules.table_close = (...a) => `${table_close?.(...a) ?? "</table>"}</div>`;
  });
  eleventy.setLayoutsDirectory("../layout");
  eleventy.ignores.add("docs/start/*.md"); // pages.mjs reads them
  for (const page of all.pages)
    eleventy.addTemplate(`pages/${page.file}`, page.text, {
      layout: "page.njk",
      permalink: `${page.address}index.html`,
      page_: page,
      title: page.title,
      groups: all.groups(),
      up: "../".repeat(page.address.split("/").length - 1),
      version,
      templateEngineOverride: "md",
    });
  eleventy.on("eleventy.after", () => {
    for (const page of all.pages) writeFileSync(`${OUT}${page.address}index.md`, all.plain(page));
    if (all.wrong.length) throw new Error(`links that lead nowhere:\n  ${[...new Set(all.wrong)].join("\n  ")}`);
    for (const [file, address] of all.files) {
      mkdirSync(dirname(OUT + address), { recursive: true });
      cpSync(ROOT + file, OUT + address);
    }
    for (const file of ["docs.css", "docs.js"]) cpSync(new URL(file, import.meta.url).pathname, OUT + file);
    writeFileSync(`${OUT}llms.txt`, listed(all));
    // One version alone, until versions.mjs keeps several side by side.
    writeFileSync(`${OUT}../versions.json`, JSON.stringify([{ version, path: "" }]) + "\n");
  });
  return {
    dir: { input: "docs/start", includes: "../layout", output: relative(".", OUT) },
    markdownTemplateEngine: false,
    htmlTemplateEngine: false,
  };
}

const TABS = { c: "C", cpp: "C++", python: "Python", js: "JavaScript", rust: "Rust" };

/** Programs in several languages, one after the other, stand behind tabs; docs.js makes these. */
function inTabs(tokens, page) {
  if (!/\/docs\/(start|topics)\//.test(page.file)) return;
  const program = (token) => token?.type === "fence" && TABS[token.info.trim()] !== undefined;
  for (let i = 0; i < tokens.length; ++i) {
    let end = i;
    while (program(tokens[end])) ++end;
    if (end - i < 2) continue;
    const html = (content) => Object.assign(new tokens[i].constructor("html_block", "", 0), { content });
    const made = tokens
      .slice(i, end)
      .flatMap((token) => [html(`<section aria-label="${TABS[token.info.trim()]}">`), token, html("</section>\n")]);
    tokens.splice(i, end - i, html('<div class="tabs">\n'), ...made, html("</div>\n"));
    i += made.length + 1;
  }
}

/** llms.txt: what there is to read, with a line on each, as plain Markdown. */
function listed(all) {
  const lines = [
    "# Carom",
    "",
    `> A rigid-body physics engine with a C interface whose every approximation is a dial. Version ${version}.`,
    "",
  ];
  for (const group of all.groups()) {
    lines.push(`## ${group.name}`, "");
    for (const page of group.pages)
      lines.push(`- [${page.title}](${page.address}index.md)${page.about && `: ${page.about.slice(0, 200)}`}`);
    lines.push("");
  }
  return lines.join("\n");
}
