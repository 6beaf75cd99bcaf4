// Accuracy in, steps out: what is got of what was asked, against closed forms and own finer runs.
#include <algorithm>
#include <cstdio>
#include <functional>

#include "carom_test.h"
#include "dynamics/accuracy/accuracy.h"
#include "rattle_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

void ask(TestWorld& t, Real tolerance, int most = 1024) {
  ask_accuracy(t, tolerance);
  t.world.set_dial(Dial::accuracy_substeps, most);
}

/// Decades of error for a decade of tolerance, from the first to the last; and each error over what was asked.
/// @param error  of a tolerance, m or rad   @param time  s
void holds(const char* what, const std::function<Real(Real)>& error, std::initializer_list<Real> tolerances,
           Real time) {
  Real first = 0, last = 0;
  for (const Real tolerance : tolerances) {
    const Real got = error(tolerance);
    std::printf("  %s: asked %.1e, got %.2e, %.2f of it\n", what, tolerance * time, got, got / (tolerance * time));
    assert_true(got < 3 * tolerance * time);
    if (first == 0) first = got;
    last = got;
  }
  const Real slope = std::log10(first / last) / std::log10(*tolerances.begin() / *(tolerances.end() - 1));
  std::printf("  %s: %.2f decades for a decade\n", what, slope);
  assert_true(std::fabs(slope - 1) < 0.25);
}

}  // namespace

/// From 170 degrees, where a quarter of a period and five of them lead to the bottom: by RATTLE. One substep a step
/// errs by 1e-3.
static void a_pendulum_gets_what_is_asked(void**) {
  const Real amplitude = 170 * kPi / 180, time = 1.25 * period(std::sqrt(1.5 * kG), amplitude);
  const int steps = static_cast<int>(time * 20);
  holds(
      "pendulum",
      [&](Real tolerance) {
        TestWorld t;
        ask(t, tolerance);
        const std::uint32_t rod = hang_rod(t, amplitude);
        t.run(steps, time / steps);
        assert_int_equal(held(t), 1);
        return (t.world.state.x[rod] - Vec3(0, -0.5, 0)).norm();
      },
      {1e-3, 1e-4, 1e-5, 1e-6}, time);
}

/// A ball on a spring along x: a cosine. Forces and velocity Verlet, no joint, no contact.
static void a_ball_on_a_spring_gets_what_is_asked(void**) {
  const Real time = 2;
  holds(
      "spring",
      [&](Real tolerance) {
        TestWorld t(Vec3::zero());
        ask(t, tolerance);
        const std::uint32_t ball = add_body(t, Vec3(1, 0, 0), 1, Vec3(1, 1, 1));
        SpringDef spring;
        spring.body_b = ball;
        spring.stiffness = 100;
        t.world.add_spring(spring);
        t.run(60, time / 60);
        return std::fabs(t.world.state.x[ball].x() - std::cos(10 * time));
      },
      {1e-1, 1e-2, 1e-3, 1e-4}, time);
}

/// A body of three unlike moments, against its own run at a much smaller tolerance. One substep a step errs by 1e-4.
static void a_top_gets_what_is_asked(void**) {
  const auto end = [](Real tolerance) {
    TestWorld t(Vec3::zero());
    ask(t, tolerance, 4096);
    const std::uint32_t top = add_body(t, Vec3::zero(), 1, Vec3(1, 2, 2.5));
    t.world.set_velocity(top, Vec3::zero(), Vec3(4, 1, 2));
    t.run(120, 1.0 / 60);
    return t.world.state.q[top];
  };
  const Quat truth = end(1e-10);
  holds(
      "top",
      [&](Real tolerance) {
        const Quat off = end(tolerance) * truth.conjugate();
        return 2 * Vec3(off.x(), off.y(), off.z()).norm();
      },
      {1e-4, 1e-5, 1e-6}, 2);
}

// ---- held out: looked at once all of the above went well ----

