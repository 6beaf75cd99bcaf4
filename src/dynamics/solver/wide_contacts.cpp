// Rows into lanes and back.
#include "dynamics/solver/wide_contacts.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "dynamics/contact/held_arms.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/quarantine.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/solver/float_range.h"

namespace carom {
namespace {

constexpr auto kMaxPoints = static_cast<std::uint32_t>(kPairPoints);

void hold_orientations(World& world, WideContacts& wide) {
  wide.held_back.resize(wide.slot.size());
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    wide.held_back[i].setZero();
    if (i < wide.first_moved) return;
    hold_orientation(world, wide.slot[i]);
    wide.held_back[i] = held_back(world, wide.slot[i]);
  });
}

template <class Number>
void fill_pair(const World& world, const WideContacts& wide, const Row& row, PairLanesOf<Number>& pair, int lane) {
  const Scene& scene = world.scene;
  pair.a[lane] = wide.body[row.a];
  pair.b[lane] = wide.body[row.b];
  set(pair.friction, lane, row.friction);
  pair.bias_rate[lane] = pair.mass_scale[lane] = pair.impulse_scale[lane] = 0;
  set(pair.bounce_speed, lane, row.restitution > 0 ? scene.dials[Dial::restitution_speed] : kInfinity);
  set_mass(world, row.moves_a, row.a, pair.inv_mass_a, pair.inv_inertia_a, lane);
  set_mass(world, row.moves_b, row.b, pair.inv_mass_b, pair.inv_inertia_b, lane);
}

template <class Number>
void fill_point(const Row& row, const RowGeometry& g, const Arms& r, const Vec3& middle, PointLanesOf<Number>& p,
                int lane) {
  const Vec3 d = r.a - middle;
  set(p.d, lane, d);
  set(p.n, lane, row.n);
  set(p.gap, lane, g.separation), set(p.separation, lane, g.separation);
  set(p.reach, lane, d.norm());
  set(p.p_n, lane, row.p.dot(row.n));
  p.sum_n[lane] = p.push[lane] = 0;
}

/// The points of a pair, and its friction at the middle of them, from the impulses its rows start with.
template <class Number>
void fill_points(const World& world, const WideContacts& wide, const WideContacts::Manifold& m,
                 PairLanesOf<Number>& pair, PointLanesOf<Number>* points, int lane) {
  const Contacts& c = *world.contacts;
  std::array<Arms, kMaxPoints> arms;
  Vec3 middle_a = Vec3::Zero(), middle_b = Vec3::Zero(), l_a = Vec3::Zero(), l_b = Vec3::Zero();
  const Real part = 1 / static_cast<Real>(m.points);
  for (std::uint32_t k = 0; k < m.points; ++k) {
    arms[k] = Arms(world, c.rows[m.row + k], c.geometry[m.row + k]);
    middle_a += part * arms[k].a;
    middle_b += part * arms[k].b;
    l_a += part * c.geometry[m.row + k].l_a;
    l_b += part * c.geometry[m.row + k].l_b;
  }
  const Vec3 n = c.rows[m.row].n, t = any_perpendicular(n).normalized();
  Vec3 force = Vec3::Zero();
  Real twist = 0;
  for (std::uint32_t k = 0; k < m.points; ++k) {
    const Row& row = c.rows[m.row + k];
    fill_point(row, c.geometry[m.row + k], arms[k], middle_a, points[k], lane);
    if (row.p == Vec3::Zero()) continue;
    const Vec3 sideways = row.p - row.p.dot(row.n) * row.n;
    force += sideways;
    twist += (arms[k].a - middle_a).cross(sideways).dot(n);
  }
  set(pair.n, lane, n);
  set(pair.t, lane, t);
  set(pair.r_a, lane, middle_a + wide.held_back[pair.a[lane]] * l_a);
  set(pair.r_b, lane, middle_b + wide.held_back[pair.b[lane]] * l_b);
  set(pair.radius_a, lane, c.geometry[m.row].radius_a), set(pair.radius_b, lane, c.geometry[m.row].radius_b);
  set(pair.p_t, lane, force.dot(t));
  set(pair.p_s, lane, force.dot(n.cross(t)));
  set(pair.p_w, lane, twist);
  pair.sum_t[lane] = pair.sum_s[lane] = pair.sum_w[lane] = 0;
}

