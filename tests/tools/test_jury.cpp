// `carom jury`: scenes are as README says, the judge finds what is done to it and nothing else, and a slice of seeds
// does not get worse.
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "carom_command.h"
#include "jury/gaps.h"
#include "jury/pairs.h"
#include "jury/trial.h"
#include "jury_script.h"

using namespace jury_test;

namespace {

/// Of the scenes of twenty seeds. It changes with the generator alone: then seeds name other scenes, and all records of
/// them are void.
constexpr std::uint64_t kGolden = 0x2bdef6b57e9bae15u;

/// The slice, and how many of its scenes failed when it was last looked at, by kind: fault, gain, throw, gape, sink,
/// pass, stall.
constexpr std::uint64_t kSliceFirst = 1001, kSliceCount = 20;
///
/// Lowered on 2026-11-25, when hills became solid, joints stopped exploding and the direct solver got one budget: {4, 5,
/// 3, 15, 9, 4, 0} before, plainly {4, 4, 3, 3, 2, 3, 0}. What sinks by a little is 8 of 20, not 6, since joined groups
/// are solved less closely, and that is chance: of 660 scenes 364 sink, 359 did, and 60 of this slice's kind had 26 to
/// 31 at five settings in no order of accuracy. What fails plainly is lower. Since friction acts where loads do, 4 pass
/// by a little, not 2, and 7 sink, not 8: chance as well (of 600 scenes 126 pass, 115 did; 338 sink, 335 did), and what
/// fails plainly is lower again, {0, 1, 0, 2, 1, 0, 0} before. Since few joined bodies are solved together whatever they
/// touch, and what is pushed apart gains nothing, nothing fails plainly: {0, 3, 0, 15, 7, 4, 0} before, plainly {0, 0, 0,
/// 2, 0, 0, 0}.
// Since what is thin is held to a share of its thickness and crowds go on as one, 3 sink by a little, not 5, and 2 pass,
// not 1: chance (of 200 other scenes 85 sink, 90 did; 38 pass, 42 did; 13 fail plainly, 15 did). Since joints are a forest
// and friction beside them is known, 8 gape by a little, not 7: chance (of 300 other scenes 89 gape, 91 did). Since drives
// are of the forest and contacts keep to what they bore, 3 sink by a little, not 2: chance (of 300 other scenes 70 sink,
// 69 did).
// Lowered on 2026-11-29, since joints hold through sweeps and contacts of what turns far are asked again in each substep: {0, 0, 0, 8, 3,
// 2, 0} before. One sinks plainly and one gains, where none did: chance (of 300 other scenes 48 fail, 10 plainly, 8 by a sink, 1 gains; 160,
// 16, 9 and 5 before). What gains is pressed between a paddle and the ground, which a paddle may do as hard as it likes.
// Since contacts with scenery are asked again too, one is thrown: chance (of 300 other scenes 3 are thrown, all plainly, 3 were; 42 fail, 51
// did). It is a rod that spins at 1e4 rad/s about its axis as a sweep stops it, within a substep.
// Since points are kept while bodies move by a millimetre 3 sink, 2 of them plainly, not 2 and 1, and 3 pass, 1 plainly, not 1 and 0:
// chance (of 500 other scenes 31 sink, 8 plainly, 29 and 9 did; 36 pass, 4 plainly, 41 and 5 did).
constexpr std::size_t kCeiling[kKinds] = {0, 1, 1, 0, 3, 3, 0};
constexpr std::size_t kPlainCeiling[kKinds] = {0, 0, 1, 0, 2, 1, 0};

/// A ball on the ground and one beside it, both at rest.
struct TwoBalls : Script {
  std::size_t one = add("sphere", {0.1}, {0, 0.1, 0}), other = add("sphere", {0.1}, {5, 0.1, 0});
};

}  // namespace

