// What `carom tune` says of its pick holds within a factor of two on nine of ten scenes that nobody tuned to: its error
// by references twice as fine as those that it was found by, its cost in worlds of an engine of its own.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../carom_test.h"
#include "tune/tune.h"

using namespace carom::tools;
using namespace carom::tools::tune;

namespace {

/// Numbers of a seed, one after the other.
class Draw {
 public:
  explicit Draw(double seed) : state_(static_cast<std::uint64_t>(seed) * 0x9E3779B97F4A7C15u + 0x1234567u) {}
  double between(double low, double high) {
    state_ ^= state_ << 13, state_ ^= state_ >> 7, state_ ^= state_ << 17;
    return low + (high - low) * static_cast<double>(state_ >> 11) * 0x1p-53;
  }

 private:
  std::uint64_t state_;
};

Actor body(const std::string& name, const std::string& shape, const std::vector<double>& params, const Vec& at) {
  Actor actor;
  actor.name = name, actor.kind = shape, actor.position = at;
  Part part;
  part.shape = shape, part.params = params;
  actor.parts.push_back(part);
  return actor;
}

Vec vector(Draw& draw, double size) {
  const double x = draw.between(-size, size), y = draw.between(-size, size), z = draw.between(-size, size);
  return {x, y, z};
}

std::unique_ptr<Observer> thrown(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Draw draw(knobs[0]);
  for (int i = 0; i < 4; ++i) {
    const double a = draw.between(0.1, 0.5), b = draw.between(0.1, 0.5), c = draw.between(0.1, 0.5);
    Actor box = body("box " + std::to_string(i), "box", {a, b, c}, Vec(5.0 * i, 0, 0));
    box.linear_velocity = vector(draw, 5);
    box.angular_velocity = vector(draw, 6);
    stage.add(box);
  }
  return nullptr;
}

std::unique_ptr<Observer> sprung(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Draw draw(knobs[0]);
  const double pull = draw.between(30, 300), aside = draw.between(0.2, 0.8);
  std::size_t last = Bungee::kWorld;
  for (int i = 0; i < 3; ++i) {
    const std::size_t ball =
        stage.add(body("ball " + std::to_string(i), "sphere", {0.1}, Vec(aside * (i + 1), -1.0 * i, 0)));
    stage.add_spring(
        {last, ball, i ? Vec(0, 0, 0) : Vec(0, 1, 0), Vec(0, 0, 0), 0.8, pull, 0.5, false, CAROM_NULL_HANDLE});
    stage.set_drag(ball, draw.between(0, 0.4), 0);
    last = ball;
  }
  return nullptr;
}

std::unique_ptr<Observer> swung(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Draw draw(knobs[0]);
  Actor fixed = body("hook", "box", {0.05, 0.05, 0.05}, Vec(0, 0, 0));
  fixed.type = CAROM_BODY_STATIC;
  std::size_t last = stage.add(fixed);
  const double length = draw.between(0.4, 0.9);
  Vec at(0, 0, 0);
  for (int i = 0; i < 2; ++i) {
    Actor rod = body("rod " + std::to_string(i), "box", {length / 2, 0.04, 0.03}, at + Vec(length / 2, 0, 0));
    rod.parts[0].density = draw.between(500, 3000);
    const std::size_t next = stage.add(rod);
    stage.join(CAROM_JOINT_BALL, last, next, at);
    at += Vec(length, 0, 0);
    last = next;
  }
  return nullptr;
}

std::unique_ptr<Observer> stacked(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Draw draw(knobs[0]);
  stage.add_half_space("ground", Vec(0, 1, 0), Vec(0, 0, 0));
  double y = 0;
  for (int i = 0; i < 7; ++i) {
    const double half = draw.between(0.2, 0.5), low = draw.between(0.1, 0.3);
    Actor box = body("box " + std::to_string(i), "box", {half, low, half}, Vec(draw.between(-0.05, 0.05), y + low, 0));
    box.parts[0].density = draw.between(300, 6000);
    stage.add(box);
    y += 2 * low;
  }
  return nullptr;
}

std::unique_ptr<Observer> poured(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  Draw draw(knobs[0]);
  stage.add_walled_ground(1.5);
  for (int i = 0; i < 24; ++i) {
    const double a = draw.between(0.15, 0.3), b = draw.between(0.15, 0.3);
    const Vec at = Vec(0, 1 + 0.6 * i, 0) + vector(draw, 0.5);
    Actor thing = i % 3 ? body("box " + std::to_string(i), "box", {a, b, a}, at)
                        : body("ball " + std::to_string(i), "sphere", {a}, at);
    thing.angular_velocity = vector(draw, 2);
    stage.add(thing);
  }
  return nullptr;
}

struct Kind {
  const char* name;
  double seconds;
  std::unique_ptr<Observer> (*fill)(Stage&, const std::vector<double>&, const std::string&);
};
constexpr Kind kKinds[] = {
    {"thrown", 3, thrown}, {"sprung", 3, sprung}, {"swung", 2, swung}, {"stacked", 3, stacked}, {"poured", 3, poured}};

bool within_two(double predicted, double found) {
  return (predicted == 0 && found == 0) || (found <= 2 * predicted && predicted <= 2 * found);
}

Setting finer(Setting setting) {
  setting.steps_per_frame *= 2;
  return setting;
}

/// Search, then judge the pick anew.
bool prediction_holds(const Kind& kind, double seed) {
  const Scene scene{std::string(kind.name), "",       "",       {{"seed", "", "", 1, 0, 1e6, true}},
                    kind.seconds,           1.0 / 60, kind.fill};
  Question q;
  q.scene = &scene;
  q.settings.values = {{"seed", seed}};
  q.seconds = kind.seconds;
  q.budget_ms = 0.25;
  q.patience = 6;
  Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
  const Result a = search(engine, q, {});
  if (a.pick < 0) return false;
  const Measured& said = a.front[static_cast<std::size_t>(a.pick)];

  Engine other(PluginPath({CAROM_PLUGIN_DIR}));
  Player player(other, q);
  const double nudge = a.chaotic ? 3e-5 : 0;  // m/s: another run than those that were judged
  const References fine = {player.play(finer(reference_setting(a.who)), a.seconds, 1e300, nudge),
                           player.play(reference_setting(a.who), a.seconds, 1e300, nudge)};
  std::vector<double> ms;
  double error = 0;
  for (int k = 0; k < 3; ++k) {
    const Trace run = player.play(said.setting, a.seconds, 1e300, a.chaotic ? 4e-5 : 0);
    ms.push_back(run.ms);
    error = errors_of(run, fine, q.frame_rate)[static_cast<std::size_t>(a.kind)];
  }
  std::sort(ms.begin(), ms.end());
  // Errors below the floor are not told apart: so it was said.
  const bool holds =
      within_two(said.ms, ms[1]) && (within_two(said.error, error) || std::max(said.error, error) <= 2 * a.floor);
  std::printf("%-8s %3.0f  %s%-6s said %.2e in %.4f ms, found %.2e in %.4f ms, floor %.1e: %s  (%s)\n", kind.name, seed,
              a.chaotic ? "chaotic, " : "", name_of(a.kind), said.error, said.ms, error, ms[1], a.floor,
              holds ? "holds" : "does NOT hold", said.setting.text().c_str());
  return holds;
}

}  // namespace

