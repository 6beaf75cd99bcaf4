// Rows from manifolds, with the impulses that the last step left; and what is left for the next one.
#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <utility>

#include "dynamics/body_state.h"
#include "dynamics/contact/asked_again.h"
#include "dynamics/contact/contact.h"
#include "dynamics/contact/rolling.h"
#include "dynamics/contact/slide.h"
#include "dynamics/warm_scale.h"

namespace carom::dynamics {
namespace {

constexpr std::size_t kPairsAhead = 12;  // whose records are fetched while those of one pair are read

/// Where a point is for the next step to find again: on A, in the frame of its shape, unless A is static or kinematic,
/// over which B may slide as fast as it likes; then on B.
const Vec3& place_of(const ContactPoint& p, bool on_b) { return on_b ? p.on_b : p.on_a; }
bool placed_on_b(const Scene& scene, std::uint32_t collider_a) {
  return scene.type[scene.colliders.body[collider_a]] != BodyType::dynamic;
}

/// Which old point each point of a manifold goes on from: the nearest within reach, nearest pairs first, each taken
/// once; a single point goes on from a single one however far it rolled. Two points that started from the same old one
/// would carry its load twice, which upsets thin bodies whose points come and go.
/// @param first, last  range of the pair in them   @return by point; null: none
std::array<const OldImpulse*, Manifold::kMaxPoints> match_points(const Array<OldImpulse>& old_points, std::size_t first,
                                                                 std::size_t last, const Manifold& manifold, bool on_b,
                                                                 Real reach) {
  std::array<const OldImpulse*, Manifold::kMaxPoints> match{};
  if (last - first == 1 && manifold.count == 1) return {&old_points[first]};
  std::size_t left = last - first;
  // A kept patch has its points where they were, in their order: nothing is nearer.
  std::size_t next = first;
  for (int i = 0; i < manifold.count && next < last && reach > 0; ++i) {
    if (old_points[next].place != place_of(manifold.point[i], on_b)) continue;
    match[static_cast<std::size_t>(i)] = &old_points[next++];
    --left;
  }
  for (; left > 0; --left) {
    Real least = reach * reach;
    const OldImpulse* nearest = nullptr;
    int of = 0;
    for (std::size_t k = first; k < last; ++k) {
      const OldImpulse* const old = &old_points[k];
      if (std::find(match.begin(), match.end(), old) != match.end()) continue;
      for (int i = 0; i < manifold.count; ++i) {
        if (match[static_cast<std::size_t>(i)]) continue;
        const Real d = (old->place - place_of(manifold.point[i], on_b)).squared_norm();
        if (d < least) least = d, nearest = old, of = i;
      }
    }
    if (!nearest) break;
    match[static_cast<std::size_t>(of)] = nearest;
  }
  return match;
}

/// What a point starts from: the impulse that held it, which stays as it is in the world while a normal turns with the
/// body it stands on, within the new cone.   @param scale  substep now over substep then
Vec3 starting_impulse(const OldImpulse& old, const Vec3& n, Real friction, Real scale) {
  const Vec3 p = scale * old.p;
  const Real normal = p.dot(n);
  if (!(normal > 0)) return Vec3::zero();
  const Vec3 tangent = p - normal * n;
  const Real bound = friction * normal, size2 = tangent.squared_norm();
  return size2 > bound * bound ? Vec3(normal * n + (bound / std::sqrt(size2)) * tangent) : p;
}

/// Which of a pair's bodies contacts move in this step.
struct Movers {
  std::uint32_t a, b;  // body slots
  bool moves_a, moves_b;

