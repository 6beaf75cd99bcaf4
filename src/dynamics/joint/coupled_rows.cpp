// Couplings: where they are, and sweeps over them.
#include "dynamics/joint/coupled_rows.h"

#include <algorithm>
#include <cmath>

#include "dynamics/body_state.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/turns.h"
#include "dynamics/joint/wide_joint_data.h"
#include "dynamics/solver/fill_lanes.h"
#include "dynamics/warm_scale.h"

namespace carom::dynamics {
namespace {

using Side = CoupledRow::Side;

/// How the coordinate of a joint depends on where its bodies go.
struct CoordinateRow {
  Real at;           // m or rad; of a twist what its pose tells
  Vec3 d, w_a, w_b;  // of u = d.(v_b - v_a) + w_b.omega_b - w_a.omega_a
};
CoordinateRow row_at(const JointEnds& ends, bool slides) {
  const Vec3 x_a = ends.a.q * Vec3::unit_x(), x_b = ends.b.q * Vec3::unit_x();
  if (slides) return {x_a.dot(ends.apart), x_a, (ends.arm_a + ends.apart).cross(x_a), ends.arm_b.cross(x_a)};
  const Vec3 axis = (x_a + x_b) / std::max(1 + x_a.dot(x_b), Real(1e-3));
  return {coordinates_of(ends)[static_cast<std::size_t>(Coordinate::twist)], Vec3::zero(), axis, axis};
}

struct EndMotion {
  Vec3 v, omega;  // m/s, rad/s, world
};
EndMotion motion_of(const BodyVelocity& v) {
  return {Vec3(v.v[0], v.v[1], v.v[2]), Vec3(v.omega[0], v.omega[1], v.omega[2])};
}

/// The bodies of a coupling in a step, with the velocities that sweeps write.
class Bodies {
 public:
  Bodies(const World& world, const CoupledRow& row) : velocity_(world.wide->velocity.data()), row_(row) {}

  EndMotion at(int k) const {
    return k < 0 ? EndMotion{Vec3::zero(), Vec3::zero()}
                 : motion_of(velocity_[row_.bodies[static_cast<std::size_t>(k)].solver]);
  }
  Real rate() const {
    Real u = 0;
    for (int k = 0; k < row_.count; ++k) {
      const CoupledBody& b = row_.bodies[static_cast<std::size_t>(k)];
      const EndMotion m = at(k);
      u += b.d.dot(m.v) + b.w.dot(m.omega);
    }
    return u;
  }
  /// An impulse d and a moment w on one of them.
  void push(int k, const Vec3& d, const Vec3& w) const {
    if (k < 0) return;
    const CoupledBody& b = row_.bodies[static_cast<std::size_t>(k)];
    if (!b.moves) return;
    const Vec3 v = b.inv_mass * b.free.times(d), omega = b.inv_inertia * w;
    BodyVelocity& to = velocity_[b.solver];
    for (int i = 0; i < 3; ++i) to.v[i] += v[i], to.omega[i] += omega[i];
  }
  void push(Real p) const {
    for (int k = 0; k < row_.count; ++k) {
      const CoupledBody& b = row_.bodies[static_cast<std::size_t>(k)];
      push(k, p * b.d, p * b.w);
    }
  }

