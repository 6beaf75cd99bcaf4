// Files that are opened or dropped: what they become, and that bad ones are told of and leave the scene as it was.
// Some are made by the native command, where it is built: build/test/bin/carom or build/demo/bin/carom.
import { strict as assert } from "node:assert";
import { execFileSync } from "node:child_process";
import { existsSync, mkdtempSync } from "node:fs";
import { readFile, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { Browser, field, now, skip, title } from "./browser.mjs";

const carom = ["test", "demo"]
  .map((p) => new URL(`../../../build/${p}/bin/carom`, import.meta.url).pathname)
  .find(existsSync);
const folder = mkdtempSync(join(tmpdir(), "carom-"));
let browser;

before(async () => {
  if (!skip) browser = await Browser.start();
});
after(() => browser?.end());

const small = { viewport: { width: 420, height: 320 } };
const state = (page) =>
  page.evaluate(() => {
    const [sim] = caromViewer.state.sims;
    return {
      bodies: sim.bodies.map((b) => ({ type: b.type, mass: b.mass, position: b.position })),
      parts: sim.parts.length,
    };
  });

/** Open a file and wait until the page says something. @returns what it says */
async function open(page, name, content) {
  const file = join(folder, name);
  if (content !== undefined) await writeFile(file, content);
  await page.evaluate(() => (document.getElementById("message").hidden = true));
  await page.setInputFiles("#open", file);
  await page.waitForFunction(() => !document.getElementById("message").hidden, null, { timeout: 30000 });
  return (await now(page)).message;
}

/** A cube of edge 2 a, as triangles of a .gltf with its buffer inside. */
function cube(a, nodes, more = {}) {
  const corners = Float32Array.from({ length: 24 }, (_, i) => ((Math.floor(i / 3) >> (i % 3)) & 1 ? a : -a));
  const faces = Uint16Array.from([
    0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5,
  ]);
  const bytes = Buffer.concat([Buffer.from(corners.buffer), Buffer.from(faces.buffer)]);
  return JSON.stringify({
    asset: { version: "2.0" },
    scene: 0,
    scenes: [{ nodes: nodes.map((_, i) => i) }],
    nodes,
    meshes: [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }],
    accessors: [
      { bufferView: 0, componentType: 5126, count: 8, type: "VEC3", min: [-a, -a, -a], max: [a, a, a] },
      { bufferView: 1, componentType: 5123, count: 36, type: "SCALAR" },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: 96 },
      { buffer: 0, byteOffset: 96, byteLength: 72 },
    ],
    buffers: [{ byteLength: 168, uri: `data:application/octet-stream;base64,${bytes.toString("base64")}` }],
    ...more,
  });
}

test("a glTF file without physics: a body for each mesh", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=1", small);
  const said = await open(
    page,
    "cubes.gltf",
    cube(0.5, [
      { mesh: 0, translation: [0, 2, 0] },
      { mesh: 0, scale: [2, 1, 1], translation: [3, 2, 0] },
    ]),
  );
  assert.match(said, /no physics/);
  const { bodies } = await state(page);
  assert.deepEqual(bodies.map((b) => b.type).sort(), ["dynamic", "dynamic", "static"]);
  const masses = bodies.map((b) => b.mass).sort((x, y) => x - y);
  assert.ok(Math.abs(masses[1] - 1000) < 1e-6 && Math.abs(masses[2] - 2000) < 1e-6, `${masses}`);
  await page.evaluate(() => caromViewer.state.sims[0].seek(30));
  assert.equal((await now(page)).step, 30);
  await page.close();
});

