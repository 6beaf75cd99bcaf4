// Joints that a host moves: where the bodies of a tree go and how fast, against what each joint says of its own two bodies
// and against differences of poses; what stays; what is refused. Accelerations against closed forms.
#include "carom_test.h"
#include "dynamics/body_state.h"
#include "dynamics/joint/speeds.h"
#include "dynamics/joint/tree/joint_moves.h"
#include "joint_draws.h"
#include "six_axes.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr std::uint32_t kWorld = kInvalid;
using Six = std::array<Real, kAxes>;

Six axes_now(const World& w, std::uint32_t j) {
  const JointEnds ends = ends_of(w, w.joints.joint[j].def);
  return axes_at(ends, counted_angles(w, w.joints.joint[j], ends));
}
Six rates_now(const World& w, std::uint32_t j) { return speeds_of(w, w.joints.joint[j]).axis; }
Real off(const Six& a, const Six& b) {
  Real worst = 0;
  for (std::size_t k = 0; k < kAxes; ++k) worst = std::max(worst, std::fabs(a[k] - b[k]));
  return worst;
}
bool may_be_asked(const World& w, std::uint32_t j) { return JointMoves::can_move(w.joints.joint[j].def.kind); }
bool is_free(const World& w, std::uint32_t j, std::uint32_t axis) {
  const Joint& joint = w.joints.joint[j];
  switch (joint.def.kind) {
    case JointKind::hinge:
      return axis == 3;
    case JointKind::slider:
      return axis == 0;
    case JointKind::ball:
      return axis >= 3;
    case JointKind::universal:
      return axis > 3;
    default:
      return !w.joints.axes_of(joint).axis[axis].is_locked();
  }
}

/// The twist of a universal joint goes with its swing.
bool follows(const World& w, std::uint32_t j, std::uint32_t axis) {
  return w.joints.joint[j].def.kind == JointKind::universal && axis == 3;
}

MoveFault write(World& w, const std::vector<JointMove>& moves, bool speeds) {
  JointMoves all(std::pmr::new_delete_resource());
  for (const JointMove& m : moves) all.ask(w, m);
  const MoveFault fault = all.find(w, speeds);
  if (fault == MoveFault::none) w.move_joints(all);
  return fault;
}

/// A tree of joints of all kinds, either way round, held by the world, by a kinematic body that moves, or by nothing. Bodies
/// move as they like, and joints do not gape.
struct Robot {
  explicit Robot(int bodies) {
    static constexpr JointKind kKinds[] = {JointKind::hinge, JointKind::slider,    JointKind::ball,
                                           JointKind::weld,  JointKind::universal, JointKind::six_axis,
                                           JointKind::hinge, JointKind::six_axis};
    const int held = below(3);
    std::uint32_t support = kWorld;
    if (held == 1) support = add_body(t, draw3(1), 1, Vec3::constant(1), BodyType::kinematic, draw_turn());
    if (held == 1) t.world.set_velocity(support, draw3(2), draw3(2));
    for (int i = 0; i < bodies; ++i) {
      BodyDef def;
      def.pose = {draw_turn(), draw3(2)};
      def.has_mass = def.has_inertia = true;
      def.mass = 1 + 0.5 * draw();
      def.inertia = Mat3::diagonal(Vec3(0.1, 0.2, 0.25));
      def.center = draw3(0.3);
      const std::uint32_t body = handle_slot(t.world.add_body(def));
      const bool hangs = i > 0 || held < 2;
      const std::uint32_t parent = i == 0 ? support : body_of[static_cast<std::size_t>(below(i))];
      body_of.push_back(body);
      if (!hangs) continue;
      JointDef d;
      d.kind = kKinds[below(8)];
      const bool child_is_a = draw() > 0.3;
      d.body_a = child_is_a ? body : parent, d.body_b = child_is_a ? parent : body;
      d.frame_a = {draw_turn(), draw3(1)}, d.frame_b = {draw_turn(), draw3(1)};
      joints.push_back(handle_slot(t.world.add_joint(d)));
      if (d.kind == JointKind::six_axis)
        for (std::uint32_t k = 0; k < kAxes; ++k)
          if (draw() > -0.2) t.world.set_joint_axis(joints.back(), k, locked_at(k == 3 || k == 4 ? 0 : 0.4 * draw()));
    }
    std::vector<JointMove> closed;
    for (const std::uint32_t j : joints) {
      if (!may_be_asked(t.world, j)) continue;
      JointMove& m = closed.emplace_back();
      m.joint = j;
      for (Real& x : m.to) x = draw();
    }
    assert_true(write(t.world, closed, false) == MoveFault::none);
    for (const std::uint32_t body : body_of) t.world.set_velocity(body, draw3(2), draw3(2));
  }
  /// Some joints, of places or rates.
  std::vector<JointMove> drawn(Real size) const {
    std::vector<JointMove> moves;
    for (const std::uint32_t j : joints) {
      bool any = false;
      for (std::uint32_t k = 0; k < kAxes; ++k) any |= is_free(t.world, j, k);
      if (!may_be_asked(t.world, j) || !any || draw() > 0.3) continue;
      JointMove& m = moves.emplace_back();
      m.joint = j;
      for (Real& x : m.to) x = size * draw();
    }
    return moves;
  }
  TestWorld t{Vec3::zero()};
  std::vector<std::uint32_t> body_of, joints;
};

