// Rows into lanes and back.
#include "dynamics/solver/wide_contacts.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "dynamics/contact/depth.h"
#include "dynamics/contact/held_arms.h"
#include "dynamics/contact/turning_ground.h"
#include "dynamics/integrate/turn_kernels.h"
#include "dynamics/quarantine.h"
#include "dynamics/solver/far_turns.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/solver/float_range.h"

namespace carom::dynamics {
namespace {

void hold_orientations(const World& world, SolverMemory& memory, WideContacts& wide) {
  wide.held_back.resize(wide.slot.size());
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    wide.held_back[i].set_zero();
    if (i < wide.first_moved) return;
    hold_orientation(world, memory, wide.slot[i]);
    wide.held_back[i] = held_back(world, wide.slot[i]);
  });
}

// What kernels know of a row's layout.
constexpr std::size_t place_of(std::size_t bytes) { return bytes / sizeof(double); }
static_assert(sizeof(Row) == kRowNumbers * sizeof(double) && place_of(offsetof(Row, u)) == kRowVelocity &&
              place_of(offsetof(Row, n)) == kRowNormal && place_of(offsetof(Row, p)) == kRowImpulse &&
              place_of(offsetof(Row, twist_share)) == kRowTwistShare);
static_assert(sizeof(RowGeometry) == kGeometryNumbers * sizeof(double) &&
              place_of(offsetof(RowGeometry, l_a)) == kGeometryA &&
              place_of(offsetof(RowGeometry, l_b)) == kGeometryB &&
              place_of(offsetof(RowGeometry, radius_a)) == kGeometryRadiusA &&
              place_of(offsetof(RowGeometry, radius_b)) == kGeometryRadiusB &&
              place_of(offsetof(RowGeometry, impulse)) == kGeometryImpulse &&
              place_of(offsetof(RowGeometry, separation)) == kGeometrySeparation);

constexpr double kZeros[kPairPoints * kRowNumbers] = {};

/// What four lanes are filled from; and whose they are.
/// @param gravity  m/s^2
template <class Number>
void find_sources(const World& world, const WideContacts& wide, const std::uint32_t* occupant, Real gravity,
                  PairLanesOf<Number>& pair, LaneSources& of) {
  const Contacts& c = *world.contacts;
  const Scene& scene = world.scene;
  const auto inertia = [&](bool moves, std::uint32_t body) {
    return moves && rotates(scene, body) ? c.inv_inertia_w[body].data() : kZeros;
  };
  for (int lane = 0; lane < kLanes; ++lane) {
    if (occupant[lane] == kEmptyLane) {
      for (const auto& all : {of.rotation_a, of.rotation_b, of.held_a, of.held_b, of.inv_inertia_a, of.inv_inertia_b,
                              of.x_a, of.x_b, of.row, of.geometry})
        all[lane] = kZeros;
      pair.a[lane] = pair.b[lane] = 0;
      of.inv_mass_a[lane] = of.inv_mass_b[lane] = of.to_b[lane] = of.friction[lane] = of.slide[lane] =
          of.bounce_speed[lane] = of.pull[lane] = 0;
      of.thickness[lane] = kInfinity;
      continue;
    }
    const std::uint32_t at = wide.manifolds[occupant[lane]].row;
    const Row& row = c.rows[at];
    const RowGeometry& g = c.geometry[at];
    pair.a[lane] = wide.body[row.a], pair.b[lane] = wide.body[row.b];
    of.rotation_a[lane] = world.plan->rotation[row.a].data(), of.rotation_b[lane] = world.plan->rotation[row.b].data();
    of.held_a[lane] = wide.held_back[pair.a[lane]].data(), of.held_b[lane] = wide.held_back[pair.b[lane]].data();
    of.inv_inertia_a[lane] = inertia(row.moves_a, row.a), of.inv_inertia_b[lane] = inertia(row.moves_b, row.b);
    of.x_a[lane] = world.state.x[row.a].data(), of.x_b[lane] = world.state.x[row.b].data();
    of.row[lane] = row.u.data(), of.geometry[lane] = g.l_a.data();
    of.inv_mass_a[lane] = row.moves_a ? scene.inv_mass[row.a] : 0;
    of.inv_mass_b[lane] = row.moves_b ? scene.inv_mass[row.b] : 0;
    of.to_b[lane] = Arms::to_b(row, g);
    of.friction[lane] = row.friction;
    of.slide[lane] = row.slides + row.slides_by_load;
    of.bounce_speed[lane] = row.restitution > 0 ? scene.dials[Dial::restitution_speed] : kInfinity;
    of.thickness[lane] = least_thickness(world, g);
    of.pull[lane] = pull_on(scene, row, gravity);
  }
}

