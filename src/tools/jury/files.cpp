// Scenes as JSON for other engines, motion as plain doubles.
#include "host/files.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "jury/gaps.h"
#include "jury/trial.h"

namespace carom::tools::jury {
namespace {

using nlohmann::json;

constexpr std::size_t kNumbers = 13;  // of a state: position, orientation (x, y, z, w), velocity, spin

json numbers(const Vec& v) { return {v.x(), v.y(), v.z()}; }
json numbers(const Quat& q) { return {q.x(), q.y(), q.z(), q.w()}; }

/// Of a place: stiffness in N/m or N m/rad, and its damping likewise.
json drive_json(const Drive& drive, double weight) {
  const double w = 2 * std::numbers::pi * drive.frequency;
  json out = {{"aim", drive.aim == Drive::Aim::speed ? "speed" : "place"}, {"goal", drive.goal}, {"most", drive.most}};
  if (drive.aim == Drive::Aim::place)
    out["stiffness"] = weight * w * w, out["damping"] = 2 * drive.damping * weight * w;
  return out;
}

json body_json(const Actor& actor, const Member& member) {
  static constexpr const char* kTypes[] = {"static", "kinematic", "dynamic"};
  const Part& part = actor.parts.at(0);
  return {{"name", actor.name},
          {"type", kTypes[actor.type]},
          {"position", numbers(actor.position)},
          {"orientation", numbers(actor.orientation)},
          {"velocity", numbers(actor.linear_velocity)},
          {"spin", numbers(actor.angular_velocity)},
          {"shape", part.shape},
          {"params", part.params},
          {"density", part.density},
          {"friction", part.friction},
          {"restitution", part.restitution},
          {"mass", member.mass},
          {"late", member.is_late},
          {"surface", numbers(member.surface)}};
}

json link_json(const Case& scene, const Link& link, const Frame& start) {
  json out = {{"kind", carom_joint_kind_name(link.kind)},
              {"a", link.a},
              {"b", link.b},
              {"at_a", numbers(link.at_a)},
              {"at_b", numbers(link.at_b)},
              {"axes_a", numbers(link.axes_a)},
              {"axes_b", numbers(link.axes_b)}};
  if (link.limited) out["limit"] = {link.lower, link.upper};
  if (link.swing > 0) out["swing"] = link.swing;
  if (link.drive.aim != Drive::Aim::none) out["drive"] = drive_json(link.drive, weight_along(scene, link, start));
  return out;
}

json paddle_json(const Paddle& paddle, const std::vector<Beat>& course) {
  json velocities = json::array();
  for (const Beat& beat : course) velocities.push_back(numbers(paddle.velocity(beat.time, beat.end)));
  return {{"body", paddle.member}, {"spin", numbers(paddle.spin)}, {"velocities", velocities}};
}

json deed_json(const Deed& deed) {
  static constexpr const char* kNames[] = {"put", "throw", "add", "remove", "pace", "drive"};
  return {{"what", kNames[static_cast<std::size_t>(deed.what)]},
          {"who", deed.who},
          {"position", numbers(deed.state.position)},
          {"orientation", numbers(deed.state.orientation)},
          {"velocity", numbers(deed.state.velocity)},
          {"spin", numbers(deed.state.omega)},
          {"value", deed.value}};
}

/// Each step: its length, and what the host does before it.
json step_json(const Case& scene, const Beat& beat) {
  json deeds = json::array();
  for (const std::size_t k : beat.deeds) deeds.push_back(deed_json(scene.deeds[k]));
  return {{"dt", beat.dt}, {"deeds", deeds}};
}

void put(std::vector<double>& out, const State& s) {
  out.insert(out.end(), s.position.data(), s.position.data() + 3);
  out.insert(out.end(), s.orientation.coeffs().data(), s.orientation.coeffs().data() + 4);
  out.insert(out.end(), s.velocity.data(), s.velocity.data() + 3);
  out.insert(out.end(), s.omega.data(), s.omega.data() + 3);
}

State state_from(const double* in) {
  State s;
  s.position = Vec(in);
  s.orientation = Quat(Eigen::Vector4d(in + 3)).normalized();  // of single precision, perhaps
  s.velocity = Vec(in + 7);
  s.omega = Vec(in + 10);
  return s;
}

}  // namespace

void write_scene_json(const std::string& path, const Scenery& scenery, const Setting& setting) {
  const Case& scene = scenery.scene;
  const std::vector<Beat> course = course_of(scene, setting);
  const Frame start = frame_of(scenery.stage);
  json out = {{"seed", scene.seed}, {"summary", scene.summary}, {"gravity", scene.gravity}};
  out["bodies"] = out["joints"] = out["paddles"] = out["steps"] = json::array();
  for (std::size_t i = 0; i < scene.members.size(); ++i)
    out["bodies"].push_back(body_json(scenery.stage.actors[i], scene.members[i]));
  for (const Link& link : scene.links) out["joints"].push_back(link_json(scene, link, start));
  for (const Paddle& paddle : scene.paddles) out["paddles"].push_back(paddle_json(paddle, course));
  for (const Beat& beat : course) out["steps"].push_back(step_json(scene, beat));
  write_file(path, out.dump());
}

void write_motion(const std::string& path, const Motion& motion) {
  std::vector<double> out;
  for (std::size_t i = 0; i < motion.frames.size(); ++i) {
    out.push_back(i ? motion.seconds[i - 1] : 0);
    for (const State& state : motion.frames[i]) put(out, state);
  }
  write_file(path, std::string(reinterpret_cast<const char*>(out.data()), out.size() * sizeof(double)));
}

Motion read_motion(const std::string& path, std::size_t members) {
  const std::string bytes = read_file(path, "write it with the other engine first");
  const std::size_t record = (1 + kNumbers * members) * sizeof(double);
  if (bytes.empty() || bytes.size() % record)
    throw Error(path + " is no motion of this scene",
                "a record holds a time and 13 numbers for each of " + std::to_string(members) + " bodies");
  std::vector<double> in(bytes.size() / sizeof(double));
  std::memcpy(in.data(), bytes.data(), bytes.size());
  Motion motion;
  for (std::size_t at = 0; at < in.size(); at += record / sizeof(double)) {
    if (at) motion.seconds.push_back(in[at]);
    Frame frame;
    for (std::size_t i = 0; i < members; ++i) frame.push_back(state_from(&in[at + 1 + kNumbers * i]));
    motion.frames.push_back(std::move(frame));
  }
  return motion;
}

}  // namespace carom::tools::jury
