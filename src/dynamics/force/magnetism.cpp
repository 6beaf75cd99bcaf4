// Magnetic moments in magnetic fields: T = m x B, with B the sum of the fields that reach the centre of mass. Where B changes
// from place to place a dipole feels the force grad(m . B), too: fields here are uniform within their boxes, so that only their
// faces would push, and nothing does.
#include "dynamics/force/force.h"

namespace carom::dynamics {
namespace {

/// T, world, at a body's centre.   @param x  m, world
Vec3 magnetic_field_at(const Scene& scene, std::uint32_t body, const Vec3& x) {
  Vec3 sum = Vec3::zero();
  scene.fields.each([&](const FieldDef& f) {
    if (f.kind == FieldKind::magnetic && f.mask & scene.field_mask_of(body)) sum += field_at(f, x);
  });
  return sum;
}

/// A m^2, body axes.
Vec3 moment_of(const Scene& scene, std::uint32_t body) {
  const auto number = [&](std::size_t k) { return scene.attributes.number<AttributeId::magnetic_moment>(body, k); };
  return Vec3(number(0), number(1), number(2));
}

}  // namespace

void magnetism::find(const Scene& scene, const State& state, Participants& participants) {
  std::uint32_t felt = 0;
  scene.fields.each([&](const FieldDef& f) { felt |= f.kind == FieldKind::magnetic ? f.mask : 0; });
  if (felt == 0) return;
  for (std::uint32_t i = 0; i < scene.attributes.bodies(AttributeId::magnetic_moment); ++i)
    if (responds(scene, state, i) && rotates(scene, i) && scene.field_mask_of(i) & felt &&
        moment_of(scene, i) != Vec3::zero())
      participants.add(i);
}

void magnetism::force(const Scene& scene, const State&, const Participants& participants, const Motion& at,
                      const Accelerate& out) {
  participants.each([&](std::uint32_t i) {
    const Vec3 torque = (at.q[i] * moment_of(scene, i)).cross(magnetic_field_at(scene, i, at.x[i]));
    out.omega[i] += out.scale * angular_acceleration(scene, i, at.q[i], torque);
  });
}

}  // namespace carom::dynamics
