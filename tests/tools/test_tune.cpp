// `carom tune`: a front that is one, a pick within the budget, predictions that hold, chaos that is told.
#include <cmath>

#include "../carom_test.h"
#include "host/cpu_time.h"
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

Result ask(const Question& q) {
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  int calls = 0, last = 0;
  const Result a = search(engine, q, [&](int done, int total, const std::string& what) {
    assert_true(done == last + 1 && done <= total && !what.empty());
    last = done, ++calls;
  });
  assert_true(calls > a.tried);
  return a;
}

void is_a_front(const Result& a) {
  assert_true(!a.front.empty() && a.all.size() > 15);
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
  const Result a = ask(q);
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
  const Result a = ask(question("bounce05", 1.5, ErrorKind::truth));
  is_a_front(a);
  assert_true(a.kind == ErrorKind::truth && a.floor == 0 && a.pick >= 0);
  assert_true(a.front.back().error < 1e-5);
  bool own = false;
  for (const Measured& m : a.all) own |= m.is_default;
  assert_true(own);
}

[[maybe_unused]] static void chaos_is_told_and_laws_are_compared(void**) {
  Question q = question("falling", 3, ErrorKind::pose);  // a few boxes and balls tumble over each other
  q.settings.values = {{"n", 12}};
  const Result a = ask(q);
  is_a_front(a);
  assert_true(a.chaotic);
  assert_true(a.kind == ErrorKind::laws && a.spread > 1e-3);
  for (const Measured& m : a.front) {  // no offence is larger than all together
    assert_true(m.offences.sink <= m.errors[static_cast<std::size_t>(ErrorKind::laws)]);
    assert_true(m.offences.cone / q.frame_rate <= m.errors[static_cast<std::size_t>(ErrorKind::laws)]);
  }
}

/// README's scene, at its own length: one run in five or so errs ten times as much as others, by luck. So runs are compared with
/// runs: two sets of five from one law lie more than a factor of two apart, all of them, in less than 2 / C(10, 5) of cases.
[[maybe_unused]] static void what_is_said_of_a_chaotic_pick_holds_for_other_runs(void**) {
  Question q = question("seesaw", find_scene("seesaw").seconds, ErrorKind::pose);
  q.repeats = 5;
  q.patience = 10;
  const Result a = ask(q);
  assert_true(a.chaotic && a.kind == ErrorKind::laws && a.pick >= 0);
  const Measured& said = a.front[static_cast<std::size_t>(a.pick)];
  std::printf("  said %.3g m (%.3g to %.3g), found %.3g m (%.3g to %.3g) in a new world\n", said.error,
              said.least_error, said.most_error, a.fresh.error, a.fresh.least_error, a.fresh.most_error);
  assert_true(errors_agree(said, a.fresh));
}

static void what_is_far_too_dear_is_given_up_at_once(void**) {
  Question q = question("stack20", 1, ErrorKind::pose);
  q.budget_ms = 1e-6;
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  const Result a = search(engine, q, {});
  assert_true(a.front.empty() && a.pick < 0 && a.too_dear == a.tried && a.tried == 1);
  assert_true(a.all.size() == 1 && a.all[0].ms > 1e-4);  // what the library's own takes is told
}

[[maybe_unused]] static void no_setting_is_offered_that_lets_a_stack_fall(void**) {
  // A tonne on a kilogram on springs and a few sweeps: solvers other than the direct one drop it.
  // Candidates that fell in the first part of 4 s are not run over all of it: no more than the front is known of them.
  // 2 s are too few for a first part, so `all` has every candidate, whatever the times of this machine are.
  for (const double seconds : {4.0, 2.0}) {
    Question q = question("massratio1e4", seconds, ErrorKind::pose);
    q.kind_chosen = true;
    const Result a = ask(q);
    assert_true(a.let_fall > 0 && a.pick >= 0);
    for (const Measured& m : a.front) assert_true(m.fallen == 0 && std::isfinite(m.error));
    int fell = 0;
    for (const Measured& m : a.all) {
      fell += m.fallen > 0;
      if (m.fallen > 0) assert_true(std::isinf(m.error));
    }
    if (seconds == 2.0) assert_int_equal(fell, a.let_fall);
    assert_true(fell <= a.let_fall);
  }
}