/// That of four pairs, which are at rest if it is new.
template <class Number>
DriveLanesOf<Number>& drive_of(ContactLanes<Number>& rows, PairLanesOf<Number>& pair) {
  if (!pair.driven) {
    const LanesOf<Number> none = all<Number>(0);
    rows.drives.push_back({none, none, none, none, none, none, none});
    pair.driven = static_cast<std::uint32_t>(rows.drives.size());
  }
  return rows.drives[pair.driven - 1];
}

/// What surfaces do of themselves, of pairs that have any.
template <class Number>
void fill_drives(const World& world, const WideContacts& wide, ContactLanes<Number>& rows) {
  const Contacts& c = *world.contacts;
  rows.drives.clear();
  for (const Driven& driven : c.driven) {
    if (!c.solved_in_lanes(driven.row)) continue;
    const WideContacts::Manifold& m = wide.manifold_of(driven.row);
    PairLanesOf<Number>& pair = rows.pairs[m.pair];
    Vec3 velocity = Vec3::zero();  // where friction acts: it is linear over the points
    for (std::uint32_t k = 0; k < m.points; ++k)
      velocity += c.surface[m.row + k] - driven.spin.cross(get(rows.points[pair.first + k].d, m.lane));
    velocity /= static_cast<Real>(m.points);
    const Vec3 n = get(pair.n, m.lane), t = get(pair.t, m.lane);
    DriveLanesOf<Number>& drive = drive_of(rows, pair);
    const int lane = static_cast<int>(m.lane);
    set(drive.t, lane, velocity.dot(t));
    set(drive.s, lane, velocity.dot(n.cross(t)));
    set(drive.w, lane, driven.spin.dot(n));
    drive.own_t[lane] = drive.t[lane], drive.own_s[lane] = drive.s[lane];
  }
}

/// Whose turns ground that turns takes what it bears round by.
template <class Number>
void fill_turning_pairs(const World& world, const WideContacts& wide, ContactLanes<Number>& rows) {
  const WideContacts::Manifold* m = wide.manifolds.data();  // in the order of the rows, as these pairs are
  for (const TurningPair& of : world.contacts->turning_pairs) {
    if (!world.contacts->solved_in_lanes(of.row)) continue;
    while (m->row != of.row) ++m;
    DriveLanesOf<Number>& drive = drive_of(rows, rows.pairs[m->pair]);
    const OwnShares share(world.scene, world.contacts->rows[of.row]);
    const auto lane = static_cast<int>(m->lane);
    set(drive.share_a, lane, share.a), set(drive.share_b, lane, share.b);
  }
}

/// Which way bodies are free, of pairs some of whose bodies are locked.
template <class Number>
void fill_locks(const World& world, const WideContacts& wide, ContactLanes<Number>& rows) {
  rows.locks.clear();
  if (world.plan->effects[+EffectId::axis_locks].candidates.count == 0) return;
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
    if (occupant[lane] == kEmptyLane) continue;
    const WideContacts::Manifold& m = wide.manifolds[occupant[lane]];
    fetch(&c.rows[m.row], m.points);
    fetch(&c.geometry[m.row], m.points);
  }
}