test(
  "a glTF file with motion: what moves falls, parts of it are one body, a level mesh is the ground",
  { skip, timeout: 120000 },
  async () => {
    const page = await browser.visit("?scene=stacks&step=1", small);
    const motion = (node) => ({
      samplers: [{ input: 2, output: 3 }],
      channels: [{ sampler: 0, target: { node, path: "translation" } }],
    });
    const parts = JSON.parse(
      cube(0.5, [
        { name: "floor", mesh: 0, scale: [40, 0, 40] },
        { name: "shelf", mesh: 0, translation: [0, 1, 0] },
        { name: "hammer", children: [3, 4], translation: [0, 4, 0] },
        { name: "head", mesh: 0 },
        { name: "handle", mesh: 0, translation: [1.5, 0, 0], scale: [2, 0.2, 0.2] },
        { name: "sign", mesh: 0, translation: [5, 2, 0], scale: [1, 1, 0] },
      ]),
    );
    parts.scenes[0].nodes = [0, 1, 2, 5];
    parts.animations = [motion(2)];
    const times = Buffer.from(Float32Array.of(0, 1, 0, 4, 0, 0, 4, 0).buffer);
    parts.accessors.push(
      { bufferView: 2, componentType: 5126, count: 2, type: "SCALAR", min: [0], max: [1] },
      { bufferView: 2, byteOffset: 8, componentType: 5126, count: 2, type: "VEC3" },
    );
    parts.bufferViews.push({ buffer: 1, byteLength: 32 });
    parts.buffers.push({ byteLength: 32, uri: `data:application/octet-stream;base64,${times.toString("base64")}` });
    const said = await open(page, "hammer.gltf", JSON.stringify(parts));
    for (const told of [/what the file moves falls/, /lowest level mesh is the ground/, /flat meshes have no volume/])
      assert.match(said, told);
    const { bodies } = await state(page);
    // The shelf, the sign and the ground stand; the floor is the ground.
    assert.deepEqual(bodies.map((b) => b.type).sort(), ["dynamic", "static", "static", "static"]);
    const mass = Math.max(...bodies.map((b) => b.mass));
    assert.ok(Math.abs(mass - 1080) < 1e-3, `${mass}`); // a cube of 1 m and 2 x 0.2 x 0.2 m
    await page.evaluate(() => caromViewer.seek(240));
    const lowest = await page.evaluate(() => {
      const { sims } = caromViewer.state,
        hammer = sims[0].bodies.find((b) => b.type === "dynamic");
      return hammer.position[1];
    });
    assert.ok(lowest > 1.4 && lowest < 2.2, `${lowest}`); // on the shelf, whose top is at 1.5 m
    await page.close();
  },
);

test("a mesh without volume that should move is told of by its name", { skip, timeout: 60000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=1", small);
  const { hash } = await now(page);
  for (const scale of [
    [1, 0, 1],
    [1e-9, 1, 3],
    [1, 1, 1e-8],
  ]) {
    const said = await open(
      page,
      "sheet.gltf",
      cube(
        0.5,
        [
          {
            name: "sheet",
            mesh: 0,
            scale,
            rotation: [0.18257418583505536, 0.3651483716701107, 0.5477225575051661, 0.7302967433402214],
            extensions: {
              KHR_physics_rigid_bodies: { motion: {}, collider: { geometry: { node: 0, convexHull: true } } },
            },
          },
        ],
        { extensionsUsed: ["KHR_physics_rigid_bodies"] },
      ),
    );
    assert.match(said, /"sheet" is flat and has no volume.*thickness/, `${scale}`);
    assert.equal((await now(page)).hash, hash);
  }
  await page.close();
});