static void bodies_that_stand_in_both_references_must_stand(void**) {
  Trace up;
  up.matter.resize(2);
  for (Matter& m : up.matter) m.mass = 1, m.spread = Eigen::Matrix3d::Identity() / 12, m.home = Vec(0, 0.5, 0);
  up.energy = up.sink = up.joints = up.cone = {0};
  up.center = {Vec(0, 0.5, 0), Vec(0, 0.5, 0)};
  up.orientation = {Quat::Identity(), Quat::Identity()};
  Trace one_down = up;
  one_down.center[1] = Vec(0, -0.5, 0);  // by more than half its size, 0.5 m
  assert_int_equal(fallen(up, {up, up}), 0);
  assert_int_equal(fallen(one_down, {up, up}), 1);
  assert_int_equal(fallen(one_down, {up, one_down}), 0);  // the references don't agree on it
  assert_true(std::isinf(errors_of(one_down, {up, up}, 60)[static_cast<std::size_t>(ErrorKind::pose)]));
}

static void candidates_are_all_different_and_near_ones_near(void**) {
  for (int bits = 0; bits < 32; ++bits)
    for (const bool few : {false, true}) {
      const Participants who{(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0, (bits & 16) != 0};
      const std::vector<Setting> all = first_candidates(who, few);
      for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) assert_false(all[i] == all[j]);
      assert_true(all.front() == Setting({1, {}}));
      for (const Setting& s : all)
        for (const Setting& n : neighbours(s, who)) assert_false(n == s);
    }
}

static bool tries(const Participants& who, const std::string& dial) {
  for (const Setting& s : first_candidates(who)) {
    for (const auto& d : s.dials)
      if (d.first == dial) return true;
    for (const Setting& n : neighbours(s, who))
      for (const auto& d : n.dials)
        if (d.first == dial) return true;
  }
  return false;
}

static void dials_without_participants_are_not_tried(void**) {
  const Participants none{}, contacts{.contacts = true}, turns{.turns = true};
  for (const char* dial :
       {"solver", "rotation", "restitution_speed", "contact_frequency", "hold_angle", "precision", "integrator"})
    assert_false(tries(none, dial));
  for (const char* dial : {"preset", "substeps"}) assert_true(tries(none, dial));
  for (const char* dial : {"solver", "contact_frequency", "hold_angle", "precision"})
    assert_true(tries(contacts, dial));
  for (const char* dial : {"rotation", "restitution_speed", "integrator"}) assert_false(tries(contacts, dial));
  assert_true(tries(turns, "rotation"));
  // And a scene tells: nothing touches, bounces or is joined in it, and its boxes are alike about all axes.
  assert_false(ask(question("freefall", 1, ErrorKind::truth)).who.contacts);
  const Result joined = ask(question("pendulum", 1, ErrorKind::truth));
  assert_true(joined.who.joints && !joined.who.contacts && !joined.who.bounces);
}

[[maybe_unused]] static void a_search_takes_about_as_long_as_it_may(void**) {
  Question q = question("falling", 10, ErrorKind::pose);
  q.settings.values = {{"n", 200}};
  q.patience = 3;
  const double begun = cpu_time();
  const Result a = ask(q);
  assert_true(cpu_time() - begun < 2 * q.patience);  // what runs when time is over is finished
  assert_true(a.seconds < q.seconds && a.pick >= 0);
}

int main(void) {
  const CMUnitTest tests[] = {
#ifndef CAROM_SANITIZED
      cmocka_unit_test(a_stack_is_held_best_by_the_direct_solver),
      cmocka_unit_test(chaos_is_told_and_laws_are_compared),
      cmocka_unit_test(what_is_said_of_a_chaotic_pick_holds_for_other_runs),
      cmocka_unit_test(no_setting_is_offered_that_lets_a_stack_fall),
      cmocka_unit_test(a_search_takes_about_as_long_as_it_may),
#endif
      cmocka_unit_test(a_bounce_is_judged_by_its_closed_form),
      cmocka_unit_test(what_is_far_too_dear_is_given_up_at_once),
      cmocka_unit_test(bodies_that_stand_in_both_references_must_stand),
      cmocka_unit_test(dials_without_participants_are_not_tried),
      cmocka_unit_test(candidates_are_all_different_and_near_ones_near),
  };
  return cmocka_run_group_tests_name("tools/tune", tests, nullptr, nullptr);
}
