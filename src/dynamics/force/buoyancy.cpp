// Buoyancy in a plane of water. Archimedes: what of a body is under water is pushed by the weight of the water that it
// displaces, at the centroid of that part, against the world's gravity; and water takes along what moves through it.
#include <algorithm>

#include "dynamics/force/floats.h"
#include "dynamics/force/force.h"

namespace carom::dynamics {
namespace {

/// m^3 and m (world) of what is under water of a body.
Submerged submerged(const Scene& scene, std::uint32_t body, const Vec3& x, const Quat& q) {
  const WaterDef& water = scene.water.def;
  const Colliders& c = scene.colliders;
  Submerged sum;
  for (std::uint32_t slot = scene.first_collider[body]; slot != kInvalid; slot = c.next[slot]) {
    const Shape& shape = *c.shape[slot];
    if (!floats(shape) || c.is_sensor(slot)) continue;
    const Pose local{c.local[slot].q, c.local[slot].p - scene.center[body]};
    const Quat turn = q * local.q;
    const Vec3 origin = x + q * local.p;
    // The plane in the shape's frame.
    const Vec3 n = turn.conjugate() * water.normal;
    const Real level = water.level - water.normal.dot(origin);
    if (level <= -shape.bounding_radius) continue;
    const std::uint32_t at = scene.water.float_of[slot];
    const Submerged part = under_plane(shape, at == kInvalid ? nullptr : &scene.water.floats[at], n, level);
    sum.volume += part.volume;
    sum.moment += part.volume * origin + turn * part.moment;
  }
  return sum;
}

}  // namespace

void buoyancy::find(const Scene& scene, const State& state, Participants& participants) {
  if (!scene.water.on) return;
  const Colliders& c = scene.colliders;
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i) {
    if (!responds(scene, state, i)) continue;
    for (std::uint32_t slot = scene.first_collider[i]; slot != kInvalid; slot = c.next[slot])
      if (floats(*c.shape[slot]) && !c.is_sensor(slot)) {
        participants.add(i);
        break;
      }
  }
}

bool buoyancy::wakes(const Scene& scene, const State& state, std::uint32_t i) {
  const WaterDef& water = scene.water.def;
  const Colliders& c = scene.colliders;
  Real radius = 0;
  for (std::uint32_t slot = scene.first_collider[i]; slot != kInvalid; slot = c.next[slot])
    radius = std::max(radius, (c.local[slot].p - scene.center[i]).norm() + c.shape[slot]->bounding_radius);
  // It may dip in within the step; a speed of its radius per millisecond would be needed to do so from farther away.
  return water.normal.dot(state.x[i]) - 2 * radius < water.level;
}

void buoyancy::force(const Scene& scene, const State& state, const Participants& participants, const Motion& at,
                     const Accelerate& out) {
  const Water& water = scene.water;
  participants.each([&](std::uint32_t i) {
    const bool turns = rotates(scene, i);
    const Submerged under = submerged(scene, i, at.x[i], turns ? at.q[i] : state.q[i]);
    if (!(under.volume > 0)) return;
    const Vec3 arm = under.moment / under.volume - at.x[i];
    const Real displaced = water.def.density * under.volume;  // kg
    Vec3 force = -displaced * scene.gravity;
    if (water.def.drag > 0) {
      const Real rate = std::min(water.def.drag * displaced * scene.inv_mass[i], water.most_rate);  // 1/s
      const Vec3 spin = turns ? Vec3(at.omega[i].cross(arm)) : Vec3(Vec3::zero());
      force -= rate * scene.mass[i] * (at.v[i] + spin - water.def.current);
      if (turns) out.omega[i] -= out.scale * rate * at.omega[i];
    }
    out.v[i] += out.scale * scene.inv_mass[i] * force;
    if (turns) out.omega[i] += out.scale * angular_acceleration(scene, i, at.q[i], arm.cross(force));
  });
}

}  // namespace carom::dynamics
