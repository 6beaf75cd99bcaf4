// Six-axis joints and drives to an orientation against closed forms, under every solver that knows joints.
#include <algorithm>

#include "carom_test.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/solver/direct.h"
#include "joint_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kEverySolver[] = {kSequentialChoice, kSoftChoice, kDirectChoice, kAutoChoice};
constexpr Real kStep = 1.0 / 60;
const Quat kOblique = normalized(Quat(0.7, 0.3, -0.5, 0.4));

std::uint32_t join_axes(TestWorld& t, std::uint32_t a, std::uint32_t b, const Vec3& at, const Quat& axes = kOblique) {
  return join(t, JointKind::six_axis, a, b, at, axes);
}
JointAxis locked_at(Real offset = 0) {
  JointAxis a;
  a.mode = AxisMode::locked, a.lower = offset;
  return a;
}
void set_all(TestWorld& t, std::uint32_t j, std::uint32_t but, const JointAxis& axis, bool places = true, bool turns = true) {
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (k != but && (k < kPlaces ? places : turns)) t.world.set_joint_axis(j, k, axis);
}
Real axis_of(const TestWorld& t, std::uint32_t j, std::uint32_t k) {
  return axes_at(place_of(t.world, joint(t, j)))[k];
}
bool is_direct(int solver) { return solver >= kDirectChoice; }
Real off_joint(const TestWorld& t, std::uint32_t j) {
  const JointPlace p = place_of(t.world, joint(t, j));
  return std::max(p.gap, p.angle);
}

}  // namespace

/// A weight on a spring in N/m with a damper in N s/m, along an oblique axis, let go 0.3 m from rest:
/// x = x0 exp(-b t) (cos w t + b / w sin w t), b = c / 2 m, w^2 = k / m - b^2. The method is of first order: it starts half a
/// substep off, w0 h / 2 of the amplitude, and fades slower by b h of its rate.
static Real oscillate(int solver, int substeps, bool alone, std::uint32_t axis) {
  const Real m = 3, k = 300, c = 4, x0 = 0.3;
  TestWorld t(Vec3::zero());
  choose(t, solver, substeps);
  const bool turns = axis >= kPlaces;
  const Vec3 along = kOblique * (axis % 3 == 0 ? Vec3(1, 0, 0) : axis % 3 == 1 ? Vec3(0, 1, 0) : Vec3(0, 0, 1));
  const std::uint32_t body = add_body(t, Vec3::zero(), m, Vec3::constant(m));
  const std::uint32_t j = join_axes(t, kTheWorld, body, Vec3::zero());
  JointAxis pulled;
  pulled.spring = {Gains::force, k, c};
  t.world.set_joint_axis(j, axis, pulled);
  if (!alone) set_all(t, j, axis, locked_at());
  if (turns)
    t.world.set_pose(body, {exp_map(x0 * along), Vec3::zero()});
  else
    t.world.set_pose(body, {Quat::identity(), x0 * along});
  const Real b = c / (2 * m), w = std::sqrt(k / m - b * b);
  Real worst = 0;
  for (int i = 1; i <= 60; ++i) {
    t.world.step(kStep);
    const Real time = i * kStep;
    const Real expected = x0 * std::exp(-b * time) * (std::cos(w * time) + b / w * std::sin(w * time));
    worst = std::max(worst, std::fabs(axis_of(t, j, axis) - expected));
  }
  return worst / x0;
}
static void a_spring_in_newtons_a_metre_fades_as_it_should(void**) {
  for (const int solver : kEverySolver)
    for (const bool alone : {false, true})
      for (std::uint32_t axis = 0; axis < kAxes; ++axis) {
        const Real coarse = oscillate(solver, 4, alone, axis), fine = oscillate(solver, 8, alone, axis);
        const Real w0 = 10, b = 2.0 / 3, h = kStep / 4;
        if (std::getenv("SHOW")) std::printf("osc %d %d %u: %g %g (%g)\n", solver, alone, axis, coarse, fine, w0 * h / 2);
        assert_true(coarse < 1.1 * (w0 * h / 2 + b * h));
        assert_true(fine < coarse / 1.9);
      }
}