/// Two masses between walls, three springs of 50 N/m: the sum of two modes.
static void two_masses_on_three_springs_get_what_is_asked(void**) {
  const Real time = 3, k = 50;
  holds(
      "masses",
      [&](Real tolerance) {
        TestWorld t(Vec3::zero());
        ask(t, tolerance);
        const std::uint32_t a = add_body(t, Vec3(1.2, 0, 0), 1, Vec3(1, 1, 1)),
                            b = add_body(t, Vec3(2, 0, 0), 1, Vec3(1, 1, 1));
        const auto spring = [&](std::uint32_t from, std::uint32_t to, const Vec3& anchor_a, const Vec3& anchor_b) {
          SpringDef def;
          def.body_a = from, def.body_b = to;
          def.anchor_a = anchor_a, def.anchor_b = anchor_b;
          def.rest = 1, def.stiffness = k;
          t.world.add_spring(def);
        };
        spring(kInvalid, a, Vec3::zero(), Vec3::zero()), spring(a, b, Vec3::zero(), Vec3::zero());
        spring(kInvalid, b, Vec3(3, 0, 0), Vec3::zero());
        t.run(90, time / 90);
        const Real both = 0.1 * std::cos(std::sqrt(k) * time), apart = 0.1 * std::cos(std::sqrt(3 * k) * time);
        return std::max(std::fabs(t.world.state.x[a].x() - (1 + both + apart)),
                        std::fabs(t.world.state.x[b].x() - (2 + both - apart)));
      },
      {1e-1, 1e-2, 1e-3, 1e-4}, time);
}

/// Two rods, against the equations of motion in two angles.
static void a_double_pendulum_gets_what_is_asked(void**) {
  const Real time = 2, l = 0.5;
  std::array<Real, 4> y = {1.5, -1, 0, 0};
  const auto rate = [&](const std::array<Real, 4>& s) {
    const Real a = s[0], b = s[1], p = s[2], q = s[3], c = std::cos(a - b), d = std::sin(a - b);
    const Real r1 = -0.5 * d * q * q - 1.5 * kG / l * std::sin(a), r2 = 0.5 * d * p * p - 0.5 * kG / l * std::sin(b);
    const Real m11 = 4.0 / 3, m12 = 0.5 * c, m22 = 1.0 / 3, det = m11 * m22 - m12 * m12;
    return std::array<Real, 4>{p, q, (m22 * r1 - m12 * r2) / det, (m11 * r2 - m12 * r1) / det};
  };
  constexpr int kFine = 40000;
  for (int i = 0; i < kFine; ++i) {  // classical Runge-Kutta
    const Real h = time / kFine;
    const auto plus = [&](Real s, const std::array<Real, 4>& b) {
      std::array<Real, 4> sum = y;
      for (std::size_t k = 0; k < 4; ++k) sum[k] += s * b[k];
      return sum;
    };
    const auto k1 = rate(y), k2 = rate(plus(h / 2, k1)), k3 = rate(plus(h / 2, k2)), k4 = rate(plus(h, k3));
    for (std::size_t k = 0; k < 4; ++k) y[k] += h / 6 * (k1[k] + 2 * k2[k] + 2 * k3[k] + k4[k]);
  }
  const Vec3 truth(l * std::sin(y[0]) + l / 2 * std::sin(y[1]), -l * std::cos(y[0]) - l / 2 * std::cos(y[1]), 0);
  holds(
      "double pendulum",
      [&](Real tolerance) {
        TestWorld t;
        ask(t, tolerance);
        const std::uint32_t last = hang_two(t, 1.5, -1, JointKind::hinge);
        t.run(60, time / 60);
        return (t.world.state.x[last] - truth).norm();
      },
      {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}, time);
}

/// A block slides and stops after v^2 / (2 mu g). Detection is once a step, and stopping is an event: what is held is
/// the bound, not a slope.
static void a_block_that_slides_stops_where_it_should(void**) {
  for (const Real tolerance : {1e-2, 1e-3, 1e-4}) {
    TestWorld t;
    ask(t, tolerance);
    const std::uint32_t rough = t.material(0.4, 0);
    t.ground(rough);
    const std::uint32_t block =
        t.add(t.keep(box(Vec3(0.3, 0.1, 0.3))), Vec3(0, 0.1, 0), BodyType::dynamic, Quat::identity(), rough);
    t.world.set_velocity(block, Vec3(3, 0, 0), Vec3::zero());
    t.run(90, 1.0 / 60);
    const Real off = std::fabs(t.world.state.x[block].x() - 9 / (2 * 0.4 * kG));
    std::printf("  block: asked %.1e, got %.2e m\n", 1.5 * tolerance, off);
    assert_true(off < 10 * 1.5 * tolerance);
  }
}

