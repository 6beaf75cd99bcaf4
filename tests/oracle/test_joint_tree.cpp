// Trees of joints: inverse dynamics against Newton's and Euler's equations of bodies that are moved by kinematics of this
// file, differentiated by differences; the mass matrix against energies; closed forms; what is no tree.
#include "carom_test.h"
#include "dynamics/joint/tree/joint_tree.h"
#include "joint_draws.h"
#include "six_axes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr std::uint32_t kWorld = kInvalid;

/// A body, the joint that holds it to those before it, and how that moves. The first may be a base.
struct Segment {
  std::uint32_t body = 0, joint = kInvalid;
  int parent = -1;  // link, or -1: the world
  bool is_base = false, child_is_a = false;
  JointKind kind = JointKind::hinge;
  Pose frame_a, frame_b;
  bool is_free[kAxes] = {};  // of six axes
  Real at[kAxes] = {};       // places and angles; of a base or a ball its turn is:
  Quat turned = Quat::identity();
  std::vector<Real> speed, rate;  // rate: of the speeds
  Pose start;
  Vec3 center;

  bool turns_as_one() const {
    return kind == JointKind::ball || (kind == JointKind::six_axis && is_free[3] && is_free[4] && is_free[5]);
  }
  /// B's frame in A's after a time.
  Pose frame(Real t) const {
    Real x[kAxes];
    std::copy(at, at + kAxes, x);
    std::size_t k = 0;
    const auto move = [&](int axis) { x[axis] += t * speed[k] + t * t / 2 * rate[k], ++k; };
    const auto turn = [&](Quat q) {
      const Vec3 w(speed[k], speed[k + 1], speed[k + 2]), a(rate[k], rate[k + 1], rate[k + 2]);
      return exp_map(t * w + t * t / 2 * a) * q;
    };
    switch (kind) {
      case JointKind::hinge:
        move(3);
        return {exp_map(Vec3(x[3], 0, 0)), Vec3::zero()};
      case JointKind::slider:
        move(0);
        return {Quat::identity(), Vec3(x[0], 0, 0)};
      case JointKind::universal:
        move(4), move(5);
        return {exp_map(Vec3(0, x[4], 0)) * exp_map(Vec3(0, 0, x[5])), Vec3::zero()};
      case JointKind::ball:
        return {turn(turned), Vec3::zero()};
      case JointKind::six_axis: {
        for (int axis = 0; axis < 3; ++axis)
          if (is_free[axis]) move(axis);
        const Vec3 place(x[0], x[1], x[2]);
        if (turns_as_one()) return {turn(turned), place};
        for (int axis = 3; axis < 6; ++axis)
          if (is_free[axis]) move(axis);
        return {exp_map(Vec3(0, x[4], x[5])) * exp_map(Vec3(x[3], 0, 0)), place};
      }
      default:
        return {};
    }
  }
};

struct Robot {
  TestWorld t{Vec3(0.4, -9.81, 1.2)};
  std::vector<Segment> links;

  /// Poses of all bodies after a time.
  std::vector<Pose> poses(Real time) const {
    std::vector<Pose> found;
    for (const Segment& l : links) {
      if (l.is_base) {
        const Vec3 v(l.speed[0], l.speed[1], l.speed[2]), w(l.speed[3], l.speed[4], l.speed[5]);
        const Vec3 a(l.rate[0], l.rate[1], l.rate[2]), alpha(l.rate[3], l.rate[4], l.rate[5]);
        const Quat q = exp_map(time * w + time * time / 2 * alpha) * l.start.q;
        const Vec3 x = l.start.apply(l.center) + time * v + time * time / 2 * a;
        found.push_back({q, x - q * l.center});
        continue;
      }
      const Pose from = l.parent < 0 ? Pose{} : found[static_cast<std::size_t>(l.parent)], frame = l.frame(time);
      found.push_back(l.child_is_a ? from * l.frame_b * frame.inverse() * l.frame_a.inverse()
                                   : from * l.frame_a * frame * l.frame_b.inverse());
    }
    return found;
  }
};