namespace {

constexpr Real kOffset[kAxes] = {0.3, -0.2, 0.1, 0.4, 0.5, -0.6};
/// Where B's frame is in A's at given coordinates.
Pose at_axes(const Real (&x)[kAxes]) {
  return {exp_map(Vec3(0, x[4], x[5])) * exp_map(Vec3(x[3], 0, 0)), Vec3(x[0], x[1], x[2])};
}

}  // namespace

/// A weight with an arm, held at an offset by all six: it stays there, and the joint bears its weight and the weight's moment. What is
/// soft gives way by less than the weight would fall in a substep, at the arm's end.
static void a_lock_at_an_offset_bears_the_weight(void**) {
  for (const int solver : kEverySolver)
    for (const bool by_limits : {false, true}) {
      TestWorld t;
      choose(t, solver);
      const Real m = 2;
      const Vec3 arm(0.5, 0, 0.2);  // of the weight, from the frame
      const Pose frame_a{kOblique, Vec3(1, 2, 3)}, there = frame_a * at_axes(kOffset);
      const std::uint32_t body = add_body(t, there.p + there.q * arm, m, Vec3(0.1, 0.2, 0.3), BodyType::dynamic, there.q);
      JointDef def;
      def.kind = JointKind::six_axis;
      def.body_b = body, def.frame_a = frame_a, def.frame_b.p = -arm;
      const std::uint32_t j = handle_slot(t.world.add_joint(def));
      for (std::uint32_t k = 0; k < kAxes; ++k) {
        JointAxis a = locked_at(kOffset[k]);
        if (by_limits) a.mode = AxisMode::limited, a.upper = a.lower;
        t.world.set_joint_axis(j, k, a);
      }
      assert_true(off_joint(t, j) < 1e-15);
      const Real h = kStep / 4;
      Real worst = 0;
      for (int i = 0; i < 120; ++i) t.world.step(kStep), worst = std::max(worst, off_joint(t, j));
      const Vec3 weight(0, -m * kG, 0), r = t.world.state.q[body] * arm;
      const Vec3 force = joint(t, j).force + weight, torque = joint(t, j).torque + r.cross(weight);
      if (std::getenv("SHOW")) std::printf("lock %d %d: off %g, force %g torque %g\n", solver, by_limits, worst, force.norm(), torque.norm());
      assert_true(worst <= (is_direct(solver) ? 2e-9 : 5 * kG * h * h));
      assert_true(force.norm() < 1e-9 * weight.norm() && torque.norm() < 1e-9 * weight.norm());
    }
}

/// Any of the 64 sets of axes is locked at offsets while a body spins and flies: what is locked errs by the second order in the
/// substep where it is soft, and by 2e-9 where it is answered directly.
static Real spin_locked(int solver, int substeps, unsigned mask) {
  TestWorld t;
  choose(t, solver, substeps);
  const Pose frame_a{kOblique, Vec3::zero()}, there = frame_a * at_axes(kOffset);
  const std::uint32_t body = add_body(t, there.p, 2, Vec3(0.2, 0.3, 0.4), BodyType::dynamic, there.q);
  JointDef def;
  def.kind = JointKind::six_axis;
  def.body_b = body, def.frame_a = frame_a, def.frame_b.p = Vec3(0.05, -0.1, 0.1);
  def.frame_a.p = frame_a.p + frame_a.q * Vec3::zero();
  const std::uint32_t j = handle_slot(t.world.add_joint(def));
  // The frame on B stands off its centre: locked places are where it is now.
  const auto now = axes_at(ends_of(t.world, joint(t, j).def));
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (mask >> k & 1) t.world.set_joint_axis(j, k, locked_at(now[k]));
  t.world.set_velocity(body, Vec3::zero(), Vec3(0.4, -0.6, 0.5));
  Real worst = 0;
  for (int i = 0; i < 30; ++i) t.world.step(kStep), worst = std::max(worst, off_joint(t, j));
  return worst;
}
static void any_axes_are_locked_at_any_offset(void**) {
  for (const int solver : kEverySolver) {
    Real most = 0, ratio = 100;
    for (unsigned mask = 0; mask < 64; ++mask) {
      const Real coarse = spin_locked(solver, 4, mask), fine = spin_locked(solver, 8, mask);
      if (is_direct(solver)) {
        assert_true(coarse < 2e-9 && fine < 2e-9);
      } else if (coarse > 1e-9) {
        ratio = std::min(ratio, coarse / fine);
        if (std::getenv("SHOW") && coarse / fine < 3.2) std::printf("mask %u: %g %g\n", mask, coarse, fine);
      }
      most = std::max(most, coarse);
    }
    if (std::getenv("SHOW")) std::printf("masks %d: %g, ratio %g\n", solver, most, ratio);
    assert_true(is_direct(solver) || ratio > 3.2);
  }
}