[[maybe_unused]] static void what_is_at_rest_or_falls_is_let_be(void**) {
  TwoBalls rest;
  assert_true(rest.play(300, nothing).failures.empty());
  Script fall;
  const std::size_t ball = fall.add("sphere", {0.1}, {0, 3, 0});
  double energy = 9.81 * 3;
  const Verdict v =
      fall.play(300, [&](std::size_t, Frame& f) {  // bounces with restitution 0.5, in steps of semi-implicit Euler
        State& s = f[ball];
        s.velocity.y() -= 9.81 * kDt;
        s.position += kDt * s.velocity;
        if (s.position.y() < 0.1 && s.velocity.y() < 0) s.velocity.y() *= -0.5, s.position.y() = 0.1;
        energy = 0.5 * s.velocity.squaredNorm() + 9.81 * s.position.y();
      });
  assert_true(energy < 9.81 * 0.2);
  for (const Failure& f : v.failures)
    print_message("%s at step %zu: %g of %g\n", name_of(f.kind), f.step, f.value, f.limit);
  assert_true(v.failures.empty());
}

[[maybe_unused]] static void energy_from_nowhere_is_found(void**) {
  TwoBalls balls;  // one rises by itself at 0.5 m/s
  fails_by(balls.play(60,
                      [&](std::size_t step, Frame& f) {
                        if (step < 20) return;
                        f[balls.one].velocity.y() = 0.5;
                        f[balls.one].position.y() += 0.5 * kDt;
                      }),
           Kind::gain, 20);
}

[[maybe_unused]] static void energy_does_not_jump_to_a_stranger(void**) {
  TwoBalls balls;
  balls.stage.actors[balls.one].linear_velocity = Vec(1, 0, 0);
  Call call;
  const double v[3] = {1, 0, 0}, w[3] = {0, 0, 0};
  call.done(carom_body_set_velocity(balls.stage.world.get(), balls.stage.actors[balls.one].body, v, w, call),
            "throwing");
  const Verdict verdict = balls.play(30, [&](std::size_t step, Frame& f) {
    f[balls.one].velocity.x() = step < 10 ? 1 : 0;
    f[balls.other].velocity.x() = step < 10 ? 0 : 1;
    f[balls.one].position.x() += kDt * f[balls.one].velocity.x();
    f[balls.other].position.x() += kDt * f[balls.other].velocity.x();
  });
  assert_non_null(verdict.of(Kind::gain));
  assert_int_equal(verdict.of(Kind::gain)->step, 10);
}

[[maybe_unused]] static void a_throw_is_found(void**) {
  TwoBalls balls;
  const Verdict v = balls.play(30, [&](std::size_t step, Frame& f) {
    if (step >= 12) f[balls.one].velocity.x() = 20, f[balls.one].position.x() -= 0.1;
  });
  assert_non_null(v.of(Kind::throws));
  assert_int_equal(v.of(Kind::throws)->step, 12);
  assert_true(v.of(Kind::throws)->plain_step == 12);
}

/// A paddle that comes at a ball at 1 m/s: the ball may leave at 2 m/s, as from an elastic bat, and not at 4.
static Verdict batted(double speed) {
  Script s;
  const std::size_t ball = s.add("sphere", {0.1}, {0, 0.1, 0});
  const std::size_t paddle = s.add("box", {0.1, 0.3, 0.5}, {-0.5, 0.35, 0}, CAROM_BODY_KINEMATIC);
  s.drawing.scene.paddles.push_back({paddle, Vec::Zero(), Vec::UnitX(), 1});
  return s.play(60, [&](std::size_t, Frame& f) {
    f[paddle].velocity = Vec(1, 0, 0);
    f[paddle].position.x() += kDt;
    if (f[paddle].position.x() > -0.205) f[ball].velocity.x() = speed;
    f[ball].position.x() += kDt * f[ball].velocity.x();
  });
}

[[maybe_unused]] static void a_paddle_gives_what_it_can_and_no_more(void**) {
  assert_true(batted(2).failures.empty());
  assert_non_null(batted(4).of(Kind::gain));
  assert_non_null(batted(20).of(Kind::throws));
}

