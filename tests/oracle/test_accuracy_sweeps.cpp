// An accuracy is asked for while something is swept: what the sweep may change takes the dial's substeps, all others
// get what they get alone, and no hit is lost where substeps go by island.
#include <algorithm>
#include <cstdio>

#include "carom_test.h"
#include "dynamics/accuracy/accuracy.h"
#include "dynamics/ccd/continuous.h"
#include "dynamics/ledger/ledger.h"
#include "rattle_scenes.h"

using namespace carom;
using namespace carom::test;

namespace {

/// A ball that flies to and fro along z between two walls, so fast that every step sweeps it.
std::uint32_t shuttle(TestWorld& t, const Vec3& at, Real speed) {
  const std::uint32_t m = t.material(0, 1);
  for (const Real z : {-2.0, 2.0})
    t.add(t.keep(box(Vec3(1, 1, 0.1))), at + Vec3(0, 0, z), BodyType::fixed, Quat::identity(), m);
  const std::uint32_t ball = t.add(t.keep(sphere(0.05)), at, BodyType::dynamic, Quat::identity(), m);
  t.world.set_velocity(ball, Vec3(0, 0, speed), Vec3::zero());
  return ball;
}

struct Others {
  bool rod = false, spring = false, pile = false, block = false, roller = false;
};

/// Islands of all kinds, far from the origin of the shuttle.   @return the state of each that is there
std::vector<Vec3> run_others(TestWorld& t, const Others& which, Real dt, int steps) {
  std::vector<std::uint32_t> slots;
  if (which.rod) slots.push_back(hang_rod(t, 2.5));
  if (which.spring) {
    slots.push_back(add_body(t, Vec3(40, 0, 0), 1, Vec3(1, 1, 1)));
    SpringDef spring;
    spring.body_b = slots.back(), spring.anchor_a = Vec3(39, 0, 0), spring.stiffness = 100;
    t.world.add_spring(spring);
  }
  const auto floor = [&](Real x) { t.add(t.keep(box(Vec3(8, 1, 8))), Vec3(x, -1, 0), BodyType::fixed); };
  if (which.pile) {
    floor(-30);
    for (int i = 0; i < 4; ++i) slots.push_back(t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(-30, 0.5 + 1.01 * i, 0)));
  }
  if (which.block) {
    floor(80);
    slots.push_back(t.add(t.keep(box(Vec3(0.3, 0.1, 0.3))), Vec3(80, 0.1, 0)));
    t.world.set_velocity(slots.back(), Vec3(3, 0, 1), Vec3::zero());
  }
  if (which.roller) {
    floor(120);
    slots.push_back(t.add(t.keep(cylinder(0.3, 0.1)), Vec3(120, 0.3, 0)));
    t.world.set_velocity(slots.back(), Vec3(1, 0, 0), Vec3(0, 0, -2));
  }
  t.run(steps, dt);
  std::vector<Vec3> state;
  for (const std::uint32_t i : slots) state.insert(state.end(), {t.world.state.x[i], t.world.state.v[i]});
  return state;
}

Real energy(const World& w) {
  Real e = 0;
  for (std::uint32_t i = 0; i < w.scene.bodies.slots(); ++i)
    if (w.scene.type[i] == BodyType::dynamic) e += w.scene.mass[i] * w.state.v[i].squared_norm() / 2;
  return e;
}

/// What balls of a row do beside the row, which says whose substeps they take: nothing, so that they go with what is
/// swept; hang on a spring or lie on a floor, so that each is an island of its own.
enum class Held { free, by_springs, by_a_floor };

/// Balls in a row along x, of radius r, that meet head on without loss, the first one fast.
/// @param every  s, a step
void strike_row(const char* what, Held held, std::initializer_list<Real> places, std::initializer_list<Real> masses,
                Real speed, Real r, Real every, int steps) {
  TestWorld t(held == Held::by_a_floor ? Vec3(0, -0.1, 0) : Vec3::zero());
  ask_accuracy(t, 1e-4);
  const std::uint32_t m = t.material(0, 1);
  if (held == Held::by_a_floor) t.ground(m);
  std::vector<std::uint32_t> row;
  const Real* mass = masses.begin();
  for (const Real x : places) {
    row.push_back(t.add(t.keep(sphere(r)), Vec3(x, r, 0), BodyType::dynamic, Quat::identity(), m));
    if (held == Held::by_springs) {
      SpringDef spring;
      spring.body_b = row.back(), spring.anchor_a = Vec3(x, 1, 0), spring.stiffness = 1e-12;
      t.world.add_spring(spring);
    }
    t.world.set_mass(row.back(), {.mass = *mass++});
  }
  t.world.set_velocity(row[0], Vec3(speed, 0, 0), Vec3::zero());
  const Real e = energy(t.world), p = momentum(t.world).x();
  std::uint64_t hits = 0;
  for (int k = 0; k < steps; ++k) {
    t.world.step(every);
    for (std::size_t i = 1; i < row.size(); ++i) {
      const Vec3 on = t.world.state.x[row[i]] - t.world.state.x[row[i - 1]];
      assert_true(on.norm() > 2 * r - 1e-3);
      // What many hits have turned aside may pass.
      if (Vec3(0, on.y(), on.z()).norm() < r) assert_true(on.x() > 0);
    }
    assert_true(std::fabs(energy(t.world) - e) < 1e-9 * e);
    assert_true(std::fabs(momentum(t.world).x() - p) < 1e-9 * p);
    hits += t.world.report.sweep_hits;
  }
  std::printf("  %s: %llu hits, last at %.3f m with %.3f m/s\n", what, static_cast<unsigned long long>(hits),
              t.world.state.x[row.back()].x(), t.world.state.v[row.back()].x());
  assert_true(t.world.state.v[row.back()].x() > 0);
}

}  // namespace

