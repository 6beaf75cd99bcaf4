// `carom jury --built`: scenes that people build are made as they are meant, the judge hears what hosts and drives do,
// and a slice of them does not get worse.
#include <unistd.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "carom_command.h"
#include "jury/built/builder.h"
#include "jury/gaps.h"
#include "jury/pairs.h"
#include "jury/trial.h"
#include "jury_script.h"
#include "sliced.h"

using namespace jury_test;

namespace {

/// Of three scenes a family. It changes with the generator alone: then seeds name other scenes, and all records of them
/// are void.
constexpr std::uint64_t kGolden = 0x91ab080d02cc8bf6u;

/// A slice, one of each family: how many failed when it was last looked at, by kind: fault, gain, throw, gape,
/// sink, pass, stall, jitter, task. Lower a ceiling with every mend.
constexpr std::uint64_t kSliceFirst = 16, kSliceCount = 16;
constexpr std::size_t kCeiling[kKinds] = {0, 0, 0, 2, 2, 1, 0, 2, 0};
constexpr std::size_t kPlainCeiling[kKinds] = {};

std::size_t families() { return all_families().size(); }

/// A ball on a hinge that stands upright, and a post: what drives it may be set.
struct Merry : Script {
  std::size_t post = add("box", {0.05, 0.05, 0.05}, {0, 1, 0}, CAROM_BODY_STATIC);
  std::size_t ball = add("sphere", {0.1}, {1, 1, 0});
  Merry() {
    Link link;
    link.kind = CAROM_JOINT_HINGE, link.a = post, link.b = ball;
    link.at_b = Vec(-1, 0, 0);
    link.axes_a = link.axes_b = turn_between(Vec::UnitX(), Vec::UnitY());
    drawing.scene.links.push_back(link);
  }
  /// It goes round, with so much more energy in each step than in the one before, J.
  Verdict gains(double by) {
    double energy = 0, angle = 0;
    const Member& m = drawing.scene.members[ball];
    const double about_post = m.mass + m.inertia(1, 1);
    return play(60, [&, by](std::size_t, Frame& f) {
      energy += by;
      const double rate = std::sqrt(2 * energy / about_post);
      angle += rate * kDt;
      f[ball].orientation = Quat(std::cos(angle / 2), 0, std::sin(angle / 2), 0);
      f[ball].position = Vec(std::cos(angle), 1, -std::sin(angle));
      f[ball].omega = Vec(0, rate, 0);
      f[ball].velocity = f[ball].omega.cross(f[ball].position - Vec(0, 1, 0));
    });
  }
  Drive& drive() { return drawing.scene.links[0].drive; }
};

/// A ball at rest on the ground.
struct OneBall : Script {
  std::size_t ball = add("sphere", {0.1}, {0, 0.1, 0});
};

}  // namespace

[[maybe_unused]] static void a_motor_gives_what_it_can_and_no_more(void**) {
  Merry merry;
  assert_non_null(merry.gains(1).of(Kind::gain));
  merry.drive() = {Drive::Aim::speed, 6, 10, 0, 0};  // 6 rad/s, 10 N m: 1 J in a sixtieth of a second
  assert_null(merry.gains(1).of(Kind::gain));
  assert_non_null(merry.gains(2).of(Kind::gain));
  merry.drive() = {Drive::Aim::speed, 0, 1e6, 0, 1};  // a brake gives nothing, however strong
  assert_non_null(merry.gains(1).of(Kind::gain));
  // To a place: with half a joule a step it is at 2 rad after 32, and beyond that a spring gives no more.
  merry.drive() = {Drive::Aim::place, 2, 100, 5, 1};
  const Verdict v = merry.gains(0.5);
  assert_non_null(v.of(Kind::gain));
  assert_true(v.of(Kind::gain)->step > 32);
}