/// Lanes of nobody.
template <class Number>
void empty(ContactLanes<Number>& rows, PairLanesOf<Number>& pair) {
  const std::uint32_t first = pair.first, points = pair.points, one_normal = pair.one_normal;
  pair = PairLanesOf<Number>{};
  pair.first = first, pair.points = points, pair.one_normal = one_normal;
  std::fill_n(&rows.points[first], points, PointLanesOf<Number>{});
}

/// How a pair's friction, a force and a twist at the middle of its points, is shared among them: by their loads, turned
/// about the point at which those loads act together. Added up again it is what it was.
class Shares {
 public:
  /// @param load  [points] N s, normal impulses   @param force  N s   @param twist  N m s, about the middle
  template <class Point, class Load>
  Shares(const Point* points, Load Point::* load, std::uint32_t count, std::uint32_t lane, const Vec3& n,
         const Vec3& force, Real twist)
      : n_(n) {
    Real all = 0, moment = 0, most = 0;
    Vec3 sum = Vec3::Zero();
    for (const Point* p = points; p < points + count; ++p) {
      const Real of_point = (p->*load)[lane], reach = p->reach[lane];
      all += of_point;
      sum += of_point * get(p->d, lane);
      most = std::max(most, reach * reach);
    }
    if (!(all > 0)) return;
    centre_ = sum / all;
    for (const Point* p = points; p < points + count; ++p)
      moment += (p->*load)[lane] * n.cross(get(p->d, lane) - centre_).squaredNorm();
    slide_ = force / all;
    if (moment > 1e-9 * all * most) turn_ = (twist - centre_.cross(force).dot(n)) / moment;
  }
  /// N s, friction at a point   @param d  m, from the middle   @param load  N s
  Vec3 at(const Vec3& d, Real load) const { return load * (slide_ + turn_ * n_.cross(d - centre_)); }

 private:
  Vec3 n_, centre_ = Vec3::Zero(), slide_ = Vec3::Zero();
  Real turn_ = 0;
};

/// What surfaces do of themselves, of pairs that have any.
template <class Number>
void fill_drives(const World& world, const WideContacts& wide, ContactLanes<Number>& rows) {
  const Contacts& c = *world.contacts;
  rows.drives.clear();
  for (const Driven& driven : c.driven) {
    if (!c.answered_in_lanes(driven.row)) continue;
    const WideContacts::Manifold& m = wide.manifold_of(driven.row);
    PairLanesOf<Number>& pair = rows.pairs[m.pair];
    if (!pair.driven) {
      rows.drives.push_back({all<Number>(0), all<Number>(0), all<Number>(0)});
      pair.driven = static_cast<std::uint32_t>(rows.drives.size());
    }
    Vec3 velocity = Vec3::Zero();  // at the middle: it is linear over the points
    for (std::uint32_t k = 0; k < m.points; ++k) velocity += c.surface[m.row + k];
    velocity /= static_cast<Real>(m.points);
    const Vec3 n = get(pair.n, m.lane), t = get(pair.t, m.lane);
    DriveLanesOf<Number>& drive = rows.drives[pair.driven - 1];
    const int lane = static_cast<int>(m.lane);
    set(drive.t, lane, velocity.dot(t));
    set(drive.s, lane, velocity.dot(n.cross(t)));
    set(drive.w, lane, driven.spin.dot(n));
  }
}

/// Which way bodies are free, of pairs some of whose bodies are locked.
template <class Number>
void fill_locks(const World& world, const WideContacts& wide, ContactLanes<Number>& rows) {
  rows.locks.clear();
  if (world.plan->effects[kLocksRow].candidates.count == 0) return;
  for (const WideContacts::Manifold& m : wide.manifolds) {
    const Row& row = world.contacts->rows[m.row];
    const Locks a = world.scene.locks_of(row.a), b = world.scene.locks_of(row.b);
    if (!(a | b)) continue;
    set_locks(rows.locks, rows.pairs[m.pair].locked, m.lane, a, b);
  }
}

/// Bring `count` of an array nearer. Lanes have an order of their own, so that what a lane is filled from, or emptied
/// into, lies anywhere.
template <class T>
void fetch(const T* first, std::size_t count) {
  const auto* const begin = reinterpret_cast<const char*>(first);
  for (std::size_t at = 0; at < count * sizeof(T); at += 64) __builtin_prefetch(begin + at);
}