const JointMove* asked(const std::vector<JointMove>& moves, std::uint32_t j) {
  for (const JointMove& m : moves)
    if (m.joint == j) return &m;
  return nullptr;
}

/// B in A's frame, whatever the kind.
Pose told(const World& w, std::uint32_t j) {
  const JointEnds ends = ends_of(w, w.joints.joint[j].def);
  return {ends.a.q.conjugate() * ends.b.q, ends.a.q.conjugate() * ends.apart};
}
Real apart(const Pose& a, const Pose& b) {
  const Quat q = a.q.conjugate() * b.q;
  return std::max((a.p - b.p).norm(), 2 * q.vec().norm());
}

}  // namespace

/// What is asked for is there; all else of each joint is as it was; the base stands where it stood.
static void joints_go_where_they_are_written(void**) {
  for (int trial = 0; trial < 300; ++trial) {
    Robot r(1 + below(12));
    World& w = r.t.world;
    std::vector<Pose> was;
    std::vector<Six> rate;
    for (const std::uint32_t j : r.joints) was.push_back(told(w, j)), rate.push_back(rates_now(w, j));
    const std::vector<JointMove> moves = r.drawn(2.5);
    const State before = w.state;
    assert_true(write(w, moves, false) == MoveFault::none);
    for (std::size_t i = 0; i < r.joints.size(); ++i) {
      const std::uint32_t j = r.joints[i];
      const JointMove* const m = asked(moves, j);
      if (!m) {
        assert_true(apart(was[i], told(w, j)) < 1e-12);
        assert_true(off(rate[i], rates_now(w, j)) < 1e-11 * (1 + off(rate[i], Six{})));
        continue;
      }
      const Six at = axes_now(w, j), now = rates_now(w, j);
      const bool any_way = is_free(w, j, 3) && is_free(w, j, 4) && is_free(w, j, 5);
      for (std::uint32_t k = 0; k < kAxes; ++k) {
        // A universal joint counts no turns: what swings beyond pi is told from the other side.
        const bool is_told = w.joints.joint[j].def.kind != JointKind::universal || std::hypot(m->to[4], m->to[5]) < 3.1;
        if (!is_told) continue;
        if (is_free(w, j, k)) assert_true(std::fabs(at[k] - m->to[k]) < 1e-12);
        if (k < 3 || (!any_way && !follows(w, j, k)))
          assert_true(std::fabs(now[k] - (is_free(w, j, k) ? rate[i][k] : 0)) < 1e-10 * (1 + off(rate[i], Six{})));
      }
      const JointPlace place = place_of(w, w.joints.joint[j]);
      assert_true(place.gap < 1e-12 && place.angle < 4e-8);
    }
    if (r.joints.empty()) continue;
    // Some body is where it was and goes as it went, unless something else holds them.
    bool any = w.joints.joint[r.joints[0]].def.body_a == kWorld || w.joints.joint[r.joints[0]].def.body_b == kWorld ||
               w.scene.type[0] == BodyType::kinematic;
    for (const std::uint32_t i : r.body_of)
      any |= w.state.x[i] == before.x[i] && w.state.q[i] == before.q[i] && w.state.v[i] == before.v[i];
    assert_true(any);
  }
}