/// Rows are rates of the coordinates, wherever bodies are.
static void rows_are_rates_of_axes(void**) {
  std::uint32_t seed = 11;
  const auto random = [&] {
    seed = seed * 1664525u + 1013904223u;
    return Real(seed >> 8) / (1 << 23) - 1;
  };
  const auto vector = [&] { return Vec3(random(), random(), random()); };
  Real worst = 0;
  for (int i = 0; i < 200; ++i) {
    TestWorld t(Vec3::zero());
    choose(t, kSoftChoice, 1);
    const auto place = [&] { return normalized(Quat(random(), random(), random(), random())); };
    const std::uint32_t a = add_body(t, vector(), 1, Vec3(1, 2, 3), BodyType::dynamic, place()),
                        b = add_body(t, vector(), 2, Vec3(2, 3, 1), BodyType::dynamic, place());
    JointDef def;
    def.kind = JointKind::six_axis;
    def.body_a = a, def.body_b = b;
    def.frame_a = {place(), vector()}, def.frame_b = {place(), vector()};
    const std::uint32_t j = handle_slot(t.world.add_joint(def));
    JointAxis pulled;
    pulled.spring = {Gains::force, 1e-9, 0};
    const auto before = axes_at(ends_of(t.world, def));
    if (before[4] * before[4] + before[5] * before[5] > 9 || std::fabs(before[3]) > 3) continue;  // near a swing of pi
    if (i % 2)
      set_all(t, j, kAxes, pulled);
    else
      for (std::uint32_t k = 0; k < kAxes; ++k) t.world.set_joint_axis(j, k, k % 2 ? locked_at(before[k]) : pulled);
    t.world.step(1e-9);  // makes rows
    const WideJoints& w = *t.world.wide_joints;
    const auto of = [](const LaneVec& v) { return Vec3(v.x[0], v.y[0], v.z[0]); };
    const Vec3 va = vector(), wa = vector(), vb = vector(), wb = vector();
    const Pose pa = t.world.pose(a), pb = t.world.pose(b);
    const Real e = 1e-5;
    const auto at = [&](Real time) {
      const auto moved = [&](const Pose& p, const Vec3& v, const Vec3& turn) {
        return Pose{normalized(exp_map(time * turn) * p.q), p.p + time * v};
      };
      t.world.set_pose(a, moved(pa, va, wa)), t.world.set_pose(b, moved(pb, vb, wb));
      return axes_at(ends_of(t.world, def));
    };
    const auto after = at(e), first = at(-e);
    int locks = 0, drives = 0;
    for (std::uint32_t k = 0; k < kAxes; ++k) {
      const bool is_lock = i % 2 == 0 && k % 2;
      const JointRowLanes& row = is_lock ? w.rows[locks++] : w.drives[drives++].row;
      const Real rate = of(row.d).dot(vb - va) + of(row.w_b).dot(wb) - of(row.w_a).dot(wa);
      const Real off = std::fabs((after[k] - first[k]) / (2 * e) - rate);
      worst = std::max(worst, off / (1 + std::fabs(rate)));
      assert_true(off < 1e-6 * (1 + std::fabs(rate)));
      assert_true(std::fabs(row.error[0] - (is_lock ? 0 : before[k])) < 1e-8);
    }
  }
  if (std::getenv("SHOW")) std::printf("rates: %g\n", worst);
}