/// The rows that four lanes will be filled from.
void fetch_rows(const Contacts& c, const WideContacts& wide, const std::uint32_t* occupant) {
  for (int lane = 0; lane < kLanes; ++lane) {
    if (occupant[lane] == kNobodysLane) continue;
    const WideContacts::Manifold& m = wide.manifolds[occupant[lane]];
    fetch(&c.rows[m.row], m.points);
    fetch(&c.geometry[m.row], m.points);
  }
}

/// All rows into lanes, and their masses. False: floats can't bear them.
template <class Number>
bool fill(World& world, WideContacts& wide, ContactLanes<Number>& rows, const ContactSweeps<Number>& sweeps) {
  rows.pairs.resize(wide.first_point.size());
  rows.points.resize(wide.parts.back().point);
  in_parallel(world.jobs, rows.pairs.size(), kPairsAPart, [&](std::uint32_t i) {
    PairLanesOf<Number>& pair = rows.pairs[i];
    const std::uint32_t* const occupant = &wide.occupant[std::size_t(i) * kLanes];
    if (i + 1 < rows.pairs.size()) fetch_rows(*world.contacts, wide, occupant + kLanes);
    const WideContacts::Manifold& of = wide.manifolds[*occupant];
    pair.first = wide.first_point[i], pair.points = of.points, pair.one_normal = has_one_normal(of);
    if (std::find(occupant, occupant + kLanes, kNobodysLane) != occupant + kLanes) empty(rows, pair);
    pair.driven = pair.locked = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
      if (occupant[lane] == kNobodysLane) continue;
      const WideContacts::Manifold& m = wide.manifolds[occupant[lane]];
      fill_pair(world, wide, world.contacts->rows[m.row], pair, lane);
      fill_points(world, wide, m, pair, &rows.points[pair.first], lane);
    }
  });
  fill_drives(world, wide, rows);
  fill_locks(world, wide, rows);
  std::atomic<bool> bearable = true;
  in_any_order(world.jobs, everything(wide, rows, wide.velocity.data()), [&](const LaneRunOf<Number>& run) {
    if (!sweeps.prepare(run)) bearable.store(false, std::memory_order_relaxed);
  });
  return bearable;
}

}  // namespace

void pack(World& world, WideContacts& wide, Real h) {
  place_pairs(world, wide);
  hold_orientations(world, wide);
  wide.is_float = !wide.manifolds.empty() && bears_floats(world, wide, h);
  if (wide.is_float) {
    if (!wide.in_float) wide.in_float = make_owned<ContactLanes<float>>(world.memory, world.memory);
    wide.is_float = fill(world, wide, *wide.in_float, wide.kernels->in_float);
  }
  if (!wide.is_float) fill(world, wide, wide.in_double, wide.kernels->in_double);
}

void load_velocities(World& world, WideContacts& wide) {
  const State& s = world.state;
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    if (i == 0) return;
    const std::uint32_t slot = wide.slot[i];
    world.plan->touched[slot] = 0;
    BodyVelocity& b = wide.velocity[i];
    for (int k = 0; k < 3; ++k) b.v[k] = s.v[slot][k], b.omega[k] = s.omega[slot][k];
    if (wide.is_float && !is_slow_enough(s, slot)) cap(b);
  });
}

void store_velocities(World& world, const WideContacts& wide, Real h) {
  State& s = world.state;
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    const std::uint32_t slot = wide.slot[i];
    if (i < wide.first_moved || !responds(world.scene, s, slot)) return;
    if (wide.is_float && !is_slow_enough(s, slot)) return;
    const BodyVelocity& b = wide.velocity[i];
    const Vec3 v(b.v[0], b.v[1], b.v[2]), omega(b.omega[0], b.omega[1], b.omega[2]);
    if (v == s.v[slot] && omega == s.omega[slot]) return;
    // Two that fall side by side push each other by the rounding of their places; they are in flight all the same.
    const Real small = 64 * kUnitRoundoff * (s.x[slot].norm() / h + s.v[slot].norm());
    if ((v - s.v[slot]).norm() > small || omega != s.omega[slot]) world.plan->touched[slot] = 1;
    s.v[slot] = v, s.omega[slot] = omega;
  });
}

