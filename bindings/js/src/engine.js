// An engine: shapes, and the worlds that share them.
import { callback } from "./callback.js";
import * as constants from "./constants.js";
import { unsupported } from "./errors.js";
import { net, Owned } from "./owner.js";
import { bring } from "./side_module.js";
import { World } from "./world.js";

/** @returns {{ pointer: number }} for engine.useShape()   @throws TypeError (no side module of a shape) */
export async function bringShape(module, source) {
  return { pointer: await bring(module, source) };
}

/** A function as a shape: slower than a side module, and of modules with one thread.
 *  @param support (params, direction) => [3] m, the farthest point of the shape along the direction; a pure function
 *  @param params  [[name, unit, least, most]] of the numbers that it takes   @returns {{ pointer: number }} for
 *  engine.useShape() */
export function bringSupport(m, support, id, params) {
  if (m.threads > 1)
    throw unsupported("bringSupport", 1, "a function of this thread is no shape for others", "Load with one thread");
  const held = (bytes) => {
    const at = m.claim(bytes); // as long as the module: engines go on reading it
    new Uint8Array(m.buffer, at, bytes).fill(0);
    return at;
  };
  const call = (_, from, n, direction, to) => {
    try {
      const point = support(m.doubles(from, Number(n)), m.doubles(direction, 3));
      new Float64Array(m.buffer, to, 3).set(point);
      return 0;
    } catch {
      return 1; // the engine tells it as a fault
    }
  };
  const size = m.structs.size("carom_param"),
    rows = held(size * params.length),
    text = (value) => m.putText(held, value);
  params.forEach(([name, unit, min, max], i) =>
    m.structs.write(m.view, "carom_param", rows + i * size, { name: text(name), unit: text(unit), min, max }),
  );
  const about = held(m.structs.size("carom_shape_plugin"));
  m.structs.write(m.view, "carom_shape_plugin", about, {
    struct_size: m.structs.size("carom_shape_plugin"),
    abi_major: constants.CAROM_PLUGIN_ABI_MAJOR,
    abi_minor: constants.CAROM_PLUGIN_ABI_MINOR,
    id: text(id),
    version: 1,
    param_count: params.length,
    params: rows,
    support: callback(m, "iilii", call),
  });
  return { pointer: about };
}

/** A shape of an engine, shared by any number of bodies. */
export class Shape {
  constructor(engine, handle) {
    this.engine = engine;
    this.handle = handle;
  }

  /** Bounds, volume, inertia, and which plugin it is of. */
  get info() {
    const m = this.engine.module;
    const info = m.get(
      "carom_shape_info",
      (at) => m.raw.carom_shape_get_info(this.engine.pointer, this.handle, at, m.error),
      "shape.info",
    );
    const built = info.is_half_space ? "half_space" : info.is_scenery ? "scenery" : "hull_of";
    return { ...info, kind: info.plugin ? this.engine.pluginId(info.plugin) : built };
  }

  /** The numbers that it was made of: of a box its half extents (m). */
  get params() {
    const m = this.engine.module,
      n = Number(this.info.param_count);
    return m.frame((room) => {
      const at = room(8 * n),
        count = room(8);
      m.view.setBigUint64(count, BigInt(n), true);
      m.call("carom_shape_get_params", this.engine.pointer, this.handle, at, count);
      return m.doubles(at, n);
    });
  }

  /** Farthest points in directions. @param directions [3n]   @returns Float64Array [3n] m, shape frame */
  supports(directions) {
    const m = this.engine.module,
      n = directions.length / 3;
    return m.frame((room) => {
      const from = m.putDoubles(room, directions, 3 * n, "supports(directions)"),
        to = room(24 * n);
      m.call("carom_shape_support", this.engine.pointer, this.handle, from, BigInt(n), to);
      return new Float64Array(m.buffer, to, 3 * n).slice();
    });
  }

  /** Corners of a mesh's or height field's triangles. @returns Float64Array [9n] m, shape frame */
  triangles() {
    const m = this.engine.module;
    return m.frame((room) => {
      const count = room(8),
        next = room(8);
      m.call("carom_shape_get_triangles", this.engine.pointer, this.handle, 0n, 0, count, next);
      const n = Number(m.view.getBigUint64(count, true)),
        to = room(72 * n);
      m.call("carom_shape_get_triangles", this.engine.pointer, this.handle, 0n, to, count, next);
      return new Float64Array(m.buffer, to, 9 * n).slice();
    });
  }

