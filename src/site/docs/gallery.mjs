// The gallery: a card for each scene of the built page, with the picture that `npm run gallery` took of it.
import { existsSync, readdirSync, readFileSync } from "node:fs";
import { THINGS } from "../src/things_list.js";
import { examples } from "./examples.mjs";

const ROOT = new URL("../../../", import.meta.url).pathname,
  PICTURES = "src/site/gallery";

/** @returns [{ title, scenes: [{ name, title, summary, look_for }] }] in the order of the page's list */
export function gallery() {
  const index = `${ROOT}src/site/dist/scenes/index.json`;
  if (!existsSync(index)) throw new Error(`${index} is missing: build the page first (npm run build)`);
  const rows = JSON.parse(readFileSync(index, "utf8"));
  const programs = examples().map(({ name, title, summary, says }) => ({
    name: `example_${name}`,
    title,
    summary,
    look_for: says,
  }));
  return [
    { title: "To watch and to push", scenes: rows.filter((row) => !row.truth) },
    { title: "To steer", scenes: THINGS },
    { title: "Examples, with their code", scenes: programs },
    { title: "The truth is known", scenes: rows.filter((row) => row.truth) },
  ].map((group) => ({
    ...group,
    scenes: group.scenes.map(({ name, title, summary, look_for }) => ({
      name,
      title: title ?? name.replace(/^accuracy_/, ""),
      summary,
      look_for,
    })),
  }));
}

/** As Markdown, for a line `@gallery`.   @throws Error where a scene has no picture, or a picture no scene */
export function galleryPage() {
  const groups = gallery(),
    names = groups.flatMap(({ scenes }) => scenes.map(({ name }) => name)),
    taken = existsSync(ROOT + PICTURES) ? readdirSync(ROOT + PICTURES).map((file) => file.replace(/\.webp$/, "")) : [];
  const missing = names.filter((name) => !taken.includes(name)),
    old = taken.filter((name) => !names.includes(name));
  if (missing.length || old.length)
    throw new Error(`the gallery lacks pictures of [${missing}], and has some of no scene [${old}]: npm run gallery`);
  const card = ({ name, title, summary, look_for }) =>
    [
      "<section>",
      `### ${title}`,
      `[![${summary.replace(/[[\]]/g, "")}](${PICTURES}/${name}.webp)](run:${name})`,
      `${summary} *${look_for[0].toUpperCase()}${look_for.slice(1)}.*`,
      "</section>",
    ].join("\n\n");
  const group = ({ title, scenes }) =>
    [`## ${title}`, '<div class="gallery">', ...scenes.map(card), "</div>"].join("\n\n");
  return groups.map(group).join("\n\n");
}