static bool all_of_them = false;

/// Beside other tests times waver, so that a few scenes stand for ten: `tests_tools tune_predictions all` runs those.
[[maybe_unused]] static void nine_of_ten_fresh_scenes_go_as_they_were_said_to(void**) {
  int held = 0, scenes = 0;
  for (const Kind& kind : kKinds)
    for (const double seed : {11.0, 12.0}) {
      if (!all_of_them && (seed != 11 || kind.seconds < 3 || kind.fill == poured)) continue;
      held += prediction_holds(kind, seed), ++scenes;
    }
  assert_true(all_of_them ? 10 * held >= 9 * scenes : held >= scenes - 1);
}

/// A bar that is turned by an angle about an axis across has its matter displaced by 2 sin(angle / 2) times its
/// gyration.
static void a_turn_counts_by_what_it_moves(void**) {
  Trace a, b;
  a.matter.resize(1);
  a.matter[0].mass = 3;
  a.matter[0].spread = Vec(0.16, 0, 0).asDiagonal();  // all of it along x, 0.4 m from the middle, rms
  a.center = {Vec(1, 2, 3)};
  a.orientation = {Quat::Identity()};
  a.energy = a.sink = a.joints = a.cone = {0};
  b = a;
  const double angle = 0.5;
  b.orientation = {Quat(Eigen::AngleAxisd(angle, Vec::UnitZ()))};
  const auto pose = static_cast<std::size_t>(ErrorKind::pose);
  assert_float_equal(errors_of(b, {a, a}, 60)[pose], 2 * std::sin(angle / 2) * 0.4, 1e-14);
  b.orientation = {Quat(Eigen::AngleAxisd(angle, Vec::UnitX()))};  // about itself
  assert_float_equal(errors_of(b, {a, a}, 60)[pose], 0, 1e-14);
  b.center = {Vec(1, 2, 3.3)};
  assert_float_equal(errors_of(b, {a, a}, 60)[pose], 0.3, 1e-14);
}

int main(int argc, char**) {
  all_of_them = argc > 1;
  const CMUnitTest tests[] = {
#ifndef CAROM_SANITIZED  // which time everything anew
      cmocka_unit_test(nine_of_ten_fresh_scenes_go_as_they_were_said_to),
#endif
      cmocka_unit_test(a_turn_counts_by_what_it_moves),
  };
  return cmocka_run_group_tests_name("tools/tune_predictions", tests, nullptr, nullptr);
}