/// First and second derivatives at 0, by differences of steps h, h / 2, h / 4 extrapolated: errors of order h^6.
struct Derivatives {
  Vec3 first, second;
};
template <class F>
Derivatives derive(const F& f, Real h) {
  Vec3 one[3], two[3];
  for (int i = 0; i < 3; ++i, h /= 2) {
    const Vec3 there = f(h), here = f(Real(0)), back = f(-h);
    one[i] = (there - back) / (2 * h), two[i] = ((there - here) - (here - back)) / (h * h);
  }
  const auto extrapolated = [](const Vec3(&d)[3]) {
    const Vec3 a = (4.0 * d[1] - d[0]) / 3, b = (4.0 * d[2] - d[1]) / 3;
    return (16.0 * b - a) / 15;
  };
  return {extrapolated(one), extrapolated(two)};
}

/// Of each body: of its centre and of its turn, world.
struct Moved {
  Derivatives place, turn;
};
std::vector<Moved> motions(const Robot& robot, Real h) {
  std::vector<Moved> found;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const Quat start = robot.poses(0)[i].q;
    const auto place = [&](Real t) { return robot.poses(t)[i].apply(robot.links[i].center); };
    const auto turn = [&](Real t) {
      const Quat e = robot.poses(t)[i].q * start.conjugate();
      return (e.w() < 0 ? -2.0 : 2.0) * e.vec();
    };
    found.push_back({derive(place, h), derive(turn, h)});
  }
  return found;
}

/// A body at a pose, with a centre of mass beside its origin and an inertia of any axes.
std::uint32_t add_link_body(TestWorld& t, const Pose& pose, const Vec3& center) {
  BodyDef def;
  def.pose = pose;
  def.has_mass = def.has_inertia = def.has_center = true;
  def.mass = 1.5 + draw(), def.center = center;
  const Mat3 r = draw_turn().matrix();
  def.inertia = r * Mat3::diagonal(Vec3(0.3, 0.25, 0.2) + draw3(0.05)) * r.transpose();
  return handle_slot(t.world.add_body(def));
}

/// @param count  bodies   @param kinds  to choose from
void build(Robot& robot, int count, bool has_base, const std::vector<JointKind>& kinds) {
  TestWorld& t = robot.t;
  for (int i = 0; i < count; ++i) {
    Segment l;
    l.center = draw3(0.3);
    l.is_base = has_base && i == 0;
    l.parent = i == 0 ? -1 : below(i);
    l.kind = kinds[static_cast<std::size_t>(below(static_cast<int>(kinds.size())))];
    l.child_is_a = below(3) == 0;
    l.frame_a = {draw_turn(), draw3(0.4)}, l.frame_b = {draw_turn(), draw3(0.4)};
    std::size_t n = l.kind == JointKind::weld        ? 0
                    : l.kind == JointKind::universal ? 2
                    : l.kind == JointKind::ball      ? 3
                                                     : 1;
    l.turned = draw_turn();
    if (l.kind == JointKind::slider) l.at[0] = draw();
    if (l.kind == JointKind::hinge) l.at[3] = 3 * draw();
    if (l.kind == JointKind::universal) l.at[4] = 3 * draw(), l.at[5] = draw();
    if (l.kind == JointKind::six_axis) {
      n = 0;
      for (int k = 0; k < 6; ++k) l.is_free[k] = below(2) == 0, l.at[k] = draw(), n += l.is_free[k];
    }
    l.speed.resize(l.is_base ? 6 : n), l.rate.resize(l.speed.size());
    for (Real& x : l.speed) x = draw();
    for (Real& x : l.rate) x = 3 * draw();
    l.start = {draw_turn(), draw3(2)};
    robot.links.push_back(l);
  }
  const std::vector<Pose> at = robot.poses(0);
  for (std::size_t i = 0; i < at.size(); ++i) robot.links[i].body = add_link_body(t, at[i], robot.links[i].center);
  for (std::size_t i = at.size(); i-- > 0;) {  // the last first: the order of joints is not that of bodies
    Segment& l = robot.links[i];
    if (l.is_base) continue;
    const std::uint32_t parent = l.parent < 0 ? kWorld : robot.links[static_cast<std::size_t>(l.parent)].body;
    JointDef def;
    def.kind = l.kind;
    def.body_a = l.child_is_a ? l.body : parent, def.body_b = l.child_is_a ? parent : l.body;
    def.frame_a = l.frame_a, def.frame_b = l.frame_b;
    l.joint = handle_slot(t.world.add_joint(def));
    for (std::uint32_t k = 0; k < kAxes && l.kind == JointKind::six_axis; ++k)
      if (!l.is_free[k]) t.world.set_joint_axis(l.joint, k, locked_at(l.at[k]));
  }
}

