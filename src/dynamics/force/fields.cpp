// Fields of acceleration or force: uniform in a box, radial, vortex. They act at centres of mass.
#include "dynamics/force/force.h"

namespace carom::dynamics {
namespace {

/// (reference / distance)^falloff
Real strength_at(const FieldDef& f, Real distance) {
  const Real ratio = f.falloff < 0 ? distance / f.reference : f.reference / distance;
  Real power = 1;
  for (int n = std::abs(f.falloff); n > 0; --n) power *= ratio;
  return power;
}

Vec3 uniform_at(const FieldDef& f, const Vec3& x) {
  if (f.half == Vec3::constant(kInfinity)) return f.vector;
  const Vec3 local = f.pose.q.conjugate() * (x - f.pose.p);
  return (local.abs() - f.half).max_entry() <= 0 ? f.vector : Vec3(Vec3::zero());
}

Vec3 radial_at(const FieldDef& f, const Vec3& x) {
  const Vec3 d = x - f.pose.p;
  const Real d2 = d.squared_norm(), s = std::sqrt(d2 + f.core * f.core);
  if (d2 > f.reach * f.reach || !(s > 0)) return Vec3::zero();
  return f.strength * strength_at(f, s) / s * d;
}

Vec3 vortex_at(const FieldDef& f, const Vec3& x) {
  const Vec3 d = f.pose.q.conjugate() * (x - f.pose.p);
  const Real d2 = d.x() * d.x() + d.z() * d.z(), s = std::sqrt(d2 + f.core * f.core);
  if (d2 > f.reach * f.reach || std::fabs(d.y()) > f.half.y() || !(s > 0)) return Vec3::zero();
  const Vec3 around(d.z(), 0, -d.x()), outward(d.x(), 0, d.z());
  const Vec3 local = (f.strength * around - f.pull * outward) / s + f.lift * Vec3::unit_y();
  return strength_at(f, s) * (f.pose.q * local);
}

}  // namespace

void fields::find(const Scene& scene, const State& state, Participants& participants) {
  const Fields& all = scene.fields;
  if (all.slots.alive_count() == 0) return;
  std::uint32_t felt = 0;
  all.each([&](const FieldDef& f) { felt |= pushes(f.kind) ? f.mask : 0; });
  for (std::uint32_t i = 0; i < scene.bodies.slots(); ++i)
    if (responds(scene, state, i) && scene.field_mask_of(i) & felt) participants.add(i);
}

Vec3 field_at(const FieldDef& field, const Vec3& x) {
  if (field.kind == FieldKind::radial) return radial_at(field, x);
  return field.kind == FieldKind::vortex ? vortex_at(field, x) : uniform_at(field, x);
}

void fields::force(const Scene& scene, const State&, const Participants& participants, const Motion& at,
                   const Accelerate& out) {
  scene.fields.each([&](const FieldDef& f) {
    if (!pushes(f.kind)) return;
    participants.each([&](std::uint32_t i) {
      if (!(scene.field_mask_of(i) & f.mask)) return;
      out.v[i] += out.scale * (f.is_force ? scene.inv_mass[i] : 1) * field_at(f, at.x[i]);
    });
  });
}

}  // namespace carom::dynamics