  destroy() {
    const m = this.engine.module;
    m.call("carom_shape_destroy", this.engine.pointer, this.handle);
  }
}

function checkThreads(module, threads) {
  if (threads === 1 || threads === module.threads) return;
  const text = `no ${threads} threads to be had: the module was loaded with ${module.threads}`;
  const remedy = `Load it with load({ threads: ${threads} }), or make the engine with one thread`;
  throw unsupported("engine", 1, text, remedy);
}

export class Engine {
  constructor(module, { threads = module.threads } = {}) {
    this.module = module;
    this.threads = threads;
    checkThreads(module, threads);
    const pointer = module.frame((room) => {
      const out = room(8);
      module.call("carom_engine_create", 0, out);
      return module.view.getUint32(out, true);
    });
    this.owned = new Owned(pointer, (p) =>
      module.check(module.raw.carom_engine_destroy(p, module.error), "engine.free"),
    );
    net.register(this, this.owned, this);
    module.call("carom_plugins_register_standard", pointer);
    if (threads > 1 && !module.raw.carom_js_use(pointer)) throw new RangeError("no memory for an engine with threads");
  }

  get pointer() {
    if (!this.owned.pointer) throw new TypeError("this engine was freed: make another with carom.engine()");
    return this.owned.pointer;
  }

  /** Destroys it; its worlds must be freed before.   @throws CaromError (IN_USE) otherwise */
  free() {
    this.owned.release();
    net.unregister(this);
  }

  /** @param {string} id  of the plugin, "carom.box" or, of a standard one, "box"   @param {ArrayLike<number>} params */
  shape(id, params) {
    const m = this.module;
    const handle = m.frame((room) => {
      const plugin = room(8),
        out = room(8);
      m.call("carom_plugin_find", this.pointer, m.putText(room, id.includes(".") ? id : `carom.${id}`), plugin);
      const numbers = m.putDoubles(room, params, params.length, "shape(id, params)");
      m.call(
        "carom_shape_create",
        this.pointer,
        m.view.getBigUint64(plugin, true),
        numbers,
        BigInt(params.length),
        out,
      );
      return m.view.getBigUint64(out, true);
    });
    return new Shape(this, handle);
  }

  sphere(radius) {
    return this.shape("sphere", [radius]);
  }
  box(x, y, z) {
    return this.shape("box", [x, y, z]);
  }
  capsule(radius, halfHeight) {
    return this.shape("capsule", [radius, halfHeight]);
  }
  /** The hull of two balls on the axis y.   @param halfHeight  m, from the middle to the centre of a ball */
  taperedCapsule(radiusBottom, radiusTop, halfHeight) {
    return this.shape("tapered_capsule", [radiusBottom, radiusTop, halfHeight]);
  }
  cylinder(radius, halfHeight) {
    return this.shape("cylinder", [radius, halfHeight]);
  }
  cone(radius, halfHeight) {
    return this.shape("cone", [radius, halfHeight]);
  }
  ellipsoid(x, y, z) {
    return this.shape("ellipsoid", [x, y, z]);
  }
  /** Convex hull of points. @param points [3n] m */
  hull(points) {
    return this.shape("hull", points);
  }

  /** Convex hull of shapes. One at two places gives its sweep, one part with a scale a scaled shape, one with a radius a
   * rounded one.   @param parts  [{ shape, position, orientation, scale }]   @param radius  m, by which all of it grows */
  hullOf(parts, radius = 0) {
    const m = this.module,
      n = parts.length;
    return new Shape(
      this,
      m.frame((room) => {
        const handles = room(8 * n),
          out = room(8);
        parts.forEach(({ shape }, i) => m.view.setBigUint64(handles + 8 * i, shape.handle, true));
        const column = (key, usual) => {
          const all = parts.flatMap((part) => Array.from(part[key] ?? usual));
          return m.putDoubles(room, all, usual.length * n, `hullOf(parts): ${key}`);
        };
        m.call(
          "carom_shape_create_hull_of",
          this.pointer,
          handles,
          BigInt(n),
          column("position", [0, 0, 0]),
          column("orientation", [0, 0, 0, 1]),
          column("scale", [1, 1, 1]),
          radius,
          out,
        );
        return m.view.getBigUint64(out, true);
      }),
    );
  }