/// Pairs of lanes with the rows that they are of, a few at a time, so that those are near when kernels come to them.
/// @param find  (place in pairs, [kLanes] manifolds, Where to find)   @param take  (begin, end, Where of each)
template <class Where, class Find, class Take>
void each_four(const World& world, const WideContacts& wide, const Find& find, const Take& take) {
  constexpr std::uint32_t kAtOnce = 4;
  const std::size_t count = wide.first_point.size();
  in_parts(world.jobs, count, kPairsAPart, [&](std::uint32_t begin, std::uint32_t end) {
    std::array<Where, kAtOnce> found;
    for (std::uint32_t i = begin; i < end; ++i) {
      const std::uint32_t* const occupant = &wide.occupant[std::size_t(i) * kLanes];
      if (i + 1 < count) fetch_rows(*world.contacts, wide, occupant + kLanes);
      const std::uint32_t at = (i - begin) % kAtOnce;
      find(i, occupant, found[at]);
      if (at + 1 == kAtOnce || i + 1 == end) take(i - at, i + 1, found.data());
    }
  });
}

/// All rows into lanes, and their masses. False: floats can't bear them.
template <class Number>
bool fill(const World& world, WideContacts& wide, ContactLanes<Number>& rows, const ContactSweeps<Number>& sweeps) {
  remake(rows.pairs, wide.first_point.size()), remake(rows.points, wide.parts.back().point);
  const LaneRunOf<Number> run = everything(wide, rows, wide.velocity.data());
  const Real gravity = world.scene.gravity.norm();
  each_four<LaneSources>(
      world, wide,
      [&](std::uint32_t i, const std::uint32_t* occupant, LaneSources& found) {
        PairLanesOf<Number>& pair = rows.pairs[i];
        const WideContacts::Manifold& of = wide.manifolds[*occupant];
        pair.first = wide.first_point[i], pair.points = of.points, pair.one_normal = has_one_normal(of);
        pair.driven = pair.locked = 0;
        find_sources(world, wide, occupant, gravity, pair, found);
      },
      [&](std::uint32_t begin, std::uint32_t end, const LaneSources* sources) {
        over_part(run, begin, end, [&](const auto& part) { sweeps.lay_out(part, sources); });
      });
  fill_drives(world, wide, rows);
  fill_turning_pairs(world, wide, rows);
  fill_locks(world, wide, rows);
  std::atomic<bool> bearable = true;
  in_any_order(world.jobs, everything(wide, rows, wide.velocity.data()), [&](const auto& part) {
    if (!sweeps.prepare(part)) bearable.store(false, std::memory_order_relaxed);
  });
  return bearable;
}

/// Solver bodies but the first, which is none: four(first of them), where there are as many and it takes them, else
/// one(each).
template <class Four, class One>
void each_four_bodies(const World& world, const WideContacts& wide, const Four& four, const One& one) {
  if (wide.slot.empty()) return;
  in_parts(world.jobs, wide.slot.size() - 1, kBodiesAPart, [&](std::uint32_t begin, std::uint32_t end) {
    for (std::uint32_t i = begin; i < end; i += kLanes) {
      if (i + kLanes <= end && four(1 + i)) continue;
      for (std::uint32_t k = i; k < std::min<std::uint32_t>(i + kLanes, end); ++k) one(1 + k);
    }
  });
}