/// While a ball is swept in every step, each other island moves as it does alone, to the bit, with every
/// solver: those that go through all rows at once have none in the pass of the sweep.
static void others_get_their_own_substeps(void**) {
  const Real dt = 1.0 / 60;
  constexpr int kSteps = 40;
  for (const Others& which : {Others{.rod = true}, Others{.spring = true}, Others{.pile = true}, Others{.block = true},
                              Others{.roller = true}, Others{true, true, true, true, true}}) {
    for (const Real solver : {kAutoChoice, kSeverityChoice, kSoftChoice}) {
      TestWorld alone, beside;
      for (TestWorld* t : {&alone, &beside}) ask_accuracy(*t, 1e-4), t->world.set_dial(Dial::solver, solver);
      const auto truth = run_others(alone, which, dt, kSteps);
      shuttle(beside, Vec3(0, 30, 0), 200);
      const auto got = run_others(beside, which, dt, kSteps);
      assert_true(beside.world.report.swept_bodies == 1);
      assert_int_equal(truth.size(), got.size());
      for (std::size_t i = 0; i < truth.size(); ++i) assert_true(truth[i] == got[i]);
    }
  }
}

/// A ball on a spring is as exact as asked beside a sweep: before, it had the dial's substeps.
static void a_sweep_takes_no_accuracy_from_others(void**) {
  for (const Real tolerance : {1e-2, 1e-3, 1e-4}) {
    TestWorld t(Vec3::zero());
    ask_accuracy(t, tolerance);
    shuttle(t, Vec3(0, 30, 0), 300);
    const std::uint32_t ball = add_body(t, Vec3(1, 0, 0), 1, Vec3(1, 1, 1));
    SpringDef spring;
    spring.body_b = ball, spring.stiffness = 100;
    t.world.add_spring(spring);
    t.run(120, 1.0 / 60);
    const Real off = std::fabs(t.world.state.x[ball].x() - std::cos(20.0));
    std::printf("  asked %.1e, got %.2e m\n", 2 * tolerance, off);
    assert_true(off < 3 * 2 * tolerance);
  }
}

/// What is swept itself moves as in a world without an accuracy.
static void what_is_swept_takes_the_dials_substeps(void**) {
  for (const Real speed : {60.0, 200.0, 777.0}) {
    Vec3 x[2], v[2], near[2];
    for (int asked = 0; asked < 2; ++asked) {
      TestWorld t;
      if (asked) ask_accuracy(t, 1e-5);
      const std::uint32_t ball = shuttle(t, Vec3(0, 5, 0), speed);
      t.ground();
      const std::uint32_t block = t.add(t.keep(box(Vec3(0.3, 0.3, 0.3))), Vec3(0, 5.4, 1.2));
      t.run(50, 1.0 / 60);
      x[asked] = t.world.state.x[ball], v[asked] = t.world.state.v[ball], near[asked] = t.world.state.x[block];
    }
    assert_true(x[0] == x[1] && v[0] == v[1] && near[0] == near[1]);
  }
}