test("a glTF file with physics: masses, shapes, places, materials", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=1", small);
  const physics = (more) => ({ extensions: { KHR_physics_rigid_bodies: more } });
  const shape = (i) => ({ collider: { geometry: { shape: i }, physicsMaterial: 0 } });
  const nodes = [
    { name: "floor", translation: [0, -0.5, 0], ...physics(shape(0)) },
    {
      name: "ball",
      translation: [0, 3, 0],
      ...physics({ motion: { mass: 7, linearVelocity: [0, 0, 2] }, ...shape(1) }),
    },
    { name: "two", translation: [4, 2, 0], children: [4], ...physics({ motion: { mass: 3 } }) },
    {
      name: "hull",
      mesh: 0,
      translation: [-4, 2, 0],
      ...physics({ motion: {}, collider: { geometry: { mesh: 0, convexHull: true } } }),
    },
    { name: "part", translation: [0, 1, 0], ...physics(shape(2)) },
  ];
  const extensions = {
    KHR_implicit_shapes: {
      shapes: [
        { type: "box", box: { size: [20, 1, 20] } },
        { type: "sphere", sphere: { radius: 0.5 } },
        { type: "capsule", capsule: { height: 1, radiusTop: 0.2, radiusBottom: 0.2 } },
      ],
    },
    KHR_physics_rigid_bodies: { physicsMaterials: [{ dynamicFriction: 0.3, restitution: 0 }] },
  };
  const text = cube(0.5, nodes, {
    scenes: [{ nodes: [0, 1, 2, 3] }],
    extensions,
    extensionsUsed: Object.keys(extensions),
  });
  await open(page, "physics.gltf", text);
  const { bodies, parts } = await state(page);
  assert.equal(parts, 4);
  const near = (a, b) => assert.ok(Math.abs(a - b) < 1e-6 * Math.max(1, Math.abs(b)), `${a}, not ${b}`);
  const at = (x) => bodies.find((b) => Math.abs(b.position[0] - x) < 1e-6 && b.type === "dynamic");
  (near(at(0).mass, 7), near(at(4).mass, 3), near(at(-4).mass, 1000));
  assert.equal(bodies.filter((b) => b.type === "static").length, 1);
  await page.evaluate(() => caromViewer.state.sims[0].seek(120));
  const later = await state(page);
  const ball = later.bodies.find((b) => Math.abs(b.mass - 7) < 1e-6);
  assert.ok(Math.abs(ball.position[1] - 0.5) < 5e-3 && ball.position[2] > 1, `${ball.position}`);
  await page.close();
});

test(
  "files of the command: glTF, worlds and recordings",
  { skip: skip || (!carom && "no native carom is built"), timeout: 180000 },
  async () => {
    const page = await browser.visit("?scene=stacks&step=1", small);
    execFileSync(carom, ["export", "ragdoll", join(folder, "ragdoll.gltf")]);
    const said = await open(page, "ragdoll.gltf");
    assert.match(said, /joints are left out \(\d+\)/);
    assert.match(said, /carom view/);
    assert.ok((await state(page)).bodies.length > 30);

    // README's own: an animation without physics. Ten dominoes stand, and all of it stays on the ground.
    execFileSync(carom, ["run", "seesaw", "--quiet", "--gltf", join(folder, "seesaw.gltf")]);
    assert.match(await open(page, "seesaw.gltf"), /18 bodies.*lowest level mesh is the ground/);
    const dominoes = await page.evaluate(() => {
      caromViewer.seek(240);
      const { sims, row } = caromViewer.state;
      return sims[0].bodies.filter((_, i) => row.bodies[i]?.[1] === "domino").map((b) => b.position[1]);
    });
    assert.equal(dominoes.length, 10);
    assert.ok(
      dominoes.every((y) => y > 0.02),
      `${dominoes}`,
    );

    execFileSync(carom, ["run", "bullet", "--seconds", "0.5", "--quiet", "--record", join(folder, "bullet.rec")]);
    assert.match(await open(page, "bullet.rec"), /30 steps/);
    assert.equal((await now(page)).step, 0);
    for (const _ of Array(12)) await page.click("#step");
    assert.deepEqual(
      { ...(await now(page)), hash: "", message: "" },
      { step: 12, hash: "", native: "true", message: "" },
    );
    const all = await page.evaluate(() => {
      const [sim] = caromViewer.state.sims,
        { hashes } = caromViewer.state.row;
      const wrong = [];
      for (const step of [30, 3, 29, 1]) (sim.seek(step), sim.hash() !== hashes[step] && wrong.push(step));
      return { wrong, known: Object.keys(hashes).length };
    });
    assert.deepEqual(all, { wrong: [], known: 30 });

    const saved = join(folder, "saved.world");
    execFileSync(carom, ["run", "stacks", "--seconds", "0.1", "--quiet", "--save", saved]);
    await page.setInputFiles("#open", saved);
    await page.waitForFunction(() => caromViewer.state.sims[0].bodies.length > 100);
    await page.close();
  },
);

