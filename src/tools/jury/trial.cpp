// Runs a scene through Carom as a host would: kinematic bodies are told their velocities before each step.
#include "jury/trial.h"

#include <cmath>

#include "host/cpu_time.h"

namespace carom::tools::jury {
namespace {

void set_dials(World& world, const Setting& setting) {
  if (!setting.preset.empty()) world.set_preset(setting.preset);
  for (const std::string& dial : setting.dials) world.set_dial(dial);
}

void drive(Scenery& scenery, double from, double to) {
  for (const Paddle& paddle : scenery.scene.paddles) {
    const Vec velocity = paddle.velocity(from, to);
    Call call;
    call.done(carom_body_set_velocity(scenery.stage.world.get(), scenery.stage.actors[paddle.member].body,
                                      velocity.data(), paddle.spin.data(), call),
              "driving a paddle");
  }
}

Cost cost_of(const carom_step_report& report, double seconds, bool times) {
  Cost cost;
  cost.seconds = times ? seconds : 0;
  cost.work = static_cast<double>(report.support_calls + report.velocity_impulses + report.position_moves);
  cost.faults = report.faults + report.quarantined_bodies;
  return cost;
}

/// What misbehaved first in the last step.
std::string fault_text(const Stage& stage) {
  static constexpr const char* kNames[] = {"fault",
                                           "support returned an error",
                                           "support not finite",
                                           "support outside the bounds",
                                           "support worse than before",
                                           "state not finite",
                                           "particle not finite"};
  const std::vector<carom_fault> faults = stage.world.faults();
  if (faults.empty()) return "";
  const carom_fault& first = faults.front();
  std::string who = "a shape";
  for (const Actor& actor : stage.actors)
    if (actor.body == first.body) who = actor.name;
  return who + ": " + kNames[std::min<std::size_t>(first.kind, 6)];
}

/// Run once; `after` hears of each step.
void run_once(Scenery& scenery, const Setting& setting,
              const std::function<void(std::size_t, const carom_step_report&, double)>& after) {
  set_dials(scenery.stage.world, setting);
  for (std::size_t step = 1; step <= steps_of(setting); ++step) {
    drive(scenery, setting.dt * static_cast<double>(step - 1), setting.dt * static_cast<double>(step));
    const double begun = cpu_time();
    scenery.stage.world.step(setting.dt);
    const double seconds = cpu_time() - begun;
    after(step, scenery.stage.world.report(), seconds);
  }
}

}  // namespace

std::size_t steps_of(const Setting& setting) {
  return static_cast<std::size_t>(std::ceil(setting.seconds / setting.dt - 1e-9));
}

Frame frame_of(const Stage& stage) {
  std::vector<double> poses, velocities;
  stage.read(CAROM_FIELD_POSE, poses);
  stage.read(CAROM_FIELD_VELOCITY, velocities);
  Frame frame;
  for (std::size_t i = 0; i < stage.actors.size(); ++i)
    frame.push_back({Vec(&poses[7 * i]), Quat(Eigen::Vector4d(&poses[7 * i + 3])), Vec(&velocities[6 * i]),
                     Vec(&velocities[6 * i + 3])});
  return frame;
}

Trial run(const PluginPath& plugins, std::uint64_t seed, const Setting& setting, const Watcher& watch, Motion* motion) {
  Scenery scenery(plugins, seed);
  Judge judge(scenery.engine.get(), scenery.scene, setting.dt);
  judge.start(frame_of(scenery.stage));
  if (motion) motion->frames.push_back(frame_of(scenery.stage));
  run_once(scenery, setting, [&](std::size_t step, const carom_step_report& report, double seconds) {
    const Frame frame = frame_of(scenery.stage);
    Cost cost = cost_of(report, seconds, setting.times);
    if (report.faults) cost.faulty = fault_text(scenery.stage);
    const Reading& reading = judge.step(frame, cost);
    if (watch) watch(step, reading, report);
    if (motion) motion->frames.push_back(frame), motion->seconds.push_back(seconds);
  });
  for (int again = 0; again < 2 && setting.times && judge.may_stall(); ++again) {
    Scenery other(plugins, seed);
    run_once(other, setting,
             [&](std::size_t step, const carom_step_report&, double seconds) { judge.retime(step, seconds); });
  }
  return {seed, scenery.scene.summary, judge.verdict(), scenery.stage.world.hash()};
}

Trial judge(const PluginPath& plugins, std::uint64_t seed, double dt, const Motion& motion, const Watcher& watch) {
  const Scenery scenery(plugins, seed);
  Judge judge(scenery.engine.get(), scenery.scene, dt);
  judge.start(frame_of(scenery.stage));
  for (std::size_t step = 1; step < motion.frames.size(); ++step) {
    Cost cost;
    cost.seconds = motion.seconds.at(step - 1);
    const Reading& reading = judge.step(motion.frames[step], cost);
    if (watch) watch(step, reading, carom_step_report{});
  }
  return {seed, scenery.scene.summary, judge.verdict(), 0};
}

std::uint64_t seed_of_day(int year, int month, int day) {
  return static_cast<std::uint64_t>((year * 100 + month) * 100 + day) * 1000;
}

}  // namespace carom::tools::jury