JointTree tree_of(const TestWorld& t, std::uint32_t body) {
  JointTree tree(std::pmr::new_delete_resource());
  assert_int_equal(static_cast<int>(tree.find(t.world, body)), static_cast<int>(TreeFault::none));
  return tree;
}

/// Numbers of links in the order of a tree: a base's, then those of joints by slot.
std::vector<Real> in_order(const Robot& robot, std::vector<Real> Segment::*numbers) {
  std::vector<const Segment*> order;
  for (const Segment& l : robot.links) order.push_back(&l);
  std::sort(order.begin(), order.end(), [](const Segment* a, const Segment* b) {
    return a->is_base != b->is_base ? a->is_base : a->joint < b->joint;
  });
  std::vector<Real> all;
  for (const Segment* l : order) all.insert(all.end(), (l->*numbers).begin(), (l->*numbers).end());
  return all;
}

Real largest(const std::vector<Real>& v) {
  Real most = 0;
  for (const Real x : v) most = std::max(most, std::fabs(x));
  return most;
}

/// Positive definite: Cholesky's pivots, in place.
bool factors(std::vector<Real> m, std::size_t n) {
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t l = 0; l < k; ++l) m[k * n + k] -= m[k * n + l] * m[k * n + l];
    if (!(m[k * n + k] > 0)) return false;
    m[k * n + k] = std::sqrt(m[k * n + k]);
    for (std::size_t i = k + 1; i < n; ++i) {
      for (std::size_t l = 0; l < k; ++l) m[i * n + k] -= m[i * n + l] * m[k * n + l];
      m[i * n + k] /= m[k * n + k];
    }
  }
  return true;
}

const std::vector<JointKind> kEveryKind = {JointKind::hinge, JointKind::slider,    JointKind::ball,
                                           JointKind::weld,  JointKind::universal, JointKind::six_axis};

}  // namespace

/// Differences err by h^6 of an eighth derivative, h = 0.01: speeds of a few rad/s make 1e-10 of it; rounding makes 1e-15 / h
/// of first, 1e-15 16 / h^2 of second derivatives.
static void forces_are_newtons_and_eulers(void**) {
  Real worst_speed = 0, worst_force = 0, worst_sum = 0, worst_energy = 0;
  for (int trial = 0; trial < 120; ++trial) {
    Robot robot;
    build(robot, 1 + below(9), trial % 2 == 0, kEveryKind);
    World& w = robot.t.world;
    const std::vector<Moved> moved = motions(robot, 0.01);
    Real energy = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
      w.set_velocity(robot.links[i].body, moved[i].place.first, moved[i].turn.first);
      const Vec3 spin = w.state.q[robot.links[i].body].conjugate() * moved[i].turn.first;
      energy += w.scene.mass[robot.links[i].body] * moved[i].place.first.squared_norm() / 2 +
                spin.dot(w.scene.inertia[robot.links[i].body] * spin) / 2;
    }
    const std::uint32_t named = robot.links[trial % 2 == 0 ? 0 : moved.size() - 1].body;
    const JointTree tree = tree_of(robot.t, named);
    const std::size_t n = tree.size();
    const std::vector<Real> u = in_order(robot, &Segment::speed), a = in_order(robot, &Segment::rate);
    assert_int_equal(n, u.size());
    std::vector<Real> speeds(n), forces(n), bias(n), mass(n * n), none(n);
    tree.read_speeds(w, speeds.data());
    for (std::size_t k = 0; k < n; ++k) worst_speed = std::max(worst_speed, std::fabs(speeds[k] - u[k]));
    tree.find_forces(w, u.data(), a.data(), forces.data());
    tree.find_forces(w, u.data(), none.data(), bias.data());
    tree.find_mass(w, mass.data());
    // What a number's force does work on: how all bodies move by that number alone.
    std::size_t at = 0;
    std::vector<Segment*> order;
    for (Segment& l : robot.links) order.push_back(&l);
    std::sort(order.begin(), order.end(), [](const Segment* x, const Segment* y) {
      return x->is_base != y->is_base ? x->is_base : x->joint < y->joint;
    });
    const Real scale = 1 + largest(forces);
    Robot still;
    still.links = robot.links;
    for (Segment& l : still.links)
      std::fill(l.speed.begin(), l.speed.end(), 0), std::fill(l.rate.begin(), l.rate.end(), 0);
    for (const Segment* l : order)
      for (std::size_t k = 0; k < l->speed.size(); ++k, ++at) {
        std::vector<Real>& speed = still.links[static_cast<std::size_t>(l - robot.links.data())].speed;
        speed[k] = 1;
        const std::vector<Moved> by_one = motions(still, 0.01);
        speed[k] = 0;
        Real work = 0;
        for (std::size_t i = 0; i < moved.size(); ++i) {
          const std::uint32_t body = robot.links[i].body;
          const Mat3 r = w.state.q[body].matrix(), inertia = r * w.scene.inertia[body] * r.transpose();
          const Vec3 omega = moved[i].turn.first;
          work += by_one[i].place.first.dot(w.scene.mass[body] * (moved[i].place.second - w.scene.gravity)) +
                  by_one[i].turn.first.dot(inertia * moved[i].turn.second + omega.cross(inertia * omega));
        }
        worst_force = std::max(worst_force, std::fabs(work - forces[at]) / scale);
      }
    Real twice = 0;
    for (std::size_t i = 0; i < n; ++i) {
      Real sum = bias[i];
      for (std::size_t j = 0; j < n; ++j) {
        assert_true(mass[i * n + j] == mass[j * n + i]);
        sum += mass[i * n + j] * a[j], twice += u[i] * mass[i * n + j] * u[j];
      }
      worst_sum = std::max(worst_sum, std::fabs(sum - forces[i]) / scale);
    }
    worst_energy = std::max(worst_energy, std::fabs(twice / 2 - energy) / (1 + energy));
    assert_true(factors(mass, n));
  }
  std::printf("  speeds %.1e, forces %.1e, M a + bias %.1e, energy %.1e\n", worst_speed, worst_force, worst_sum,
              worst_energy);
  assert_true(worst_speed < 1e-10 && worst_force < 1e-7 && worst_sum < 1e-13 && worst_energy < 1e-11);
}