/** The world and the names that an importer writes, opened together. */
async function openRobot(page, world, names) {
  const files = [join(folder, "robot.world"), join(folder, "robot.world.json")];
  await writeFile(files[0], world);
  await writeFile(files[1], names);
  await page.evaluate(() => (document.getElementById("message").hidden = true));
  await page.setInputFiles("#open", files);
  await page.waitForFunction(
    () => caromViewer.state.row.name === undefined || !document.getElementById("message").hidden,
  );
  return page.evaluate(() => {
    const { state, stage } = caromViewer,
      [picture] = state.pictures;
    return {
      dt: state.sims[0].dt,
      names: state.sims[0].bodies.map((_, i) => picture.nameOf(i)),
      up: stage.camera.up.toArray(),
      message: document.getElementById("message").hidden ? "" : document.getElementById("message").textContent,
    };
  });
}

test("a robot's file: its own step, its names, and up is against gravity", { skip, timeout: 120000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=1", small);
  const world = Buffer.from(
    await page.evaluate(() => {
      const { engine } = caromViewer.state,
        made = engine.world();
      made.gravity = [0, 0, -9.81];
      made.body({ shape: engine.box(0.2, 0.2, 0.1), type: "static", position: [0, 0, 0.1] });
      const link = made.body({ shape: engine.box(0.3, 0.05, 0.05), position: [0.35, 0, 1], density: 1000 });
      made.joint("hinge", null, link, { at: [0, 0, 1], axes: [0, 0, Math.SQRT1_2, Math.SQRT1_2] });
      const bytes = made.save({ whole: true });
      made.free();
      return bytes.toBase64();
    }),
    "base64",
  );
  for (const names of ["nonsense", "null", "{}", '{"dt":0,"bodies":{"link":1}}', '{"dt":0.002,"bodies":{"link":"1"}}']) {
    const told = await openRobot(page, world, names);
    assert.match(told.message, /the file of names is none/);
    assert.equal((await now(page)).step, 1);
  }
  const told = await openRobot(page, world, JSON.stringify({ dt: 0.002, bodies: { link: 1, tool: 1 } }));
  assert.deepEqual(told, { dt: 0.002, names: ["body 0", "link"], up: [0, 0, 1], message: "" });
  const after = await page.evaluate(() => {
    const { sims, pictures } = caromViewer.state;
    caromViewer.seek(150); // 0.3 s: a rod that was let go level, 3 g / 4 l t^2 down at first
    return { z: sims[0].bodies[1].position[2], name: pictures[0].nameOf(1) };
  });
  assert.ok(after.z < 0.9 && after.z > 0.6 && after.name === "link", JSON.stringify(after));
  // What is dropped falls along gravity. Scenes have their own up again.
  await page.click('[data-tool="box"]');
  const box = await page.locator("#view").boundingBox();
  const [u, v] = await page.evaluate(() => {
    for (let k = 1; k < 400; ++k) {
      const at = [(k % 20) / 20, Math.floor(k / 20) / 20];
      if (caromViewer.probe(...at)) return at;
    }
    return null;
  });
  await page.mouse.click(box.x + u * box.width, box.y + v * box.height);
  const fallen = await page.evaluate(() => {
    const [sim] = caromViewer.state.sims,
      from = sim.bodies[2].position;
    for (let i = 0; i < 50; ++i) sim.advance();
    return sim.bodies[2].position.map((x, k) => x - from[k]);
  });
  assert.ok(Math.abs(fallen[0]) < 1e-3 && Math.abs(fallen[1]) < 1e-3 && fallen[2] < -0.02, `${fallen}`);
  await page.selectOption("#scene", "stacks");
  await page.waitForFunction(() => caromViewer.state.row.name === "stacks");
  assert.deepEqual(await page.evaluate(() => caromViewer.stage.camera.up.toArray()), [0, 1, 0]);
  await page.close();
});

const robots = new URL("../../../build/robots", import.meta.url).pathname,
  importer = existsSync(robots) && carom;
