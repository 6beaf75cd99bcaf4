// Moments of contacts that resist rolling or spinning.
#include "dynamics/contact/resistance.h"

#include <algorithm>

#include "dynamics/body_state.h"
#include "dynamics/solver/table.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

/// N s: what a pair's points press in all, in this step so far; of solvers in lanes, in this substep.
Real normal_sum(const World& world, const Resistance& r) {
  const Contacts& c = *world.contacts;
  Real sum = 0;
  if (world.plan->solver->in_lanes && c.solved_in_lanes(r.row)) {
    const WideContacts::Manifold& m = world.wide->manifold_of(r.row);
    with_lanes(*world.wide, [&](const auto& lanes, const auto&) {
      const auto& pair = lanes.pairs[m.pair];
      for (std::uint32_t k = 0; k < m.points; ++k) sum += lanes.points[pair.first + k].p_n[m.lane];
    });
    return sum;
  }
  for (std::uint32_t i = r.row; i < r.row + r.points; ++i) sum += c.geometry[i].impulse.dot(c.rows[i].n);
  return sum - r.normal_sum;
}

/// Whether a moment turns a body.
bool turns(const World& world, bool moves, std::uint32_t body) {
  return moves && rotates(world.scene, body) && !world.state.held_out[body];
}

void twist(const World& world, Velocities& to, const Row& row, const Vec3& moment) {
  const Contacts& c = *world.contacts;
  if (turns(world, row.moves_a, row.a)) to.omega[row.a] -= c.inv_inertia_w[row.a] * moment;
  if (turns(world, row.moves_b, row.b)) to.omega[row.b] += c.inv_inertia_w[row.b] * moment;
}

}  // namespace

void find_resistance(const World& world, const StepTime& time) {
  Contacts& c = *world.contacts;
  const Real scale = start_scale(world, time.h);
  c.resisting.clear();
  std::uint64_t rolling = 0, spinning = 0;
  for (std::uint32_t i = 0, next; world.scene.resists && i < c.rows.size(); i = next) {
    next = c.first_row[c.geometry[i].pair + 1];
    const Pair& pair = world.pairs.place(c.geometry[i].pair).pair;
    const MixedMaterial m = mixed(world.scene, pair.a, pair.b);
    Resistance r{i, next - i, m.rolling, m.spinning, Vec3::zero(), 0};
    if (!(r.rolling > 0 || r.spinning > 0)) continue;
    rolling += r.rolling > 0, spinning += r.spinning > 0;
    const auto before = [](const OldImpulse& old, const Pair& p) { return old.pair < p; };
    if (scale > 0)
      for (auto old = std::lower_bound(world.impulses.old.begin(), world.impulses.old.end(), pair, before);
           old != world.impulses.old.end() && old->pair == pair; ++old)
        r.moment += scale * old->moment;
    c.resisting.push_back(r);
  }
  count_participants(world, EffectId::rolling_resistance, rolling);
  count_participants(world, EffectId::spinning_resistance, spinning);
}

void hold_moments(const World& world, Velocities& to, const StepTime&) {
  Contacts& c = *world.contacts;
  if (c.resisting.empty()) return;
  refresh_rotations(world);
  refresh_inertias(world);
  for (Resistance& r : c.resisting) {
    twist(world, to, c.rows[r.row], r.moment);
    r.normal_sum = 0;
    r.normal_sum = normal_sum(world, r);
  }
}

void resist(const World& world, Velocities& to, const StepTime&) {
  Contacts& c = *world.contacts;
  const State& s = world.state;
  const Driven* driven = c.driven.data();
  for (Resistance& r : c.resisting) {
    const Row& row = c.rows[r.row];
    Mat3 k = Mat3::zero();
    if (turns(world, row.moves_a, row.a)) k += c.inv_inertia_w[row.a];
    if (turns(world, row.moves_b, row.b)) k += c.inv_inertia_w[row.b];
    const Real load = std::max(Real(0), normal_sum(world, r));
    Vec3 spin = s.omega[row.b] - s.omega[row.a];
    while (driven < c.driven.data() + c.driven.size() && driven->row < r.row) ++driven;
    if (driven < c.driven.data() + c.driven.size() && driven->row == r.row) spin += driven->spin;
    const Vec3 next = resisting_moment(r.moment, spin, k, row.n, r.rolling * load, r.spinning * load);
    twist(world, to, row, next - r.moment);
    r.moment = next;
  }
}

Vec3 resisting_moment(const Vec3& moment, const Vec3& omega, const Mat3& k, const Vec3& n, Real rolling,
                      Real spinning) {
  constexpr Real kRounding = 1e-12;  // of a response that locks leave
  const Real k_n = n.dot(k * n);
  if (!(k.trace() > 0)) return Vec3::zero();
  const Real had = moment.dot(n);
  const Real spin = k_n > kRounding * k.trace() ? std::clamp(had - omega.dot(n) / k_n, -spinning, spinning) : 0;
  const Vec3 left = omega + (spin - had) * (k * n);
  const Vec3 t = any_perpendicular(n).normalized(), s = n.cross(t);
  const Vec3 k_t = k * t, k_s = k * s;
  const Real tt = t.dot(k_t), ts = t.dot(k_s), ss = s.dot(k_s), det = tt * ss - ts * ts;
  const Real o_t = left.dot(t), o_s = left.dot(s);
  Real roll_t = moment.dot(t), roll_s = moment.dot(s);
  if (const Real trace = tt + ss; det > kRounding * trace * trace)
    roll_t -= (ss * o_t - ts * o_s) / det, roll_s -= (tt * o_s - ts * o_t) / det;
  else if (trace > kRounding * k.trace())  // turns about one axis of the plane alone
    roll_t -= (tt * o_t + ts * o_s) / (trace * trace), roll_s -= (ts * o_t + ss * o_s) / (trace * trace);
  else
    roll_t = roll_s = 0;
  const Real size = std::sqrt(roll_t * roll_t + roll_s * roll_s);
  if (size > rolling) roll_t *= rolling / size, roll_s *= rolling / size;
  return spin * n + roll_t * t + roll_s * s;
}

}  // namespace carom::dynamics