static void joints_go_as_fast_as_they_are_written(void**) {
  for (int trial = 0; trial < 300; ++trial) {
    Robot r(1 + below(12));
    World& w = r.t.world;
    std::vector<Six> rate;
    for (const std::uint32_t j : r.joints) rate.push_back(rates_now(w, j));
    const std::vector<JointMove> moves = r.drawn(5);
    const State before = w.state;
    assert_true(write(w, moves, true) == MoveFault::none);
    for (std::size_t i = 0; i < r.joints.size(); ++i) {
      const std::uint32_t j = r.joints[i];
      const JointMove* const m = asked(moves, j);
      const Six now = rates_now(w, j);
      for (std::uint32_t k = 0; k < kAxes; ++k) {
        if (m && follows(w, j, k)) continue;
        const Real want = !m ? rate[i][k] : is_free(w, j, k) ? m->to[k] : 0;
        assert_true(std::fabs(now[k] - want) < 1e-11 * (10 + off(rate[i], Six{})));
      }
    }
    for (const std::uint32_t i : r.body_of) assert_true(w.state.x[i] == before.x[i] && w.state.q[i] == before.q[i]);
  }
}

/// Where joints are written a moment before and after, bodies are as far apart as they go fast.
static void speeds_are_differences_of_places(void**) {
  const Real h = 1e-5;
  for (int trial = 0; trial < 200; ++trial) {
    Robot r(2 + below(8));
    World& w = r.t.world;
    if (w.scene.type[0] == BodyType::kinematic) w.set_velocity(0, Vec3::zero(), Vec3::zero());
    for (const std::uint32_t i : r.body_of) w.set_velocity(i, Vec3::zero(), Vec3::zero());
    std::vector<JointMove> rates = r.drawn(1), places[2];
    for (const JointMove& m : rates)
      for (const int side : {0, 1}) {
        JointMove& to = places[side].emplace_back(m);
        const Six now = axes_now(w, m.joint);
        for (std::size_t k = 0; k < kAxes; ++k) to.to[k] = now[k] + (side ? h : -h) * m.to[k];
      }
    State at[2] = {State(w.state), State(w.state)};
    for (const int side : {0, 1}) {
      assert_true(write(w, places[side], false) == MoveFault::none);
      at[side] = w.state;
    }
    for (JointMove& m : places[0])
      for (std::size_t k = 0; k < kAxes; ++k) m.to[k] += h * asked(rates, m.joint)->to[k];
    assert_true(write(w, places[0], false) == MoveFault::none);
    assert_true(write(w, rates, true) == MoveFault::none);
    for (const std::uint32_t i : r.body_of) {
      const Vec3 v = (at[1].x[i] - at[0].x[i]) / (2 * h);
      const Quat turn = at[1].q[i] * at[0].q[i].conjugate();
      const Vec3 omega = (turn.w() < 0 ? -1 : 1) * turn.vec() / h;
      assert_true((v - w.state.v[i]).norm() < 2e-8 * (1 + v.norm()));
      assert_true((omega - w.state.omega[i]).norm() < 2e-8 * (1 + omega.norm()));
    }
  }
}