[[maybe_unused]] static void what_a_host_gives_is_no_gain(void**) {
  for (const bool told : {true, false}) {
    OneBall one;
    State high;
    high.position = Vec(0, 3, 0);
    high.velocity = Vec(0, 0, 2);
    if (told) one.drawing.scene.deeds.push_back({0.5, Deed::What::put, one.ball, high, 0});
    Judge judge(one.engine.get(), one.drawing.scene, kDt);
    Frame frame = frame_of(one.stage);
    judge.start(frame);
    State& s = frame[one.ball];
    for (std::size_t step = 1; step <= 60; ++step) {
      const bool now = step == 31;
      if (now) s.position = high.position, s.velocity = high.velocity;
      judge.begin(kDt, now && told ? std::vector<std::size_t>{0} : std::vector<std::size_t>{}, frame);
      if (step >= 31) s.velocity.y() -= 9.81 * kDt, s.position += kDt * s.velocity;
      judge.step(frame);
    }
    const Verdict v = judge.verdict();
    assert_int_equal(v.of(Kind::gain) != nullptr, !told);
    assert_int_equal(v.failures.empty(), told);
  }
}

[[maybe_unused]] static void who_is_not_there_is_not_judged(void**) {
  OneBall one;
  const std::size_t other = one.add("sphere", {0.1}, {0.05, 0.1, 0});  // deep in it, but never there
  const auto leave = [&](std::size_t, Frame& f) { f[other].is_there = false; };
  assert_null(one.play(60, leave).of(Kind::pass));
  assert_non_null(one.play(60, nothing).of(Kind::pass));
}

[[maybe_unused]] static void what_shakes_in_one_place_is_found(void**) {
  OneBall one;
  one.drawing.scene.built = true;
  const auto shake = [&](double by) {
    return [&, by](std::size_t step, Frame& f) { f[one.ball].position.x() = step % 2 ? by : 0; };
  };
  // Second differences are twice as large: 0.5 mm from 0.25 mm to and fro on.
  assert_null(one.play(180, shake(2.4e-4)).of(Kind::jitter));
  const Verdict v = one.play(180, shake(2.7e-4));
  assert_non_null(v.of(Kind::jitter));
  assert_int_equal(v.of(Kind::jitter)->step, 120);  // two seconds
  assert_int_equal(v.of(Kind::jitter)->plain_step, 0);
  assert_int_equal(one.play(180, shake(1.1e-3)).of(Kind::jitter)->plain_step, 120);
  // What swings smoothly, and what goes somewhere, does not shake.
  assert_null(one.play(300,
                       [&](std::size_t step, Frame& f) {
                         f[one.ball].position.x() = 0.01 * std::sin(6.28 * static_cast<double>(step) * kDt);
                       })
                  .of(Kind::jitter));
  assert_null(one.play(300,
                       [&](std::size_t step, Frame& f) {
                         f[one.ball].position.x() = 0.01 * static_cast<double>(step) + (step % 2 ? 1e-3 : 0);
                       })
                  .of(Kind::jitter));
}

[[maybe_unused]] static void what_is_not_done_is_found(void**) {
  OneBall one;
  Goal goal{"the ball rolls", 0.5, 1, true, {}, 0.5, "m"};
  goal.missed_by = [ball = one.ball](const Frame& start, const Frame& now) {
    return 1 - (now[ball].position.x() - start[ball].position.x());
  };
  one.drawing.scene.goals = {goal};
  const auto roll = [&](double speed) {
    return [&, speed](std::size_t, Frame& f) { f[one.ball].position.x() += speed * kDt; };
  };
  assert_null(one.play(120, roll(1.1)).of(Kind::task));
  fails_by(one.play(120, roll(0.9)), Kind::task, 60);
  assert_int_equal(one.play(120, roll(0.9)).of(Kind::task)->plain_step, 0);
  assert_int_equal(one.play(120, roll(0.3)).of(Kind::task)->plain_step, 60);
  one.drawing.scene.goals[0].once = false;  // at all times from half a second on
  fails_by(one.play(120, roll(1.1)), Kind::task, 30);
}

[[maybe_unused]] static void turns_are_those_of_the_library(void**) {
  for (double angle = -3.14; angle < 3.15; angle += 0.01) {
    const Turned t = turned_by(angle);
    // A quarter's are exact to rounding; each doubling doubles an error and adds two.
    assert_true(std::fabs(t.cos - std::cos(angle)) < 10 * DBL_EPSILON);
    assert_true(std::fabs(t.sin - std::sin(angle)) < 10 * DBL_EPSILON);
  }
}

