// Runs a scene through Carom as a host would: kinematic bodies are told their velocities before each step.
#include "jury/trial.h"

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

/// Run once; `begun` hears of each step before it, `after` when it is done.
void run_once(Scenery& scenery, const Setting& setting, const std::function<void(const Beat&)>& begun,
              const std::function<void(std::size_t, const carom_step_report&, double)>& after) {
  set_dials(scenery.stage.world, setting);
  std::size_t step = 0;
  for (const Beat& beat : course_of(scenery.scene, setting)) {
    for (const std::size_t deed : beat.deeds) act(scenery, scenery.scene.deeds[deed]);
    drive(scenery, beat.time, beat.end);
    begun(beat);
    const double from = cpu_time();
    scenery.stage.world.step(beat.dt);
    const double seconds = cpu_time() - from;
    after(++step, scenery.stage.world.report(), seconds);
  }
}

/// Another engine's frame after what the host did.
Frame acted(const Case& scene, const std::vector<std::size_t>& deeds, Frame frame) {
  for (const std::size_t k : deeds) {
    const Deed& deed = scene.deeds[k];
    if (deed.what == Deed::What::remove) frame[deed.who].is_there = false;
    if (deed.what == Deed::What::put || deed.what == Deed::What::add) frame[deed.who] = deed.state;
    if (deed.what == Deed::What::throws)
      frame[deed.who].velocity = deed.state.velocity, frame[deed.who].omega = deed.state.omega;
  }
  return frame;
}

}  // namespace

std::vector<Beat> course_of(const Case& scene, const Setting& setting) {
  std::vector<Beat> course;
  double dt = setting.dt_of(scene), time = 0;
  const double seconds = setting.seconds_of(scene);
  for (std::size_t deed = 0; time < seconds - 1e-9 * dt;) {
    Beat beat{time, 0, 0, {}};
    for (; deed < scene.deeds.size() && scene.deeds[deed].time <= time + 1e-9; ++deed) {
      beat.deeds.push_back(deed);
      if (scene.deeds[deed].what == Deed::What::pace && !(setting.dt > 0)) dt = scene.deeds[deed].value;
    }
    beat.dt = dt;
    beat.end = time = scene.deeds.empty() ? dt * static_cast<double>(course.size() + 1) : time + dt;
    course.push_back(std::move(beat));
  }
  return course;
}

Frame frame_of(const Stage& stage) {
  std::vector<carom_body> there;
  for (const Actor& actor : stage.actors)
    if (actor.body != CAROM_NULL_HANDLE) there.push_back(actor.body);
  std::vector<double> poses, velocities;
  stage.world.read(CAROM_FIELD_POSE, there, poses);
  stage.world.read(CAROM_FIELD_VELOCITY, there, velocities);
  Frame frame(stage.actors.size());
  std::size_t k = 0;
  for (std::size_t i = 0; i < frame.size(); ++i) {
    frame[i].is_there = stage.actors[i].body != CAROM_NULL_HANDLE;
    if (!frame[i].is_there) continue;
    frame[i] = {Vec(&poses[7 * k]), Quat(Eigen::Vector4d(&poses[7 * k + 3])), Vec(&velocities[6 * k]),
                Vec(&velocities[6 * k + 3]), true};
    ++k;
  }
  return frame;
}

Trial run(const PluginPath& plugins, std::uint64_t seed, const Setting& setting, const Watcher& watch, Motion* motion) {
  Scenery scenery(plugins, seed, setting.built);
  Judge judge(scenery.engine.get(), scenery.scene, setting.dt_of(scenery.scene));
  judge.start(frame_of(scenery.stage));
  if (motion) motion->frames.push_back(frame_of(scenery.stage));
  const auto begun = [&](const Beat& beat) {
    judge.begin(beat.dt, beat.deeds, beat.deeds.empty() ? Frame() : frame_of(scenery.stage));
  };
  run_once(scenery, setting, begun, [&](std::size_t step, const carom_step_report& report, double seconds) {
    const Frame frame = frame_of(scenery.stage);
    Cost cost = cost_of(report, seconds, setting.times);
    if (report.faults) cost.faulty = fault_text(scenery.stage);
    const Reading& reading = judge.step(frame, cost);
    if (watch) watch(step, reading, report);
    if (motion) motion->frames.push_back(frame), motion->seconds.push_back(seconds);
  });
  for (int again = 0; again < 2 && setting.times && judge.may_stall(); ++again) {
    Scenery other(plugins, seed, setting.built);
    run_once(
        other, setting, [](const Beat&) {},
        [&](std::size_t step, const carom_step_report&, double seconds) { judge.retime(step, seconds); });
  }
  const Case& scene = scenery.scene;
  return {seed, scene.summary, scene.family, scene.links.size(), judge.verdict(), scenery.stage.world.hash()};
}

Trial judge(const PluginPath& plugins, std::uint64_t seed, const Setting& setting, const Motion& motion,
            const Watcher& watch) {
  const Scenery scenery(plugins, seed, setting.built);
  const std::vector<Beat> course = course_of(scenery.scene, setting);
  Judge judge(scenery.engine.get(), scenery.scene, course.at(0).dt);
  Frame before = frame_of(scenery.stage);
  judge.start(before);
  for (std::size_t step = 1; step < motion.frames.size() && step <= course.size(); ++step) {
    const Beat& beat = course[step - 1];
    before = acted(scenery.scene, beat.deeds, before);
    judge.begin(beat.dt, beat.deeds, before);
    Frame now = motion.frames[step];
    for (std::size_t i = 0; i < now.size(); ++i) now[i].is_there = before[i].is_there;
    Cost cost;
    cost.seconds = motion.seconds.at(step - 1);
    const Reading& reading = judge.step(now, cost);
    if (watch) watch(step, reading, carom_step_report{});
    before = std::move(now);
  }
  return {seed, scenery.scene.summary, scenery.scene.family, scenery.scene.links.size(), judge.verdict(), 0};
}

std::uint64_t seed_of_day(int year, int month, int day) {
  return static_cast<std::uint64_t>((year * 100 + month) * 100 + day) * 1000;
}

}  // namespace carom::tools::jury