/// Velocities without differences: a chain of hinges and balls that hangs from a base, each speed added by hand.
static void energy_is_that_of_the_bodies(void**) {
  TestWorld t;
  std::vector<std::uint32_t> body = {add_link_body(t, {draw_turn(), draw3(1)}, draw3(0.2))};
  Vec3 v = draw3(2), omega = draw3(3);
  t.world.set_velocity(body[0], v, omega);
  for (int i = 1; i <= 29; ++i) {
    const Vec3 at = t.world.state.x[body.back()] + draw3(0.3);
    const Quat axes = draw_turn();
    const std::uint32_t next = add_link_body(t, {draw_turn(), at + draw3(0.2)}, draw3(0.1));
    const bool ball = i % 5 == 0;
    join(t, ball ? JointKind::ball : JointKind::hinge, body.back(), next, at, axes);
    v += omega.cross(at - t.world.state.x[body.back()]);
    omega += axes * (ball ? draw3(2) : Vec3(2 * draw(), 0, 0));
    v += omega.cross(t.world.state.x[next] - at);
    t.world.set_velocity(next, v, omega);
    body.push_back(next);
  }
  const JointTree tree = tree_of(t, body[0]);
  const std::size_t n = tree.size();
  assert_int_equal(n, 6 + 24 + 3 * 5);
  std::vector<Real> u(n), mass(n * n);
  tree.read_speeds(t.world, u.data()), tree.find_mass(t.world, mass.data());
  Real twice = 0, energy = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < n; ++j) twice += u[i] * mass[i * n + j] * u[j];
  for (const std::uint32_t b : body) {
    const Vec3 spin = t.world.state.q[b].conjugate() * t.world.state.omega[b];
    energy += t.world.scene.mass[b] * t.world.state.v[b].squared_norm() + spin.dot(t.world.scene.inertia[b] * spin);
  }
  assert_true(std::fabs(twice - energy) < 1e-12 * energy);
}

