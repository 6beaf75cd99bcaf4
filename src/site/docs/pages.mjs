// The pages of the documentation: every Markdown file of the repository under its own path, start pages and topics of
// docs/, names of packages (api.mjs). Links between them are made anew; what is linked and is no page is copied along.
// A link that leads nowhere is an error.
import { existsSync, readdirSync, readFileSync, statSync } from "node:fs";
import { dirname, extname, join, normalize, posix, relative } from "node:path";
import { apiPages } from "./api.mjs";
import { datedTable, peersPicture } from "./benchmarks.mjs";
import { SCENES } from "./curves/scenes.js";
import { examples } from "./examples.mjs";
import { galleryPage } from "./gallery.mjs";
import { releasesPage } from "./release.mjs";

export const ROOT = new URL("../../../", import.meta.url).pathname;
const OWN = /^src\/site\/docs\/(start|topics)\/(.+)\.md$/; // pages that are in no folder of what they tell of
const OUT = ["build", "out", "node_modules", "dist"];
const PICTURES = [".svg", ".png", ".webp", ".jpg", ".html"];

const GROUPS = [
  ["Start", /^src\/site\/docs\/start\//],
  ["Topics", /^src\/site\/docs\/topics\//],
  ["Overview", /^(README|ABI)\.md$/],
  ["Interface", /^include\//],
  ["Bindings", /^bindings\//],
  ["The command", /^src\/tools\//],
  ["In a browser", /^src\/site\//],
  ["The inside", /^(src|plugins)\//],
  ["Tests and measurements", /^tests\//],
  ["The project", /./],
];

function* markdown(folder = "") {
  for (const entry of readdirSync(ROOT + folder, { withFileTypes: true }).sort((a, b) => (a.name < b.name ? -1 : 1))) {
    const path = posix.join(folder, entry.name);
    if (entry.isDirectory()) {
      if (!entry.name.startsWith(".") && !OUT.includes(entry.name)) yield* markdown(path);
    } else if (entry.name.endsWith(".md")) yield path;
  }
}

/** Of a file: "src/tools/README.md" is at src/tools/, "ABI.md" at ABI/, start pages at start/, the first at the root. */
function addressOf(file) {
  const [, folder, name] = OWN.exec(file) ?? [];
  if (folder) return folder === "start" && name === "index" ? "" : `${folder}/${name}/`;
  if (file === "README.md") return "readme/";
  return file.endsWith("/README.md")
    ? file.slice(0, -9)
    : file.endsWith("/index.md")
      ? file.slice(0, -8)
      : `${file.slice(0, -3)}/`;
}

/** A line `@include FILE [LANGUAGE]` stands for a file's text, or for the first block of a page in that language. */
function included(line) {
  const [, file, language] = /^@include (\S+)(?: (\S+))?$/.exec(line);
  const text = readFileSync(ROOT + file, "utf8");
  if (!file.endsWith(".md")) return `\`\`\`${language ?? extname(file).slice(1)}\n${text.trimEnd()}\n\`\`\``;
  const block = new RegExp(`^\`\`\`${language}\\n[\\s\\S]*?^\`\`\`$`, "m").exec(text);
  if (!block) throw new Error(`${file} has no block in ${language}`);
  return block[0];
}

/** A line `@example NAME [LANGUAGE]` stands for that program in each language, that one first; tests/bindings/examples.py
 *  runs them. */
function example(line) {
  const [, name, first] = /^@example (\w+)(?: (\w+))?$/.exec(line) ?? [];
  const found = examples().find((each) => each.name === name);
  if (!found) throw new Error(`${line}: there is no such example`);
  const order = Object.entries(found.files).sort(([a], [b]) => (b === first) - (a === first));
  const programs = order.map(([language, file]) => included(`@include ${relative(ROOT, file)} ${language}`));
  return `${programs.join("\n\n")}\n\n[Run it beside its picture](run:example_${name})`;
}

/** A line `@curve SCENE` stands for a curve of curves/scenes.js, measured where the page is read. */
function curve(line) {
  const scene = /^@curve (\w+)$/.exec(line)?.[1];
  if (!SCENES[scene]) throw new Error(`${line}: there is no such curve`);
  return [
    `<div class="curve" data-scene="${scene}" data-wasm="../../../carom.wasm">`,
    `<p>Error against cost: ${SCENES[scene].what}.</p>`,
    '<p><button type="button">Measure it here</button> <span role="status"></span></p>',
    '<div class="picture"></div>',
    "</div>",
  ].join("\n");
}

export class Pages {
  constructor() {
    this.files = new Map(); // that are copied: source path -> address
    this.wrong = []; // links
    const read = [...markdown()].map((file) => ({ file, text: readFileSync(ROOT + file, "utf8") }));
    this.pages = [...read, ...apiPages(ROOT)].map(({ file, text }) => {
      if (OWN.test(file))
        text = text
          .replace(/^@include .*$/gm, included)
          .replace(/^@example .*$/gm, example)
          .replace(/^@curve .*$/gm, curve)
          .replace(/^@gallery$/gm, galleryPage)
          .replace(/^@peers$/gm, () => peersPicture())
          .replace(/^@dated$/gm, datedTable)
          .replace(/^@releases$/gm, releasesPage);
      const heading = /^# (.+)$/m.exec(text);
      if (!heading) throw new Error(`${file} has no heading`);
      const title = heading[1].replace(/[`*]/g, "");
      const prose =
        text
          .slice(heading.index + heading[0].length)
          .split(/\n\n+/)
          .find((p) => /^[A-Z`[]/.test(p.trim())) ?? "";
      return {
        file,
        text,
        curve: /class="curve"/.test(text),
        title: file === "README.md" ? "README" : title,
        about: prose
          .trim()
          .replace(/\s+/g, " ")
          .replace(/!?\[([^\]]*)\]\([^)]*\)/g, "$1"),
        address: addressOf(file),
        group: GROUPS.findIndex(([, pattern]) => pattern.test(file)),
      };
    });
    this.byFile = new Map(this.pages.map((page) => [page.file, page]));
  }

  /** For the list beside a page: [{ name, pages }]. */
  groups() {
    const first = (page) => (page.address === "" ? 0 : 1);
    return GROUPS.map(([name], number) => ({
      name,
      number,
      open: number < 2,
      pages: this.pages.filter((page) => page.group === number).sort((a, b) => first(a) - first(b)),
    })).filter((group) => group.pages.length);
  }

  /** Where a link of a page leads, as an address from the page's own.   @param plain  to Markdown instead of pages */
  target(page, href, plain = false) {
    if (href.startsWith("run:")) return `${relative(`/${page.address}`, "/") || "."}/../?scene=${href.slice(4)}`;
    if (/^([a-z]+:|#|\/\/)/i.test(href)) return href;
    const [path, anchor] = href.split("#"),
      end = anchor === undefined ? "" : `#${anchor}`;
    const from = OWN.test(page.file) ? "" : dirname(page.file);
    let file = normalize(join(from, decodeURIComponent(path))).replace(/\/$/, "");
    if (file.startsWith("..") || !(this.byFile.has(file) || existsSync(ROOT + file))) return this.#lost(page, href);
    if (!this.byFile.has(file) && statSync(ROOT + file).isDirectory()) {
      // A folder is its page, or that of the nearest folder above that has one.
      while (file && file !== "." && !this.byFile.has(`${file}/README.md`)) file = dirname(file);
      file = file && file !== "." ? `${file}/README.md` : "README.md";
    }
    const to = this.byFile.get(file);
    const goal = to ? to.address + (plain ? "index.md" : "") : this.#copied(file);
    return (relative(`/${page.address}`, `/${goal}`) || ".") + (to && !plain ? "/" : "") + end;
  }

  #copied(file) {
    const address = `files/${file}${PICTURES.includes(extname(file)) ? "" : ".txt"}`;
    this.files.set(file, address);
    return address;
  }
  #lost(page, href) {
    this.wrong.push(`${page.file}: ${href}`);
    return href;
  }

  /** A page as plain Markdown whose links lead to plain Markdown. */
  plain(page) {
    let fenced = false;
    return page.text
      .split("\n")
      .map((line) => {
        if (/^```/.test(line)) fenced = !fenced;
        if (fenced || /^ {4}/.test(line)) return line;
        return line.replace(
          /(\]\()([^)\s]+)(\))/g,
          (_, open, href, close) => open + this.target(page, href, true) + close,
        );
      })
      .join("\n");
  }
}

/** The id of a heading, as code hosts make it. */
export const slug = (text) =>
  text
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s_-]/gu, "")
    .trim()
    .replace(/\s/g, "-");
