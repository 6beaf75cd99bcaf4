#include "dynamics/solver/direct/load.h"

#include <algorithm>

#include "dynamics/contact/held_arms.h"
#include "dynamics/contact/slide.h"
#include "dynamics/force/force.h"
#include "dynamics/solver/direct/unchanged.h"
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

/// Whether one of two that touch is not known to be a polytope, nor to roll on a ball (rolling.h).
bool is_curved(const World& world, const RowGeometry& g) {
  const Pair& pair = world.pairs.place(g.pair).pair;
  const Array<const Shape*>& shape = world.scene.colliders.shape;
  const auto turns_away = [](const Shape& s, Real radius) { return is_curved(s) && radius == s.core_radius; };
  return turns_away(*shape[pair.a], g.radius_a) || turns_away(*shape[pair.b], g.radius_b);
}

/// Whether all points of a pair are as near as the nearest, to kTouching of their distance. What has some in the air is
/// no patch: it tips, rolls or parts.
bool lies_flat(const Contacts& c, const PairRows& pair, const Vec3* r) {
  Real least = kInfinity, most = -kInfinity, width2 = 0;
  for (std::uint32_t k = 0; k < pair.count; ++k) {
    const Real gap = c.geometry[pair.row + k].separation;
    least = std::min(least, gap), most = std::max(most, gap);
    width2 = std::max(width2, (r[k] - r[0]).squared_norm());
  }
  return most - least <= kTouching * std::sqrt(width2);
}

/// rad/s, what surfaces of a pair turn of themselves.
Vec3 surface_spin(const Contacts& c, std::uint32_t row) {
  const auto it = std::lower_bound(c.driven.begin(), c.driven.end(), row,
                                   [](const Driven& d, std::uint32_t r) { return d.row < r; });
  return it != c.driven.end() && it->row == row ? it->spin : Vec3(Vec3::zero());
}