/// M = m l^2 + I; held still m g l sin q, whatever the speed.
static void a_pendulum(void**) {
  const Real m = 2, l = 0.7, inertia = 0.3, q = 0.6;
  TestWorld t;
  const std::uint32_t bob = add_body(t, Vec3(0, -l, 0), m, Vec3::constant(inertia));
  join(t, JointKind::hinge, kWorld, bob, Vec3::zero(), x_along(Vec3(0, 0, 1)));
  const Quat turned = exp_map(Vec3(0, 0, q));
  t.world.set_pose(bob, {turned, turned * Vec3(0, -l, 0)});
  const JointTree tree = tree_of(t, bob);
  assert_int_equal(tree.size(), 1);
  Real mass = 0, force = 0;
  const Real speed = 3, rate = 5;
  tree.find_mass(t.world, &mass), tree.find_forces(t.world, &speed, &rate, &force);
  assert_true(std::fabs(mass - (m * l * l + inertia)) < 1e-15);
  assert_true(std::fabs(force - (mass * rate + m * kG * l * std::sin(q))) < 1e-14);
  t.world.set_mode(static_cast<std::size_t>(EffectId::gravity), EffectMode::forbid);
  tree.find_forces(t.world, &speed, &rate, &force);
  assert_true(std::fabs(force - mass * rate) < 1e-14);
}

/// Two points of mass on rods, absolute angles p and q from hanging, here as angles of joints p and q - p.
///   tau_p' = (m1 + m2) l1^2 p'' + m2 l1 l2 (q'' cos(p - q) + q'^2 sin(p - q)) + (m1 + m2) g l1 sin p
///   tau_q' = m2 l2^2 q'' + m2 l1 l2 (p'' cos(p - q) - p'^2 sin(p - q)) + m2 g l2 sin q
/// and torques of the joints: of the first tau_p' + tau_q', of the second tau_q'. Points have a little inertia: I p'', I q''.
static void a_double_pendulum(void**) {
  const Real m1 = 1.3, m2 = 0.8, l1 = 0.9, l2 = 0.6, inertia = 1e-3, p = 0.8, q = -0.4;
  const Real dp = 1.7, dq = -2.2, ddp = 3, ddq = 4;
  TestWorld t;
  const std::uint32_t one = add_body(t, Vec3(0, -l1, 0), m1, Vec3::constant(inertia)),
                      two = add_body(t, Vec3(0, -l1 - l2, 0), m2, Vec3::constant(inertia));
  const Quat z = x_along(Vec3(0, 0, 1));
  join(t, JointKind::hinge, kWorld, one, Vec3::zero(), z);
  join(t, JointKind::hinge, one, two, Vec3(0, -l1, 0), z);
  const Quat at_p = exp_map(Vec3(0, 0, p)), at_q = exp_map(Vec3(0, 0, q));
  t.world.set_pose(one, {at_p, at_p * Vec3(0, -l1, 0)});
  t.world.set_pose(two, {at_q, at_p * Vec3(0, -l1, 0) + at_q * Vec3(0, -l2, 0)});
  const JointTree tree = tree_of(t, two);
  const Real u[2] = {dp, dq - dp}, a[2] = {ddp, ddq - ddp};
  Real force[2];
  tree.find_forces(t.world, u, a, force);
  const Real c = std::cos(p - q), s = std::sin(p - q), k = m2 * l1 * l2;
  const Real of_p =
      ((m1 + m2) * l1 * l1 + inertia) * ddp + k * (ddq * c + dq * dq * s) + (m1 + m2) * kG * l1 * std::sin(p);
  const Real of_q = (m2 * l2 * l2 + inertia) * ddq + k * (ddp * c - dp * dp * s) + m2 * kG * l2 * std::sin(q);
  assert_true(std::fabs(force[0] - (of_p + of_q)) < 1e-13 && std::fabs(force[1] - of_q) < 1e-13);
}

/// A cart on a rail along x, a pole on it: x, and an angle q from upright about z.
///   F = (M + m) x'' - m l (q'' cos q - q'^2 sin q),   tau = (m l^2 + I) q'' - m l x'' cos q - m g l sin q
static void a_cart_with_a_pole(void**) {
  const Real cart = 3, m = 0.5, l = 0.8, inertia = 0.02, q = 0.4, dx = 1.1, dq = 2.3, ddx = -1.5, ddq = 0.7;
  TestWorld t;
  const std::uint32_t base = add_body(t, Vec3(2, 0, 0), cart, Vec3::constant(1)),
                      pole = add_body(t, Vec3(2, l, 0), m, Vec3::constant(inertia));
  join(t, JointKind::slider, kWorld, base, Vec3(0, 0, 0));
  join(t, JointKind::hinge, base, pole, Vec3(2, 0, 0), x_along(Vec3(0, 0, 1)));
  const Quat turned = exp_map(Vec3(0, 0, q));
  t.world.set_pose(pole, {turned, Vec3(2, 0, 0) + turned * Vec3(0, l, 0)});
  const JointTree tree = tree_of(t, base);
  const Real u[2] = {dx, dq}, a[2] = {ddx, ddq};
  Real force[2], mass[4];
  tree.find_forces(t.world, u, a, force), tree.find_mass(t.world, mass);
  const Real c = std::cos(q), s = std::sin(q);
  assert_true(std::fabs(force[0] - ((cart + m) * ddx - m * l * (ddq * c - dq * dq * s))) < 1e-14);
  assert_true(std::fabs(force[1] - ((m * l * l + inertia) * ddq - m * l * ddx * c - m * kG * l * s)) < 1e-14);
  assert_true(std::fabs(mass[0] - (cart + m)) < 1e-15 && std::fabs(mass[1] + m * l * c) < 1e-15);
}