/// One island does not change what another gets, nor a bit of it: each alone, and all in one world.
static void islands_do_not_know_of_each_other(void**) {
  const auto build = [](TestWorld& t, bool pile, bool rod, bool top, Vec3* end) {
    ask(t, 1e-4);
    std::uint32_t rod_slot = 0, top_slot = 0, box_slot = 0;
    if (rod) rod_slot = hang_rod(t, 2.5);
    if (top) {
      top_slot = add_body(t, Vec3(50, 0, 0), 1, Vec3(1, 2, 2.5));
      t.world.set_velocity(top_slot, Vec3::zero(), Vec3(4, 1, 2));
    }
    if (pile) {
      t.add(t.keep(box(Vec3(10, 1, 10))), Vec3(-30, -1, 0), BodyType::fixed);
      for (int i = 0; i < 4; ++i) box_slot = t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(-30, 0.5 + 1.01 * i, 0));
    }
    t.run(40, 1.0 / 60);
    if (rod) end[0] = t.world.state.x[rod_slot];
    if (top) end[1] = t.world.state.omega[top_slot];
    if (pile) end[2] = t.world.state.x[box_slot];
  };
  Vec3 alone[3], together[3];
  for (int k = 0; k < 3; ++k) {
    TestWorld t;
    build(t, k == 2, k == 0, k == 1, alone);
  }
  TestWorld t;
  build(t, true, true, true, together);
  for (int k = 0; k < 3; ++k) assert_true(alone[k] == together[k]);
  assert_int_equal(t.world.accuracy->views.size(), 3);
}

/// Solvers that go through all rows at once: what touches nothing and takes other substeps finds none of them.
static void rows_at_once_stay_with_their_island(void**) {
  for (const Real solver : {kSeverityChoice, kSoftChoice, kDirectChoice}) {
    Vec3 alone[2], together[2];
    for (int which = 0; which < 3; ++which) {
      TestWorld t;
      t.world.set_dial(Dial::solver, solver);
      ask(t, 1e-4);
      std::uint32_t box_slot = 0, ball = 0;
      if (which != 1) {
        t.add(t.keep(box(Vec3(10, 1, 10))), Vec3(0, -1, 0), BodyType::fixed);
        for (int i = 0; i < 4; ++i) box_slot = t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(0, 0.5 + 1.01 * i, 0));
      }
      if (which != 0) {
        ball = t.add(t.keep(sphere(0.1)), Vec3(50, 40, 0));
        t.world.set_damping(ball, 3, 0.5);
        t.world.set_velocity(ball, Vec3(9, 0, 0), Vec3(1, 5, 2));
      }
      t.run(40, 1.0 / 60);
      if (which != 1) (which == 2 ? together : alone)[0] = t.world.state.x[box_slot];
      if (which != 0) (which == 2 ? together : alone)[1] = t.world.state.x[ball];
    }
    for (int k = 0; k < 2; ++k) assert_true(alone[k] == together[k]);
  }
}

/// The ledger has what was accepted run once more. That changes nothing: not moments of what rolls and spins against a
/// resistance, which a run starts from, nor impulses, springs or joints.
static void a_ledger_changes_no_bit(void**) {
  for (int which = 0; which < 4; ++which) {
    std::uint64_t hash[2];
    for (int booked = 0; booked < 2; ++booked) {
      TestWorld t;
      ask(t, 1e-3, 16);
      Material m;
      m.friction = 0.6, m.rolling = 0.01 + 0.02 * which, m.spinning = 0.02, m.restitution = which == 1 ? 0.3 : 0;
      const std::uint32_t material = handle_slot(t.world.add_material(m));
      t.ground(material);
      std::uint32_t ball[3];
      for (int i = 0; i < 3; ++i) {
        ball[i] = t.add(t.keep(sphere(0.3 + 0.1 * i)), Vec3(2 * i, 0.3 + 0.1 * i, 0), BodyType::dynamic,
                        Quat::identity(), material);
        t.world.set_velocity(ball[i], Vec3(1 + i, 0, 0.5), Vec3(0, 3 * i, -2));
      }
      if (which == 2) join(t, JointKind::ball, ball[0], ball[1], Vec3(1, 0.4, 0));
      if (which == 3)
        t.add(t.keep(box(Vec3(0.4, 0.2, 0.3))), Vec3(3, 0.2, 0), BodyType::dynamic, Quat::identity(), material);
      if (booked) t.world.keep_ledger(true);
      t.run(90, 1.0 / 60);
      hash[booked] = t.world.hash();
    }
    assert_true(hash[0] == hash[1]);
  }
}