/// The ledger changes nothing, though the swept have one run and all others one more; what it tells adds up.
static void a_ledger_changes_no_bit_of_it(void**) {
  for (int which = 0; which < 4; ++which) {
    std::uint64_t hash[2];
    for (int booked = 0; booked < 2; ++booked) {
      TestWorld t;
      ask_accuracy(t, 1e-3);
      if (which == 3) t.world.set_dial(Dial::sleep_time, 0.2), t.world.set_dial(Dial::sleep, 1);
      t.ground(t.material(0.5, 0.3));
      for (int i = 0; i < 5; ++i) t.add(t.keep(box(Vec3(0.5, 0.5, 0.5))), Vec3(1.3 * (i % 2), 0.5 + i / 2 * 1.01, 0));
      hang_rod(t, 2);
      if (booked) t.world.keep_ledger(true);
      if (which == 3) t.run(60, 1.0 / 60);
      const std::uint32_t bullet = t.add(t.keep(sphere(0.05 + 0.02 * which)), Vec3(-6 - which, 0.6 + 0.2 * which, 0.1));
      t.world.set_velocity(bullet, Vec3(150 + 77 * which, 3, 0), Vec3(0, 10, 3));
      for (int k = 0; k < 60; ++k) {
        t.world.step(1.0 / 60);
        if (!booked) continue;
        const Ledger& l = *t.world.ledger;
        Amount sum = l.before;
        for (const Account& a : l.step) sum += a.value();
        assert_true(std::fabs(sum.energy() - l.now.energy()) <= l.step_rounding.energy);
        assert_true((sum.linear - l.now.linear).norm() <= l.step_rounding.linear);
      }
      hash[booked] = t.world.hash();
    }
    assert_true(hash[0] == hash[1]);
  }
}

/// A hit leads on to what no straight path came near, in the same step: nothing is lost and nothing passed through.
static void chains_of_hits_keep_what_they_carry(void**) {
  for (const Held held : {Held::free, Held::by_springs, Held::by_a_floor}) {
    strike_row("like masses", held, {0, 1, 2, 3}, {1, 1, 1, 1}, 100, 0.1, 1.0 / 60, 20);
    strike_row("ever lighter", held, {0, 1, 4, 9}, {8, 2, 0.5, 0.1}, 100, 0.1, 1.0 / 60, 20);
  }
}

// ---- held out: looked at once all of the above went well ----

static void other_chains_of_hits(void**) {
  for (const Held held : {Held::free, Held::by_springs, Held::by_a_floor}) {
    strike_row("ever lighter, far", held, {0, 0.5, 9, 30, 90}, {100, 10, 1, 0.1, 0.01}, 70, 0.05, 1.0 / 30, 40);
    strike_row("slow steps", held, {0, 2, 40, 41, 200}, {30, 3, 3, 0.3, 0.03}, 100, 0.15, 1.0 / 10, 30);
    strike_row("near the edge of the reach", held, {0, 1.1, 2.05, 4.1}, {5, 1, 0.2, 0.04}, 120, 0.1, 1.0 / 60, 20);
  }
  // Twenty hits turn balls aside and into a floor, which takes what is slower than its restitution speed.
  for (const Held held : {Held::free, Held::by_springs})
    strike_row("a heavy last", held, {0, 1, 5, 20}, {4, 1, 0.25, 1000}, 250, 0.2, 1.0 / 120, 120);
}

/// Boxes that float, bullets among them: momentum is kept to rounding, for any number of threads the same bits.
static void bullets_among_what_floats(void**) {
  for (const int seed : {3, 14, 159}) {
    std::uint64_t hash[2];
    for (int many = 0; many < 2; ++many) {
      JobPool pool(
          4, [] {}, std::pmr::new_delete_resource());
      TestWorld t(Vec3::zero());
      if (many) t.world.jobs = &pool;
      ask_accuracy(t, 1e-4);
      Random random(static_cast<std::uint64_t>(seed));
      const auto within = [&](Real r) {
        return Vec3(random.uniform(-r, r), random.uniform(-r, r), random.uniform(-r, r));
      };
      const std::uint32_t m = t.material(0.3, 0.8);
      for (int i = 0; i < 30; ++i) {
        const Vec3 half = Vec3::constant(0.3) + within(0.2);
        const std::uint32_t b = t.add(t.keep(box(half)), within(4), BodyType::dynamic, Quat::identity(), m);
        t.world.set_velocity(b, within(1), within(2));
      }
      for (int i = 0; i < 5; ++i) {
        const Vec3 from = 8 * random.direction();
        const std::uint32_t b = t.add(t.keep(sphere(0.06)), from, BodyType::dynamic, Quat::identity(), m);
        t.world.set_velocity(b, (within(2) - from) * random.uniform(10, 60), within(20));
      }
      const Vec3 before = momentum(t.world);
      Real most = 0;
      for (std::uint32_t i = 0; i < t.world.scene.bodies.slots(); ++i)
        most += t.world.scene.mass[i] * t.world.state.v[i].norm();
      t.run(90, 1.0 / 60);
      assert_true((momentum(t.world) - before).norm() < 1e-10 * most);
      hash[many] = t.world.hash();
    }
    assert_true(hash[0] == hash[1]);
  }
}

int main(void) {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(others_get_their_own_substeps),
      cmocka_unit_test(a_sweep_takes_no_accuracy_from_others),
      cmocka_unit_test(what_is_swept_takes_the_dials_substeps),
      cmocka_unit_test(a_ledger_changes_no_bit_of_it),
      cmocka_unit_test(chains_of_hits_keep_what_they_carry),
      cmocka_unit_test(other_chains_of_hits),
      cmocka_unit_test(bullets_among_what_floats),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