test(
  "what python3 -m carom.robots wrote of a model opens",
  { skip: skip || (!importer && "build/robots has no reader of models: .ci/test fetches it"), timeout: 120000 },
  async () => {
    await writeFile(
      join(folder, "arm.xml"),
      `<mujoco><worldbody><geom type="plane" size="5 5 .1"/><body name="upper" pos="0 0 1"><joint name="shoulder" axis="0 1 0"/>
       <geom type="capsule" fromto="0 0 0 .5 0 0" size=".05"/><body name="fore" pos=".5 0 0"><joint name="elbow" axis="0 1 0"/>
       <geom type="capsule" fromto="0 0 0 .4 0 0" size=".04"/></body></body></worldbody></mujoco>`,
    );
    const build = join(carom, "..", "..");
    execFileSync("python3", ["-m", "carom.robots", join(folder, "arm.xml"), "-o", join(folder, "arm.world")], {
      env: {
        ...process.env,
        PYTHONPATH: `${new URL("../../../bindings/python", import.meta.url).pathname}:${robots}`,
        CAROM_LIBRARY: join(build, "lib", "libcarom.so.0.9"),
        CAROM_PLUGIN_PATH: join(build, "plugins"),
      },
    });
    const page = await browser.visit("?scene=stacks&step=1", small);
    const told = await openRobot(
      page,
      await readFile(join(folder, "arm.world")),
      await readFile(join(folder, "arm.world.json")),
    );
    assert.equal(told.message, "");
    assert.deepEqual(told.up, [0, 0, 1]);
    assert.ok(told.dt === 0.002 && told.names.includes("upper") && told.names.includes("fore"), `${told.names}`);
    const low = await page.evaluate(() => {
      const { sims, pictures } = caromViewer.state;
      caromViewer.seek(200);
      return sims[0].bodies.map((b, i) => [pictures[0].nameOf(i), b.position[2]]);
    });
    assert.ok(low.find(([name]) => name === "fore")[1] < 0.9, `${low}`);
    await page.close();
  },
);

test(
  "carom view: a recording comes first, and has the recorded hashes",
  { skip: skip || (!carom && "no native carom is built"), timeout: 120000 },
  async () => {
    const { spawn } = await import("node:child_process");
    execFileSync(carom, ["run", "bullet", "--seconds", "0.2", "--quiet", "--record", join(folder, "served.rec")]);
    const server = spawn(carom, [
      "view",
      join(folder, "served.rec"),
      "--port",
      "0",
      "--site",
      new URL("../dist", import.meta.url).pathname,
    ]);
    try {
      const said = await new Promise((resolve, reject) => {
        server.stdout.once("data", (text) => resolve(String(text)));
        server.stderr.once("data", (text) => reject(new Error(String(text))));
      });
      const page = await browser.visit(/http:\S+/.exec(said)[0], small);
      await page.evaluate(() => caromViewer.state.playing && document.getElementById("play").click());
      assert.equal(await page.evaluate(() => caromViewer.state.row.name), "served");
      const same = await page.evaluate(() => {
        const [sim] = caromViewer.state.sims;
        return [5, 12].map((step) => (sim.seek(step), sim.hash() === caromViewer.state.row.hashes[step]));
      });
      assert.deepEqual(same, [true, true]);
      // Scenes of other numbers are made by the command.
      await page.selectOption("#scene", "stacks");
      await page.waitForFunction(() => caromViewer.state.row.name === "stacks");
      await title(page, "Settings").click();
      await title(page, "its own numbers").click();
      await field(page, /^n\b/).locator('[type="number"]').fill("2");
      await page.keyboard.press("Enter");
      await page.locator("#panel button", { hasText: "Make the scene anew" }).click();
      await page.waitForFunction(() => caromViewer.state.row.made?.n === 2);
      const made = await page.evaluate(() => {
        const [sim] = caromViewer.state.sims;
        return [sim.bodies.length, (sim.seek(20), sim.hash() === caromViewer.state.row.hashes[20])];
      });
      assert.deepEqual(made, [2 * 40 + 1, true]);
      await page.close();
    } finally {
      server.kill();
    }
  },
);