/// A pile at rest takes no more than the two substeps without which its contacts would be softer, and is estimated
/// every eighth step.
static void a_pile_at_rest_costs_little(void**) {
  TestWorld t;
  ask(t, 1e-4);
  t.ground();
  for (int i = 0; i < 5; ++i) t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(0, 0.5 + i, 0));
  t.run(120, 1.0 / 60);
  std::uint64_t work = 0;
  for (int k = 0; k < 64; ++k) {
    t.world.step(1.0 / 60);
    assert_int_equal(t.world.accuracy->views.size(), 1);
    assert_in_range(t.world.accuracy->views[0].substeps, 1, 2);
    work += t.world.accuracy->views[0].work;
  }
  std::printf("  64 steps, %llu substeps\n", static_cast<unsigned long long>(work));
  assert_true(work <= 64 * 2 + 16 * 4);
}

/// Heaps that fall, asked for more than contacts give: no island goes beyond its points times substeps but to take as
/// many as without an accuracy; it says so where that leaves an error over the tolerance, and most of the work is used.
static void large_islands_stay_within_their_work(void**) {
  const struct {
    int bodies;
    Real work, dt;
  } heaps[] = {{27, 400, 1.0 / 60}, {60, 2000, 1.0 / 60}, {40, 900, 1.0 / 120}, {12, 30, 1.0 / 30}};
  for (const auto& heap : heaps) {
    TestWorld t;
    ask(t, 1e-6);
    t.world.set_dial(Dial::accuracy_work, heap.work);
    t.ground();
    for (int i = 0; i < heap.bodies; ++i)
      t.add(t.keep(box(Vec3(0.3, 0.2, 0.4))), Vec3(0.5 * (i % 3), 0.5 + 0.5 * (i / 3), 0.37 * (i % 4)));
    int bound = 0;
    Real most = 0;
    for (int k = 0; k < 60; ++k) {
      t.world.step(heap.dt);
      for (const Passes::Island& island : t.world.accuracy->passes.islands) {
        const Real work = Real(island.rows) * island.trial.taken;
        assert_true(island.rows == 0 || work <= heap.work || island.trial.taken <= 4);
        if (island.rows > 0) most = std::max(most, std::min(work, heap.work));
      }
      for (const AccuracyView& view : t.world.accuracy->views) {
        if (!(view.flags & AccuracyView::kHitBound)) continue;
        ++bound;
        assert_true(view.share() > 1);
      }
    }
    std::printf("  %d boxes: %.0f of %.0f, bound %d times\n", heap.bodies, most, heap.work, bound);
    assert_true(bound > 0);
    assert_true(most > heap.work / 2);
  }
}

/// A world that asks for nothing has nothing of it: no room, no notes, and what bits a step with the same substeps has
/// where accuracy was asked for and taken back.
static void nothing_is_there_where_nothing_is_asked(void**) {
  const auto pile = [](TestWorld& t) {
    t.ground();
    for (int i = 0; i < 5; ++i) t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(0.1 * i, 0.6 + 1.1 * i, 0));
    hang_rod(t, 2);
  };
  TestWorld never, once;
  pile(never), pile(once);
  ask(once, 1e-4);
  ask(once, 0, 256);
  for (int k = 0; k < 60; ++k) {
    never.world.step(1.0 / 60), once.world.step(1.0 / 60);
    assert_null(never.world.accuracy.get());
    assert_null(once.world.accuracy.get());
    assert_true(never.world.hash() == once.world.hash());
  }
  for (const AccuracyMemory& note : never.world.state.accuracy) assert_true(note == AccuracyMemory());
  ask(once, 1e-4);
  once.world.step(1.0 / 60);
  assert_non_null(once.world.accuracy.get());
  ask(once, 0, 256);
  once.world.step(1.0 / 60);
  assert_null(once.world.accuracy.get());
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(a_pendulum_gets_what_is_asked),
      cmocka_unit_test(a_ball_on_a_spring_gets_what_is_asked),
      cmocka_unit_test(a_top_gets_what_is_asked),
      cmocka_unit_test(two_masses_on_three_springs_get_what_is_asked),
      cmocka_unit_test(a_double_pendulum_gets_what_is_asked),
      cmocka_unit_test(a_block_that_slides_stops_where_it_should),
      cmocka_unit_test(islands_do_not_know_of_each_other),
      cmocka_unit_test(rows_at_once_stay_with_their_island),
      cmocka_unit_test(a_ledger_changes_no_bit),
      cmocka_unit_test(a_pile_at_rest_costs_little),
      cmocka_unit_test(large_islands_stay_within_their_work),
      cmocka_unit_test(nothing_is_there_where_nothing_is_asked),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
