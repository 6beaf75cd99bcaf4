// Particles: many points without shape, read in one call a set.
import * as C from "./constants.js";

/** Of all sets of particles of a world, one after the other.   @returns Float32Array [3n] m */
export function particlePositions(world) {
  const m = world.module;
  return m.frame((room) => {
    const count = room(8);
    const parts = [];
    for (const set of m.handles("carom_world_get_particles", world.pointer)) {
      m.call("carom_particles_get_count", world.pointer, set, count);
      const k = Number(m.view.getBigUint64(count, true)),
        to = room(12 * k);
      if (k)
        m.call(
          "carom_particles_read",
          world.pointer,
          set,
          C.CAROM_FIELD_POSITION,
          C.CAROM_SCALAR_F32,
          0,
          BigInt(k),
          to,
          0n,
        );
      parts.push(new Float32Array(m.buffer, to, 3 * k).slice());
    }
    const all = new Float32Array(parts.reduce((sum, p) => sum + p.length, 0));
    let end = 0;
    for (const part of parts) (all.set(part, end), (end += part.length));
    return all;
  });
}
