// Angles of joints count whole turns: stops, springs, gears and readings beyond half a turn, under every solver.
#include <algorithm>
#include <numbers>
#include <vector>

#include "carom_test.h"
#include "dynamics/snapshot/snapshot.h"
#include "six_axes.h"
#include "sliced.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = std::numbers::pi;
/// rad: what a stop may be passed by. The direct solver leads errors back to 1e-9. Stops of the others are softened: they
/// may leave a share of what a substep turns.
Real passed_by(int solver, Real speed = 0) { return is_direct(solver) ? 1e-6 : std::max(0.02, speed * kStep / 4 / 4); }

struct Way {
  int solver;
  Real order;  // of joints
};
constexpr Way kWays[] = {{kSoftChoice, 0}, {kDirectChoice, 0}, {kAutoChoice, 0},
                         {kAutoChoice, 2}, {kAutoChoice, 4},   {kAutoChoice, 6}};

enum class Kind { hinge, ball, turn_x, turn_y, turn_z };
constexpr Kind kEveryKind[] = {Kind::hinge, Kind::ball, Kind::turn_x, Kind::turn_y, Kind::turn_z};

/// A body on a joint that leaves one turn free.
struct Turner {
  TestWorld t{Vec3(0, 0, 0)};
  Kind kind;
  std::uint32_t body, j, base = kInvalid;
  Vec3 axis;

  Turner(Kind k, const Way& way, bool two_links = false) : kind(k) {
    choose(t, way.solver);
    t.world.set_dial(Dial::joint_order, way.order);
    body = add_body(t, Vec3(0.5, 0, 0), 20, Vec3(0.2, 1.5, 1.4));
    if (two_links) base = add_body(t, Vec3(-0.3, 0, 0), 60, Vec3(1, 3, 3));
    const bool is_axes = kind >= Kind::turn_x;
    j = join(t,
             is_axes              ? JointKind::six_axis
             : kind == Kind::ball ? JointKind::ball
                                  : JointKind::hinge,
             base, body, Vec3(0, 0, 0), kOblique);
    axis = kOblique * Vec3::unit(is_axes ? static_cast<int>(kind) - static_cast<int>(Kind::turn_x) : 0);
    if (kind == Kind::ball) set_limit(t, j, Coordinate::swing, 0, 0);  // else it tumbles
    if (is_axes) set_all(t, j, free_axis(), locked_at());
  }
  bool two() const { return base != kInvalid; }
  std::uint32_t free_axis() const {
    return kPlaces + static_cast<std::uint32_t>(kind) - static_cast<std::uint32_t>(Kind::turn_x);
  }
  JointAxis& set(JointAxis& a) const { return a = t.world.joints.axes_of(joint(t, j)).axis[free_axis()]; }
  void limit(Real lower, Real upper) {
    JointAxis a;
    if (kind < Kind::turn_x) return set_limit(t, j, Coordinate::twist, lower, upper);
    set(a), a.mode = AxisMode::limited, a.lower = lower, a.upper = upper;
    t.world.set_joint_axis(j, free_axis(), a);
  }
  void motor(Real speed, Real most) {
    JointAxis a;
    if (kind < Kind::turn_x) return set_motor(t, j, Coordinate::twist, speed, most);
    set(a), a.drive = AxisDrive::velocity, a.speed = speed, a.max_force = most;
    t.world.set_joint_axis(j, free_axis(), a);
  }
  void spring(Real target) {
    JointAxis a;
    if (kind < Kind::turn_x) return set_spring(t, j, Coordinate::twist, target, 1, 1);
    set(a), a.spring = {Gains::frequency, 1, 1}, a.rest = target;
    t.world.set_joint_axis(j, free_axis(), a);
  }
  void throw_it(Real speed) { t.world.set_velocity(body, (speed * axis).cross(t.world.state.x[body]), speed * axis); }
  Real angle() const { return kind < Kind::turn_x ? coordinate(t, j, Coordinate::twist) : axis_of(t, j, free_axis()); }
};

struct Range {
  Real lower, upper;
};
constexpr Range kStops[] = {{0, 3.14159}, {-kPi, kPi}, {-kPi - 1e-15, kPi + 1e-15}, {-1, 4.5}, {-7, 20}};

void it_stops_there(Turner& t, const Range& stops, int steps, Real passed, bool reaches = true) {
  Real most = -kInfinity;
  for (int i = 0; i < steps; ++i) {
    t.t.world.step(kStep);
    const Real x = t.angle();
    most = std::max(most, x);
    assert_true(x < stops.upper + passed && x > stops.lower - passed);
  }
  assert_true(!reaches || most > stops.upper - 0.02);
}