 private:
  BodyVelocity* velocity_;
  const CoupledRow& row_;
};

/// A joint that is coupled, in lanes.
struct SideLanes {
  JointLanes& joint;
  std::uint32_t lane;
  JointRowLanes* rows;
};
SideLanes lanes_of(WideJoints& w, const Side& side) {
  const WideJoints::Place place = w.place[side.link];
  JointLanes& joint = w.joints[place.lanes];
  return {joint, place.lane, w.rows.data() + joint.first};
}
/// f(side, lanes, row) for each row that its joints lock.
template <class F>
void each_lock(WideJoints& w, const CoupledRow& row, F&& f) {
  for (const Side* side : {&row.follower, &row.leader}) {
    const SideLanes lanes = lanes_of(w, *side);
    for (std::uint32_t k = 0; k < lanes.joint.layout.equalities; ++k) f(*side, lanes, lanes.rows[k]);
  }
}

int body_in(CoupledRow& row, std::uint32_t body) {
  if (body == kInvalid) return -1;
  for (int k = 0; k < row.count; ++k)
    if (row.bodies[static_cast<std::size_t>(k)].body == body) return k;
  row.bodies[static_cast<std::size_t>(row.count)].body = body;
  return row.count++;
}

/// Adds share times the coordinate's row.
void add_row(CoupledRow& row, const Side& side, const CoordinateRow& of, Real share) {
  const auto add = [&](int k, const Vec3& d, const Vec3& w) {
    if (k < 0) return;
    CoupledBody& b = row.bodies[static_cast<std::size_t>(k)];
    b.d += share * d, b.w += share * w;
  };
  add(side.a, -of.d, -of.w_a), add(side.b, of.d, of.w_b);
}

Real rate_of(const Bodies& bodies, const Side& side, const CoordinateRow& of) {
  const EndMotion a = bodies.at(side.a), b = bodies.at(side.b);
  return of.d.dot(b.v - a.v) + of.w_b.dot(b.omega) - of.w_a.dot(a.omega);
}

/// What locks of both joints and the coupling do to each other's velocities, and its factors: the coupling comes last, so
/// what of it locks leave is its own. A lock that others imply bears nothing.
void factor_rows(WideJoints& w, CoupledRow& row) {
  constexpr Real kImplied = 1e-11;
  struct Ends {
    std::array<Vec3, CoupledRow::kMostBodies> d, w;
  };
  std::array<Ends, CoupledRow::kMostOfAll> rows{};
  int n = 0;
  each_lock(w, row, [&](const Side& side, const SideLanes& lanes, const JointRowLanes& r) {
    Ends& to = rows[static_cast<std::size_t>(n++)];
    to.d.fill(Vec3::zero()), to.w.fill(Vec3::zero());
    const Vec3 d = get(r.d, lanes.lane);
    if (side.a >= 0)
      to.d[static_cast<std::size_t>(side.a)] -= d, to.w[static_cast<std::size_t>(side.a)] -= get(r.w_a, lanes.lane);
    if (side.b >= 0)
      to.d[static_cast<std::size_t>(side.b)] += d, to.w[static_cast<std::size_t>(side.b)] += get(r.w_b, lanes.lane);
  });
  row.locks = n;
  Ends& own = rows[static_cast<std::size_t>(n++)];
  own.d.fill(Vec3::zero()), own.w.fill(Vec3::zero());
  for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
    own.d[k] = row.bodies[k].d, own.w[k] = row.bodies[k].w;
  const auto at = [](int i, int j) { return static_cast<std::size_t>(i * (i + 1) / 2 + j); };
  for (int i = 0; i < n; ++i) {
    std::array<Vec3, CoupledRow::kMostBodies> v, omega;
    for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k) {
      const CoupledBody& b = row.bodies[k];
      v[k] = b.inv_mass * b.free.times(rows[static_cast<std::size_t>(i)].d[k]);
      omega[k] = b.inv_inertia * rows[static_cast<std::size_t>(i)].w[k];
    }
    for (int j = 0; j <= i; ++j) {
      Real sum = 0;
      for (std::size_t k = 0; k < static_cast<std::size_t>(row.count); ++k)
        sum += v[k].dot(rows[static_cast<std::size_t>(j)].d[k]) + omega[k].dot(rows[static_cast<std::size_t>(j)].w[k]);
      row.factor[at(i, j)] = sum;
    }
  }
  for (int i = 0; i < n; ++i) {
    const Real whole = row.factor[at(i, i)];
    for (int j = 0; j < i; ++j) {
      Real x = row.factor[at(i, j)];
      for (int k = 0; k < j; ++k) x -= row.factor[at(i, k)] * row.factor[at(j, k)];
      row.factor[at(i, j)] = x;  // L D, so far
    }
    Real rest = whole;
    for (int j = 0; j < i; ++j) {
      const Real x = row.factor[at(i, j)];
      row.factor[at(i, j)] = x * row.factor[at(j, j)];
      rest -= x * row.factor[at(i, j)];
    }
    row.factor[at(i, i)] = rest > kImplied * whole ? 1 / rest : 0;
  }
}

/// x <- K^-1 x.
void solve_rows(const CoupledRow& row, Real* x) {
  const int n = row.locks + 1;
  const auto at = [](int i, int j) { return static_cast<std::size_t>(i * (i + 1) / 2 + j); };
  for (int i = 1; i < n; ++i)
    for (int j = 0; j < i; ++j) x[i] -= row.factor[at(i, j)] * x[j];
  for (int i = n - 1; i >= 0; --i) {
    x[i] *= row.factor[at(i, i)];
    for (int j = i + 1; j < n; ++j) x[i] -= row.factor[at(j, i)] * x[j];
  }
}

void place(const World& world, WideJoints& w, CoupledRow& row) {
  for (CoupledBody& b : row.bodies) {
    b.d = b.w = Vec3::zero();
    if (!b.moves || !rotates(world.scene, b.body)) continue;
    const Mat3 r = world.state.q[b.body].matrix();
    const Locks locks = world.scene.locks_of(b.body);
    b.inv_inertia = locks & kAngularLocks ? inverse_of_free(r * world.scene.inertia[b.body] * r.transpose(), locks)
                                          : Mat3(r * world.scene.inv_inertia[b.body] * r.transpose());
  }
  const auto look = [&](Side& side) {
    const JointEnds ends = ends_of(world, world.joints.joint[side.joint].def);
    const bool slides = is_slide(world, side.joint);
    const CoordinateRow of = row_at(ends, slides);
    side.at = slides ? of.at : nearest_turn(of.at, side.at + side.ahead), side.ahead = 0;
    return of;
  };
  const CoordinateRow follows = look(row.follower), leads = look(row.leader);
  const PolynomialAt f = polynomial_at(world.joints.coupling_of(world.joints.joint[row.joint]), row.leader.at);
  row.slope = f.slope, row.bend = f.bend;
  add_row(row, row.follower, follows, 1), add_row(row, row.leader, leads, -f.slope);
  row.error = row.follower.at - f.value;
  row.curve = 0;
  if (w.is_swept(row.link)) factor_rows(w, row);
}

/// Half a substep of the second derivative of a coordinate at constant velocities: @see bend_sweep.h. An angle is straight.
Real curve_of(const World& world, const Bodies& bodies, const Side& side, Real h) {
  if (!is_slide(world, side.joint)) return 0;
  const JointEnds ends = ends_of(world, world.joints.joint[side.joint].def);
  const EndMotion a = bodies.at(side.a), b = bodies.at(side.b);
  const Vec3 turns_a = a.omega.cross(ends.arm_a), turns_b = b.omega.cross(ends.arm_b);
  const Vec3 d = ends.a.q * Vec3::unit_x(), d1 = a.omega.cross(d), d2 = a.omega.cross(d1);
  const Vec3 parting = (b.v + turns_b) - (a.v + turns_a), inward = b.omega.cross(turns_b) - a.omega.cross(turns_a);
  const Real half = (h / 2) / (1 + (h * h / 4) * (a.omega.squared_norm() + b.omega.squared_norm()));
  return half * (d2.dot(ends.apart) + 2 * d1.dot(parting) + d.dot(inward));
}

/// Locks and coupling as one.
template <bool kPush>
void sweep(const World& world, WideJoints& w, CoupledRow& row) {
  const Bodies bodies(world, row);
  std::array<Real, CoupledRow::kMostOfAll> x;
  const JointLanes& own = w.joints[w.place[row.link].lanes];
  const std::uint32_t lane = w.place[row.link].lane;
  const Real mass_scale = own.mass_scale[lane], bias_rate = own.bias_rate[lane], kept = own.impulse_scale[lane];
  const auto asked = [&](Real u, Real curve, Real error) {
    return kPush ? mass_scale * (u + curve + bias_rate * error) : u;
  };
  int n = 0;
  each_lock(w, row, [&](const Side& side, const SideLanes& lanes, const JointRowLanes& r) {
    const EndMotion a = bodies.at(side.a), b = bodies.at(side.b);
    const std::uint32_t k = lanes.lane;
    const Real u = get(r.d, k).dot(b.v - a.v) + get(r.w_b, k).dot(b.omega) - get(r.w_a, k).dot(a.omega);
    x[static_cast<std::size_t>(n++)] = asked(u, r.curve[k], r.error[k]);
  });
  x[static_cast<std::size_t>(n)] = asked(bodies.rate(), row.curve, row.error);
  solve_rows(row, x.data());
  n = 0;
  each_lock(w, row, [&](const Side& side, const SideLanes& lanes, JointRowLanes& r) {
    const int k = static_cast<int>(lanes.lane);
    const Real change = -x[static_cast<std::size_t>(n++)] - (kPush ? kept * r.p[k] : 0);
    r.p[k] += change;
    const Vec3 p = change * get(r.d, lanes.lane), turn_b = change * get(r.w_b, lanes.lane);
    bodies.push(side.a, -p, -change * get(r.w_a, lanes.lane)), bodies.push(side.b, p, turn_b);
    if (kPush) return;
    const Vec3 torque = turn_b - get(lanes.joint.r_b, lanes.lane).cross(p);
    set(lanes.joint.force, k, get(lanes.joint.force, lanes.lane) + p);
    set(lanes.joint.torque, k, get(lanes.joint.torque, lanes.lane) + torque);
  });
  const Real change = -x[static_cast<std::size_t>(n)] - (kPush ? kept * row.p : 0);
  row.p += change;
  bodies.push(change);
  if (!kPush) row.effort += row.p;
}

template <class F>
void each_swept(const World& world, F&& f) {
  WideJoints& w = *world.wide_joints;
  for (CoupledRow& row : w.coupled())
    if (w.is_swept(row.link)) f(w, row);
}

}  // namespace

