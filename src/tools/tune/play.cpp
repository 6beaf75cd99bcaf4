// One run of a scene under a setting.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/cpu_time.h"
#include "tune/tune.h"

namespace carom::tools::tune {
namespace {

constexpr int kMoments = 120;
constexpr std::size_t kMostWatched = 400;  // bodies and particles: others of a crowd fare like these

Matter matter_of(const World& world, carom_body body) {
  Call call;
  carom_body_desc desc;
  call.done(carom_body_desc_init(&desc, sizeof desc), "reading a body");
  call.done(carom_body_get(world.get(), body, &desc, call), "reading a body");
  Matter matter;
  matter.mass = desc.mass;
  const Eigen::Matrix3d inertia = Eigen::Map<const Eigen::Matrix3d>(desc.inertia);  // symmetric
  if (desc.mass > 0) matter.spread = (0.5 * inertia.trace() * Eigen::Matrix3d::Identity() - inertia) / desc.mass;
  return matter;
}

/// The dynamic bodies and particles of a stage, and what they weigh.
class Watch {
 public:
  Watch(Stage& stage, Trace& trace) : stage_(stage), trace_(trace) {
    std::size_t many = 0;
    for (const Actor& actor : stage.actors) many += moves(actor);
    const std::size_t stride = std::max<std::size_t>(1, (many + kMostWatched - 1) / kMostWatched);
    std::size_t k = 0;
    for (std::size_t i = 0; i < stage.actors.size(); ++i) {
      const Actor& actor = stage.actors[i];
      if (!moves(actor) || k++ % stride) continue;
      if (actor.body != CAROM_NULL_HANDLE) {
        bodies_.push_back(actor.body);
        trace.matter.push_back(matter_of(stage.world, actor.body));
      } else {
        particles_.push_back(i);
      }
    }
    for (const std::size_t i : particles_) {
      trace.matter.emplace_back();
      trace.matter.back().mass = stage.actors[i].mass;
    }
    for (const Actor& actor : stage.actors)
      if (actor.type == CAROM_BODY_DYNAMIC && actor.body != CAROM_NULL_HANDLE)
        trace.weight += matter_of(stage.world, actor.body).mass;
      else if (actor.particles != CAROM_NULL_HANDLE)
        trace.weight += actor.mass;
    std::vector<Quat> turned;
    std::vector<Vec> homes;
    read(homes, turned);
    for (std::size_t i = 0; i < homes.size(); ++i) trace.matter[i].home = homes[i];
  }

  void after_step(const carom_step_report& report) {
    sink_ = std::max(sink_, report.max_penetration);
    trace_.finite &= report.quarantined_bodies == 0 && report.quarantined_particles == 0;
    trace_.who.contacts |= report.contact_points > 0;
  }

  /// What only some steps are asked for: it takes as long as a step.
  void moment() {
    read(trace_.center, trace_.orientation);
    carom_residuals left{};
    left.struct_size = sizeof left;
    Call call;
    call.done(carom_world_get_residuals(stage_.world.get(), &left, call), "judging a step");
    trace_.energy.push_back(left.energy);
    trace_.sink.push_back(sink_);
    trace_.joints.push_back(std::hypot(left.joint_gap, left.joint_angle * mean_size()));
    trace_.cone.push_back(std::max({left.complementarity, left.cone, left.slip}));
    sink_ = 0;
    for (const carom_plan_line& line : stage_.world.plan()) note(line);
  }

 private:
  static bool moves(const Actor& actor) {
    return actor.particles != CAROM_NULL_HANDLE ||
           (actor.body != CAROM_NULL_HANDLE && actor.type == CAROM_BODY_DYNAMIC);
  }

  double mean_size() const {
    double sum = 0;
    for (std::size_t i = 0; i < bodies_.size(); ++i) sum += trace_.matter[i].size();
    return bodies_.empty() ? 0 : sum / static_cast<double>(bodies_.size());
  }

  void read(std::vector<Vec>& centers, std::vector<Quat>& turned) {
    std::vector<double> x, q;
    if (!bodies_.empty()) {
      stage_.world.read(CAROM_FIELD_CENTER, bodies_, x);
      stage_.world.read(CAROM_FIELD_ORIENTATION, bodies_, q);
    }
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      centers.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      turned.emplace_back(q[4 * i + 3], q[4 * i], q[4 * i + 1], q[4 * i + 2]);
    }
    if (particles_.empty()) return;
    stage_.read(CAROM_FIELD_POSITION, x);
    for (const std::size_t i : particles_) {
      centers.emplace_back(x[3 * i], x[3 * i + 1], x[3 * i + 2]);
      turned.push_back(Quat::Identity());
    }
  }