namespace {

/// A cart that slides along the oblique axis k and is pulled along it.
struct Cart {
  static constexpr Real kMass = 2;
  TestWorld t;
  std::uint32_t body, j, axis;
  Vec3 along;
  Real answered = 0, borne = 0;  // m/s, N: to which the direct solver answers
  /// @param gravity  m/s^2, along the axis
  Cart(int solver, int substeps, std::uint32_t k, Real gravity, const JointAxis& how)
      : t(gravity * (kOblique * unit(k))), axis(k), along(kOblique * unit(k)) {
    choose(t, solver, substeps);
    t.world.set_dial(Dial::velocity_tolerance, 1e-9);
    if (is_direct(solver)) answered = 1e-9 * kDirectShare, borne = kMass * answered * substeps / kStep;
    body = add_body(t, Vec3::zero(), kMass, Vec3::constant(1));
    j = join_axes(t, kTheWorld, body, Vec3::zero());
    set_all(t, j, k, locked_at());
    t.world.set_joint_axis(j, k, how);
  }
  static Vec3 unit(std::uint32_t k) { return k == 0 ? Vec3(1, 0, 0) : k == 1 ? Vec3(0, 1, 0) : Vec3(0, 0, 1); }
  void run(int steps) { t.run(steps, kStep); }
  Real x() const { return axis_of(t, j, axis); }
  Real v() const { return along.dot(t.world.state.v[body]); }
  Real force() const { return along.dot(joint(t, j).force); }
};

}  // namespace

/// Against a hard stop a weight comes to rest: there to what is soft of a joint, and the stop bears it. A soft stop gives way by load
/// over stiffness, in whatever the stiffness is told.
static void stops_bear_a_weight(void**) {
  const Real g = -4;
  for (const int solver : kEverySolver)
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
      JointAxis hard;
      hard.mode = AxisMode::limited, hard.lower = -0.5, hard.upper = 0.7;
      Cart cart(solver, 4, k, g, hard);
      cart.run(240);
      const Real h = kStep / 4;
      if (std::getenv("SHOW")) std::printf("hard %d %u: x %g f %g\n", solver, k, cart.x() + 0.5, cart.force() + Cart::kMass * g);
      assert_true(std::fabs(cart.x() + 0.5) <= (is_direct(solver) ? 2e-9 : -g * h * h));
      assert_true(std::fabs(cart.force() + Cart::kMass * g) < 1e-12 + cart.borne);
      const Real w = 2 * 3.14159265358979323846 * 3;
      const AxisPull pulls[] = {{Gains::force, 250, 20}, {Gains::frequency, 3, 0.7}, {Gains::acceleration, 125, 10}};
      const Real gives[] = {Cart::kMass * g / 250, g / (w * w), g / 125};
      for (int i = 0; i < 3; ++i) {
        JointAxis soft = hard;
        soft.stop = pulls[i];
        Cart other(solver, 4, k, g, soft);
        other.run(600);
        if (std::getenv("SHOW")) std::printf("soft %d: x %g\n", i, other.x() + 0.5 - gives[i]);
        assert_true(std::fabs(other.x() + 0.5 - gives[i]) < 1e-9);
        assert_true(std::fabs(other.force() + Cart::kMass * g) < 1e-12 + other.borne);
      }
    }
}

/// A drive to a velocity holds it under load, and moves on with what it cannot bear; one by effort pushes as it says; what is uniform
/// errs by rounding.
static void drives_push_as_hard_as_they_may(void**) {
  const int steps = 60, substeps = 4;
  const Real g = -3, m = Cart::kMass, time = steps * kStep, rounding = 16 * steps * substeps * kUnitRoundoff;
  for (const int solver : kEverySolver)
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
      JointAxis a;
      a.drive = AxisDrive::velocity, a.speed = 1.5, a.most = 20;
      Cart strong(solver, substeps, k, g, a);
      strong.run(steps);
      a.most = 4;
      Cart weak(solver, substeps, k, g, a);
      weak.run(steps);
      a.drive = AxisDrive::effort, a.effort = 9, a.most = kInfinity;
      Cart pushed(solver, substeps, k, g, a);
      pushed.run(steps);
      a.effort = -9, a.most = 5;
      Cart bounded(solver, substeps, k, 0, a);
      bounded.run(steps);
      if (std::getenv("SHOW"))
        std::printf("drives %d %u: %g force %g; %g %g %g\n", solver, k, strong.v() - 1.5, strong.force() + m * g, weak.v() - (g + 4 / m) * time,
                    pushed.v() - (g + 9 / m) * time, bounded.v() + 5 / m * time);
      // Directly, and by springs under any solver, what is answered is the velocity of the middle of a substep; half of the load
      // comes after that.
      const Real late = is_direct(solver) ? g * kStep / substeps / 2 : 0;
      assert_true(std::fabs(strong.v() - 1.5 - late) <= 3 * rounding + strong.answered);
      assert_true(std::fabs(strong.force() + m * g) <= m / kStep * substeps * (3 * rounding + strong.answered));
      assert_true(std::fabs(weak.v() - (g + 4 / m) * time) <= 3 * rounding);
      assert_true(std::fabs(pushed.v() - (g + 9 / m) * time) <= 3 * rounding);
      assert_true(std::fabs(bounded.v() + 5 / m * time) <= 3 * rounding);
    }
}