void a_stop_is_never_passed_by_a_motor(void**) {
  for (const Way& way : kWays)
    for (const Kind kind : kEveryKind)
      for (const Range& stops : kStops) {
        static OneOf turn(1, 5);
        if (!turn.next()) continue;
        Turner t(kind, way);
        t.limit(stops.lower, stops.upper), t.motor(11, 200);
        it_stops_there(t, stops, 220, passed_by(way.solver));
      }
}

void nor_is_it_by_what_is_thrown(void**) {
  for (const Way& way : kWays)
    for (const Kind kind : kEveryKind)
      for (const Real speed : {5.0, 20.0, 90.0}) {
        static OneOf turn(1, 5);
        if (!turn.next()) continue;
        Turner t(kind, way, kind == Kind::hinge && speed > 5);
        t.limit(-kPi, kPi), t.throw_it(speed);
        it_stops_there(t, {-kPi, kPi}, 60, passed_by(way.solver, speed), kind != Kind::ball && speed > 5 && !t.two());
      }
}

/// 5 and 20 rad a step, at 4 substeps up to 5 rad each.
void turns_are_counted_at_any_speed(void**) {
  for (const Way& way : kWays)
    for (const bool limited : {false, true})
      for (const Real speed : {7.0, 300.0, -1200.0}) {
        Turner t(Kind::hinge, way);
        t.t.world.set_velocity(t.body, Vec3::zero(), Vec3::zero());
        t.t.world.remove_joint(t.j);
        t.j = join(t.t, JointKind::hinge, kInvalid, t.body, Vec3(0.5, 0, 0), x_along(Vec3(0, 1, 0)));
        if (limited) t.limit(-1000, 1000);
        t.t.world.set_velocity(t.body, Vec3::zero(), Vec3(0, speed, 0));
        t.t.run(30, kStep);
        assert_true(std::fabs(t.angle() - speed / 2) < 1e-9 * std::fabs(speed));
      }
}

void a_spring_winds_up_many_turns(void**) {
  for (const Way& way : kWays)
    for (const Kind kind : kEveryKind) {
      static OneOf turn(1, 5);
      if (!turn.next()) continue;
      if (kind == Kind::ball) continue;  // what winds it up so fast makes it swing
      Turner t(kind, way);
      const Real target = is_direct(way.solver) ? 41 : 8;
      t.spring(target);
      t.t.run(300, kStep);
      assert_true(std::fabs(t.angle() - target) < 1e-3);
    }
}

/// Stiff drives to far away lead what hangs on an arm by radians a substep. It comes there, on its joint, from whatever it
/// hangs on: the world, or a block that stands on the ground.
void a_stiff_drive_keeps_its_arm(void**) {
  struct Drive {
    Real arm, frequency, damping, target;  // m, Hz, 1, rad
    bool stands;
  };
  const Drive drives[] = {{0.4, 5, 1, 900, false},  {0.4, 5, 1, 300, true},  {1, 15, 0.5, -300, false},
                          {0.15, 8, 1, 200, true},  {0.7, 3, 1, -250, true}, {0.25, 20, 0.7, 120, true},
                          {0.9, 6, 0.6, 400, false}};
  for (const Drive& d : drives) {
    static OneOf turn(1, 3);
    if (!turn.next()) continue;
    TestWorld t;
    std::uint32_t base = kInvalid;
    if (d.stands) {
      t.ground();
      base = t.add(t.keep(box(Vec3(1.5, 0.5, 1.5))), Vec3(0, 0.5, 0));
    }
    const std::uint32_t arm = add_body(t, Vec3(d.arm, 2, 0), 1, Vec3(0.002, 0.014, 0.014));
    const std::uint32_t j = join(t, JointKind::hinge, base, arm, Vec3(0, 2, 0), exp_map(Vec3(0, 0, kPi / 2)));
    set_spring(t, j, Coordinate::twist, d.target, d.frequency, d.damping);
    Real gap = 0;
    for (int i = 0; i < 600; ++i) t.run(1, kStep), gap = std::max(gap, gap_of(t, j));
    print_message("arm %g, %g Hz, to %g: at %g, gap %g\n", d.arm, d.frequency, d.target,
                  coordinate(t, j, Coordinate::twist), gap);
    assert_true(gap < 0.3 * d.arm);
    assert_true(std::fabs(coordinate(t, j, Coordinate::twist) - d.target) < 0.01);
  }
}

