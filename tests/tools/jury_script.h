// A scene by hand and its motion by script, before the judge of `carom jury`.
#pragma once

#include <array>
#include <cstring>
#include <functional>

#include "carom_command.h"
#include "jury/drawing.h"
#include "jury/trial.h"

namespace jury_test {

using namespace carom::tools;
using namespace carom::tools::jury;

constexpr double kDt = 1.0 / 60;

inline PluginPath plugins() { return PluginPath({CAROM_PLUGIN_DIR}); }

/// A scene by hand, and its motion by script: what happens to whom is set by the test.
struct Script {
  Script() : engine(plugins()), stage(engine), drawing(1, stage) {
    Actor ground;
    ground.name = "plane";
    ground.type = CAROM_BODY_STATIC;
    Part part;
    part.shape = "half_space";
    part.params = {0, 1, 0, 0};
    ground.parts.push_back(part);
    drawing.add(ground);
  }
  std::size_t add(const std::string& shape, const std::vector<double>& params, const Vec& position,
                  std::uint32_t type = CAROM_BODY_DYNAMIC) {
    Actor actor;
    actor.name = shape + " " + std::to_string(drawing.scene.members.size());
    actor.type = type;
    actor.position = position;
    Part part;
    part.shape = shape;
    part.params = params;
    actor.parts.push_back(part);
    return drawing.add(actor);
  }
  /// @param move  changes the frame of the step before into that of a step
  Verdict play(std::size_t steps, const std::function<void(std::size_t, Frame&)>& move,
               const std::function<Cost(std::size_t)>& cost = {}) {
    Judge judge(engine.get(), drawing.scene, kDt);
    Frame frame = frame_of(stage);
    judge.start(frame);
    for (std::size_t step = 1; step <= steps; ++step) {
      move(step, frame);
      judge.step(frame, cost ? cost(step) : Cost{});
    }
    return judge.verdict();
  }
  Engine engine;
  Stage stage;
  Drawing drawing;
};

inline void nothing(std::size_t, Frame&) {}

/// Exactly one kind of failure, from a step on.
inline void fails_by(const Verdict& v, Kind kind, std::size_t step) {
  for (const Failure& f : v.failures)
    if (f.kind != kind) print_message("also %s at step %zu, %s\n", name_of(f.kind), f.step, f.who.c_str());
  assert_int_equal(v.failures.size(), 1);
  assert_true(v.failures[0].kind == kind);
  assert_int_equal(v.failures[0].step, step);
}

constexpr std::uint64_t kNoBits = 14695981039346656037u;

/// Bits of all that was drawn.
inline std::uint64_t bits_of(const Frame& frame, std::uint64_t hash) {
  for (const State& s : frame)
    for (const double x : {s.position.x(), s.position.y(), s.position.z(), s.orientation.x(), s.orientation.w(),
                           s.velocity.y(), s.omega.z()}) {
      std::uint64_t bits;
      std::memcpy(&bits, &x, sizeof bits);
      hash = (hash ^ bits) * 1099511628211u;
    }
  return hash;
}

/// How many scenes of a slice fail, by kind, and plainly.
class Slice {
 public:
  void add(const Verdict& verdict) {
    for (const Failure& f : verdict.failures) {
      ++failed_[static_cast<std::size_t>(f.kind)];
      plain_[static_cast<std::size_t>(f.kind)] += f.plain_step > 0;
    }
  }
  void is_within(const std::size_t (&ceiling)[kKinds], const std::size_t (&plain_ceiling)[kKinds],
                 std::size_t scenes) const {
    for (std::size_t k = 0; k < kKinds; ++k) {
      print_message("%-6s %2zu scenes of %zu (at most %zu), %2zu plainly (at most %zu)\n",
                    name_of(static_cast<Kind>(k)), failed_[k], scenes, ceiling[k], plain_[k], plain_ceiling[k]);
      assert_true(failed_[k] <= ceiling[k] && plain_[k] <= plain_ceiling[k]);
    }
  }

 private:
  std::array<std::size_t, kKinds> failed_{}, plain_{};
};

}  // namespace jury_test