/// A drive to a position sags by load over stiffness; its target may move, and is followed at its speed with the same sag; a spring beside
/// it shares the load.
static void drives_hold_a_position(void**) {
  const Real g = -3, m = Cart::kMass, k = 400, c = 60;
  for (const int solver : kEverySolver) {
    JointAxis a;
    a.drive = AxisDrive::position, a.gains = {Gains::force, k, c}, a.target = 0.4;
    Cart still(solver, 4, 1, g, a);
    still.run(300);
    assert_true(std::fabs(still.x() - 0.4 - m * g / k) < 1e-9);
    a.spring = {Gains::force, 100, 0}, a.rest = -0.2;
    Cart shared(solver, 4, 1, g, a);
    shared.run(300);
    const Real rests = (k * 0.4 + 100 * -0.2 + m * g) / (k + 100);
    assert_true(std::fabs(shared.x() - rests) < 1e-9);
    a.spring = {}, a.speed = 0.5;
    Cart moving(solver, 4, 1, g, a);
    // A target that moves by steps of the host's.
    for (int i = 0; i < 300; ++i) {
      a.target = 0.5 * i * kStep;
      moving.t.world.set_joint_axis(moving.j, 1, a);
      moving.run(1);
    }
    // Within a step the target stands: half a step's way behind on the mean, k / (k + ...) of it.
    if (std::getenv("SHOW"))
      std::printf("hold %d: %g %g moving %g v %g\n", solver, still.x() - 0.4 - m * g / k, shared.x() - rests,
                  moving.x() - 0.5 * 300 * kStep - m * g / k, moving.v() - 0.5);
    assert_true(std::fabs(moving.v() - 0.5) < 0.5 * k / m * kStep * kStep);
    assert_true(std::fabs(moving.x() - 0.5 * 300 * kStep - m * g / k) < 0.5 * kStep);
    a = JointAxis{};
    a.drive = AxisDrive::position, a.gains = {Gains::acceleration, 0, 30}, a.speed = 2;
    Cart soft(solver, 4, 2, g, a);  // soft in velocity: 30 (2 - v) = -g
    soft.run(300);
    assert_true(std::fabs(soft.v() - (2 + g / 30) - g * kStep / 8) < 1e-9);
  }
}

namespace {

struct Turned {
  Real off, across, spin;
};
/// A ball of isotropic inertia, turned by an angle about an oblique axis from its target and let go: critically damped it comes back
/// along that axis by angle (1 + w t) exp(-w t).
Turned turn_back(int solver, int substeps, JointKind kind, Real angle, bool two) {
  const Real inertia = 0.4, hertz = 1.2, w = 2 * 3.14159265358979323846 * hertz;
  TestWorld t(Vec3::zero());
  choose(t, solver, substeps);
  const Vec3 axis = Vec3(0.48, -0.6, 0.64);
  const Quat target = normalized(Quat(0.5, 0.5, -0.3, 0.6));
  const std::uint32_t base = two ? add_body(t, Vec3(0, 1, 0), 3, Vec3::constant(1.2)) : kTheWorld;
  const std::uint32_t body = add_body(t, Vec3::zero(), 3, Vec3::constant(inertia));
  const std::uint32_t j = join(t, kind, base, body, Vec3::zero(), kOblique);
  if (kind == JointKind::six_axis && !two) set_all(t, j, kAxes, locked_at(), true, false);
  if (two && kind == JointKind::six_axis) set_all(t, j, kAxes, JointAxis{}, true, false);
  TurnDrive d;
  d.mode = AxisDrive::position, d.target = target, d.gains = {Gains::frequency, hertz, 1};
  t.world.set_joint_turn(j, d);
  // B's frame in A's is exp(angle axis) target; frames stand alike in the bodies.
  const Quat q = exp_map(angle * axis) * target;
  t.world.set_pose(body, {normalized(kOblique * q * kOblique.conjugate()), Vec3::zero()});
  Turned worst = {0, 0, 0};
  for (int i = 1; i <= 60; ++i) {
    t.world.step(kStep);
    const JointEnds ends = ends_of(t.world, joint(t, j).def);
    const Quat off = (ends.a.q.conjugate() * ends.b.q) * target.conjugate();
    const Real sign = off.w() < 0 ? -1 : 1, left = 2 * std::atan2(off.vec().norm(), sign * off.w());
    const Real time = i * kStep, expected = angle * (1 + w * time) * std::exp(-w * time);
    worst.off = std::max(worst.off, std::fabs(left - expected));
    worst.across = std::max(worst.across, (sign * off.vec().cross(axis)).norm());
  }
  return worst;
}

}  // namespace

