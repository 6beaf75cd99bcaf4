// A state as a link: scene, step, settings, and what was done by hand. The same link gives the same bits.

const KNOWN = [
  "scene",
  "step",
  "play",
  "preset",
  "dials",
  "do",
  "ab",
  "preset_b",
  "dials_b",
  "do_b",
  "threads",
  "embed",
  "code",
];
const LONGEST = 12000; // letters; beyond, browsers and mailers cut

/** @param dials [{ name, min, max, unit }]   @throws Error that says what is wrong with the link */
export function readLink(query, presets, dials) {
  const given = new URLSearchParams(query);
  for (const key of given.keys())
    if (!KNOWN.includes(key)) throw new Error(`the link's "${key}" means nothing here: ${KNOWN.join(", ")} do`);
  const settings = (suffix) => {
    const out = [];
    const preset = given.get(`preset${suffix}`);
    if (preset !== null) {
      const value = presets.indexOf(preset);
      if (value < 0) throw new Error(`the link's preset "${preset}" is none of ${presets.join(", ")}`);
      out.push({ do: "preset", value });
    }
    for (const pair of (given.get(`dials${suffix}`) ?? "").split(",").filter(Boolean)) {
      const [name, text] = pair.split(":"),
        value = Number(text);
      const dial = dials.find((d) => d.name === name);
      if (!dial) throw new Error(`the link's dial "${name}" does not exist`);
      if (text === undefined || text === "" || !Number.isFinite(value))
        throw new Error(`the link's dial ${name} has no number`);
      if (value < dial.min || value > dial.max)
        throw new Error(
          `the link's dial ${name} is ${text}: it goes from ${dial.min} to ${dial.max} ${dial.unit}`.trim(),
        );
      out.push({ do: "dial", name, value });
    }
    return out;
  };
  const step = Number(given.get("step") ?? 0);
  if (!Number.isInteger(step) || step < 0 || step > 1e6)
    throw new Error("the link's step is not a whole number from 0 to 1000000");
  const log = (key) => {
    if (!given.has(key)) return [];
    try {
      const read = JSON.parse(given.get(key));
      if (!Array.isArray(read) || !read.every(([s, a]) => Number.isInteger(s) && s >= 0 && typeof a?.do === "string"))
        throw new Error();
      return read;
    } catch {
      throw new Error("the link's actions are damaged: it was cut off, perhaps by a mail program");
    }
  };
  const sides = [{ settings: settings(""), log: log("do") }];
  if (given.get("ab") === "1") sides.push({ settings: settings("_b"), log: log("do_b") });
  return {
    scene: given.get("scene"),
    code: given.has("code"),
    step,
    plays: !given.has("step") || given.get("play") === "1",
    sides,
  };
}

function settingsOf(settings, presets, suffix, out) {
  const dials = new Map();
  for (const s of settings) {
    if (s.do === "preset") (dials.clear(), out.set(`preset${suffix}`, presets[s.value]));
    else dials.set(s.name, s.value);
  }
  if (dials.size) out.set(`dials${suffix}`, [...dials].map(([name, value]) => `${name}:${value}`).join(","));
}

/** @param sides  [{settings, log}], one or two   @returns the query, or null if there is too much in it */
export function writeLink({ scene, step, plays, sides }, presets) {
  const out = new URLSearchParams();
  out.set("scene", scene);
  out.set("step", String(step));
  if (plays) out.set("play", "1");
  sides.forEach(({ settings, log }, i) => {
    const suffix = i ? "_b" : "";
    if (i) out.set("ab", "1");
    settingsOf(settings, presets, suffix, out);
    const done = log.filter(([s]) => s <= step);
    if (done.length) out.set(`do${suffix}`, JSON.stringify(done));
  });
  const text = `?${out}`.replaceAll("%3A", ":").replaceAll("%2C", ",");
  return text.length > LONGEST ? null : text;
}