/// An arm of two hinges about z: x = cos a + cos (a + b), whichever way joints are made, and however long its reach.
static void an_arm_reaches_where_its_angles_say(void**) {
  for (const bool turned : {false, true})
    for (const Real length : {0.01, 1.0, 30.0}) {
      TestWorld t(Vec3::zero());
      const Quat about_z = x_along(Vec3(0, 0, 1));
      const std::uint32_t upper = add_body(t, Vec3(length / 2, 0, 0), 1, Vec3::constant(1)),
                          lower = add_body(t, Vec3(3 * length / 2, 0, 0), 1, Vec3::constant(1));
      const std::uint32_t shoulder = join(t, JointKind::hinge, turned ? upper : kWorld, turned ? kWorld : upper,
                                          Vec3::zero(), about_z),
                          elbow = join(t, JointKind::hinge, turned ? lower : upper, turned ? upper : lower,
                                       Vec3(length, 0, 0), about_z);
      const Real a = 0.7, b = -1.9, sign = turned ? -1 : 1, speed_a = 3, speed_b = -2;
      assert_true(write(t.world, {{elbow, {0, 0, 0, sign * b}}, {shoulder, {0, 0, 0, sign * a}}}, false) ==
                  MoveFault::none);
      assert_true(write(t.world, {{elbow, {0, 0, 0, sign * speed_b}}, {shoulder, {0, 0, 0, sign * speed_a}}}, true) ==
                  MoveFault::none);
      const State& s = t.world.state;
      const Vec3 first(length * std::cos(a), length * std::sin(a), 0),
          second(length * std::cos(a + b), length * std::sin(a + b), 0);
      assert_true((s.x[lower] - (first + 0.5 * second)).norm() < 4e-16 * (1 + 4 * length));
      const Vec3 v =
          speed_a * Vec3(-first.y(), first.x(), 0) + 0.5 * (speed_a + speed_b) * Vec3(-second.y(), second.x(), 0);
      assert_true((s.v[lower] - v).norm() < 1e-14 * (1 + length));
      assert_true((s.omega[lower] - Vec3(0, 0, speed_a + speed_b)).norm() < 1e-14);
      // Of 1e-15 more or less it is the same place.
      const Vec3 there = s.x[lower];
      assert_true(write(t.world, {{elbow, {0, 0, 0, sign * b + 1e-15}}}, false) == MoveFault::none);
      assert_true((s.x[lower] - there).norm() < 1e-14 * (1 + length));
    }
}

static void what_is_there_already_keeps_its_bits(void**) {
  Robot r(9);
  World& w = r.t.world;
  const State before = w.state;
  for (const bool speeds : {false, true}) {
    std::vector<JointMove> same;
    for (const std::uint32_t j : r.joints)
      if (may_be_asked(w, j)) same.push_back({j, speeds ? rates_now(w, j) : axes_now(w, j)});
    assert_true(write(w, same, speeds) == MoveFault::none);
  }
  for (const std::uint32_t i : r.body_of) {
    assert_true(w.state.x[i] == before.x[i] && w.state.q[i] == before.q[i]);
    assert_true(w.state.v[i] == before.v[i] && w.state.omega[i] == before.omega[i]);
  }
}

/// A four-bar linkage with a hand on its coupler: bars cannot be written, the hand can.
static void loops_are_refused(void**) {
  TestWorld t(Vec3::zero());
  const Quat about_z = x_along(Vec3(0, 0, 1));
  const std::uint32_t bar[3] = {add_body(t, Vec3(0, 0.5, 0), 1, Vec3::constant(1)),
                                add_body(t, Vec3(0.5, 1, 0), 1, Vec3::constant(1)),
                                add_body(t, Vec3(1, 0.5, 0), 1, Vec3::constant(1))},
                      hand = add_body(t, Vec3(0.5, 2, 0), 1, Vec3::constant(1));
  std::uint32_t at[4];
  for (int i = 0; i < 4; ++i)
    at[i] = join(t, JointKind::hinge, i == 0 ? kWorld : bar[i - 1], i == 3 ? kWorld : bar[i],
                 Vec3(i > 1, i == 1 || i == 2, 0), about_z);
  const std::uint32_t wrist = join(t, JointKind::hinge, bar[1], hand, Vec3(0.5, 1, 0), about_z);
  const State before = t.world.state;
  for (const int i : {0, 1, 2, 3})
    for (const bool speeds : {false, true}) {
      JointMoves one(std::pmr::new_delete_resource());
      one.ask(t.world, {at[i], {0, 0, 0, 0.1}});
      assert_true(one.find(t.world, speeds) == MoveFault::loop && one.joint_at_fault() == at[i]);
    }
  assert_true(write(t.world, {{wrist, {0, 0, 0, 1.0}}, {at[0], {0, 0, 0, 0}}}, false) == MoveFault::none);
  assert_true(t.world.state.x[bar[1]] == before.x[bar[1]] && !(t.world.state.x[hand] == before.x[hand]));
  // All four at once are a loop, too; the last of them closes it.
  assert_true(write(t.world,
                    {{at[0], {0, 0, 0, 1}}, {at[1], {0, 0, 0, 1}}, {at[2], {0, 0, 0, 1}}, {at[3], {0, 0, 0, 1}}},
                    false) == MoveFault::loop);
  // Without one bar the others are a tree. A rope to the world closes a loop, too, a gear does not.
  t.world.break_joint(at[3]);
  assert_true(write(t.world, {{at[3], {0, 0, 0, 1}}}, false) == MoveFault::broken);
  assert_true(write(t.world, {{at[0], {0, 0, 0, 0.2}}}, false) == MoveFault::none);
  join(t, JointKind::gear, bar[0], bar[2], Vec3::zero(), about_z);
  assert_true(write(t.world, {{at[0], {0, 0, 0, 0.3}}}, false) == MoveFault::none);
  join(t, JointKind::distance, kWorld, bar[2], Vec3(2, 2, 0));
  assert_true(write(t.world, {{at[0], {0, 0, 0, 0.4}}}, false) == MoveFault::loop);
  assert_true(write(t.world, {{wrist, {0, 0, 0, 0.4}}}, false) == MoveFault::none);
  // What is beyond numbers.
  assert_true(write(t.world, {{wrist, {0, 0, 0, 1e8}}}, true) == MoveFault::none);
  const std::uint32_t rail =
      join(t, JointKind::slider, hand, add_body(t, Vec3::zero(), 1, Vec3::constant(1)), Vec3::zero());
  assert_true(write(t.world, {{rail, {1e9}}}, true) == MoveFault::far);
}