static void a_ball_turns_back_by_the_shortest_way(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : {JointKind::ball, JointKind::six_axis})
      for (const Real angle : {0.6, 2.5}) {
        const Turned coarse = turn_back(solver, 4, kind, angle, false), fine = turn_back(solver, 8, kind, angle, false);
        const Real w = 2 * 3.14159265358979323846 * 1.2, h = kStep / 4;
        if (std::getenv("SHOW"))
          std::printf("turn %d %d %g: %g %g across %g (wh %g)\n", solver, int(kind), angle, coarse.off, fine.off, coarse.across, w * h);
        assert_true(coarse.off < angle * w * h && fine.off < coarse.off / 1.9);
        assert_true(coarse.across < 1e-12 && fine.across < 1e-12);
      }
}

/// The same between two bodies that fly: gains per mass know what both weigh together.
static void two_bodies_turn_to_each_other(void**) {
  for (const int solver : kEverySolver) {
    const Turned coarse = turn_back(solver, 4, JointKind::six_axis, 2.5, true),
                 fine = turn_back(solver, 8, JointKind::six_axis, 2.5, true);
    const Real w = 2 * 3.14159265358979323846 * 1.2, h = kStep / 4;
    if (std::getenv("SHOW")) std::printf("two %d: %g %g across %g\n", solver, coarse.off, fine.off, coarse.across);
    assert_true(coarse.off < 2.5 * w * h && fine.off < coarse.off / 1.9 && coarse.across < 1e-12);
  }
}

/// A ball driven at an angular velocity about an oblique axis gets there, as fast as its torque about each axis allows; by effort it speeds
/// up as of torque over inertia.
static void a_ball_is_driven_about_three_axes(void**) {
  const Real inertia = 0.5;
  const int steps = 60, substeps = 4;
  for (const int solver : kEverySolver)
    for (const AxisDrive mode : {AxisDrive::velocity, AxisDrive::effort}) {
      TestWorld t(Vec3::zero());
      choose(t, solver, substeps);
      const std::uint32_t body = add_body(t, Vec3::zero(), 2, Vec3::constant(inertia));
      const std::uint32_t j = join(t, JointKind::ball, kTheWorld, body, Vec3::zero(), kOblique);
      TurnDrive d;
      d.mode = mode;
      d.velocity = {0.7, -3, 1.1}, d.effort = {0.2, -0.4, 0.3};
      d.most = mode == AxisDrive::velocity ? Vec3(1, 0.6, 1) : Vec3(1, 1, 0.1);
      t.world.set_joint_turn(j, d);
      t.run(steps, kStep);
      const Real time = steps * kStep;
      const Vec3 omega = kOblique.conjugate() * t.world.state.omega[body];
      const Vec3 expected = mode == AxisDrive::velocity ? Vec3(0.7, -0.6 / inertia * time, 1.1)
                                                        : time / inertia * Vec3(0.2, -0.4, 0.1);
      if (std::getenv("SHOW")) std::printf("ball %d %d: %g\n", solver, int(mode), (omega - expected).norm());
      assert_true((omega - expected).norm() < 16 * steps * substeps * kUnitRoundoff * 3);
    }
}