  /** All points p with normal . p <= offset.   @param normal [3] unit   @param offset m */
  halfSpace(normal = [0, 1, 0], offset = 0) {
    const m = this.module;
    return new Shape(
      this,
      m.frame((room) => {
        const out = room(8);
        m.call(
          "carom_shape_create_half_space",
          this.pointer,
          m.putDoubles(room, normal, 3, "halfSpace(normal)"),
          offset,
          out,
        );
        return m.view.getBigUint64(out, true);
      }),
    );
  }

  /** Scenery of triangles, for bodies that do not move.   @param vertices [3n] m   @param triangles [3m] indices */
  mesh(vertices, triangles, { twoSided = false } = {}) {
    const m = this.module;
    return new Shape(
      this,
      m.frame((room) => {
        const at = m.putDoubles(room, vertices, vertices.length, "mesh(vertices)");
        const corners = room(4 * triangles.length),
          out = room(8);
        new Uint32Array(m.buffer, corners, triangles.length).set(triangles);
        const desc = m.put(room, "carom_mesh_desc", {
          vertices: at,
          vertex_count: BigInt(Math.floor(vertices.length / 3)),
          triangles: corners,
          triangle_count: BigInt(Math.floor(triangles.length / 3)),
          flags: twoSided ? 1 : 0,
        });
        m.call("carom_shape_create_mesh", this.pointer, desc, out);
        return m.view.getBigUint64(out, true);
      }),
    );
  }

  /** Scenery over a grid.   @param heights [rows * columns] m, row by row along z   @param spacing [2] m along x and
   * z */
  heightField(heights, columns, spacing) {
    const m = this.module;
    return new Shape(
      this,
      m.frame((room) => {
        const at = m.putDoubles(room, heights, heights.length, "heightField(heights)"),
          out = room(8);
        const desc = m.put(room, "carom_height_field_desc", {
          heights: at,
          columns,
          rows: heights.length / columns,
          spacing,
        });
        m.call("carom_shape_create_height_field", this.pointer, desc, out);
        return m.view.getBigUint64(out, true);
      }),
    );
  }

  /** A shape plugin of your own, as a side module: see side_module.js.   @returns its id, for shape(id, params)
   *  @throws TypeError (no side module of a shape), CaromError (the engine refuses it, e.g. as invalid) */
  async loadShape(source) {
    return this.useShape(await bringShape(this.module, source));
  }

  /** A shape that carom.bringShape() brought.   @returns its id, for shape(id, params)
   *  @throws CaromError (the engine refuses it, e.g. as invalid) */
  useShape({ pointer }) {
    const m = this.module;
    return this.pluginId(
      m.frame((room) => {
        const out = room(8);
        m.call("carom_plugin_register", this.pointer, pointer, out);
        return m.view.getBigUint64(out, true);
      }),
    );
  }

  /** A shape whose support function is written here; see carom.bringSupport().   @returns its id, for shape(id, params)
   *  @throws CaromError (UNSUPPORTED with threads; the engine refuses it, e.g. as invalid) */
  supportPlugin(support, id, params) {
    return this.useShape(bringSupport(this.module, support, id, params));
  }

  /** Id of a plugin, by handle: "carom.box". */
  pluginId(plugin) {
    const m = this.module;
    return m.frame((room) => {
      const out = room(8);
      m.call("carom_plugin_describe", this.pointer, plugin, out);
      const { offset } = m.structs.layouts.get("carom_shape_plugin").fields.get("id");
      return m.text(m.view.getUint32(m.view.getUint32(out, true) + offset, true));
    });
  }

  /** What shape(id, params) takes at least.   @returns [{ name, unit, min, max }] */
  parameters(id) {
    const m = this.module;
    return m.frame((room) => {
      const plugin = room(8),
        out = room(8);
      m.call("carom_plugin_find", this.pointer, m.putText(room, id.includes(".") ? id : `carom.${id}`), plugin);
      m.call("carom_plugin_describe", this.pointer, m.view.getBigUint64(plugin, true), out);
      const about = m.structs.read(m.view, "carom_shape_plugin", m.view.getUint32(out, true));
      return Array.from({ length: about.param_count }, (_, i) => {
        const row = m.structs.read(m.view, "carom_param", about.params + i * m.structs.size("carom_param"));
        return { ...row, name: m.text(row.name), unit: m.text(row.unit) };
      });
    });
  }

  /** @param options  gravity [3] m/s^2, body_capacity */
  world(options = {}) {
    return new World(this, options);
  }
}

if (Symbol.dispose) Engine.prototype[Symbol.dispose] = Engine.prototype.free;
