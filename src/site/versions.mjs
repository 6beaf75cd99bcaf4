// Keeps the site of several versions: the page and its documentation as they were built, each version in its folder,
// the newest at the root as well. A folder of files that any web server serves.
//   npm run build && npm run keep -- DIR        DIR/index.html, DIR/0.9.0/index.html, DIR/versions.json
import { cpSync, existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";

const VERSION = /^\d+\.\d+\.\d+$/;
const newer = (a, b) => {
  const [x, y] = [a, b].map((version) => version.split(".").map(Number));
  return y[0] - x[0] || y[1] - x[1] || y[2] - x[2];
};

/** @param built  dist/   @param keep  folder; another build of the same version is replaced   @returns versions */
export function keepVersion(built, keep, version) {
  if (!VERSION.test(version)) throw new Error(`${version} is no version: three numbers, as 1.2.3`);
  mkdirSync(keep, { recursive: true });
  // What is there goes, but for versions: so it has to be a folder of this program's, or an empty one.
  if (readdirSync(keep).length > 0 && !existsSync(join(keep, "versions.json")))
    throw new Error(`${keep} has other files: name an empty folder, or one that an earlier call filled`);
  rmSync(join(keep, version), { recursive: true, force: true });
  cpSync(built, join(keep, version), { recursive: true });
  const versions = readdirSync(keep)
    .filter((name) => VERSION.test(name))
    .sort(newer);
  // The root is the newest version's, whichever was built last.
  for (const name of readdirSync(keep)) if (!VERSION.test(name)) rmSync(join(keep, name), { recursive: true });
  cpSync(join(keep, versions[0]), keep, { recursive: true });
  const list = (to) => JSON.stringify(versions.map((name) => ({ version: name, path: `${to}${name}/` }))) + "\n";
  writeFileSync(join(keep, "versions.json"), list(""));
  for (const name of versions) writeFileSync(join(keep, name, "versions.json"), list("../"));
  return versions;
}

if (process.argv[1] === new URL(import.meta.url).pathname) {
  const built = new URL("dist/", import.meta.url).pathname,
    keep = process.argv[2];
  if (!keep || !existsSync(join(built, "versions.json"))) {
    console.error(keep ? "the site is not built: npm run build" : "name a folder: npm run keep -- DIR");
    process.exit(2);
  }
  const [{ version }] = JSON.parse(readFileSync(join(built, "versions.json")));
  try {
    console.log(`${resolve(keep)}: ${keepVersion(built, resolve(keep), version).join(", ")}`);
  } catch (error) {
    console.error(error.message);
    process.exit(2);
  }
}