namespace {

/// Where a body on a joint of a kind, or on a six-axis joint that is set up as one, ends.
std::array<Pose, 2> end_of(int solver, int substeps, JointKind kind, bool as_axes, int drive) {
  TestWorld t;
  choose(t, solver, substeps);
  const std::uint32_t a = add_body(t, Vec3::zero(), 4, Vec3(0.5, 0.6, 0.7)), b = add_body(t, Vec3(1, 0.2, 0), 2, Vec3(0.2, 0.3, 0.35));
  join(t, JointKind::ball, kTheWorld, a, Vec3(-0.5, 0, 0));
  const std::uint32_t j = join(t, as_axes ? JointKind::six_axis : kind, a, b, Vec3(0.5, 0, 0), kOblique);
  const bool turns = kind == JointKind::hinge || kind == JointKind::ball, slides = kind == JointKind::slider;
  if (as_axes) {
    set_all(t, j, slides ? 0 : kAxes, locked_at(), true, false);
    if (kind != JointKind::ball) set_all(t, j, turns ? 3 : kAxes, locked_at(), false, true);
  }
  const Coordinate c = slides ? Coordinate::slide : Coordinate::twist;
  JointAxis axis;
  if (drive == 1) axis.spring = {Gains::frequency, 2, 0.3}, axis.rest = 0.2;
  if (drive == 2) axis.drive = AxisDrive::velocity, axis.speed = 1, axis.most = 6;
  if (drive == 3) axis.mode = AxisMode::limited, axis.lower = -0.1, axis.upper = 0.15;
  if (as_axes && drive) t.world.set_joint_axis(j, slides ? 0 : 3, axis);
  if (!as_axes && drive == 1) set_spring(t, j, c, 0.2, 2, 0.3);
  if (!as_axes && drive == 2) set_motor(t, j, c, 1, 6);
  if (!as_axes && drive == 3) set_limit(t, j, c, -0.1, 0.15);
  t.run(30, kStep);
  return {t.world.pose(a), t.world.pose(b)};
}

}  // namespace

static Real unlike(int solver, int substeps, JointKind kind, int drive) {
  const auto one = end_of(solver, substeps, kind, false, drive), other = end_of(solver, substeps, kind, true, drive);
  Real most = 0;
  for (int i = 0; i < 2; ++i)
    most = std::max({most, (one[i].p - other[i].p).norm(), (one[i].q - other[i].q).norm()});
  return most;
}

/// Set up as a hinge, slider, weld or ball it is one: the same rows, to rounding. With a spring, a motor or a limit likewise where it is
/// answered directly; where it is swept, six-axis joints hold their locks before drives, too, and the two meet as substeps get small (but when a limit is hit is not smooth in them).
static void axes_are_the_other_kinds(void**) {
  for (const int solver : kEverySolver)
    for (const JointKind kind : {JointKind::ball, JointKind::hinge, JointKind::slider, JointKind::weld})
      for (int drive = 0; drive < (kind == JointKind::weld ? 1 : 4); ++drive) {
        const Real off = unlike(solver, 4, kind, drive);
        const bool swept = drive && !is_direct(solver);
        if (std::getenv("SHOW"))
          std::printf("as %d kind %d drive %d: %g %g\n", solver, int(kind), drive, off, swept ? unlike(solver, 8, kind, drive) : 0);
        if (!swept)
          assert_true(off < 1e-12);
        else
          assert_true(off < 2e-3 && (drive == 3 || unlike(solver, 32, kind, drive) < off / 4));
      }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_spring_in_newtons_a_metre_fades_as_it_should),
      cmocka_unit_test(a_lock_at_an_offset_bears_the_weight),
      cmocka_unit_test(any_axes_are_locked_at_any_offset),
      cmocka_unit_test(rows_are_rates_of_axes),
      cmocka_unit_test(stops_bear_a_weight),
      cmocka_unit_test(drives_push_as_hard_as_they_may),
      cmocka_unit_test(drives_hold_a_position),
      cmocka_unit_test(a_ball_turns_back_by_the_shortest_way),
      cmocka_unit_test(two_bodies_turn_to_each_other),
      cmocka_unit_test(a_ball_is_driven_about_three_axes),
      cmocka_unit_test(axes_are_the_other_kinds),
  };
  return cmocka_run_group_tests_name("oracle/six_axis", tests, nullptr, nullptr);
}