test(
  "an OBJ file is a body that falls into the scene; a shape is a tool from then on",
  { skip, timeout: 120000 },
  async () => {
    const page = await browser.visit("?scene=stacks&step=1", small);
    const before = (await state(page)).bodies.length;
    const obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";
    assert.match(await open(page, "corner.obj", obj), /convex hull/);
    let now_ = await state(page);
    assert.equal(now_.bodies.length, before + 1);
    assert.ok(Math.abs(now_.bodies.at(-1).mass - 1000 / 6) < 1e-6, `${now_.bodies.at(-1).mass}`);
    // By dropping it on the picture, too.
    await page.evaluate((text) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([text], "dropped.obj"));
      document
        .getElementById("stage")
        .dispatchEvent(new DragEvent("drop", { dataTransfer, bubbles: true, cancelable: true }));
    }, obj);
    await page.waitForFunction((n) => caromViewer.state.sims[0].bodies.length === n, before + 2);
    const large = obj.replace(/^v.*$/gm, (line) => line.replaceAll("1", "100"));
    assert.match(await open(page, "large.obj", large), /1 m long/);

    const side = new URL("../../../bindings/js/dist/template.wasm", import.meta.url);
    if (existsSync(side)) {
      assert.match(await open(page, "template.wasm", await readFile(side)), /carom\.template/);
      const count = (await state(page)).bodies.length;
      const box = await page.locator("#view").boundingBox();
      await page.mouse.click(box.x + box.width / 2, box.y + box.height * 0.62);
      assert.equal((await state(page)).bodies.length, count + 1);
      await page.evaluate(() => caromViewer.state.sims[0].seek(caromViewer.step + 30));
      // It is there in the next scene, too.
      await page.selectOption("#scene", "wall");
      await page.waitForFunction(() => caromViewer.state.row.name === "wall");
      const other = (await state(page)).bodies.length;
      await page.mouse.click(box.x + box.width / 2, box.y + box.height * 0.62);
      assert.equal((await state(page)).bodies.length, other + 1);
    }
    await page.close();
  },
);

test("hostile files are told of and change nothing", { skip, timeout: 240000 }, async () => {
  const page = await browser.visit("?scene=stacks&step=3", small);
  const { hash } = await now(page);
  const good = cube(0.5, [{ mesh: 0 }]),
    edited = (change) => {
      const json = JSON.parse(good);
      change(json);
      return JSON.stringify(json);
    };
  const header = Buffer.concat([Buffer.from("CAROMREC"), Buffer.from(Uint32Array.of(1, 0).buffer)]);
  for (const [name, content] of [
    ["empty.gltf", ""],
    ["text.gltf", "not JSON"],
    ["list.gltf", "[]"],
    ["cut.glb", Buffer.from("glTF\x02\0\0\0\xff\xff\xff\xff", "latin1")],
    ["remote.gltf", edited((j) => (j.buffers[0].uri = "https://example.com/secret.bin"))],
    ["upward.gltf", edited((j) => (j.buffers[0].uri = "../scenes/index.json"))],
    ["long.gltf", edited((j) => (j.accessors[0].count = 1e9))],
    ["none.gltf", edited((j) => (j.meshes = []))],
    ["loop.gltf", edited((j) => (j.nodes[0].children = [0]))],
    ["required.gltf", edited((j) => (j.extensionsRequired = ["EXT_of_nobody"]))],
    ["omi.gltf", edited((j) => (j.extensionsUsed = ["OMI_physics_body"]))],
    ["huge.gltf", edited((j) => (j.nodes[0].scale = [1e300, 1e300, 1e300]))],
    ["flat.gltf", edited((j) => (j.nodes[0].scale = [1, 0, 1]))],
    [
      "physics.gltf",
      edited(
        (j) => (
          (j.extensionsUsed = ["KHR_physics_rigid_bodies"]),
          (j.nodes[0].extensions = {
            KHR_physics_rigid_bodies: { motion: { mass: -1 }, collider: { geometry: { shape: 7 } } },
          })
        ),
      ),
    ],
    ["empty.obj", ""],
    ["nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 4 2\n"],
    ["flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 2 4 3\n"],
    ["header.rec", header],
    ["noise.rec", Buffer.concat([header, Buffer.alloc(5000, 0x5a)])],
    ["empty.wasm", Buffer.from("\0asm", "latin1")],
    ["other.wasm", Buffer.from([0, 97, 115, 109, 1, 0, 0, 0])],
    ["picture.png", Buffer.from("\x89PNG\r\n\x1a\n", "latin1")],
  ]) {
    const said = await open(page, name, content);
    assert.ok(said.length > 20, `${name}: "${said}"`);
    assert.equal((await now(page)).hash, hash, `${name}: ${said}`);
  }
  await page.close();
});

test("no console error in all of this", { skip }, () => assert.deepEqual(browser.complaints(), []));
