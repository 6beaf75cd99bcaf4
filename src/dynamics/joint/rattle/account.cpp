// Accounts of islands that joints alone hold, a step at once.
#include "dynamics/joint/rattle/rattle.h"
#include "dynamics/ledger/accounts.h"

namespace carom::dynamics::rattle {

/// Forces give what their kicks do at the mean of the velocities and poses of both ends of the step, gravity the work
/// along the way, drives likewise; the rest of the change is the joints': what they do to a body, and by how much a step errs.
void account(const World& world, const Rattle& r) {
  Ledger& l = ledger_of(world);
  const State& s = world.state;
  each_held(r, [&](const RattleIsland& island) {
    for (std::uint32_t i = island.body; i < island.body + island.movers; ++i) {
      const std::uint32_t slot = r.bodies[i].slot;
      const Ledger::Body b = l.body[slot];
      const Real m = world.scene.mass[slot];
      const Vec3 v = 0.5 * (b.v + s.v[slot]), omega = 0.5 * (b.omega + s.omega[slot]), x = 0.5 * (b.x + s.x[slot]);
      Mat3 inertia = Mat3::zero();
      if (r.bodies[i].turns)
        inertia = 0.5 * (inertia_at(world.scene, slot, b.q) + inertia_at(world.scene, slot, s.q[slot]));
      Amount rest = amount_now(world, slot) - amount_of(world, slot, b.x, b.q, b.v, b.omega);
      Real speed = b.v.norm() + s.v[slot].norm(), spin = b.omega.norm() + s.omega[slot].norm();
      const auto give = [&](std::size_t cause, const Amount& a) { l.step[cause].add(a), rest = rest - a; };
      const auto kicks = l.kicks_of(slot);
      for (std::size_t c = Ledger::kFixedColumns; c < l.columns; ++c) {
        const Vec3 p = m * kicks[c].v, spun = inertia * kicks[c].omega;
        if (l.cause_of[c] == l.gravity)
          give(l.gravity, {0, 0, p, x.cross(p)});
        else
          give(l.cause_of[c], {p.dot(v) + spun.dot(omega), 0, p, x.cross(p) + spun});
        speed += kicks[c].v.norm(), spin += kicks[c].omega.norm();
      }
      const Real work = m * pull_on(world, slot).dot(s.x[slot] - b.x);
      give(l.gravity, {work, -work, Vec3::zero(), Vec3::zero()});
      const Vec3 &p = r.bodies[i].driven_p, &spun = r.bodies[i].driven_l;
      if (!p.is_zero() || !spun.is_zero()) {
        const Amount driven = {p.dot(v) + spun.dot(omega), 0, p, x.cross(p) + spun};
        l.account(Cause::drives, driven), rest = rest - driven;
      }
      l.account(Cause::joints, rest);
      may_round(world, slot, speed, spin);
      clear_kicks(l, slot);
      open_phase(world, slot);
    }
  });
}

}  // namespace carom::dynamics::rattle