/// A rod on a motor at its end, against gravity: I w' = M until it is at its speed, and then for ever, with a motor that has
/// little to spare and turns of radians a substep; and beyond 2048 rad, where an angle that counts turns has lost the digits of rounding.
void a_motor_brings_a_long_arm_to_its_speed(void**) {
  struct Scene {
    Real length, mass, speed, surge, step;  // m, kg, rad/s, rad/s^2, s
    bool on_a_base, has_tip;
  };
  const Scene scenes[] = {
      {0.4, 1.5, 500, 24000, kStep, false, false},     {0.2, 0.4, 900, 9000, kStep, true, false},
      {1.1, 8, -330, 700, Real(1) / 120, false, true}, {0.3, 0.2, 610, 1500, Real(1) / 30, true, false},
      {0.7, 30, 140, 90, kStep, false, true},          {0.55, 2.5, -470, 4000, Real(1) / 240, true, true}};
  for (const int solver : {kSoftChoice, kDirectChoice, kAutoChoice})
    for (const Scene& s : scenes) {
      static OneOf turn(1, 3);
      if (!turn.next()) continue;
      TestWorld t;
      choose(t, solver);
      const auto rod = [&](Real from) {
        const Real across = s.mass * s.length * s.length / 12;
        return add_body(t, Vec3(from + s.length / 2, 0, 0), s.mass, Vec3(across / 50, across, across));
      };
      std::uint32_t base = kInvalid;
      if (s.on_a_base) {
        base = add_body(t, Vec3(0, 0, -1), 50, Vec3(5, 5, 5));
        join(t, JointKind::weld, kInvalid, base, Vec3(0, 0, -1), Quat::identity());
      }
      const std::uint32_t arm = rod(0);
      Real inertia = s.mass * s.length * s.length / 3;
      if (s.has_tip) {
        join(t, JointKind::weld, arm, rod(s.length), Vec3(s.length, 0, 0), Quat::identity());
        inertia *= 8;
      }
      const std::uint32_t j = join(t, JointKind::hinge, base, arm, Vec3(0, 0, 0), x_along(Vec3(0, 0, 1)));
      set_motor(t, j, Coordinate::twist, s.speed, inertia * s.surge);
      const Real until = std::fabs(s.speed) / s.surge + 3000 / std::fabs(s.speed);
      const Real way = s.speed < 0 ? -1 : 1;
      // Gravity takes m g l / I at most; what it takes from a motor to its speed comes back in half a turn.
      const Real falls = 9.81 * (s.has_tip ? 2 * s.length : s.length / 2) * s.mass / inertia;
      Real before = 0;
      for (Real time = 0; time < until; time += s.step) {
        t.run(1, s.step);
        const Real u = way * t.world.state.omega[arm].z();
        assert_true(u >=
                    std::min((s.surge - falls) * (time + s.step), (1 - 1e-9) * std::fabs(s.speed)) - falls * s.step);
        assert_true(u <= (1 + 1e-9) * std::fabs(s.speed));
        assert_true(gap_of(t, j) < 1e-9);
        before = u;
      }
      assert_true(std::fabs(before - std::fabs(s.speed)) < 1e-9 * std::fabs(s.speed));
    }
}

void snapshots_hold_turns(void**) {
  const auto bytes_of = [](const World& w) {
    std::vector<std::byte> bytes(save_state(w, nullptr, 0));
    save_state(w, bytes.data(), bytes.size());
    return bytes;
  };
  for (const Kind kind : {Kind::hinge, Kind::turn_x, Kind::turn_y}) {
    Turner t(kind, kWays[3]);
    t.motor(9, 200), t.limit(-3, 30);
    const std::vector<std::byte> unwound = bytes_of(t.t.world);
    t.t.run(100, kStep);
    const std::vector<std::byte> wound = bytes_of(t.t.world);
    const Real there = t.angle();
    assert_true(there > 10);
    const auto has_turns = [](const std::vector<std::byte>& bytes) {
      static constexpr std::byte kTag[] = {std::byte{'T'}, std::byte{'U'}, std::byte{'R'}, std::byte{'N'}};
      return std::search(bytes.begin(), bytes.end(), std::begin(kTag), std::end(kTag)) != bytes.end();
    };
    assert_true(!has_turns(unwound) && has_turns(wound));  // what old snapshots say is what they said
    t.t.run(200, kStep);
    const std::uint64_t hash = t.t.world.hash();
    SnapshotFault fault;
    assert_true(restore_state(t.t.world, wound.data(), wound.size(), fault));
    assert_true(t.angle() == there);
    t.t.run(200, kStep);
    assert_true(t.t.world.hash() == hash);
    assert_true(std::fabs(t.angle() - 30) < 1e-6);
    assert_true(restore_state(t.t.world, unwound.data(), unwound.size(), fault));
    assert_true(t.angle() == 0);
  }
}

/// A host puts bodies back: no stop unwinds turns of which nobody knows any more.
void a_body_that_is_put_back_stays_there(void**) {
  for (const Real put : {0.0, -1.5, 2.5}) {
    Turner t(Kind::hinge, kWays[3]);
    const Pose begin = t.t.world.pose(t.body);
    t.limit(-4, 4), t.motor(9, 200);
    t.t.run(90, kStep);
    assert_true(std::fabs(t.angle() - 4) < 1e-6);
    t.motor(0, 0);
    const Quat turn = exp_map(put * t.axis);
    t.t.world.set_pose(t.body, {turn * begin.q, turn * begin.p});
    t.t.world.set_velocity(t.body, Vec3::zero(), Vec3::zero());
    assert_true(std::fabs(t.angle() - put) < 1e-9);
    t.t.run(30, kStep);
    assert_true(std::fabs(t.angle() - put) < 1e-6);
  }
}