/// A block on a radial rail of a table that a host turns at w: m (r'' - w^2 r) along the rail.
static void a_rail_on_a_table_that_turns(void**) {
  const Real m = 2, r = 1.5, w = 3;
  TestWorld t;
  const std::uint32_t table = add_body(t, Vec3(5, 0, 0), 1, Vec3::constant(1), BodyType::kinematic),
                      block = add_body(t, Vec3(5 + r, 0, 0), m, Vec3::constant(1));
  join(t, JointKind::slider, table, block, Vec3(5, 0, 0));
  t.world.set_velocity(table, Vec3(1, 0, 0), Vec3(0, w, 0));
  t.world.set_velocity(block, Vec3(1 + 0.25, 0, -w * r), Vec3(0, w, 0));
  const JointTree tree = tree_of(t, block);
  Real speed = 0, force = 0;
  const Real rate = 0.5;
  tree.read_speeds(t.world, &speed), tree.find_forces(t.world, &speed, &rate, &force);
  assert_true(std::fabs(speed - 0.25) < 1e-14 && std::fabs(force - m * (rate - w * w * r)) < 1e-13);
}

static TreeFault fault_of(const TestWorld& t, std::uint32_t body) {
  JointTree tree(std::pmr::new_delete_resource());
  return tree.find(t.world, body);
}

static void what_is_no_tree_is_refused(void**) {
  TestWorld t;
  std::vector<std::uint32_t> b;
  for (int i = 0; i < 4; ++i) b.push_back(add_body(t, Vec3(i, 0, 0), 1, Vec3::constant(1)));
  const std::uint32_t wall = add_body(t, Vec3(9, 0, 0), 1, Vec3::constant(1), BodyType::fixed);
  assert_true(fault_of(t, wall) == TreeFault::not_moved);
  assert_int_equal(tree_of(t, b[0]).size(), 6);
  for (std::size_t i = 0; i + 1 < b.size(); ++i) join(t, JointKind::hinge, b[i], b[i + 1], Vec3(Real(i) + 0.5, 0, 0));
  assert_int_equal(tree_of(t, b[2]).size(), 9);
  const std::uint32_t held = join(t, JointKind::weld, wall, b[3], Vec3(4, 0, 0));
  assert_int_equal(tree_of(t, b[0]).size(), 3);
  const std::uint32_t twice = join(t, JointKind::hinge, kWorld, b[0], Vec3(0, 0, 0));  // the wall and the world are one
  for (const std::uint32_t body : b) assert_true(fault_of(t, body) == TreeFault::loop);
  t.world.break_joint(twice);
  assert_int_equal(tree_of(t, b[1]).size(), 3);
  t.world.remove_joint(held);
  const std::uint32_t ring = join(t, JointKind::ball, b[3], b[0], Vec3(4, 0, 0));
  for (const std::uint32_t body : b) assert_true(fault_of(t, body) == TreeFault::loop);
  t.world.remove_joint(ring);
  const std::uint32_t beside = join(t, JointKind::hinge, b[0], b[1], Vec3(0.5, 1, 0));  // a second between the same two
  assert_true(fault_of(t, b[3]) == TreeFault::loop);
  t.world.remove_joint(beside);
  for (const JointKind kind : {JointKind::gear, JointKind::pulley, JointKind::distance}) {
    const std::uint32_t couples = join(t, kind, b[2], wall, Vec3(2, 0, 0));
    assert_true(fault_of(t, b[0]) == TreeFault::kind);
    t.world.remove_joint(couples);
  }
  t.world.set_enabled(b[1], false);  // what is disabled holds what hangs on it
  assert_true(fault_of(t, b[1]) == TreeFault::not_moved);
  assert_int_equal(tree_of(t, b[0]).size(), 1);
  assert_int_equal(tree_of(t, b[3]).size(), 2);
  t.world.set_enabled(b[1], true);
  AttributeValue locks{};
  locks[0] = 1;
  t.world.set_attribute(b[1], AttributeId::locks, locks);
  assert_true(fault_of(t, b[3]) == TreeFault::locked);
}

