// Joints as arrays, and inverse dynamics of a tree of them: see carom/joint.h and carom/tree.h.
import * as C from "./constants.js";

/** @param field  "position": CAROM_JOINT_BULK_POSITION */
function numbered(m, field) {
  const number = C[`CAROM_JOINT_BULK_${field.toUpperCase()}`];
  if (number === undefined)
    throw new TypeError(`joints have no field "${field}": CAROM_JOINT_BULK_* names those there are`);
  return m.frame((room) => {
    const width = room(4);
    m.check(m.raw.carom_joint_bulk_width(number, width), field);
    return { number, width: m.view.getUint32(width, true) };
  });
}

function all(m, world, joints, room, width) {
  const handles = (joints ?? world.joints()).map((joint) => joint.handle),
    at = room(8 * handles.length);
  new BigUint64Array(m.buffer, at, handles.length).set(handles);
  return { at, n: BigInt(handles.length), values: room(8 * width * handles.length), total: width * handles.length };
}

/** Mixed into World. */
export const joints = {
  /** @param field  of CAROM_JOINT_BULK_*: "position", "velocity", ...   @param joints  by default all
   *  @returns Float64Array, the field's numbers of each joint in turn */
  readJoints(field, joints) {
    const m = this.module,
      { number, width } = numbered(m, field);
    return m.frame((room) => {
      const { at, n, values, total } = all(m, this, joints, room, width);
      m.call("carom_world_read_joints", this.pointer, number, C.CAROM_SCALAR_F64, at, n, values, 0n);
      return new Float64Array(m.buffer, values, total).slice();
    });
  },

  writeJoints(field, numbers, joints) {
    const m = this.module,
      { number, width } = numbered(m, field);
    m.frame((room) => {
      const { at, n, values, total } = all(m, this, joints, room, width);
      if (numbers.length !== total)
        throw new TypeError(`writeJoints(${field}) takes ${total} numbers, not ${numbers.length}`);
      new Float64Array(m.buffer, values, total).set(numbers);
      m.call("carom_world_write_joints", this.pointer, number, C.CAROM_SCALAR_F64, at, n, values, 0n);
    });
  },

  /** The tree of joints that a body belongs to. */
  tree(body) {
    return new Tree(this, body);
  },
};

class Tree {
  constructor(world, body) {
    Object.assign(this, { world, body });
  }

  /** How many coordinates it has. */
  get size() {
    const { module: m, pointer } = this.world,
      stride = BigInt(m.structs.size("carom_tree_coordinate"));
    return Number(
      m.u64(
        (count) => m.raw.carom_tree_get_coordinates(pointer, this.body.handle, 0, stride, 0n, count, m.error),
        "size",
      ),
    );
  }

  /** Forces that give these accelerations at the present pose, N or N m.   @param options  accelerations [size], 0 by
   *  default; speeds [size], by default those that it has */
  forces({ accelerations, speeds } = {}) {
    const { module: m, pointer } = this.world,
      n = this.size;
    return m.frame((room) => {
      const given = (values) => (values ? m.putDoubles(room, values, n, "forces()") : 0),
        out = room(8 * n);
      const before = [given(speeds), given(accelerations)];
      m.call("carom_tree_get_forces", pointer, this.body.handle, ...before, out, BigInt(n));
      return new Float64Array(m.buffer, out, n).slice();
    });
  }

  /** The mass matrix, row by row.   @returns Float64Array [size size] kg, kg m, kg m^2 */
  mass() {
    const { module: m, pointer } = this.world,
      n = this.size;
    return m.frame((room) => {
      const out = room(8 * n * n);
      m.call("carom_tree_get_mass", pointer, this.body.handle, out, BigInt(n));
      return new Float64Array(m.buffer, out, n * n).slice();
    });
  }
}