/// A ball on a fixed hinge weighs what it does about the pin; two boxes on a slide, what two masses weigh to each other.
[[maybe_unused]] static void a_joint_knows_what_it_moves(void**) {
  Merry merry;
  const Member& m = merry.drawing.scene.members[merry.ball];
  const double weight = weight_along(merry.drawing.scene, merry.drawing.scene.links[0], frame_of(merry.stage));
  assert_true(std::fabs(weight - (m.mass + m.inertia(1, 1))) < 1e-12 * weight);
  Script pair;
  const std::size_t a = pair.add("box", {0.1, 0.1, 0.1}, {0, 1, 0}), b = pair.add("box", {0.2, 0.1, 0.1}, {1, 1, 0});
  Link link;
  link.kind = CAROM_JOINT_SLIDER, link.a = a, link.b = b, link.at_a = Vec(1, 0, 0);
  const double ma = pair.drawing.scene.members[a].mass, mb = pair.drawing.scene.members[b].mass;
  const double slides = weight_along(pair.drawing.scene, link, frame_of(pair.stage));
  assert_true(std::fabs(slides - ma * mb / (ma + mb)) < 1e-12 * slides);
}

/// How a scene begins: whole, and with nothing in another but where that is meant.
static void begins_as_meant(std::uint64_t seed) {
  const Scenery drawn(plugins(), seed, true);
  const Case& c = drawn.scene;
  const Frame start = frame_of(drawn.stage);
  assert_string_equal(c.family.c_str(), family_of(seed));
  assert_true(c.members.size() > 2 && c.members.size() < 200);
  for (const Link& link : c.links) {
    if (!(gap_of(c, link, start) < 1e-9))
      print_message("seed %d: %s gapes\n", static_cast<int>(seed), c.summary.c_str());
    assert_true(gap_of(c, link, start) < 1e-9);
  }
  for (const Near& near : near_pairs(drawn.engine.get(), c, start, c.dt)) {
    const bool tied = std::any_of(c.links.begin(), c.links.end(),
                                  [&](const Link& l) { return std::minmax(l.a, l.b) == std::minmax(near.a, near.b); });
    if (!tied && c.grace == 0 && near.separation < -1e-6)
      print_message("seed %d, %s: %s and %s, %g m\n", static_cast<int>(seed), c.summary.c_str(),
                    c.members[near.a].name.c_str(), c.members[near.b].name.c_str(), near.separation);
    assert_true(tied || c.grace > 0 || near.separation >= -1e-6);
  }
  double last = 0;
  for (const Deed& deed : c.deeds) {
    assert_true(deed.time >= last);
    last = deed.time;
  }
  for (const Goal& goal : c.goals) assert_true(goal.until <= c.seconds && goal.from <= goal.until);
}

[[maybe_unused]] static void scenes_are_built_as_meant(void**) {
  assert_true(families() >= 12);
#ifdef CAROM_SANITIZED
  constexpr std::size_t kEach = 2;
#else
  constexpr std::size_t kEach = 20;
#endif
  for (std::uint64_t seed = 0; seed < kEach * families(); ++seed) begins_as_meant(seed);
}

[[maybe_unused]] static void a_seed_is_the_same_scene_everywhere(void**) {
  std::uint64_t hash = kNoBits;
  const auto add = [&](double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    hash = (hash ^ bits) * 1099511628211u;
  };
  for (std::uint64_t seed = 0; seed < 3 * families(); ++seed) {
    const Scenery drawn(plugins(), seed, true);
    hash = bits_of(frame_of(drawn.stage), hash);
    for (const Link& link : drawn.scene.links) add(link.drive.goal), add(link.drive.most), add(link.drive.frequency);
    for (const Deed& deed : drawn.scene.deeds) add(deed.time), add(deed.value), add(deed.state.position.x());
    add(drawn.scene.dt);
  }
  if (hash != kGolden) print_message("now 0x%llx\n", static_cast<unsigned long long>(hash));
  assert_true(hash == kGolden);
}