void begin_couplings(const World& world, Real h) {
  WideJoints& w = *world.wide_joints;
  if (w.couplings) w.couplings->clear();
  if (world.joints.couplings.empty()) return;
  if (!w.couplings) w.couplings = make_owned<Array<CoupledRow>>(world.memory);
  const auto link_of = [&](std::uint32_t joint) {
    const auto at = std::ranges::lower_bound(w.active, joint);
    return static_cast<std::uint32_t>(at - w.active.begin());
  };
  for (std::uint32_t i = 0; i < w.active.size(); ++i) {
    const Joint& joint = world.joints.joint[w.active[i]];
    if (!joint.coupling) continue;
    const Coupling& coupling = world.joints.coupling_of(joint);
    CoupledRow& row = w.couplings->emplace_back();
    row.joint = w.active[i], row.link = i;
    const auto side = [&](std::uint32_t of, Side& to) {
      const JointDef& def = world.joints.joint[of].def;
      to.joint = of, to.link = link_of(of);
      to.a = body_in(row, def.body_a), to.b = body_in(row, def.body_b);
      to.at = coupled_coordinate(world, of);
    };
    side(coupling.follower, row.follower), side(coupling.leader, row.leader);
    for (CoupledBody& b : row.bodies) {
      if (b.body == kInvalid) continue;
      b.solver = world.wide->body[b.body];
      b.moves = yields(world.scene, world.state, b.body) && !world.state.sleeps(b.body);
      b.inv_mass = b.moves ? world.scene.inv_mass[b.body] : 0;
      b.free = free_axes(world.scene.locks_of(b.body));
    }
    const WideJoints::Place own = w.place[i];
    row.again = w.joints[own.lanes].again[own.lane];
    const bool warm = joint.p_h > 0 && world.scene.dials.choice(Dial::warm_start) != 0;
    row.p = warm ? warm_scale(h, joint.p_h) * joint.p[0] : 0;
  }
}