[[maybe_unused]] static void a_gape_is_found(void**) {
  Script s;
  const std::size_t a = s.add("box", {0.1, 0.1, 0.1}, {0, 0.1, 0}), b = s.add("box", {0.1, 0.1, 0.1}, {0.25, 0.1, 0});
  for (const std::uint32_t kind : {CAROM_JOINT_BALL, CAROM_JOINT_HINGE, CAROM_JOINT_SLIDER, CAROM_JOINT_WELD}) {
    Link link;
    link.kind = kind, link.a = a, link.b = b;
    link.at_a = Vec(0.125, 0, 0), link.at_b = Vec(-0.125, 0, 0);
    s.drawing.scene.links = {link};
    assert_true(s.play(5, nothing).failures.empty());
    const auto aside = [&](double by) {
      return [&, by](std::size_t step, Frame& f) {
        if (step == 3) f[b].position.z() += by;
      };
    };
    assert_true(s.play(20, aside(0.009)).failures.empty());
    fails_by(s.play(20, aside(0.011)), Kind::gape, 3);
    assert_int_equal(s.play(20, aside(0.04)).of(Kind::gape)->plain_step, 12);  // a sixth of a second
    // Along the axis a slider is free, between its limits.
    s.drawing.scene.links[0].limited = kind == CAROM_JOINT_SLIDER;
    s.drawing.scene.links[0].lower = -0.1, s.drawing.scene.links[0].upper = 0.1;
    const Verdict along = s.play(20, [&](std::size_t step, Frame& f) {
      f[b].position.x() += step == 3 ? 0.09 : step == 9 ? 0.03 : 0;
    });
    fails_by(along, Kind::gape, kind == CAROM_JOINT_SLIDER ? 9 : 3);
    // A turn about the axis is a hinge's business and a ball's.
    const Verdict turned = s.play(20, [&](std::size_t step, Frame& f) {
      if (step != 3) return;
      f[b].orientation = Quat(1, 0.2, 0, 0).normalized();
    });
    assert_int_equal(turned.of(Kind::gape) != nullptr, kind == CAROM_JOINT_SLIDER || kind == CAROM_JOINT_WELD);
  }
}

[[maybe_unused]] static void what_sinks_for_long_is_found(void**) {
  TwoBalls balls;
  const auto deep = [&](std::size_t from, std::size_t to, double depth) {
    return [&, from, to, depth](std::size_t step, Frame& f) {
      f[balls.one].position.y() = 0.1 - (step >= from && step < to ? depth : 0);
    };
  };
  const double limit = 0.001 + 0.02 * 0.2;
  assert_null(balls.play(40, deep(5, 14, 1.1 * limit)).of(Kind::sink));  // for nine steps
  assert_true(balls.play(40, deep(5, 41, 0.9 * limit)).failures.empty());
  fails_by(balls.play(40, deep(5, 41, 1.1 * limit)), Kind::sink, 14);
  assert_int_equal(balls.play(40, deep(5, 40, 1.1 * limit)).of(Kind::sink)->plain_step, 0);
  assert_int_equal(balls.play(60, deep(5, 60, 6 * limit)).of(Kind::sink)->plain_step, 34);
}

[[maybe_unused]] static void what_passes_through_is_found(void**) {
  TwoBalls balls;  // below the ground
  fails_by(balls.play(10, [&](std::size_t step, Frame& f) { f[balls.one].position.y() = step >= 5 ? -0.01 : 0.1; }),
           Kind::pass, 5);
  Script s;  // through a plate, within a step
  const std::size_t ball = s.add("sphere", {0.05}, {-0.5, 1, 0});
  s.add("box", {0.01, 1, 1}, {0, 1, 0}, CAROM_BODY_STATIC);
  for (const double way : {0.4, 1.0}) {
    const Verdict v = s.play(20, [&](std::size_t step, Frame& f) {
      if (step == 7) f[ball].position.x() += way;
    });
    assert_int_equal(v.failures.size(), way > 0.5);
    if (way > 0.5) fails_by(v, Kind::pass, 7);
  }
}