  Movers(const World& world, const Pair& pair)
      : a(world.scene.colliders.body[pair.a]), b(world.scene.colliders.body[pair.b]) {
    moves_a = yields(world.scene, world.state, a) && !world.state.sleeps(a);
    moves_b = yields(world.scene, world.state, b) && !world.state.sleeps(b);
  }
};

std::uint32_t count_rows(const World& world, const PairTable::Place& place) {
  if (place.points == 0) return 0;
  const Movers m(world, place.pair);
  const EffectModes& modes = world.scene.modes;
  if (modes.forbids(+EffectId::response, m.a) || modes.forbids(+EffectId::response, m.b)) return 0;
  return m.moves_a || m.moves_b ? place.points : 0;
}

/// What a body of a pair is round by in a step.
struct RollsOn {
  Real radius = 0;    // m, of its core, or of the ball it rolls on
  int at_alone = -1;  // of more points, that which it rolls on: the others are in the air, and stay there
};

/// Materials of pairs that come one after the other: most are those of the pair before.
class Mixing {
 public:
  explicit Mixing(const Scene& scene) : scene_(scene) {}
  const MixedMaterial& of(std::uint32_t collider_a, std::uint32_t collider_b) {
    const std::uint32_t a = scene_.colliders.material[collider_a], b = scene_.colliders.material[collider_b];
    if (is_known_ && a == a_ && b == b_) return known_;
    known_ = mixed(scene_, collider_a, collider_b);
    a_ = a, b_ = b, is_known_ = !scene_.modes.forbidden_anywhere;
    return known_;
  }