void load_shifts(const World& world, WideContacts& wide) {
  const State& s = world.state;
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    if (i == 0) return;
    const Vec3 x = s.x[wide.slot[i]] - wide.start_x[i];
    const Quat q = s.q[wide.slot[i]] * wide.start_q[i].conjugate();
    wide.shift[i] = {.x = {x.x(), x.y(), x.z()}, .u = {q.x(), q.y(), q.z()}, .w = q.w()};
  });
}

void heed_impacts(World& world, WideContacts& wide) {
  const Contacts& c = *world.contacts;
  if (std::ranges::none_of(c.impacts, &Impact::concerns_solver)) return;
  measure_lanes(world);
  for (const Impact& at : c.impacts) {
    if (!at.concerns_solver() || !c.answered_in_lanes(at.row)) continue;
    const WideContacts::Manifold& m = wide.manifold_of(at.row);
    with_lanes(wide, [&](auto& lanes, const auto&) {
      auto& pair = lanes.pairs[m.pair];
      auto& p = lanes.points[pair.first + at.row - m.row];
      set(p.separation, static_cast<int>(m.lane), c.geometry[at.row].separation);
      if (at.count == 0) return;
      p.p_n[m.lane] = 0;
      pair.p_t[m.lane] = pair.p_s[m.lane] = pair.p_w[m.lane] = 0;
    });
  }
}

void displace(World& world, const WideContacts& wide) {
  State& s = world.state;
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    const std::uint32_t slot = wide.slot[i];
    if (i < wide.first_moved || !responds(world.scene, s, slot)) return;
    const BodyVelocity& d = wide.displacement[i];
    correct_pose(s, slot, Vec3(d.v[0], d.v[1], d.v[2]), Vec3(d.omega[0], d.omega[1], d.omega[2]));
  });
}

namespace {

constexpr std::size_t kManifoldsAhead = 2;

template <class Number>
void unpack(World& world, const WideContacts& wide, const ContactLanes<Number>& rows) {
  using Point = PointLanesOf<Number>;
  Contacts& c = *world.contacts;
  const State& s = world.state;
  in_parallel(world.jobs, wide.manifolds.size(), kLanes * kPairsAPart, [&](std::uint32_t i) {
    if (i + kManifoldsAhead < wide.manifolds.size()) {
      const WideContacts::Manifold& later = wide.manifolds[i + kManifoldsAhead];
      const PairLanesOf<Number>& its = rows.pairs[later.pair];
      fetch(&its.n, 2);
      fetch(&its.p_t, 6);
      fetch(&rows.points[its.first], later.points);
    }
    const WideContacts::Manifold& m = wide.manifolds[i];
    const PairLanesOf<Number>& pair = rows.pairs[m.pair];
    const Point* const points = &rows.points[pair.first];
    const std::uint32_t lane = m.lane;
    const Vec3 n = get(pair.n, lane), t = get(pair.t, lane), sideways = n.cross(t);
    const Vec3 force = pair.p_t[lane] * t + pair.p_s[lane] * sideways,
               sum_force = pair.sum_t[lane] * t + pair.sum_s[lane] * sideways;
    const Shares now(points, &Point::p_n, m.points, lane, n, force, pair.p_w[lane]),
        step(points, &Point::sum_n, m.points, lane, n, sum_force, pair.sum_w[lane]);
    const Row& first = c.rows[m.row];
    const Vec3 apart = s.x[first.b] - s.x[first.a];  // first: far from the origin both are large and nearly equal
    for (std::uint32_t k = 0; k < m.points; ++k) {
      Row& row = c.rows[m.row + k];
      RowGeometry& g = c.geometry[m.row + k];
      const Point& p = points[k];
      const Vec3 d = get(p.d, lane);
      row.p = p.p_n[lane] * row.n + now.at(d, p.p_n[lane]);
      g.impulse += p.sum_n[lane] * row.n + step.at(d, p.sum_n[lane]);
      const Vec3 r_a = arm_a(world, row, g), r_b = arm_b(world, row, g);
      row.u = relative_velocity(s, row, r_a, r_b);
      g.separation = (apart + (r_b - r_a)).dot(row.n);
    }
  });
}

}  // namespace

void unpack(World& world, const WideContacts& wide) {
  refresh_rotations(world);
  with_lanes(wide, [&](const auto& rows, const auto&) { unpack(world, wide, rows); });
}

}  // namespace carom