/// Turns that are written are counted, and are gone on with.
static void written_turns_count(void**) {
  TestWorld t(Vec3::zero());
  const std::uint32_t wheel = add_body(t, Vec3::zero(), 1, Vec3::constant(1));
  const std::uint32_t j = join(t, JointKind::hinge, kWorld, wheel, Vec3::zero());
  for (const Real angle : {40.0, -7.0, 1e4}) {
    assert_true(write(t.world, {{j, {0, 0, 0, angle}}}, false) == MoveFault::none);
    assert_true(std::fabs(coordinate(t, j, Coordinate::twist) - angle) < 1e-15 * (1 + std::fabs(angle)) * 4);
    assert_true(write(t.world, {{j, {0, 0, 0, 2}}}, true) == MoveFault::none);
    for (int i = 0; i < 30; ++i) t.world.step(kStep);
    assert_true(std::fabs(coordinate(t, j, Coordinate::twist) - (angle + 1)) < 1e-10 * (1 + std::fabs(angle)));
  }
}

/// Of two words for one joint the last counts. What sleeps wakes. The world may hold either side.
static void the_last_word_counts(void**) {
  TestWorld t(Vec3::zero());
  t.world.set_dial(Dial::sleep, 1);
  const std::uint32_t a = add_body(t, Vec3(1, 0, 0), 1, Vec3::constant(1)),
                      b = add_body(t, Vec3(2, 0, 0), 1, Vec3::constant(1));
  const std::uint32_t first = join(t, JointKind::slider, a, kWorld, Vec3::zero()),
                      second = join(t, JointKind::slider, b, a, Vec3(1, 0, 0));
  for (int i = 0; i < 120; ++i) t.world.step(kStep);
  assert_true(t.world.asleep(a) && t.world.asleep(b));
  assert_true(write(t.world, {{first, {9}}, {second, {-3}}, {first, {-2}}}, false) == MoveFault::none);
  assert_true(!t.world.asleep(a) && !t.world.asleep(b));
  // B's point is at -2 in A's frame, so A is 2 further on, and the body on it 3 more.
  assert_true((t.world.state.x[a] - Vec3(3, 0, 0)).norm() < 1e-15 &&
              (t.world.state.x[b] - Vec3(7, 0, 0)).norm() < 1e-15);
}

// ---- accelerations ----

namespace {

std::uint32_t join_measured(TestWorld& t, JointKind kind, std::uint32_t a, std::uint32_t b, const Vec3& at,
                            const Quat& axes = Quat::identity()) {
  JointDef def = joint_at(t, kind, a, b, at, axes);
  def.measured = true;
  return handle_slot(t.world.add_joint(def));
}

}  // namespace

