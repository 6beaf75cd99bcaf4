// `carom tune`: a front that is one, a pick within the budget, predictions that hold, chaos that is told.
#include <cmath>

#include "../carom_test.h"
#include "tune/tune.h"

using namespace carom::tools;
using namespace carom::tools::tune;

namespace {

Question question(const char* name, double seconds, ErrorKind kind) {
  Question q;
  for (const accuracy::Challenge& c : accuracy::all_challenges())
    if (c.scene.name == name) q.challenge = &c;
  q.scene = q.challenge ? &q.challenge->scene : &find_scene(name);
  q.seconds = seconds;
  q.kind = kind;
  q.repeats = 1;
  return q;
}

Answer ask(const Question& q) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  int calls = 0, last = 0;
  const Answer a = search(engine, q, [&](int done, int total, const std::string& what) {
    assert_true(done == last + 1 && done <= total && !what.empty());
    last = done, ++calls;
  });
  assert_true(calls > a.tried);
  return a;
}

void is_a_front(const Answer& a) {
  assert_true(!a.front.empty() && a.all.size() > 40);
  for (std::size_t i = 1; i < a.front.size(); ++i)
    assert_true(a.front[i].ms >= a.front[i - 1].ms && a.front[i].error < a.front[i - 1].error);
  for (const Measured& m : a.all)
    for (const Measured& f : a.front)  // clearly better and cheaper than a member: it would be there in its place
      assert_false(m.ms < f.ms && m.error < 0.9 * f.error);
}

}  // namespace

[[maybe_unused]] static void a_stack_is_held_best_by_the_direct_solver(void**) {
  Question q = question("stack20", 2, ErrorKind::pose);
  q.kind_chosen = true;
  const Answer a = ask(q);
  is_a_front(a);
  assert_false(a.chaotic);
  assert_true(a.pick >= 0);
  const Measured& pick = a.front[static_cast<std::size_t>(a.pick)];
  assert_true(pick.ms <= q.budget_ms);
  // Soft contacts sink by centimetres, the direct solver by none of them: the pick is not soft.
  assert_true(pick.error < 1e-4);
  assert_true(a.fresh.error == pick.error);  // same settings, same bits
  bool soft = false;
  for (const Measured& m : a.all)
    for (const auto& [dial, value] : m.setting.dials)
      soft |= dial == "solver" && value == "soft_step" && m.error > 1e-3;
  assert_true(soft);
}

static void a_bounce_is_judged_by_its_closed_form(void**) {
  const Answer a = ask(question("bounce05", 1.5, ErrorKind::truth));
  is_a_front(a);
  assert_true(a.kind == ErrorKind::truth && a.floor == 0 && a.pick >= 0);
  assert_true(a.front.back().error < 1e-5);
  bool own = false;
  for (const Measured& m : a.all) own |= m.is_default;
  assert_true(own);
}

[[maybe_unused]] static void chaos_is_told_and_gaps_are_compared(void**) {
  Question q = question("falling", 3, ErrorKind::pose);  // a few boxes and balls tumble over each other
  q.settings.values = {{"n", 6}};
  const Answer a = ask(q);
  is_a_front(a);
  assert_true(a.chaotic);
  assert_true(a.kind == ErrorKind::gap && a.spread > 1e-3);
}

static void what_is_far_too_dear_is_given_up(void**) {
  Question q = question("stack20", 1, ErrorKind::pose);
  q.budget_ms = 1e-6;
  const Answer a = ask(q);
  assert_true(a.front.empty() && a.pick < 0 && a.too_dear == a.tried && a.tried > 40);
}

static void candidates_are_all_different_and_near_ones_near(void**) {
  const std::vector<Setting> all = first_candidates();
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) assert_false(all[i] == all[j]);
  assert_true(all.front() == Setting({1, {}}));
  for (const Setting& s : all)
    for (const Setting& n : neighbours(s)) assert_false(n == s);
}

int main(void) {
  const CMUnitTest tests[] = {
#ifndef CAROM_SANITIZED
      cmocka_unit_test(a_stack_is_held_best_by_the_direct_solver),
      cmocka_unit_test(chaos_is_told_and_gaps_are_compared),
#endif
      cmocka_unit_test(a_bounce_is_judged_by_its_closed_form),
      cmocka_unit_test(what_is_far_too_dear_is_given_up),
      cmocka_unit_test(candidates_are_all_different_and_near_ones_near),
  };
  return cmocka_run_group_tests_name("tools/tune", tests, nullptr, nullptr);
}