/// Let friction of a patch that slides act where its loads do: of each point nearer to their middle, or where they are
/// not known to that of the points. Of what sticks it acts at the points.
/// @param contacts  of the pair, which act at its points so far   @param r  m, from B's centre of mass
void spread(const Contacts& c, const PairRows& pair, const GivenMotion& a, const GivenMotion& b, const Vec3* r,
            ConeContact* contacts) {
  const Row* const rows = &c.rows[pair.row];
  if (!rows->one_normal || !lies_flat(c, pair, r)) return;
  Real load[kPairPoints], whole = 0;
  for (std::uint32_t k = 0; k < pair.count; ++k) whole += load[k] = std::max(Real(0), rows[k].p.dot(rows->n));
  if (!(whole > 0)) return;
  const Vec3 spin = surface_spin(c, pair.row) + b.omega - a.omega;
  Vec3 middle = Vec3::zero();
  for (std::uint32_t k = 0; k < pair.count; ++k)
    middle += (rows->loads_known ? load[k] / whole : Real(1) / pair.count) * r[k];
  for (std::uint32_t k = 0; k < pair.count; ++k) {
    ConeContact& contact = contacts[k];
    const Vec3 apart = (1 - rows->twist_share) * (r[k] - middle), moment = apart.cross(contact.n),
               turned = spin.cross(apart);
    if (a.turns) contact.r_a -= apart;
    if (b.turns) contact.r_b -= apart;
    contact.n_a = a.turns ? moment : Vec3::zero();
    contact.n_b = b.turns ? moment : Vec3::zero();
    contact.surface -= turned - turned.dot(contact.n) * contact.n;
    contact.is_spread = true;
  }
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

void load_contacts(const World& world, std::span<const std::uint32_t> rows, const ConeBody* bodies,
                   ConeContact* contacts, LoadWhat what) {
  const Contacts& c = *world.contacts;
  const auto sources = [&](const PairRows& pair, PointSources& of) {
    const ConeContact& contact = contacts[pair.at];
    if (what == LoadWhat::not_curved && contact.is_curved) return false;
    of = point_sources(world, pair);
    const bool is_of_now = c.rows[pair.row].rolls || c.geometry[pair.row].is_asked_again;
    const auto put = [&](std::uint32_t body, const double*& held, const double*& inv_inertia, double& inv_mass) {
      held = body != kInvalid && !is_of_now ? bodies[body].held_back.data() : kNoMatrix;
      inv_inertia = body != kInvalid ? bodies[body].inv_inertia.data() : kNoMatrix;
      inv_mass = body != kInvalid ? bodies[body].inv_mass : 0;
    };
    put(contact.a, of.held_a, of.inv_inertia_a, of.inv_mass_a);
    put(contact.b, of.held_b, of.inv_inertia_b, of.inv_mass_b);
    return true;
  };
  each_pair(c, rows, sources, world.wide->kernels->points.place, [&](const PairRows& pair, const PointPlaces& places) {
    const Row& first = c.rows[pair.row];
    const ConeContact& of = contacts[pair.at];
    const GivenMotion given_a(world, bodies, of.a, first.a), given_b(world, bodies, of.b, first.b);
    const bool is_given = given_a.any() || given_b.any();
    const bool curved =
        what == LoadWhat::all && !c.geometry[pair.row].is_asked_again && is_curved(world, c.geometry[pair.row]);
    for (std::uint32_t k = 0; k < pair.count; ++k) {
      ConeContact& contact = contacts[pair.at + k];
      const Vec3 r_a(places.r_a.x[k], places.r_a.y[k], places.r_a.z[k]),
          r_b(places.r_b.x[k], places.r_b.y[k], places.r_b.z[k]);
      contact.is_curved = curved;
      contact.is_spread = false;
      contact.n = c.rows[pair.row + k].n;
      contact.r_a = given_a.turns ? r_a : Vec3::zero();
      contact.r_b = given_b.turns ? r_b : Vec3::zero();
      contact.k = places.response[k];
      contact.give = 0;
      contact.curve.set_zero();
      contact.apart = r_a - r_b;
      contact.surface = is_given ? Vec3(given_b.at(r_b) - given_a.at(r_a)) : Vec3::zero();
      if (!c.surface.empty()) contact.surface += c.surface[pair.row + k];
    }
    if (!first.slides) return;
    Vec3 at[kPairPoints];
    for (std::uint32_t k = 0; k < pair.count; ++k) at[k] = Vec3(places.r_b.x[k], places.r_b.y[k], places.r_b.z[k]);
    spread(c, pair, given_a, given_b, at, contacts + pair.at);
  });
}

void load_group(const World& world, std::size_t g) {
  DirectGroups& d = *world.direct;
  for (ConeBody& b : d.bodies_of(g)) {
    load_mass(world, b);
    b.v = {world.state.v[b.slot], world.state.omega[b.slot]};
  }
  load_contacts(world, d.rows_of(g), d.bodies.data(), d.contacts.data() + d.begin[g].contact, LoadWhat::all);
}

void load_groups(const World& world, SolverMemory& memory, Real h) {
  constexpr std::size_t kGroupsAPart = 4;
  DirectGroups& d = *world.direct;
  d.stood.resize(world.scene.bodies.slots());
  if (d.groups() == 0) return;
  const std::uint64_t of_step = print_of_step(world, h);
  in_parallel(world.jobs, d.groups(), kGroupsAPart, [&](std::uint32_t g) {
    GroupRest& rest = d.rest[g];
    rest.problem = rest.in_lanes || d.is_joined(g) ? 0 : print_of_problem(world, d.bodies_of(g), d.rows_of(g), of_step);
    rest.is_unchanged = rest.lasts = rest.problem != 0 && rest.problem == d.stood_of(g).problem;
    if (rest.is_unchanged) return;
    for (const ConeBody& b : d.bodies_of(g)) hold_orientation(world, memory, b.slot);
    load_group(world, g);
  });
}

}  // namespace carom::dynamics