/// Belts on ground that turns, one by one: what their drive is, and the friction that goes along.
void lead_belts(const World& world, WideContacts& wide, Real h) {
  with_lanes(wide, [&](auto& lanes, const auto&) {
    for (const TurningPair& of : world.contacts->turning_pairs) {
      if (!of.has_belts || !world.contacts->solved_in_lanes(of.row)) continue;
      const WideContacts::Manifold& m = wide.manifold_of(of.row);
      auto& pair = lanes.pairs[m.pair];
      auto& drive = lanes.drives[pair.driven - 1];
      const auto lane = static_cast<int>(m.lane);
      const Lead both = lead_of(world, of, h);
      const Vec3 lead = both.at(get(pair.r_a, m.lane) - get(pair.r_b, m.lane));
      const Vec3 n = get(pair.n, m.lane), t = get(pair.t, m.lane), s = n.cross(t);
      set(drive.t, lane, drive.own_t[lane] + lead.dot(t)), set(drive.s, lane, drive.own_s[lane] + lead.dot(s));
      // The ground's turn is in the friction already; the belt's is not.
      const Vec3 friction =
          exp_map(h * (both.turn - both.spin).dot(n) * n) * Vec3(pair.p_t[lane] * t + pair.p_s[lane] * s);
      set(pair.p_t, lane, friction.dot(t)), set(pair.p_s, lane, friction.dot(s));
    }
  });
}

}  // namespace

void pack(const World& world, SolverMemory& memory, WideContacts& wide, Real h) {
  place_pairs(world, wide);
  hold_orientations(world, memory, wide);
  find_far_turners(world, wide);
  wide.is_float = !wide.manifolds.empty() && bears_floats(world, wide, h);
  if (wide.is_float) {
    if (!wide.in_float) wide.in_float = make_owned<ContactLanes<float>>(world.memory, world.memory);
    wide.is_float = fill(world, wide, *wide.in_float, wide.kernels->in_float);
  }
  if (!wide.is_float) fill(world, wide, wide.in_double, wide.kernels->in_double);
}

void load_velocities(const World& world, WideContacts& wide) {
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

void store_velocities(const World& world, Velocities& to, const WideContacts& wide, Real h) {
  const State& s = world.state;
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    const std::uint32_t slot = wide.slot[i];
    if (i < wide.first_moved || !responds(world.scene, s, slot)) return;
    if (wide.is_float && !is_slow_enough(s, slot)) return;
    const BodyVelocity& b = wide.velocity[i];
    const Vec3 v(b.v[0], b.v[1], b.v[2]), omega(b.omega[0], b.omega[1], b.omega[2]);
    const bool turned = omega != s.omega[slot];
    if (!turned && v == s.v[slot]) return;
    // Two that fall side by side push each other by the rounding of their places; they are in flight all the same.
    const auto is_pushed = [&] {
      const Real small = 64 * kUnitRoundoff * (s.x[slot].norm() / h + s.v[slot].norm());
      return (v - s.v[slot]).norm() > small;
    };
    if (turned || is_pushed()) world.plan->touched[slot] = 1;
    to.v[slot] = v, to.omega[slot] = omega;
  });
}

void load_shifts(const World& world, WideContacts& wide) {
  const State& s = world.state;
  const auto in_lanes = turn_kernels().shift;
  each_four_bodies(
      world, wide,
      [&](std::uint32_t i) {
        static_assert(sizeof(BodyShift) == 8 * sizeof(double));
        in_lanes({s.x.data()->data(), s.q.data()->data(), wide.start_x[i].data(), wide.start_q[i].data(),
                  reinterpret_cast<double*>(&wide.shift[i])},
                 &wide.slot[i]);
        return true;
      },
      [&](std::uint32_t i) {
        wide.shift[i] = shift_since(s, wide.slot[i], {wide.start_q[i], wide.start_x[i]});
      });
}

void lead_lanes(const World& world, WideContacts& wide, Real h) {
  Contacts& c = *world.contacts;
  if (c.turning_pairs.empty()) return;
  const State& state = world.state;
  Array<BodyTurn>& turn = wide.placing->turn;
  const auto in_lanes = turn_kernels().lead;
  each_four_bodies(
      world, wide,
      [&](std::uint32_t i) {
        static_assert(sizeof(BodyTurn) == 10 * sizeof(double));
        return in_lanes({state.x.data()->data(), state.omega.data()->data(), reinterpret_cast<double*>(&turn[i])},
                        &wide.slot[i], h);
      },
      [&](std::uint32_t i) {
        const std::uint32_t slot = wide.slot[i];
        const Vec3 &x = state.x[slot], &omega = state.omega[slot];
        const Quat q = exp_map(h * omega);
        turn[i] = {{x.x(), x.y(), x.z()}, {q.x(), q.y(), q.z()}, q.w(), {omega.x(), omega.y(), omega.z()}};
      });
  over_contacts(world, [&](const auto& sweeps, const auto& run) { sweeps.lead(run, turn.data(), h); });
  if (std::ranges::any_of(c.turning_pairs, &TurningPair::has_belts)) lead_belts(world, wide, h);
}