  void note(const carom_plan_line& line) {
    if (line.effect == CAROM_PLAN_NO_EFFECT || line.participants == 0) return;
    const auto is = [&](const char* name) { return std::strcmp(line.name, name) == 0; };
    Participants& who = trace_.who;
    who.may_touch |= is("collision");
    who.joints |= is("joints");
    who.bounces |= is("restitution");
    who.turns |= is("gyroscopic");
    for (const char* name : {"springs", "drag", "fields", "buoyancy", "linear_damping", "angular_damping", "magnetism"})
      who.forces |= is(name);
  }

  Stage& stage_;
  Trace& trace_;
  std::vector<carom_body> bodies_;
  std::vector<std::size_t> particles_;  // indices of actors
  double sink_ = 0;
};

void push(Stage& stage, const std::vector<accuracy::Push>& pushes) {
  const double torque[3] = {0, 0, 0};
  for (const accuracy::Push& p : pushes) {
    Call call;
    call.done(carom_body_add_force(stage.world.get(), stage.actors[p.actor].body, p.force.data(), torque, call),
              "pushing " + stage.actors[p.actor].name);
  }
}

void nudge_first(Stage& stage, double speed) {
  for (const Actor& actor : stage.actors) {
    if (actor.body == CAROM_NULL_HANDLE || actor.type != CAROM_BODY_DYNAMIC) continue;
    std::vector<double> v;
    stage.world.read(CAROM_FIELD_VELOCITY, {actor.body}, v);
    v[0] += speed;
    Call call;
    call.done(carom_body_set_velocity(stage.world.get(), actor.body, v.data(), v.data() + 3, call), "nudging a body");
    return;
  }
}

}  // namespace

Trace Player::play(const Setting& setting, double seconds, double most_ms, double nudge) {
  // Work that threads share is told by the wall's clock: it is what a frame waits for.
  const auto now = question_.threads == 1 ? cpu_time : wall_time;
  const double started = now();
  const auto* trial = dynamic_cast<const accuracy::Trial*>(observer_.get());
  if (stage_ && !trial) {
    stage_->world.restore(start_, "its start");
  } else {
    observer_.reset();
    stage_ = std::make_unique<Stage>(engine_);
    observer_ = build(*question_.scene, question_.settings, *stage_);
    trial = dynamic_cast<const accuracy::Trial*>(observer_.get());
    if (!trial) start_ = stage_->world.save();
  }
  Stage& stage = *stage_;
  Trace trace;
  for (const auto& [dial, value] : setting.dials) stage.world.set_dial(dial + "=" + value);
  Watch watch(stage, trace);
  if (nudge > 0) nudge_first(stage, nudge);
  start_seconds_ = now() - started;
  const int frames = std::max(1, static_cast<int>(std::lround(seconds * question_.frame_rate)));
  const int stride = (frames + kMoments - 1) / kMoments;
  const double dt = 1 / (question_.frame_rate * setting.steps_per_frame);
  int played = 0;
  for (bool over = false; played < frames && !over && trace.finite && !trace.dear; ++played) {
    double frame = 0;  // s
    for (int k = 0; k < setting.steps_per_frame; ++k) {
      if (trial) push(stage, trial->pushes());
      const double begun = now();
      stage.world.step(dt);
      frame += now() - begun;
      const carom_step_report report = stage.world.report();
      watch.after_step(report);
      if (trial) observer_->watch(stage, report.time);
    }
    trace.ms += 1e3 * frame;
    trace.dear = trace.ms > most_ms * frames;
    trace.worst_ms = std::max(trace.worst_ms, 1e3 * frame);
    over = trial && trial->over();
    if ((played + 1) % stride == 0 || played + 1 == frames) watch.moment();
  }
  trace.ms /= played;
  if (trial) {
    trace.truth = trial->errors(stage).front();
    trace.fell = trial->fell();
    if (trace.fell || std::isnan(trace.truth)) trace.truth = std::numeric_limits<double>::infinity();
  }
  return trace;
}

}  // namespace carom::tools::tune