void place_couplings(const World& world) {
  WideJoints& w = *world.wide_joints;
  for (CoupledRow& row : w.coupled()) place(world, w, row);
}

void bend_couplings(const World& world, Real h) {
  for (CoupledRow& row : world.wide_joints->coupled()) {
    const Bodies bodies(world, row);
    const Joint& leader = world.joints.joint[row.leader.joint];
    const Real u = rate_of(bodies, row.leader, row_at(ends_of(world, leader.def), is_slide(world, row.leader.joint)));
    row.curve = curve_of(world, bodies, row.follower, h) - row.slope * curve_of(world, bodies, row.leader, h) -
                (h / 2) * row.bend * u * u;
  }
}

void aim_couplings(const World& world, Real h) {
  for (CoupledRow& row : world.wide_joints->coupled())
    for (Side* const side : {&row.follower, &row.leader})
      if (!is_slide(world, side->joint))
        side->ahead = turns_ahead(world, world.joints.joint[side->joint], Vec3(side->at, 0, 0), h).x();
}

void start_couplings(const World& world) {
  each_swept(world, [&](WideJoints&, CoupledRow& row) { Bodies(world, row).push(row.p); });
}
void solve_couplings(const World& world) {
  each_swept(world, [&](WideJoints& w, CoupledRow& row) { sweep<true>(world, w, row); });
}
void relax_couplings(const World& world) {
  each_swept(world, [&](WideJoints& w, CoupledRow& row) { sweep<false>(world, w, row); });
}
void act_again_by_couplings(const World& world) {
  each_swept(world, [&](WideJoints&, CoupledRow& row) {
    row.effort += row.again * row.p;
    Bodies(world, row).push(row.again * row.p);
  });
}

void end_couplings(const World& world, Joints& joints, Real dt) {
  for (const CoupledRow& row : world.wide_joints->coupled()) {
    Joint& joint = joints.joint[row.joint];
    joint.p[0] = finite(row.p) ? row.p : 0;
    joint.force = Vec3::zero(), joint.torque = Vec3(finite(row.effort) ? row.effort / dt : 0, 0, 0);
  }
}

}  // namespace carom::dynamics
