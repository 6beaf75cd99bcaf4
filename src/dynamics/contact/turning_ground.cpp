#include "dynamics/contact/turning_ground.h"

#include <array>

#include "dynamics/contact/slide.h"
#include "dynamics/contact/surface.h"
#include "dynamics/solver/direct/cone_group_constants.h"

namespace carom::dynamics {
namespace {

/// (exp(h omega) - 1) x / h, m/s, without the difference.
Vec3 way_of(const Vec3& omega, const Vec3& x, Real h) {
  const Quat turn = exp_map(h * omega);
  const Vec3 u = turn.vec(), c = u.cross(x);
  return 2 / h * (turn.w() * c + u.cross(c));
}

/// m/s: mean velocity of a point, at first s, that a field of spin `omega` carries.
Vec3 bent(const Vec3& omega, const Vec3& s, Real h) {
  const Real w2 = omega.squared_norm();
  if (!(h * h * w2 > 1e-24)) return s;
  return (omega.dot(s) / w2) * omega + way_of(omega, s.cross(omega) / w2, h);
}

struct Belts {
  Surface a, b;
  Belts(const World& world, const Row& row, const RowGeometry& g) : Belts(world, row, world.pairs.place(g.pair).pair) {}
  Belts(const World& world, const Row& row, const Pair& pair) : a(world, pair.a, row.a), b(world, pair.b, row.b) {}
  bool any() const { return a.any() || b.any(); }
  bool turn() const { return a.angular != Vec3::zero() || b.angular != Vec3::zero(); }
};

/// Whether the ground of a pair turns in a step, as far as anybody may see.
bool turns(const World& world, const Row& row, Real dt) {
  const State& s = world.state;
  if (!row.moves_a) return s.omega[row.a] != Vec3::zero();
  if (!row.moves_b) return s.omega[row.b] != Vec3::zero();
  const Real a2 = s.omega[row.a].squared_norm() * dt * dt, b2 = s.omega[row.b].squared_norm() * dt * dt;
  return std::min(a2, b2) > kTurnsAlong * kTurnsAlong && std::max(a2, b2) < kBends * kBends;
}

}  // namespace

OwnShares::OwnShares(const Scene& scene, const Row& row) {
  const Real m_a = row.moves_a ? scene.inv_mass[row.a] : 0, m_b = row.moves_b ? scene.inv_mass[row.b] : 0;
  a = m_a + m_b > 0 ? m_b / (m_a + m_b) : 0, b = 1 - a;
}

Lead lead_of(const World& world, const TurningPair& pair, Real h) {
  const State& s = world.state;
  const Row& row = world.contacts->rows[pair.row];
  const Vec3 apart = s.x[row.b] - s.x[row.a], &w_a = s.omega[row.a], &w_b = s.omega[row.b];
  const OwnShares share(world.scene, row);
  Lead lead;
  lead.to.set_zero();
  lead.turn = lead.spin = share.a * w_a + share.b * w_b;
  if (share.a > 0) lead.to += share.a * way_of(w_a, apart, h);
  if (share.b > 0) lead.to += share.b * way_of(w_b, apart, h);
  if (!pair.has_belts) return lead;
  const Belts belts(world, row, world.contacts->geometry[pair.row]);
  lead.to -= pair.belt;
  lead.turn += belts.a.angular + belts.b.angular;
  if (belts.a.any()) lead.to += exp_map(h * w_a) * bent(belts.a.angular, belts.a.at(s.x[row.b]), h);
  if (belts.b.any()) lead.to -= exp_map(h * w_b) * bent(belts.b.angular, belts.b.at(s.x[row.a]), h);
  return lead;
}

void number_turning_pairs(Contacts& c) {
  for (std::uint32_t i = 0; i < c.turning_pairs.size(); ++i)
    for (std::uint32_t k = 0; k < c.turning_pairs[i].points; ++k)
      c.geometry[c.turning_pairs[i].row + k].turning_pairs = i + 1;
}

void find_turning_pairs(const World& world, const StepTime& time) {
  Contacts& c = *world.contacts;
  const State& s = world.state;
  c.turning_pairs.clear();
  for (const ContactPair& m : c.contact_pairs) {
    const Row& row = c.rows[m.row];
    if (!(row.friction > 0)) continue;
    const bool has_belts = !c.surface.empty() && Belts(world, row, c.geometry[m.row]).any();
    if (!turns(world, row, time.dt) && !(has_belts && Belts(world, row, c.geometry[m.row]).turn())) continue;
    TurningPair& t = c.turning_pairs.emplace_back(TurningPair{m.row, m.count});
    t.has_belts = has_belts;
    if (has_belts) {
      const Belts belts(world, row, c.geometry[m.row]);
      t.belt = belts.a.at(s.x[row.b]) - belts.b.at(s.x[row.a]);
    }
    if (m.count < 2) continue;  // it has no patch to slide
    // What went along in the substep before slides by nothing, though its velocity is that of the chord. A chord as good as its tangent
    // changes nothing.
    const Vec3 apart = s.x[row.b] - s.x[row.a];
    const Real turn2 = std::max(s.omega[row.a].squared_norm(), s.omega[row.b].squared_norm());
    const Real most2 = time.h * time.h / 4 * turn2 * turn2 * apart.squared_norm();  // (m/s)^2, of what is below
    if (!has_belts && most2 < 1e-4 * kCreeps * kCreeps) continue;
    if (c.surface.empty() && !may_slide(world, m.row, m.count, most2)) continue;
    const Vec3 lag = lead_of(world, t, -time.h).at(apart);
    std::array<Vec3, Manifold::kMaxPoints> slip;
    for (std::uint32_t k = 0; k < m.count; ++k) slip[k] = c.surface.empty() ? lag : Vec3(lag + c.surface[m.row + k]);
    find_slide(world, m.row, m.count, slip.data());
  }
  number_turning_pairs(c);
}

}  // namespace carom::dynamics