[[maybe_unused]] static void stalls_and_faults_are_found(void**) {
  TwoBalls balls;
  const auto costs = [](double usual, double once, bool work) {
    return [=](std::size_t step) {
      Cost cost;
      (work ? cost.work : cost.seconds) = step == 33 ? once : usual;
      return cost;
    };
  };
  assert_true(balls.play(60, nothing, costs(1e-4, 1.9e-3, false)).failures.empty());  // below 2 ms
  assert_true(balls.play(60, nothing, costs(1e-3, 2.9e-3, false)).failures.empty());  // below three times the mean
  fails_by(balls.play(60, nothing, costs(1e-4, 2.1e-3, false)), Kind::stall, 33);
  fails_by(balls.play(60, nothing, costs(1e3, 1.1e5, true)), Kind::stall, 33);
  fails_by(balls.play(20, [&](std::size_t step, Frame& f) { f[balls.one].position.x() = step == 9 ? NAN : 0; }),
           Kind::fault, 9);
  fails_by(balls.play(20, nothing,
                      [](std::size_t step) {
                        Cost cost;
                        cost.faults = step == 4;
                        return cost;
                      }),
           Kind::fault, 4);
}

[[maybe_unused]] static void hills_are_where_the_engine_has_them(void**) {
  for (std::uint64_t seed = 1, seen = 0; seen < 3; ++seed) {
    const Scenery drawn(plugins(), seed);
    if (!drawn.scene.heights) continue;
    ++seen;
    const Heights& hills = *drawn.scene.heights;
    std::size_t ground = 0;
    while (!drawn.scene.members[ground].is_heights) ++ground;
    Random random(seed);
    for (int i = 0; i < 100; ++i) {
      const double x = random.between(-1.5, 1.5), z = random.between(-1.5, 1.5);
      const double from[3] = {x, 5, z}, down[3] = {0, -10, 0};
      const Quat straight = Quat::Identity();
      carom_cast hit;
      hit.struct_size = sizeof hit;
      Call call;
      call.done(carom_ray_cast(drawn.engine.get(), drawn.scene.members[ground].shape, hills.corner.data(),
                               straight.coeffs().data(), from, down, 1, nullptr, &hit, call),
                "looking down");
      assert_int_equal(hit.outcome, CAROM_CAST_HIT);
      const auto at = hills.at(x, z);
      assert_true(std::fabs(5 - 10 * hit.time - at->height) < 1e-9);
      assert_true((Vec(hit.normal) + at->normal).norm() < 1e-9);
    }
  }
}

[[maybe_unused]] static void scenes_are_as_described(void**) {
  std::size_t joined = 0, stirred = 0, hulls = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Scenery drawn(plugins(), seed);
    const Case& c = drawn.scene;
    const Frame start = frame_of(drawn.stage);
    std::size_t bodies = 0;
    for (const Member& m : c.members) {
      if (!m.moves()) continue;
      ++bodies;
      assert_true(m.size > 0.02 && m.size < 1.2 && m.thickness > 0.0005);  // a box of 80 cm is wider across its corners
      hulls += m.name.find("hull") != std::string::npos;
    }
    assert_true(bodies >= 2 && bodies <= 40);
    joined += !c.links.empty(), stirred += !c.paddles.empty();
    for (const Link& link : c.links) assert_true(gap_of(c, link, start) < 1e-9);
    for (const Near& near : near_pairs(drawn.engine.get(), c, start, kDt)) {
      const bool tied = std::any_of(c.links.begin(), c.links.end(), [&](const Link& l) {
        return std::minmax(l.a, l.b) == std::minmax(near.a, near.b);
      });
      if (!tied) assert_true(near.separation > 0.999 * kGap);
    }
  }
  // Of 60, within three standard deviations of a half and of a quarter.
  assert_true(joined > 30 - 12 && joined < 30 + 12 && stirred > 15 - 11 && stirred < 15 + 11 && hulls > 20);
}

[[maybe_unused]] static void a_seed_is_the_same_scene_everywhere(void**) {
  std::uint64_t hash = kNoBits;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) hash = bits_of(frame_of(Scenery(plugins(), seed).stage), hash);
  if (hash != kGolden) print_message("now 0x%llx\n", static_cast<unsigned long long>(hash));
  assert_true(hash == kGolden);
}