 private:
  const Scene& scene_;
  bool is_known_ = false;
  std::uint32_t a_ = 0, b_ = 0;  // slots of materials
  MixedMaterial known_{};
};

/// @param dt  s, a step; 0: nothing rolls   @param sign  of the normal, outwards   @param point  of a point, on the
/// body, in its shape's frame
template <class PointOf>
RollsOn round_by(const World& world, std::uint32_t collider, std::uint32_t body, std::uint32_t other,
                 const Manifold& manifold, Real dt, Real sign, const PointOf& point) {
  const Shape& shape = *world.scene.colliders.shape[collider];
  const Vec3 turn = dt * (world.state.omega[body] - world.state.omega[other]);
  if (shape.core_radius > 0 || turn == Vec3::zero()) return {shape.core_radius};
  const Mat3 from_world = (world.plan->rotation[body] * world.plan->local[collider].r).transpose();
  const auto radius_at = [&](int k) {
    return rolling_radius(shape, point(manifold.point[k]), sign * (from_world * manifold.point[k].normal),
                          from_world * turn);
  };
  if (manifold.count > 2) {
    const auto nearer = [](const ContactPoint& p, const ContactPoint& q) { return p.separation < q.separation; };
    const ContactPoint* const deepest = std::min_element(manifold.point, manifold.point + manifold.count, nearer);
    const auto is_in_the_air = [&](const ContactPoint& p) { return &p == deepest || p.separation > 0; };
    if (!std::all_of(manifold.point, manifold.point + manifold.count, is_in_the_air)) return {};
    const int at = static_cast<int>(deepest - manifold.point);
    const Real radius = radius_at(at);
    return radius > 0 ? RollsOn{radius, at} : RollsOn{};
  }
  // Along the line that a cylinder lies on it is the same; a cone's is not, and rows of a pair share one.
  constexpr Real kAlike = 0.01;
  const Real first = radius_at(0), last = manifold.count == 2 ? radius_at(1) : first;
  return first > 0 && std::fabs(last - first) <= kAlike * first ? RollsOn{first} : RollsOn{};
}

/// What is found out of the pairs that a thread fills rows of.
struct Filled {
  std::uint64_t with_friction = 0;  // rows
  bool bounces = false, rolls = false;
};

/// The rows of a pair, and what is said of it beside them.
/// @param cursor  in the old ones, not after the pair; moved on to it
/// @param scale   substep now over substep then; 0: start cold   @param dt  s, a step
void fill_rows(const World& world, std::size_t pair_index, ContactPair& contact, Mixing& mixing, std::size_t& cursor,
               Real scale, Real dt, Filled& filled) {
  Contacts& c = *world.contacts;
  const Array<OldImpulse>& olds = world.impulses.old;
  const Scene& scene = world.scene;
  const Manifold& manifold = world.pairs[pair_index].manifold;
  const Pair pair = world.pairs.place(pair_index).pair;
  const std::uint32_t ca = pair.a, cb = pair.b;
  const Shape &shape_a = *scene.colliders.shape[ca], &shape_b = *scene.colliders.shape[cb];
  const Movers m(world, pair);
  const MixedMaterial& material = mixing.of(ca, cb);
  const Frame &fa = world.plan->local[ca], &fb = world.plan->local[cb];
  while (cursor < olds.size() && olds[cursor].pair < pair) ++cursor;
  std::size_t last = cursor;
  while (last < olds.size() && olds[last].pair == pair) ++last;
  const bool on_b = placed_on_b(scene, ca);
  std::array<const OldImpulse*, Manifold::kMaxPoints> match{};
  if (scale > 0 && last > cursor)
    match = match_points(olds, cursor, last, manifold, on_b, scene.dials[Dial::cache_distance]);

  const auto is_first = [&](const ContactPoint& p) { return p.normal == manifold.point[0].normal; };
  const bool one_normal = std::all_of(manifold.point + 1, manifold.point + manifold.count, is_first);
  const Real rolls_in = one_normal ? dt : 0;  // s: on several normals nothing rolls as on a ball
  const auto on_a = [](const ContactPoint& p) { return p.on_a; };
  const auto on_body_b = [](const ContactPoint& p) { return p.on_b; };
  RollsOn round_a{shape_a.core_radius}, round_b{shape_b.core_radius};
  if (may_roll(shape_a)) round_a = round_by(world, ca, m.a, m.b, manifold, rolls_in, 1, on_a);
  if (may_roll(shape_b)) round_b = round_by(world, cb, m.b, m.a, manifold, rolls_in, -1, on_body_b);
  const Real radius_a = round_a.radius, radius_b = round_b.radius;
  const bool rolls = radius_a != shape_a.core_radius || radius_b != shape_b.core_radius;
  const int at_alone = std::max(round_a.at_alone, round_b.at_alone), count = manifold.count;
  const Mat3 &rotation_a = world.plan->rotation[m.a], &rotation_b = world.plan->rotation[m.b];
  Row* const rows = &c.rows[contact.row];
  RowGeometry* const geometry = &c.geometry[contact.row];
  std::size_t found = 0;
  for (int k = 0; k < count; ++k) {
    const ContactPoint& point = manifold.point[k];
    Row& row = rows[k];
    RowGeometry& g = geometry[k];
    const OldImpulse* const old = match[static_cast<std::size_t>(k)];
    found += old != nullptr;
    row.u = Vec3::zero();
    row.n = point.normal;
    row.p = old ? starting_impulse(*old, row.n, material.friction, scale) : Vec3(Vec3::zero());
    row.friction = material.friction;
    row.restitution = material.restitution;
    row.a = m.a, row.b = m.b, row.moves_a = m.moves_a, row.moves_b = m.moves_b;
    row.one_normal = one_normal, row.rolls = rolls;
    g.is_asked_again = false, g.turning_pairs = 0;
    g.radius_a = radius_a, g.radius_b = radius_b;
    const ContactPoint& where = at_alone < 0 ? point : manifold.point[at_alone];
    g.l_a = fa.apply(where.on_a);
    g.l_b = fb.apply(where.on_b);
    if (radius_a > 0) g.l_a -= radius_a * (rotation_a.transpose() * row.n);
    if (radius_b > 0) g.l_b += radius_b * (rotation_b.transpose() * row.n);
    g.impulse = Vec3::zero();
    g.place = place_of(point, on_b);
    g.separation = where.separation;
    g.pair = static_cast<std::uint32_t>(pair_index);
    g.point = static_cast<std::uint16_t>(k);
  }
  rows->loads_known = found == last - cursor;
  contact.a = m.a, contact.b = m.b, contact.moves_a = m.moves_a, contact.moves_b = m.moves_b;
  contact.one_normal = one_normal;
  if (material.friction > 0) filled.with_friction += contact.count;
  filled.bounces |= material.restitution > 0, filled.rolls |= rolls;
  find_slide(world, contact.row, contact.count, nullptr);
}

/// Rows of all pairs, in their order: first how many each has, then what they are.
Filled fill_all_rows(const World& world, StepReport& report, Real scale, Real dt) {
  constexpr std::size_t kPairsAPart = 64;
  Contacts& c = *world.contacts;
  const Array<OldImpulse>& olds = world.impulses.old;
  const std::size_t pairs = world.pairs.size();
  c.first_row.resize(pairs + 1);
  in_parallel(world.jobs, pairs, 2 * kPairsAPart,
              [&](std::uint32_t i) { c.first_row[i] = count_rows(world, world.pairs.place(i)); });
  std::uint32_t n = 0;
  c.contact_pairs.clear(), c.contact_pairs.reserve(pairs);
  for (std::size_t i = 0; i < pairs; ++i) {
    const std::uint32_t count = std::exchange(c.first_row[i], n);
    if (count > 0) c.contact_pairs.push_back({n, count, 0, 0, false, false, false});
    n += count;
  }
  c.first_row[pairs] = n;
  report.contact_pairs = c.contact_pairs.size();
  remake(c.rows, n), remake(c.geometry, n);
  std::atomic<std::uint64_t> with_friction{0};
  std::atomic<bool> any_bounces{false}, any_rolls{false};
  in_parts(world.jobs, pairs, kPairsAPart, [&](std::uint32_t begin, std::uint32_t end) {
    const auto before = [](const OldImpulse& old, const Pair& pair) { return old.pair < pair; };
    auto cursor = static_cast<std::size_t>(
        std::lower_bound(olds.begin(), olds.end(), world.pairs.place(begin).pair, before) - olds.begin());
    const auto begins_before = [](const ContactPair& contact, std::uint32_t row) { return contact.row < row; };
    auto contact = std::lower_bound(c.contact_pairs.begin(), c.contact_pairs.end(), c.first_row[begin], begins_before);
    Mixing mixing(world.scene);
    Filled part;
    for (std::uint32_t i = begin; i < end; ++i) {
      world.pairs.fetch(i + kPairsAhead);
      if (c.first_row[i] < c.first_row[i + 1]) fill_rows(world, i, *contact++, mixing, cursor, scale, dt, part);
    }
    with_friction.fetch_add(part.with_friction, std::memory_order_relaxed);
    if (part.bounces) any_bounces.store(true, std::memory_order_relaxed);
    if (part.rolls) any_rolls.store(true, std::memory_order_relaxed);
  });
  return {with_friction.load(std::memory_order_relaxed), any_bounces.load(std::memory_order_relaxed),
          any_rolls.load(std::memory_order_relaxed)};
}

/// For who bounces and has unlike moments.
void reserve_spins(const World& world) {
  Contacts& c = *world.contacts;
  c.spins.clear();
  if (!world.plan->rotation_method) return;
  c.spins.reserve(world.scene.bodies.slots());
  if (c.one_spin.runs.empty()) c.one_spin.add(0);
}

/// Who bounces; and how many take part in what.
void list_impacts(const World& world, const Filled& filled) {
  Contacts& c = *world.contacts;
  c.bouncing.clear(), c.impacts.clear();
  c.any_rolls = filled.rolls;
  if (filled.bounces)
    for (const ContactPair& m : c.contact_pairs)
      for (std::uint32_t k = m.row; c.rows[m.row].restitution > 0 && k < m.row + m.count; ++k) {
        c.geometry[k].impact = static_cast<std::uint32_t>(c.impacts.size());
        c.bouncing.push_back(k);
        c.impacts.emplace_back().row = k;
      }
  count_participants(world, EffectId::friction, filled.with_friction);
  count_participants(world, EffectId::restitution, c.bouncing.size());
  count_participants(world, EffectId::response, c.contact_pairs.size());
}

/// Who is moved by rows or joints, ascending. Looked for among the rows where those are few, so that no other body
/// costs anything.
void list_bodies(const World& world) {
  Contacts& c = *world.contacts;
  const Plan& plan = *world.plan;
  const std::size_t movers = plan.linear.count + plan.rotating.count;
  c.is_bound.resize(world.scene.bodies.slots(), 0);
  c.bodies.reserve(std::min(movers, 2 * (c.contact_pairs.size() + c.links.size())));
  for (const std::uint32_t i : c.bodies) c.is_bound[i] = 0;
  c.bodies.clear();
  constexpr std::size_t kFew = 32;  // of so many movers one may be listed: sorting costs less than a look at all
  const auto each_end = [&](const auto& both, const auto& see) {
    if (both.moves_a && !world.state.sleeps(both.a)) see(both.a);
    if (both.moves_b && !world.state.sleeps(both.b)) see(both.b);
  };
  if (kFew * (c.contact_pairs.size() + c.links.size()) < movers) {
    const auto see = [&](std::uint32_t i) {
      if (!std::exchange(c.is_bound[i], 1)) c.bodies.push_back(i);
    };
    for (const ContactPair& m : c.contact_pairs) each_end(m, see);
    for (const Link& l : c.links) each_end(l, see);
    std::sort(c.bodies.begin(), c.bodies.end());
    return;
  }
  const auto mark = [&](std::uint32_t i) {
    std::atomic_ref<std::uint8_t>(c.is_bound[i]).store(1, std::memory_order_relaxed);
  };
  in_parallel(world.jobs, c.contact_pairs.size(), kRowsAPart,
              [&](std::uint32_t i) { each_end(c.contact_pairs[i], mark); });
  for (const Link& l : c.links) each_end(l, mark);
  each_of_both(plan.linear, plan.rotating, [&](std::uint32_t i) {
    if (c.is_bound[i]) c.bodies.push_back(i);
  });
}

}  // namespace

void reserve_search(const World& world) {
  Contacts& c = *world.contacts;
  const std::size_t slots = world.scene.bodies.slots(), n = c.rows.size();
  c.half_of.resize(slots);
  for (const std::uint32_t i : c.bodies) c.half_of[i].end = 0;
  for (const ContactPair& m : c.contact_pairs) {
    if (m.moves_a) c.half_of[m.a].end += m.count;
    if (m.moves_b) c.half_of[m.b].end += m.count;
  }
  std::uint32_t begin = 0;
  for (const std::uint32_t i : c.bodies) {
    c.half_of[i].begin = begin;
    c.half_of[i].end = begin += c.half_of[i].end;
  }
  c.half.resize(begin);
  c.keys.resize(n), c.place.resize(n), c.ranked.reserve(n);
}

Real start_scale(const World& world, Real h) {
  const bool warm = world.scene.dials.choice(Dial::warm_start) != 0 && world.impulses.old_h > 0;
  return warm ? warm_scale(h, world.impulses.old_h) : 0;
}

void make_rows(const World& world, StepReport& report, const StepTime& time) {
  Contacts& c = *world.contacts;
  for (const std::uint32_t i : c.bodies) world.plan->touched[i] = 0;  // of the last step
  const Filled filled = fill_all_rows(world, report, start_scale(world, time.h), time.dt);
  report.contact_points = c.rows.size();
  list_impacts(world, filled);
  find_asked_again(world, time);
}

void list_moved_bodies(const World& world, Impulses& impulses, const StepTime&) {
  Contacts& c = *world.contacts;
  const std::size_t n = c.rows.size(), slots = world.scene.bodies.slots();
  list_bodies(world);
  if (!c.bouncing.empty()) reserve_search(world), reserve_spins(world);
  c.inv_inertia_w.resize(slots);
  c.last_impact.resize(slots);
  c.displaced.resize(slots, {Vec3::zero(), Vec3::zero()});
  if (n > impulses.old.capacity()) impulses.old.reserve(with_slack(n));
  c.blocks.assign((n + kRowsAPart - 1) / kRowsAPart, {});
}

void remember_impulses(const World& world, Impulses& to, Real h) {
  Contacts& c = *world.contacts;
  std::uint32_t n = 0;
  for (Contacts::Block& block : c.blocks) n += std::exchange(block.loaded, n);  // now: where its impulses stand
  to.old.resize(n);
  to.old_h = h;
  each_block(world, [&](const Contacts::Block& block, std::size_t first, std::size_t last) {
    OldImpulse* next = to.old.data() + block.loaded;
    const auto ends_before = [](const Resistance& r, std::size_t row) { return r.row + r.points <= row; };
    auto resistance = std::lower_bound(c.resisting.begin(), c.resisting.end(), first, ends_before);
    for (std::size_t i = first; i < last; ++i) {
      const Row& row = c.rows[i];
      if (!leaves_impulse(world, row)) continue;
      const RowGeometry& g = c.geometry[i];
      while (resistance != c.resisting.end() && ends_before(*resistance, i)) ++resistance;
      const bool resists = resistance != c.resisting.end() && resistance->row <= i;
      *next++ = {world.pairs.place(g.pair).pair, g.place, row.p, Vec3::zero()};
      if (resists && finite(resistance->moment)) next[-1].moment = resistance->moment;
    }
  });
}

}  // namespace carom::dynamics
