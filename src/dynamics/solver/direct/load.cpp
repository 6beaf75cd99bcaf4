#include "dynamics/solver/direct/load.h"

#include <algorithm>

#include "dynamics/contact/held_arms.h"
#include "dynamics/contact/slide.h"
#include "dynamics/force/force.h"
#include "dynamics/solver/pair_points.h"
#include "dynamics/solver/sweep_constants.h"

namespace carom::dynamics {
namespace {

/// What a body's point does that impulses do not change: all of it where they move no body, its spin where they don't
/// turn the body.
struct GivenMotion {
  bool turns;
  Vec3 v = Vec3::zero(), omega = Vec3::zero();  // m/s, rad/s

  GivenMotion(const World& world, const ConeBody* bodies, std::uint32_t body, std::uint32_t slot)
      : turns(body != kInvalid && bodies[body].turns) {
    if (body == kInvalid) v = world.state.v[slot];
    if (!turns) omega = world.state.omega[slot];
  }
  bool any() const { return !turns && (v != Vec3::zero() || omega != Vec3::zero()); }
  Vec3 at(const Vec3& r) const { return v + omega.cross(r); }
};

bool is_curved(const Shape& s) {
  return s.form != Form::box && s.form != Form::polytope && s.form != Form::half_space && !is_scenery(s);
}

/// Whether one of two that touch is not known to be a polytope, nor to roll on a ball (rolling.h).
bool is_curved(const World& world, const RowGeometry& g) {
  const Pair& pair = world.pairs.place(g.pair).pair;
  const Array<const Shape*>& shape = world.scene.colliders.shape;
  const auto turns_away = [](const Shape& s, Real radius) { return is_curved(s) && radius == s.core_radius; };
  return turns_away(*shape[pair.a], g.radius_a) || turns_away(*shape[pair.b], g.radius_b);
}

/// rad/s, what surfaces of a pair turn of themselves.
Vec3 surface_spin(const Contacts& c, std::uint32_t row) {
  const auto it = std::lower_bound(c.driven.begin(), c.driven.end(), row,
                                   [](const Driven& d, std::uint32_t r) { return d.row < r; });
  return it != c.driven.end() && it->row == row ? it->spin : Vec3(Vec3::zero());
}

/// Whether a pair's patch does, by its first row. What rolls slips at points in the air alone.
bool slides(const Row& first) { return first.slides && !first.rolls; }

/// Weights of a pair's points in the middle where its friction acts: of what slides their loads, if they will stay. Else
/// all that are as near as the nearest, to kTouching of their distance, alike: what hangs in the air, as under a cylinder
/// that rolls, has no part in it, and what sticks keeps one place, whatever its loads do.
void find_weights(const Contacts& c, const PairRows& pair, const Vec3* r, Real* weight) {
  Real load[kPairPoints], whole = 0, least = kInfinity, width2 = 0, sum = 0;
  for (std::uint32_t k = 0; k < pair.count; ++k) {
    whole += load[k] = std::max(Real(0), c.rows[pair.row + k].p.dot(c.rows[pair.row + k].n));
    least = std::min(least, c.geometry[pair.row + k].separation);
    width2 = std::max(width2, (r[k] - r[0]).squared_norm());
  }
  const bool by_load = whole > 0 && c.rows[pair.row].slides_by_load;
  const Real near = kTouching * std::sqrt(width2);
  for (std::uint32_t k = 0; k < pair.count; ++k) {
    weight[k] = by_load ? load[k] : c.geometry[pair.row + k].separation - least <= near ? 1 : 0;
    sum += weight[k];
  }
  for (std::uint32_t k = 0; k < pair.count; ++k) weight[k] /= sum;
}

/// How far from the middle a patch presses, in the mean: of what slides by its loads.
/// @param apart  m, how far points are from it, by weights
Real reach_of(const Contacts& c, const PairRows& pair, std::span<const ContactPlace> places, Real apart) {
  if (!slides(c.rows[pair.row])) return apart;
  Real moment = 0, whole = 0;
  for (std::uint32_t k = 0; k < pair.count; ++k) {
    const Real load = std::max(Real(0), c.rows[pair.row + k].p.dot(c.rows[pair.row + k].n));
    moment += load * places[k].d.norm(), whole += load;
  }
  return c.rows[pair.row].twist_share * (whole > 0 && moment > 0 ? moment / whole : apart);
}

/// 1/kg, mean velocity of a patch per impulse on it.
Real response_of(const ConePatch& c, const ConeBody* bodies) {
  Real sum = 0;
  const Vec3 t = any_perpendicular(c.n).normalized(), s = c.n.cross(t);
  const auto add = [&](std::uint32_t body, const Vec3& r, const Vec3& w) {
    if (body == kInvalid) return;
    const ConeBody& b = bodies[body];
    for (const Vec3& axis : {t, s}) {
      const Vec3 turn = r.cross(axis);
      sum += b.inv_mass + turn.dot(b.inv_inertia * turn);
    }
    sum += w.dot(b.inv_inertia * w);
  };
  add(c.a, c.r_a, c.w_a), add(c.b, c.r_b, c.w_b);
  return sum / (c.reach > 0 ? 3 : 2);
}

}  // namespace

void load_mass(const World& world, ConeBody& b) {
  b.mass = world.scene.mass[b.slot], b.inv_mass = world.scene.inv_mass[b.slot];
  b.locks = world.scene.locks_of(b.slot);
  b.turns = rotates(world.scene, b.slot);
  if (!b.turns) return void((b.inertia.set_identity(), b.inv_inertia.set_zero(), b.held_back.set_zero()));
  const Mat3& r = world.plan->rotation[b.slot];
  b.held_back = held_back(world, b.slot);
  b.inertia = r * world.scene.inertia[b.slot] * r.transpose();
  b.inv_inertia = b.locks & kAngularLocks ? inverse_of_free(b.inertia, b.locks)
                                          : Mat3(r * world.scene.inv_inertia[b.slot] * r.transpose());
}

void load_contacts(const World& world, std::span<const std::uint32_t> rows, const ConeProblem& problem, LoadWhat what) {
  const Contacts& c = *world.contacts;
  const ConeBody* const bodies = problem.bodies;
  const auto sources = [&](const PairRows& pair, PointSources& of) {
    const ConeRow& contact = problem.contacts[pair.at];
    if (what == LoadWhat::not_curved && problem.places[pair.at].is_curved) return false;
    of = point_sources(world, pair);
    const bool rolls = c.rows[pair.row].rolls;  // whose arms are those of the moment
    const auto put = [&](std::uint32_t body, const double*& held, const double*& inv_inertia, double& inv_mass) {
      held = body != kInvalid && !rolls ? bodies[body].held_back.data() : kNoMatrix;
      inv_inertia = body != kInvalid ? bodies[body].inv_inertia.data() : kNoMatrix;
      inv_mass = body != kInvalid ? bodies[body].inv_mass : 0;
    };
    put(contact.a, of.held_a, of.inv_inertia_a, of.inv_mass_a);
    put(contact.b, of.held_b, of.inv_inertia_b, of.inv_mass_b);
    return true;
  };
  each_pair(c, rows, sources, world.wide->kernels->points.place, [&](const PairRows& pair, const PointPlaces& at) {
    const Row& first = c.rows[pair.row];
    const ConeRow& of = problem.contacts[pair.at];
    const GivenMotion given_a(world, bodies, of.a, first.a), given_b(world, bodies, of.b, first.b);
    const bool is_given = given_a.any() || given_b.any() || !c.surface.empty();
    const bool curved = what == LoadWhat::all && is_curved(world, c.geometry[pair.row]);
    Vec3 r_a[kPairPoints], r_b[kPairPoints];
    Real weight[kPairPoints];
    for (std::uint32_t k = 0; k < pair.count; ++k) {
      r_a[k] = Vec3(at.r_a.x[k], at.r_a.y[k], at.r_a.z[k]);
      r_b[k] = Vec3(at.r_b.x[k], at.r_b.y[k], at.r_b.z[k]);
    }
    find_weights(c, pair, r_b, weight);
    const auto surface_at = [&](std::uint32_t k) {
      const Vec3 surface = given_b.at(r_b[k]) - given_a.at(r_a[k]);
      return c.surface.empty() ? surface : Vec3(surface + c.surface[pair.row + k]);
    };
    for (std::uint32_t k = 0; k < pair.count; ++k) {
      ConeRow& row = problem.contacts[pair.at + k];
      ContactPlace& place = problem.places[pair.at + k];
      const Vec3& n = c.rows[pair.row + k].n;
      place.is_curved = curved;
      place.n = n;
      place.r_a = given_a.turns ? r_a[k] : Vec3::zero();
      place.r_b = given_b.turns ? r_b[k] : Vec3::zero();
      place.apart = r_a[k] - r_b[k];
      place.response = at.response[k];
      place.curve = 0;
      row.d_a = row.d_b = n;
      row.w_a = place.r_a.cross(n), row.w_b = place.r_b.cross(n);
      row.k = 0;
      for (const auto& [body, turn] : {std::pair(row.a, row.w_a), std::pair(row.b, row.w_b)})
        if (body != kInvalid) row.k += bodies[body].inv_mass + turn.dot(bodies[body].inv_inertia * turn);
      row.give = 0, row.high = row.most = kInfinity, row.bends = false;
      row.surface = is_given ? surface_at(k).dot(n) : 0;
    }
    const bool alone = problem.patches[problem.places[pair.at].patch].count == 1;
    for (std::uint32_t k = 0; k < pair.count; k += alone ? 1 : pair.count) {
      ConePatch& patch = problem.patches[problem.places[pair.at + k].patch];
      const std::span<ContactPlace> places = problem.places.subspan(pair.at + k, patch.count);
      Vec3 middle_a = Vec3::zero(), middle_b = Vec3::zero(), surface = Vec3::zero();
      for (std::uint32_t i = 0; i < patch.count; ++i) {
        const Real share = places[i].weight = alone ? 1 : weight[i];
        middle_a += share * r_a[k + i], middle_b += share * r_b[k + i];
        if (is_given) surface += share * surface_at(k + i);
      }
      for (std::uint32_t i = 0; i < patch.count; ++i) places[i].d = r_b[k + i] - middle_b;
      patch.n = c.rows[pair.row + k].n;
      patch.is_curved = curved;
      patch.slides = slides(first), patch.bears_all = first.slides_by_load;
      constexpr Real kNoReach = 1e-9;  // of the arms: points that are one but for rounding bear no twist
      Real apart = 0;
      for (const ContactPlace& place : places) apart += place.weight * place.d.norm();
      patch.reach = apart > kNoReach * (middle_a.norm() + middle_b.norm()) ? reach_of(c, pair, places, apart) : 0;
      patch.r_a = given_a.turns ? middle_a : Vec3::zero();
      patch.r_b = given_b.turns ? middle_b : Vec3::zero();
      patch.w_a = given_a.turns ? Vec3(patch.reach * patch.n) : Vec3::zero();
      patch.w_b = given_b.turns ? Vec3(patch.reach * patch.n) : Vec3::zero();
      const Real spin = is_given ? (surface_spin(c, pair.row) + given_b.omega - given_a.omega).dot(patch.n) : 0;
      patch.surface = surface + (patch.reach * spin - surface.dot(patch.n)) * patch.n;
      patch.curve.set_zero();
      patch.k = response_of(patch, bodies);
      patch.give = 0;
    }
  });
}

void load_groups(const World& world, SolverMemory& memory, DirectGroups& d) {
  constexpr std::size_t kGroupsAPart = 4;
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) {
    const DirectGroups::Begin &from = d.begin[g], &to = d.begin[g + 1];
    for (ConeBody& b : std::span(d.bodies.data() + from.body, to.body - from.body)) {
      hold_orientation(world, memory, b.slot);
      load_mass(world, b);
      b.v = {world.state.v[b.slot], world.state.omega[b.slot]};
    }
    load_contacts(world, {d.row.data() + from.contact, to.contact - from.contact}, d.problem(g), LoadWhat::all);
  });
}

}  // namespace carom::dynamics