[[maybe_unused]] static void the_command_says_what_the_judge_says(void**) {
  const std::string folder =
      (std::filesystem::temp_directory_path() / ("carom_jury_" + std::to_string(::getpid()))).string();
  const auto ran = command_test::run_carom("jury --seeds 3..4 --no-times --json --write " + folder, false);
  const auto judged = command_test::run_carom("jury --seeds 3..4 --no-times --json --judge " + folder, false);
  assert_true(ran.code == 0 || ran.code == 1);
  assert_true(ran.says("\"seeds\": [\n    3,\n    4\n  ]"));
  const auto run = nlohmann::json::parse(ran.text), again = nlohmann::json::parse(judged.text);
  for (std::size_t i = 0; i < 2; ++i)
    for (const auto& f : run["scenes"][i]["failures"]) {
      if (f["kind"] == "stall" || f["kind"] == "fault") continue;  // of times and of what the engine says of itself
      const auto& found = again["scenes"][i]["failures"];
      assert_true(std::any_of(found.begin(), found.end(), [&](const auto& g) {
        return g["kind"] == f["kind"] && g["step"] == f["step"] && g["who"] == f["who"];
      }));
    }
  assert_true(command_test::run_carom("run " + folder + "/3.gltf --seconds 0.05 --quiet").code <= 1);
  std::filesystem::remove_all(folder);
  assert_int_equal(command_test::run_carom("jury --seeds 9..1").code, 2);
  assert_true(command_test::run_carom("jury --seed 2 --steps --seconds 0.1 --no-times").says("gained most"));
}

/// What today's engine does with seeds that nobody chose. Lower a ceiling with every mend. One of what is plain never
/// rises; others are chance by one or two, and rise only beside hundreds of scenes that are no worse (the jury's NOTES.md).
[[maybe_unused]] static void a_slice_of_seeds_does_not_get_worse(void**) {
  Slice slice;
  Setting setting;
  setting.times = false;
  for (std::uint64_t seed = kSliceFirst; seed < kSliceFirst + kSliceCount; ++seed)
    slice.add(run(plugins(), seed, setting).verdict);
  slice.is_within(kCeiling, kPlainCeiling, kSliceCount);
}

/// Seeds that failed until their cause was mended: velocities that grew where nothing moved (1003, 5034), chains torn and
/// pulled together (5023), a push through what is light into what is heavy (1036, 5048).
[[maybe_unused]] static void what_was_mended_stays_so(void**) {
  Setting setting;
  setting.times = false;
  for (const std::uint64_t seed : {1003, 1036, 5023, 5034, 5048})
    for (const Failure& f : run(plugins(), seed, setting).verdict.failures) {
      if (f.kind != Kind::gain && !(f.kind == Kind::gape && f.plain_step > 0)) continue;
      print_message("seed %d: %s\n", static_cast<int>(seed), name_of(f.kind));
      assert_true(false);
    }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_is_at_rest_or_falls_is_let_be),
      cmocka_unit_test(energy_from_nowhere_is_found),
      cmocka_unit_test(energy_does_not_jump_to_a_stranger),
      cmocka_unit_test(a_throw_is_found),
      cmocka_unit_test(a_paddle_gives_what_it_can_and_no_more),
      cmocka_unit_test(a_gape_is_found),
      cmocka_unit_test(what_sinks_for_long_is_found),
      cmocka_unit_test(what_passes_through_is_found),
      cmocka_unit_test(stalls_and_faults_are_found),
      cmocka_unit_test(hills_are_where_the_engine_has_them),
      cmocka_unit_test(scenes_are_as_described),
      cmocka_unit_test(a_seed_is_the_same_scene_everywhere),
      cmocka_unit_test(the_command_says_what_the_judge_says),
#ifndef CAROM_SANITIZED
      cmocka_unit_test(a_slice_of_seeds_does_not_get_worse),
      cmocka_unit_test(what_was_mended_stays_so),
#endif
  };
  return cmocka_run_group_tests_name("tools/jury", tests, nullptr, nullptr);
}