[[maybe_unused]] static void the_command_says_what_the_judge_says(void**) {
  const std::string folder =
      (std::filesystem::temp_directory_path() / ("carom_built_" + std::to_string(::getpid()))).string();
  const std::string what = "jury --built --seeds 12..15 --seconds 1 --no-times --json";
  const auto ran = command_test::run_carom(what + " --write " + folder, false);
  const auto judged = command_test::run_carom(what + " --judge " + folder, false);
  const auto run = nlohmann::json::parse(ran.text), again = nlohmann::json::parse(judged.text);
  for (std::size_t i = 0; i < 4; ++i) assert_true(run["scenes"][i]["failures"] == again["scenes"][i]["failures"]);
  assert_true(command_test::run_carom("run " + folder + "/15.gltf --seconds 0.05 --quiet").code <= 1);
  std::filesystem::remove_all(folder);
  assert_true(command_test::run_carom("jury --built --family nothing --seed 1").says("vehicle"));
  assert_int_equal(command_test::run_carom("jury --family net --seed 1").code, 2);
  assert_true(
      command_test::run_carom("jury --built --family net --seeds 0..15 --seconds 0.1 --no-times").says("of 1 scenes"));
}

/// What today's engine does with built scenes.
[[maybe_unused]] static void a_slice_of_seeds_does_not_get_worse(void**) {
  Slice slice;
  Setting setting;
  setting.times = false, setting.built = true;
  setting.seconds = carom::test::sliced(0.0, 0.0, 0.7);  // 0: as drawn
  const auto stride = carom::test::sliced<std::uint64_t>(1, 1, 4);
  for (std::uint64_t seed = kSliceFirst; seed < kSliceFirst + kSliceCount; seed += stride) {
    const Trial trial = run(plugins(), seed, setting);
    for (const Failure& f : trial.verdict.failures)
      print_message("seed %d, %s: %s%s\n", static_cast<int>(seed), trial.summary.c_str(), name_of(f.kind),
                    f.plain_step ? ", plainly" : "");
    slice.add(trial.verdict);
  }
  slice.is_within(kCeiling, kPlainCeiling, kSliceCount);
}

/// Seeds that failed until their cause was mended: a track that went from hand to hand with its impulses (17), what was
/// joined by two ways of solving (42, 106, 156), a wall that fell through the ground when its work ended (95), bridges whose
/// light planks were swung by loads (18, 146), nets and tracks that soft joints tore (51, 147, 273), and a
/// bridge whose bends gave energy where its planks hang on two hinges each (82).
[[maybe_unused]] static void what_was_mended_stays_so(void**) {
  if (carom::test::sliced(false, false, true)) return;  // sanitizers have the slice
  Setting setting;
  setting.times = false, setting.built = true;
  for (const std::uint64_t seed : {17, 18, 42, 51, 82, 95, 106, 146, 147, 156, 273})
    for (const Failure& f : run(plugins(), seed, setting).verdict.failures) {
      if (f.kind != Kind::gain && f.plain_step == 0) continue;
      if (f.kind == Kind::jitter) continue;  // a bridge that swings goes to and fro, by 2 cm a second (146)
      print_message("seed %d: %s\n", static_cast<int>(seed), name_of(f.kind));
      assert_true(false);
    }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_motor_gives_what_it_can_and_no_more),
      cmocka_unit_test(what_a_host_gives_is_no_gain),
      cmocka_unit_test(who_is_not_there_is_not_judged),
      cmocka_unit_test(what_shakes_in_one_place_is_found),
      cmocka_unit_test(what_is_not_done_is_found),
      cmocka_unit_test(turns_are_those_of_the_library),
      cmocka_unit_test(a_joint_knows_what_it_moves),
      cmocka_unit_test(scenes_are_built_as_meant),
      cmocka_unit_test(a_seed_is_the_same_scene_everywhere),
      cmocka_unit_test(the_command_says_what_the_judge_says),
      cmocka_unit_test(a_slice_of_seeds_does_not_get_worse),
      cmocka_unit_test(what_was_mended_stays_so),
  };
  return cmocka_run_group_tests_name("tools/jury_built", tests, nullptr, nullptr);
}