/// torque / I of a wheel, g of what falls on an upright rail, 0 of what rests and before any step.
static void accelerations_are_what_a_step_did(void**) {
  for (const int solver : kEverySolver)
    for (const Real dt : {1.0 / 60, 1.0 / 1000}) {
      TestWorld t;
      choose(t, solver);
      const std::uint32_t wheel = add_body(t, Vec3::zero(), 1, Vec3::constant(0.5)),
                          weight = add_body(t, Vec3(3, 0, 0), 2, Vec3::constant(1)),
                          still = add_body(t, Vec3(6, 0, 0), 2, Vec3::constant(1));
      const std::uint32_t turns = join_measured(t, JointKind::hinge, kWorld, wheel, Vec3::zero()),
                          falls = join_measured(t, JointKind::slider, kWorld, weight, Vec3(3, 0, 0),
                                                x_along(Vec3(0, 1, 0))),
                          rests = join_measured(t, JointKind::weld, kWorld, still, Vec3(6, 0, 0)),
                          other = join(t, JointKind::hinge, still, add_body(t, Vec3(7, 0, 0), 1, Vec3::constant(1)),
                                       Vec3(7, 0, 0));
      set_motor(t, turns, Coordinate::twist, 1e6, 1.5);
      const auto rate = [&](std::uint32_t j, std::size_t k) { return joint(t, j).acceleration[k]; };
      assert_true(rate(turns, 3) == 0 && rate(falls, 0) == 0);
      for (int i = 0; i < 20; ++i) {
        t.world.step(dt);
        assert_true(std::fabs(rate(turns, 3) - 3) < 1e-5 && std::fabs(rate(falls, 0) + kG) < 1e-9);
        assert_true(off(joint(t, rests).acceleration, Six{}) < 1e-6);
        assert_true(off(joint(t, other).acceleration, Six{}) == 0);
      }
    }
}

/// A pendulum let go at rest: -g sin(a) / l in the limit, of first order in the step: the mean over it.
static void a_pendulum_accelerates_by_its_angle(void**) {
  const Real length = 0.8, angle = 1.1;
  for (const Real dt : {1e-2, 1e-3, 1e-4}) {
    TestWorld t;
    const std::uint32_t bob = add_body(t, Vec3(0, -length, 0), 2, Vec3::constant(1e-3));
    const std::uint32_t j = join_measured(t, JointKind::hinge, kWorld, bob, Vec3::zero(), x_along(Vec3(0, 0, 1)));
    assert_true(write(t.world, {{j, {0, 0, 0, angle}}}, false) == MoveFault::none);
    t.world.step(dt);
    const Real want = -2 * kG * length * std::sin(angle) / (2 * length * length + 1e-3);
    assert_true(std::fabs(joint(t, j).acceleration[3] - want) < 60 * dt * dt + 1e-7);
  }
}

/// Bodies that move away take joints with them; a slot that is used again measures as its joint says.
static void measuring_ends_with_its_joint(void**) {
  TestWorld t;
  const std::uint32_t a = add_body(t, Vec3::zero(), 1, Vec3::constant(1));
  const std::uint32_t j = join_measured(t, JointKind::slider, kWorld, a, Vec3::zero(), x_along(Vec3(0, 1, 0)));
  t.world.step(kStep);
  assert_true(t.world.joints.measured == 1);
  t.world.remove_joint(j);
  assert_true(t.world.joints.measured == 0);
  const std::uint32_t again = join(t, JointKind::slider, kWorld, a, Vec3::zero(), x_along(Vec3(0, 1, 0)));
  t.world.step(kStep);
  assert_true(again == j && off(joint(t, again).acceleration, Six{}) == 0);
  t.world.remove_joint(again);
  join_measured(t, JointKind::slider, kWorld, a, Vec3::zero(), x_along(Vec3(0, 1, 0)));
  assert_true(off(joint(t, again).acceleration, Six{}) == 0);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(joints_go_where_they_are_written),
      cmocka_unit_test(joints_go_as_fast_as_they_are_written),
      cmocka_unit_test(speeds_are_differences_of_places),
      cmocka_unit_test(an_arm_reaches_where_its_angles_say),
      cmocka_unit_test(what_is_there_already_keeps_its_bits),
      cmocka_unit_test(loops_are_refused),
      cmocka_unit_test(written_turns_count),
      cmocka_unit_test(the_last_word_counts),
      cmocka_unit_test(accelerations_are_what_a_step_did),
      cmocka_unit_test(a_pendulum_accelerates_by_its_angle),
      cmocka_unit_test(measuring_ends_with_its_joint),
  };
  return cmocka_run_group_tests_name("oracle/joint_moves", tests, nullptr, nullptr);
}
