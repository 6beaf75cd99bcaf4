// A program of the examples, or what a visitor made of it, run apart from the page: what it prints, and a recording of the
// first world that it steps. The page shows that, and ends a program that does not end.
import * as carom from "carom";

const { Character, Vehicle, World, Engine, Shape, constants } = carom;
const printed = [],
  shapes = [], // that are functions of the program's: the page needs them, too
  beside = []; // what is no body: { look, poses: by step }
let shown, // the world
  recorder,
  recording,
  steps = 0,
  floor = false; // is there ground?

const LONGEST = 36000; // steps, 10 minutes: more is no example

const say = (...values) => printed.push(values.map(String).join(" "));
const note = (thing) => thing.world === shown && (thing.poses[steps] = thing.pose());

const { step, free } = World.prototype;
World.prototype.step = function (dt) {
  if (!shown) {
    shown = this;
    recorder = this.record();
    floor = this.colliders().some(({ shape }) => new Shape(this.engine, shape).info.kind === "half_space");
  }
  if (this === shown) {
    if (steps >= LONGEST) throw new RangeError(`the page shows ${LONGEST} steps at most: step less`);
    for (const thing of beside) if (steps === 0) note(thing);
  }
  step.call(this, dt);
  if (this !== shown) return;
  ++steps;
  beside.forEach(note);
};
World.prototype.free = function () {
  if (this === shown) end();
  free.call(this);
};
function end() {
  recording ??= recorder?.end();
}

class Walker extends Character {
  constructor(world, shape, options) {
    super(world, shape, options);
    const look = { shape: shape.info.kind.replace("carom.", ""), params: shape.params, kind: "walker" };
    this.shown = { world, look, poses: [], pose: () => [...this.position, ...this.state.orientation] };
    beside.push(this.shown);
  }
  move(...how) {
    super.move(...how);
    note(this.shown); // it moves after the step
  }
}

const times = ([ax, ay, az, aw], [bx, by, bz, bw]) => [
  aw * bx + ax * bw + ay * bz - az * by,
  aw * by - ax * bz + ay * bw + az * bx,
  aw * bz + ax * by - ay * bx + az * bw,
  aw * bw - ax * bx - ay * by - az * bz,
];
const about = (axis, angle) => [...axis.map((x) => x * Math.sin(angle / 2)), Math.cos(angle / 2)];
class Car extends Vehicle {
  constructor(chassis, wheels, options) {
    super(chassis, wheels, options);
    wheels.forEach(({ radius = 0.33 }, i) => {
      const pose = () => {
        const { position, angle, steer } = this.wheels[i];
        // Steered about the chassis' y, turned about its x; a cylinder stands along y, so it is laid down first.
        const turns = [about([0, 1, 0], steer), about([1, 0, 0], angle), about([0, 0, 1], Math.PI / 2)];
        return [...position, ...turns.reduce(times, chassis.orientation)];
      };
      beside.push({
        world: chassis.world,
        look: { shape: "cylinder", params: [radius, 0.12], kind: "tyre" },
        poses: [],
        pose,
      });
    });
  }
}

const { supportPlugin } = Engine.prototype;
Engine.prototype.supportPlugin = function (support, id, params) {
  const made = supportPlugin.call(this, support, id, params);
  shapes.push({ text: String(support), id, params });
  return made;
};

/** What a program imports, by name. */
const assert = (good, why = "an assertion is false") => {
  if (!good) throw new Error(why);
};
let compiled;
globalThis.caromImports = {
  carom: { ...carom, load: (source = compiled) => carom.load(source), Character: Walker, Vehicle: Car },
  "carom/constants": constants,
  "node:assert/strict": { default: Object.assign(assert, { ok: assert }) },
};

/** Its imports as lines that take them from there; lines keep their numbers. */
export function linked(program) {
  return program.replace(/^import\s+(\{[^}]*\}|\* as \w+|\w+)\s+from\s+"([^"]+)";?/gm, (_, names, from) => {
    if (!(from in globalThis.caromImports))
      throw new Error(`a program here imports carom, carom/constants and node:assert/strict, not ${from}`);
    const place = `globalThis.caromImports[${JSON.stringify(from)}]`;
    if (names.startsWith("{")) return `const ${names.replaceAll(" as ", ": ")} = ${place};`;
    return names.startsWith("*") ? `const ${names.slice(5)} = ${place};` : `const ${names} = ${place}.default;`;
  });
}

onmessage = async ({ data }) => {
  compiled = data.module;
  console.log = console.info = say;
  let error = null;
  try {
    await import(URL.createObjectURL(new Blob([linked(data.program)], { type: "text/javascript" })));
  } catch (e) {
    error = e instanceof Error ? `${e.name === "Error" ? "" : `${e.name}: `}${e.message}` : String(e);
  }
  try {
    end();
  } catch {
    // The world is gone: what was printed is all there is.
  }
  const things = beside.filter(({ poses }) => poses.length).map(({ look, poses }) => ({ look, poses }));
  postMessage({ printed, error, recording, shapes, beside: things, floor });
};
