// Six-axis joints against closed forms, under every solver that knows joints: springs, locks, stops, drives of one axis.
#include <algorithm>

#include "carom_test.h"
#include "dynamics/solver/direct.h"
#include "six_axes.h"

using namespace carom;
using namespace carom::test;

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
  const std::uint32_t j = join_axes(t, kInvalid, body, Vec3::zero());
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

/// A weight with an arm, held at an offset by all six: it stays there, and the joint bears its weight and the weight's moment.
/// What is soft gives way by less than the weight would fall in a substep, at the arm's end.
static void a_lock_at_an_offset_bears_the_weight(void**) {
  for (const int solver : kEverySolver)
    for (const bool by_limits : {false, true}) {
      TestWorld t;
      choose(t, solver);
      const Real m = 2;
      const Vec3 arm(0.5, 0, 0.2);  // of the weight, from the frame
      const Pose frame_a{kOblique, Vec3(1, 2, 3)}, there = frame_a * at_axes(kOffset);
      const std::uint32_t body =
          add_body(t, there.p + there.q * arm, m, Vec3(0.1, 0.2, 0.3), BodyType::dynamic, there.q);
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
  const std::uint32_t j = handle_slot(t.world.add_joint(def));
  // The frame on B stands off its centre: locked places are where it is now.
  const auto now = axes_told(ends_of(t.world, joint(t, j).def));
  for (std::uint32_t k = 0; k < kAxes; ++k)
    if (mask >> k & 1) t.world.set_joint_axis(j, k, locked_at(now[k]));
  t.world.set_velocity(body, Vec3::zero(), Vec3(0.4, -0.6, 0.5));
  Real worst = 0;
  for (int i = 0; i < 30; ++i) t.world.step(kStep), worst = std::max(worst, off_joint(t, j));
  return worst;
}
static void any_axes_are_locked_at_any_offset(void**) {
  for (const int solver : kEverySolver) {
    Real ratio = 100;
    for (unsigned mask = 0; mask < 64; ++mask) {
      const Real coarse = spin_locked(solver, 4, mask), fine = spin_locked(solver, 8, mask);
      if (is_direct(solver)) {
        assert_true(coarse < 2e-9 && fine < 2e-9);
      } else if (coarse > 1e-9) {
        ratio = std::min(ratio, coarse / fine);
      }
    }
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
  const auto vector = [&] { return Vec3{random(), random(), random()}; };
  Real worst = 0;
  for (int i = 0; i < 200; ++i) {
    TestWorld t(Vec3::zero());
    choose(t, kSoftChoice, 1);
    leave_joints_to_solver(t);
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
    const auto before = axes_told(ends_of(t.world, def));
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
      return axes_told(ends_of(t.world, def));
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
    j = join_axes(t, kInvalid, body, Vec3::zero());
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

/// Against a hard stop a weight comes to rest: there to what is soft of a joint, and the stop bears it. A soft stop gives way
/// by load over stiffness, in whatever the stiffness is told.
static void stops_bear_a_weight(void**) {
  const Real g = -4;
  for (const int solver : kEverySolver)
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
      JointAxis hard;
      hard.mode = AxisMode::limited, hard.lower = -0.5, hard.upper = 0.7;
      Cart cart(solver, 4, k, g, hard);
      cart.run(240);
      const Real h = kStep / 4;
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
        assert_true(std::fabs(other.x() + 0.5 - gives[i]) < 1e-9);
        assert_true(std::fabs(other.force() + Cart::kMass * g) < 1e-12 + other.borne);
      }
    }
}

/// A drive to a velocity holds it under load, and moves on with what it cannot bear; one by effort pushes as it says; what is
/// uniform errs by rounding.
static void drives_push_as_hard_as_they_may(void**) {
  const int steps = 60, substeps = 4;
  const Real g = -3, m = Cart::kMass, time = steps * kStep, rounding = 16 * steps * substeps * kUnitRoundoff;
  for (const int solver : kEverySolver)
    for (std::uint32_t k = 0; k < kPlaces; ++k) {
      JointAxis a;
      a.drive = AxisDrive::velocity, a.speed = 1.5, a.max_force = 20;
      Cart strong(solver, substeps, k, g, a);
      strong.run(steps);
      a.max_force = 4;
      Cart weak(solver, substeps, k, g, a);
      weak.run(steps);
      a.drive = AxisDrive::effort, a.effort = 9, a.max_force = kInfinity;
      Cart pushed(solver, substeps, k, g, a);
      pushed.run(steps);
      a.effort = -9, a.max_force = 5;
      Cart bounded(solver, substeps, k, 0, a);
      bounded.run(steps);
      assert_true(std::fabs(strong.v() - 1.5) <= 3 * rounding + strong.answered);
      assert_true(std::fabs(strong.force() + m * g) <= m / kStep * substeps * (3 * rounding + strong.answered));
      assert_true(std::fabs(weak.v() - (g + 4 / m) * time) <= 3 * rounding);
      assert_true(std::fabs(pushed.v() - (g + 9 / m) * time) <= 3 * rounding);
      assert_true(std::fabs(bounded.v() + 5 / m * time) <= 3 * rounding);
    }
}

/// A drive to a position sags by load over stiffness; its target may move, and is followed at its speed with the same sag; a
/// spring beside it shares the load.
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
    assert_true(std::fabs(moving.v() - 0.5) < 0.5 * k / m * kStep * kStep);
    assert_true(std::fabs(moving.x() - 0.5 * 300 * kStep - m * g / k) < 0.5 * kStep);
    a = JointAxis{};
    a.drive = AxisDrive::position, a.gains = {Gains::acceleration, 0, 30}, a.speed = 2;
    Cart soft(solver, 4, 2, g, a);  // soft in velocity: 30 (2 - v) = -g
    soft.run(300);
    assert_true(std::fabs(soft.v() - (2 + g / 30) - g * kStep / 8) < 1e-9);
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
  };
  return cmocka_run_group_tests_name("oracle/six_axis", tests, nullptr, nullptr);
}
