// The release page, made of CHANGELOG.md: what is open or was released, the highlights, then every change by part.
import { readFileSync } from "node:fs";

const ROOT = new URL("../../../", import.meta.url).pathname;

/** @returns [{ title, parts: [{ title, notes: [text] }] }], the newest release first */
export function releases(text = readFileSync(`${ROOT}CHANGELOG.md`, "utf8")) {
  const out = [];
  for (const release of text.split(/^## /m).slice(1)) {
    const [title] = release.split("\n", 1),
      parts = release.split(/^### /m).slice(1);
    if (!parts.length) throw new Error(`CHANGELOG.md: release ${title} has no part "### ..."`);
    out.push({
      title,
      parts: parts.map((part) => {
        const [name] = part.split("\n", 1);
        const notes = part
          .slice(name.length)
          .split(/^- /m)
          .slice(1)
          .map((note) => note.trim().replace(/\s*\n\s*/g, " "));
        if (!notes.length) throw new Error(`CHANGELOG.md: ${title}, ${name} has no note`);
        return { title: name, notes };
      }),
    });
  }
  if (!out.length) throw new Error('CHANGELOG.md has no release "## ..."');
  return out;
}

/** As Markdown, for a line `@releases`. What a note begins with in bold is a highlight. */
export const releasesPage = () =>
  releases()
    .map(({ title, parts }) => {
      const notes = parts.flatMap((part) => part.notes),
        bold = notes.map((note) => /^\*\*(.+?)\*\*/.exec(note)?.[1].replace(/[:.]$/, "")).filter(Boolean);
      const list = (all) => all.map((note) => `- ${note}`).join("\n");
      return [
        `## ${title}`,
        `${notes.length} notes. ${bold.length ? "In short:" : ""}`.trim(),
        list(bold),
        ...parts.map(
          (part) =>
            `<details><summary>${part.title}: ${part.notes.length}</summary>\n\n${list(part.notes)}\n\n</details>`,
        ),
      ].join("\n\n");
    })
    .join("\n\n");
