// Contacts as the last step left them in their rows; joints and energy from the state.
#include "dynamics/residuals.h"

#include <algorithm>

#include "dynamics/contact/contact.h"
#include "dynamics/contact_views.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/ledger/accounts.h"

namespace carom::dynamics {
namespace {

/// 1/kg, what a unit impulse along n changes of the velocity along n at an arm.
Real give(const World& world, bool moves, std::uint32_t body, const Vec3& arm, const Vec3& n) {
  if (!moves) return 0;
  const Vec3 turn = arm.cross(n);
  return world.scene.inv_mass[body] + turn.dot(world.contacts->inv_inertia_w[body] * turn);
}

/// A pair's points: its normal impulses one by one, its friction as one.
void judge_pair(const World& world, const ContactPair& m, Residuals& r) {
  const Contacts& c = *world.contacts;
  Vec3 friction = Vec3::zero(), slip = Vec3::zero();
  Real load = 0, k_pair = 0, mu = 0;
  for (std::uint32_t i = m.row; i < m.row + m.count; ++i) {
    const Row& row = c.rows[i];
    const RowGeometry& g = c.geometry[i];
    const Real k = give(world, row.moves_a, row.a, arm_a(world, row, g), row.n) +
                   give(world, row.moves_b, row.b, arm_b(world, row, g), row.n);
    if (!(k > 0)) continue;
    const Real p = row.p.dot(row.n), u_n = row.u.dot(row.n);
    // What is still open may close in the next substep.
    const Real closing = world.impulses.old_h > 0 ? u_n + std::max(g.separation, Real(0)) / world.impulses.old_h : u_n;
    const bool bounces = row.restitution > 0 && u_n > 0;
    if (!bounces)
      r.complementarity = std::max(r.complementarity, k * std::fabs(p - std::max(p - closing / k, Real(0))));
    load += p;
    friction += row.p - p * row.n;
    Vec3 u = row.u;
    if (!c.surface.empty()) u += c.surface[i];
    slip += (u - u.dot(row.n) * row.n) / static_cast<Real>(m.count);
    k_pair += k / static_cast<Real>(m.count);
    mu = row.friction;
  }
  if (!(load > 0 && k_pair > 0)) return;
  const Real most = mu * load, rub = friction.norm();
  r.cone = std::max(r.cone, k_pair * (rub - most));
  Vec3 aim = friction - slip / k_pair;
  if (const Real length = aim.norm(); length > most) aim *= most / length;
  r.slip = std::max(r.slip, k_pair * (friction - aim).norm() - k_pair * std::max(rub - most, Real(0)));
}

void judge_contacts(const World& world, Residuals& r) {
  const Contacts& c = *world.contacts;
  if (world.contact_views().empty()) return;  // nothing touched in the last step, whatever rows an older one left
  Real sum = 0;
  std::uint64_t overlapping = 0;
  r.points = c.rows.size();
  for (const RowGeometry& g : c.geometry) {
    if (!(g.separation < 0)) continue;
    r.max_penetration = std::max(r.max_penetration, -g.separation);
    sum -= g.separation;
    ++overlapping;
  }
  if (overlapping) r.mean_penetration = sum / static_cast<Real>(overlapping);
  for (const ContactPair& m : c.contact_pairs) judge_pair(world, m, r);
}

void judge_joints(const World& world, Residuals& r) {
  for (const std::uint32_t slot : world.wide_joints->active) {
    if (!world.joints.alive(slot) || world.joints.joint[slot].broken) continue;
    const JointPlace place = place_of(world, world.joints.joint[slot]);
    ++r.joints;
    r.joint_gap = std::max(r.joint_gap, place.gap);
    r.joint_angle = std::max(r.joint_angle, place.angle);
  }
}

void measure_energy(const World& world, Residuals& r) {
  Sum<Real> energy{0};
  for (std::uint32_t i = 0; i < world.scene.bodies.slots(); ++i)
    if (is_dynamic(world, i) && !is_lost(world, i)) energy.add(amount_now(world, i).energy());
  if (!world.scene.modes.forbids(+EffectId::gravity))
    for (const ParticleSet& set : world.particles.set)
      for (std::size_t i = 0; i < set.size(); ++i)
        if (!set.is_held(i))
          energy.add(-set.mass_of(i) * set.def.gravity_factor * world.scene.gravity.dot(set.position(i)));
  r.energy = energy.value() + world.particles.linear_energy();
}

}  // namespace

Residuals residuals_of(const World& world) {
  Residuals r;
  judge_contacts(world, r);
  judge_joints(world, r);
  measure_energy(world, r);
  if (world.ledger)
    for (const Cause cause : {Cause::integrator, Cause::unassigned})
      r.energy_drift += world.ledger->step[index_of(cause)].value().energy();
  return r;
}

}  // namespace carom::dynamics