/// Animated by poses alone it counts, and a stop that is set far away forgets whole turns.
void poses_a_little_apart_are_counted(void**) {
  Turner t(Kind::hinge, kWays[3]);
  const Pose begin = t.t.world.pose(t.body);
  for (int i = 1; i <= 100; ++i) {
    const Quat turn = exp_map((0.2 * i) * t.axis);
    t.t.world.set_pose(t.body, {turn * begin.q, turn * begin.p});
    t.t.world.set_velocity(t.body, Vec3::zero(), Vec3::zero());
    t.t.world.step(kStep);
  }
  assert_true(std::fabs(t.angle() - 20) < 1e-6);
  t.limit(-2, 2);
  assert_true(std::fabs(t.angle() - (20 - 6 * kPi)) < 1e-6);
}

void gears_turn_their_hinges_many_times(void**) {
  for (const Way& way : kWays) {
    TestWorld t(Vec3(0, 0, 0));
    choose(t, way.solver);
    t.world.set_dial(Dial::joint_order, way.order);
    const Quat axes = x_along(Vec3(0, 1, 0));
    const std::uint32_t a = add_body(t, Vec3(0, 0, 0), 2, Vec3::constant(0.05)),
                        b = add_body(t, Vec3(1, 0, 0), 3, Vec3::constant(0.08));
    const std::uint32_t of_a = join(t, JointKind::hinge, kInvalid, a, Vec3(0, 0, 0), axes),
                        of_b = join(t, JointKind::hinge, kInvalid, b, Vec3(1, 0, 0), axes);
    Transmission gear;
    gear.ratio = -2.5;
    t.world.set_transmission(join(t, JointKind::gear, a, b, Vec3(0, 0, 0), axes), gear);
    set_limit(t, of_b, Coordinate::twist, -10, 10), set_motor(t, of_a, Coordinate::twist, 30, 20);
    t.run(180, kStep);
    assert_true(std::fabs(coordinate(t, of_b, Coordinate::twist) - 10) < passed_by(way.solver));
    assert_true(std::fabs(coordinate(t, of_a, Coordinate::twist) - 25) < 2.5 * passed_by(way.solver));
  }
}

/// Two turns at once, one beyond a swing of pi, where no rotation vector tells them.
void a_cross_turns_both_ways(void**) {
  for (const Way& way : kWays)
    for (const std::uint32_t swing : {4u, 5u}) {
      TestWorld t(Vec3(0, 0, 0));
      choose(t, way.solver);
      t.world.set_dial(Dial::joint_order, way.order);
      const std::uint32_t body = add_body(t, Vec3(0, 0, 0), 3, Vec3(0.05, 0.06, 0.07)),
                          j = join_axes(t, kInvalid, body, Vec3(0, 0, 0));
      set_all(t, j, swing, locked_at());
      JointAxis a;
      a.mode = AxisMode::limited, a.lower = -9, a.upper = 9, a.drive = AxisDrive::velocity, a.speed = 4,
      a.max_force = 50;
      t.world.set_joint_axis(j, swing, a);
      a.lower = -12, a.upper = 12, a.speed = -3.3;
      t.world.set_joint_axis(j, 3, a);
      for (int i = 0; i < 300; ++i) {
        t.world.step(kStep);
        assert_true(off_joint(t, j) < passed_by(way.solver));
      }
      assert_true(std::fabs(axis_of(t, j, swing) - 9) < passed_by(way.solver));
      assert_true(std::fabs(axis_of(t, j, 3) + 12) < passed_by(way.solver));
    }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_stop_is_never_passed_by_a_motor),
      cmocka_unit_test(nor_is_it_by_what_is_thrown),
      cmocka_unit_test(turns_are_counted_at_any_speed),
      cmocka_unit_test(a_spring_winds_up_many_turns),
      cmocka_unit_test(a_stiff_drive_keeps_its_arm),
      cmocka_unit_test(a_motor_brings_a_long_arm_to_its_speed),
      cmocka_unit_test(snapshots_hold_turns),
      cmocka_unit_test(a_body_that_is_put_back_stays_there),
      cmocka_unit_test(poses_a_little_apart_are_counted),
      cmocka_unit_test(gears_turn_their_hinges_many_times),
      cmocka_unit_test(a_cross_turns_both_ways),
  };
  return cmocka_run_group_tests_name("oracle/joint_turns", tests, nullptr, nullptr);
}
