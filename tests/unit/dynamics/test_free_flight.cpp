// Who flies takes a step in one go: the others do not change its bits, and it ends where its parabola does.
#include <cmath>
#include <random>
#include <set>

#include "carom_test.h"
#include "dynamics/integrate/free_flight.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 60;  // s

Participants listed(const std::set<std::uint32_t>& slots) {
  Participants list(std::pmr::new_delete_resource());
  for (const std::uint32_t i : slots) list.add(i);
  return list;
}

std::set<std::uint32_t> slots_of(const Participants& list) {
  std::set<std::uint32_t> slots;
  list.each([&](std::uint32_t i) { slots.insert(i); });
  assert_int_equal(slots.size(), list.count);
  for (std::size_t r = 1; r < list.runs.size(); ++r) assert_true(list.runs[r - 1].end < list.runs[r].begin);
  return slots;
}

/// Balls and cubes high up, some of them spinning and some of less weight.
std::vector<std::uint32_t> throw_some(TestWorld& t) {
  const Shape *ball = t.keep(sphere(0.3)), *cube = t.keep(box(Vec3::constant(0.3)));
  std::vector<std::uint32_t> flyers;
  for (int i = 0; i < 20; ++i) {
    const std::uint32_t body = t.add(i % 2 ? ball : cube, Vec3(2 * i, 500, 0));
    t.world.set_velocity(body, Vec3(0.1 * i, 1, -2), i % 3 ? Vec3(1, 0.1 * i, 3) : Vec3::zero());
    if (i % 4 == 0) t.world.set_attribute(body, AttributeId::gravity_factor, {0.5});
    flyers.push_back(body);
  }
  return flyers;
}

/// A heap of three, a pendulum, and a plank that tumbles.
void let_others_work(TestWorld& t) {
  const Shape *cube = t.keep(box(Vec3::constant(0.5))), *plank = t.keep(box(Vec3(0.1, 0.4, 1)));
  t.world.set_dial(Dial::sleep, 0);
  t.ground();
  for (int i = 0; i < 3; ++i) t.add(cube, Vec3(0, 0.5 + i, 0));
  JointDef def;
  def.body_a = t.add(cube, Vec3(10, 20, 0));
  def.frame_b.p = Vec3(12, 20, 0);
  def.frame_a.p = Vec3(2, 0, 0);
  t.world.add_joint(def);
  t.world.set_velocity(t.add(plank, Vec3(30, 100, 0)), Vec3::zero(), Vec3(1, 2, 3));
}

}  // namespace

static void lists_unite_and_part_as_sets_do(void**) {
  std::mt19937 random(7);
  for (int round = 0; round < 2000; ++round) {
    std::set<std::uint32_t> a, b, either, rest;
    const std::uint32_t range = 1 + random() % 40;
    for (std::uint32_t k = random() % 40; k > 0; --k) a.insert(random() % range);
    for (std::uint32_t k = random() % 40; k > 0; --k) b.insert(random() % range);
    either = a;
    either.insert(b.begin(), b.end());
    for (const std::uint32_t i : a)
      if (!b.count(i)) rest.insert(i);
    Participants out(std::pmr::new_delete_resource());
    unite(listed(a), listed(b), out);
    assert_true(slots_of(out) == either);
    take_out(listed(a), listed(b), out);
    assert_true(slots_of(out) == rest);
  }
}

static void flyers_have_the_bits_of_a_world_of_their_own(void**) {
  TestWorld alone, among;
  const std::vector<std::uint32_t> flyers = throw_some(alone);
  assert_true(throw_some(among) == flyers);
  let_others_work(among);
  for (int step = 0; step < 60; ++step) {
    for (TestWorld* t : {&alone, &among})
      if (step % 10 == 3) t->world.add_force(flyers[5], Vec3(100, 200, 300), Vec3::zero());
    alone.run(1, kStep), among.run(1, kStep);
    assert_true(among.world.report.contact_points > 0);
    const State &a = alone.world.state, &b = among.world.state;
    for (const std::uint32_t i : flyers)
      assert_true(a.x[i] == b.x[i] && a.v[i] == b.v[i] && a.omega[i] == b.omega[i] && a.q[i] == b.q[i]);
  }
  // Twice in a step, as often as in a substep of the four others; of the pendulum at the ends of its four stages.
  assert_int_equal(alone.world.plan->find("gravity")->evaluations, 2 * 60 * 20);
  assert_int_equal(among.world.plan->find("gravity")->evaluations, 2 * 60 * (20 + 4 * 4) + 60 * 5);
}

static void a_flyer_ends_where_its_parabola_does(void**) {
  TestWorld t;
  let_others_work(t);
  const std::uint32_t ball = t.add(t.keep(sphere(0.3)), Vec3(0, 500, 0));
  t.world.set_velocity(ball, Vec3(3, 4, 5), Vec3(0, 2, 0));
  t.run(120, kStep);
  const Real s = 120 * kStep;
  const Vec3 there = Vec3(0, 500, 0) + s * Vec3(3, 4, 5) + s * s / 2 * Vec3(0, -9.81, 0);
  // A step rounds a place of 500 m, three times.
  assert_true((t.world.state.x[ball] - there).norm() < 3 * 120 * kEpsilon * 500);
  assert_true((t.world.state.v[ball] - Vec3(3, 4 - 9.81 * s, 5)).norm() < 3 * 120 * kEpsilon * 20);
  const Real turned = 2 * std::acos(std::min(Real(1), std::abs(t.world.state.q[ball].w())));
  assert_true(std::abs(turned - std::abs(std::remainder(2 * s, 8 * std::atan(1.0)))) <
              1e-7);  // acos near 1: a root of rounding
}

static void what_depends_on_the_state_is_substepped(void**) {
  TestWorld t;
  let_others_work(t);
  const std::uint32_t ball = t.add(t.keep(sphere(0.3)), Vec3(0, 500, 0));
  t.world.set_attribute(ball, AttributeId::drag, {0.1, 0.1});
  t.run(1, kStep);
  const std::uint64_t flows = t.world.plan->find("drag")->evaluations;
  assert_int_equal(flows, 2 * t.world.plan->substeps);
  // And where somebody is swept, all are: a sweep asks where others are in mid-step.
  const std::uint64_t before = t.world.plan->find("gravity")->evaluations;
  t.world.set_continuous(ball, SweepMode::always);
  t.run(1, kStep);
  assert_int_equal(t.world.plan->find("gravity")->evaluations - before, 2 * 4 * 5 + 5);
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(lists_unite_and_part_as_sets_do),
      cmocka_unit_test(flyers_have_the_bits_of_a_world_of_their_own),
      cmocka_unit_test(a_flyer_ends_where_its_parabola_does),
      cmocka_unit_test(what_depends_on_the_state_is_substepped),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