/// Where two axes agree, or a swing is at pi, there is no number that is none.
static void singular_poses_stay_finite(void**) {
  for (const Real swing : {0.0, 1e-9, 1e-4, 0.9999, 1.0, 3.14159, std::numbers::pi, 2 * std::numbers::pi})
    for (int free = 0; free < 8; ++free) {
      TestWorld t;
      const std::uint32_t body = add_body(t, Vec3(0, 0, 1), 2, Vec3(0.1, 0.2, 0.3));
      const std::uint32_t j = join_axes(t, kWorld, body, Vec3::zero(), Quat::identity());
      for (std::uint32_t k = 0; k < 3; ++k)
        if (!(free >> k & 1)) t.world.set_joint_axis(j, 3 + k, locked_at(k == 1 ? swing : 0));
      const Quat q = exp_map(Vec3(0, swing, 0));
      t.world.set_pose(body, {q, q * Vec3(0, 0, 1)});
      t.world.set_velocity(body, Vec3(1, 2, 3), Vec3(3, 2, 1));
      const JointTree tree = tree_of(t, body);
      const std::size_t n = tree.size();
      std::vector<Real> u(n), a(n, 1), f(n), mass(n * n);
      tree.read_speeds(t.world, u.data()), tree.find_forces(t.world, u.data(), a.data(), f.data());
      tree.find_mass(t.world, mass.data());
      for (const std::vector<Real>& v : {u, f, mass})
        for (const Real x : v) assert_true(std::isfinite(x));
    }
}

/// An arm some of whose links have their gravity compensated needs what the others weigh, and stands still with that.
static void compensated_gravity_needs_no_force(void**) {
  for (const Real share : {0.0, 0.4, 1.0, 1.5}) {
    TestWorld t;
    t.world.set_dial(Dial::solver, kDirectChoice);
    const std::uint32_t upper = add_body(t, Vec3(0.5, 0, 0), 2, Vec3::constant(0.2)),
                        lower = add_body(t, Vec3(1.5, 0, 0), 3, Vec3::constant(0.3));
    const Quat about_z = x_along(Vec3(0, 0, 1));
    const std::uint32_t shoulder = join(t, JointKind::hinge, kWorld, upper, Vec3::zero(), about_z),
                        elbow = join(t, JointKind::hinge, upper, lower, Vec3(1, 0, 0), about_z);
    t.world.set_attribute(lower, AttributeId::gravity_factor, {1 - share});
    JointTree tree(std::pmr::new_delete_resource());
    assert_true(tree.find(t.world, upper) == TreeFault::none);
    const Real still[2] = {0, 0};
    Real force[2];
    tree.find_forces(t.world, still, still, force);
    const Real weight = (1 - share) * 3 * kG;
    assert_true(std::fabs(force[0] - (2 * kG * 0.5 + weight * 1.5)) < 1e-12);
    assert_true(std::fabs(force[1] - weight * 0.5) < 1e-12);
    const std::uint32_t joints[] = {shoulder, elbow};
    for (int i = 0; i < 60; ++i) {
      for (const int k : {0, 1})
        set_motor(t, joints[k], Coordinate::twist, force[k] < 0 ? -1e6 : 1e6, std::fabs(force[k]));
      t.world.step(1.0 / 60);
    }
    for (const std::uint32_t j : joints) assert_true(std::fabs(coordinate(t, j, Coordinate::twist)) < 1e-6);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(forces_are_newtons_and_eulers),
      cmocka_unit_test(energy_is_that_of_the_bodies),
      cmocka_unit_test(a_pendulum),
      cmocka_unit_test(a_double_pendulum),
      cmocka_unit_test(a_cart_with_a_pole),
      cmocka_unit_test(a_rail_on_a_table_that_turns),
      cmocka_unit_test(what_is_no_tree_is_refused),
      cmocka_unit_test(singular_poses_stay_finite),
      cmocka_unit_test(compensated_gravity_needs_no_force),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