void measure_lanes(const World& world) {
  load_shifts(world, *world.wide);
  over_contacts(world, [](const auto& sweeps, const auto& run) { sweeps.measure(run); });
}

void heed_impacts(const World& world, WideContacts& wide) {
  const Contacts& c = *world.contacts;
  const bool any = std::ranges::any_of(c.impacts, &Impact::concerns_solver);
  // What rolls is measured to other digits than it was led on by: always, so that no body's bounce is felt elsewhere.
  if (any || c.any_rolls) measure_lanes(world);
  if (!any) return;
  for (const Impact& at : c.impacts) {
    if (!at.concerns_solver() || !c.solved_in_lanes(at.row)) continue;
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

void displace(const World& world, Poses& to, const WideContacts& wide) {
  const State& s = world.state;
  in_parallel(world.jobs, wide.slot.size(), kBodiesAPart, [&](std::uint32_t i) {
    const std::uint32_t slot = wide.slot[i];
    if (i < wide.first_moved || !responds(world.scene, s, slot)) return;
    const BodyVelocity& d = wide.displacement[i];
    Vec3 turn(d.omega[0], d.omega[1], d.omega[2]);
    if (wide.far_turn[i].may && turns_too_far(world, slot, turn)) turn.set_zero();
    correct_pose(to, slot, Vec3(d.v[0], d.v[1], d.v[2]), turn);
  });
}

namespace {

/// Where four lanes are put.
void find_targets(const World& world, const WideContacts& wide, const std::uint32_t* occupant, LaneTargets& of) {
  Contacts& c = *world.contacts;
  const State& s = world.state;
  for (int lane = 0; lane < kLanes; ++lane) {
    if (occupant[lane] == kEmptyLane) {
      for (const auto& all :
           {of.rotation_a, of.rotation_b, of.x_a, of.x_b, of.v_a, of.v_b, of.omega_a, of.omega_b, of.row, of.geometry})
        all[lane] = kZeros;
      of.to_row[lane] = of.to_geometry[lane] = nullptr;
      continue;
    }
    const std::uint32_t at = wide.manifolds[occupant[lane]].row;
    Row& row = c.rows[at];
    of.rotation_a[lane] = world.plan->rotation[row.a].data(), of.rotation_b[lane] = world.plan->rotation[row.b].data();
    of.x_a[lane] = s.x[row.a].data(), of.x_b[lane] = s.x[row.b].data();
    of.v_a[lane] = s.v[row.a].data(), of.v_b[lane] = s.v[row.b].data();
    of.omega_a[lane] = s.omega[row.a].data(), of.omega_b[lane] = s.omega[row.b].data();
    of.row[lane] = of.to_row[lane] = row.u.data();
    of.geometry[lane] = of.to_geometry[lane] = c.geometry[at].l_a.data();
  }
}

}  // namespace

void unpack(const World& world, WideContacts& wide) {
  refresh_rotations(world);
  with_lanes(wide, [&](auto& lanes, const auto& sweeps) {
    const auto run = everything(wide, lanes, wide.velocity.data());
    each_four<LaneTargets>(
        world, wide,
        [&](std::uint32_t, const std::uint32_t* occupant, LaneTargets& found) {
          find_targets(world, wide, occupant, found);
        },
        [&](std::uint32_t begin, std::uint32_t end, const LaneTargets* targets) {
          over_part(run, begin, end, [&](const auto& part) { sweeps.read_back(part, targets); });
        });
  });
}

}  // namespace carom::dynamics
