// Particles: many points without shape, read in one call a set.
import * as C from "./constants.js";

/** Of all sets of particles of a world, one after the other.   @returns Float32Array [3n] m */
export function particlePositions(world) {
  const m = world.module;
  return m.frame((room) => {
    const count = room(8);
    m.call("carom_world_get_particles", world.pointer, 0, 0n, count);
    const n = Number(m.view.getBigUint64(count, true)),
      at = room(8 * n);
    if (n) m.call("carom_world_get_particles", world.pointer, at, BigInt(n), count);
    const parts = [];
    for (const set of Array.from(new BigUint64Array(m.buffer, at, n))) {
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
