// Six-axis joints, and drives to an orientation, in scene files.
#include "scenefile/axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace carom::tools::scenefile {
namespace {

constexpr double kZeroWidth = 1e-9, kFar = 1e9, kAnyForce = 1e30;        // m or rad; m; N or N m
constexpr std::uint32_t kOwnAxes[] = {CAROM_AXIS_TURN_X, CAROM_AXIS_X};  // of a hinge, of a slider
constexpr const char* kModes[] = {"free", "locked", "limited"};
constexpr const char* kDrives[] = {"none", "position", "velocity", "effort"};
constexpr const char* kGains[] = {"frequency", "force", "acceleration"};

template <class Desc>
struct WordField {
  const char* name;
  std::uint32_t Desc::*field;
  const char* const* words;
  std::uint32_t count;
};
constexpr WordField<carom_joint_axis> kAxisWords[] = {{"mode", &carom_joint_axis::mode, kModes, 3},
                                                      {"drive", &carom_joint_axis::drive, kDrives, 4},
                                                      {"stopGains", &carom_joint_axis::stop_gains, kGains, 3},
                                                      {"driveGains", &carom_joint_axis::drive_gains, kGains, 3},
                                                      {"springGains", &carom_joint_axis::spring_gains, kGains, 3}};
constexpr WordField<carom_joint_orientation_drive> kTurnWords[] = {
    {"drive", &carom_joint_orientation_drive::drive, kDrives, 4},
    {"gains", &carom_joint_orientation_drive::gains, kGains, 3}};
struct NumberField {
  const char* name;
  double carom_joint_axis::*field;
};
constexpr NumberField kAxisNumbers[] = {{"lower", &carom_joint_axis::lower},
                                        {"upper", &carom_joint_axis::upper},
                                        {"stopStiffness", &carom_joint_axis::stop_stiffness},
                                        {"stopDamping", &carom_joint_axis::stop_damping},
                                        {"target", &carom_joint_axis::target},
                                        {"speed", &carom_joint_axis::speed},
                                        {"effort", &carom_joint_axis::effort},
                                        {"maxForce", &carom_joint_axis::max_force},
                                        {"driveStiffness", &carom_joint_axis::drive_stiffness},
                                        {"driveDamping", &carom_joint_axis::drive_damping},
                                        {"rest", &carom_joint_axis::rest},
                                        {"springStiffness", &carom_joint_axis::spring_stiffness},
                                        {"springDamping", &carom_joint_axis::spring_damping},
                                        {"friction", &carom_joint_axis::friction},
                                        {"armature", &carom_joint_axis::armature},
                                        {"effortLimit", &carom_joint_axis::effort_limit},
                                        {"speedLimit", &carom_joint_axis::speed_limit}};

template <class Desc, std::size_t n>
void put_words(const Desc& d, const WordField<Desc> (&fields)[n], json& to) {
  for (const auto& f : fields)
    if (d.*f.field) to[f.name] = f.words[d.*f.field];
}
template <class Desc, std::size_t n>
void take_words(const Value& from, const WordField<Desc> (&fields)[n], Desc& d) {
  for (const auto& f : fields) {
    const auto value = from.get(f.name);
    if (!value) continue;
    std::string all;
    std::uint32_t k = 0;
    for (; k < f.count && value->text() != f.words[k]; ++k) all += (k ? ", " : "") + std::string(f.words[k]);
    if (k == f.count) value->fail("is '" + value->text() + "'", "write one of: " + all);
    d.*f.field = k;
  }
}

json axis_json(const carom_joint_axis& d) {
  carom_joint_axis plain;
  carom_joint_axis_init(&plain, sizeof plain);
  json out = json::object();
  put_words(d, kAxisWords, out);
  for (const NumberField& f : kAxisNumbers)
    if (d.*f.field != plain.*f.field || std::signbit(d.*f.field)) out[f.name] = d.*f.field;
  return out;
}
carom_joint_axis axis_of(const Value& from) {
  carom_joint_axis d;
  carom_joint_axis_init(&d, sizeof d);
  take_words(from, kAxisWords, d);
  for (const NumberField& f : kAxisNumbers) d.*f.field = from.number_or(f.name, d.*f.field);
  return d;
}

/// Limits and a drive as KHR_physics_rigid_bodies has them; what it has no words for stands in CAROM_physics alone.
void show_axis(const carom_joint_axis& d, std::uint32_t axis, json& entry) {
  const bool turns = axis >= CAROM_AXIS_TURN_X;
  const auto number = axis % 3;
  if (d.mode != CAROM_AXIS_MODE_FREE) {
    json limit = {{turns ? "angularAxes" : "linearAxes", {number}},
                  {"min", d.lower},
                  {"max", d.mode == CAROM_AXIS_MODE_LOCKED ? d.lower : d.upper}};
    if (d.mode == CAROM_AXIS_MODE_LIMITED && d.stop_gains == CAROM_GAINS_FORCE && d.stop_stiffness > 0)
      limit["stiffness"] = d.stop_stiffness, limit["damping"] = d.stop_damping;
    entry["limits"].push_back(std::move(limit));
  }
  if (d.drive != CAROM_DRIVE_POSITION || d.drive_gains == CAROM_GAINS_FREQUENCY) return;
  json drive = {{"type", turns ? "angular" : "linear"},
                {"mode", d.drive_gains == CAROM_GAINS_FORCE ? "force" : "acceleration"},
                {"axis", number},
                {"positionTarget", d.target},
                {"velocityTarget", d.speed},
                {"stiffness", d.drive_stiffness},
                {"damping", d.drive_damping}};
  if (d.max_force < kAnyForce) drive["maxForce"] = d.max_force;
  entry["drives"].push_back(std::move(drive));
}

json turn_json(const carom_joint_orientation_drive& d) {
  const auto list = [](const double* x, int n) { return json(std::vector<double>(x, x + n)); };
  json out = {{"target", list(d.target, 4)},      {"velocity", list(d.velocity, 3)}, {"effort", list(d.effort, 3)},
              {"maxForce", list(d.max_force, 3)}, {"stiffness", d.stiffness},        {"damping", d.damping}};
  put_words(d, kTurnWords, out);
  return out;
}
carom_joint_orientation_drive turn_of(const Value& from) {
  carom_joint_orientation_drive d;
  carom_joint_orientation_drive_init(&d, sizeof d);
  take_words(from, kTurnWords, d);
  const auto list = [&](const char* name, double* to, std::size_t n) {
    const auto value = from.get(name);
    if (value) std::ranges::copy(value->numbers(n), to);
  };
  list("target", d.target, 4), list("velocity", d.velocity, 3), list("effort", d.effort, 3),
      list("maxForce", d.max_force, 3);
  d.stiffness = from.number_or("stiffness", 0), d.damping = from.number_or("damping", 0);
  return d;
}

/// A limit of KHR_physics_rigid_bodies: without `min` or `max` it is open there.
struct Khr {
  bool turns, is_lock;
  double lower, upper;
  Value axes;
};

/// OMI_physics_joint says "infinite" with what is negative.
double given_or_boundless(const Value& of, const char* key, double boundless) {
  const bool omi = of.place().starts_with("/extensions/OMI_");
  const double x = of.number_or(key, boundless, omi ? -1e300 : 0, 1e300);
  return x < 0 ? boundless : x;
}
Khr khr_of(const Value& limit) {
  const bool turns = limit.has("angularAxes");
  const double far = turns ? kMostTurned : kFar;
  const double lower = std::clamp(limit.number_or("min", -far), -far, far),
               upper = std::clamp(limit.number_or("max", far), -far, far);
  return {turns, upper - lower < kZeroWidth && !is_soft_limit(limit), lower, std::max(lower, upper),
          limit[turns ? "angularAxes" : "linearAxes"]};
}

void take_limit(const Value& limit, std::array<carom_joint_axis, CAROM_AXIS_COUNT>& axes) {
  const Khr khr = khr_of(limit);
  if (holds_nothing(limit)) return;
  for (std::size_t k = 0; k < khr.axes.size(); ++k) {
    carom_joint_axis& d = axes[khr.axes.at(k).index(3, "axes") + (khr.turns ? 3 : 0)];
    d.mode = khr.is_lock ? CAROM_AXIS_MODE_LOCKED : CAROM_AXIS_MODE_LIMITED;
    d.lower = khr.lower, d.upper = khr.upper;
    d.stop_gains = CAROM_GAINS_FORCE;
    d.stop_stiffness = std::min(given_or_boundless(limit, "stiffness", 0), kAnyForce);
    d.stop_damping = d.stop_stiffness > 0 ? std::min(limit.number_or("damping", 0, 0, 1e300), kAnyForce) : 0;
  }
}

void take_drive(const Value& drive, std::array<carom_joint_axis, CAROM_AXIS_COUNT>& axes) {
  const bool turns = drive["type"].text() == "angular";
  const double far = turns ? kMostTurned : kFar;
  carom_joint_axis& d = axes[drive["axis"].index(3, "axes") + (turns ? 3 : 0)];
  d.drive = CAROM_DRIVE_POSITION;
  d.drive_gains = !drive.has("mode") || drive["mode"].text() == "force" ? CAROM_GAINS_FORCE : CAROM_GAINS_ACCELERATION;
  d.drive_stiffness = std::min(stiffness_of_drive(drive), kAnyForce);
  d.drive_damping = std::min(drive.number_or("damping", 0, 0, 1e300), kAnyForce);
  d.target = std::clamp(drive.number_or("positionTarget", 0), -far, far);
  d.speed = std::clamp(drive.number_or("velocityTarget", 0), -1e6, 1e6);
  d.max_force = std::min(most_of_drive(drive), kAnyForce);
}

}  // namespace

void write_axes(carom_world* world, carom_joint joint, bool has_axes, json& own, json& entry) {
  Call call;
  for (std::uint32_t k = 0; has_axes && k < CAROM_AXIS_COUNT; ++k) {
    carom_joint_axis d;
    carom_joint_axis_init(&d, sizeof d);
    call.done(carom_joint_get_axis(world, joint, k, &d, call), "reading an axis");
    own["axes"].push_back(axis_json(d));
    show_axis(d, k, entry);
  }
  for (const std::uint32_t k : kOwnAxes) {  // of a hinge, of a slider
    carom_joint_axis d;
    carom_joint_axis_init(&d, sizeof d);
    if (has_axes || carom_joint_get_axis(world, joint, k, &d, nullptr) != CAROM_OK) continue;
    if (json own_axis = axis_json(d); !own_axis.empty()) own["axis"] = std::move(own_axis);
  }
  carom_joint_orientation_drive d;
  carom_joint_orientation_drive_init(&d, sizeof d);
  if (carom_joint_get_orientation_drive(world, joint, &d, nullptr) == CAROM_OK && d.drive != CAROM_DRIVE_NONE)
    own["orientationDrive"] = turn_json(d);
}

void read_own_axes(carom_world* world, carom_joint joint, const Value& own) {
  Call call;
  const auto axes = own.get("axes");
  for (std::uint32_t k = 0; axes && k < axes->size(); ++k) {
    const carom_joint_axis d = axis_of(axes->at(k));
    call.done(carom_joint_set_axis(world, joint, k, &d, call), axes->at(k).place());
  }
  if (const auto axis = own.get("axis")) {
    const carom_joint_axis d = axis_of(*axis);
    const std::uint32_t k = kOwnAxes[own["kind"].text() == carom_joint_kind_name(CAROM_JOINT_SLIDER)];
    call.done(carom_joint_set_axis(world, joint, k, &d, call), axis->place());
  }
  if (const auto drive = own.get("orientationDrive")) {
    const carom_joint_orientation_drive d = turn_of(*drive);
    call.done(carom_joint_set_orientation_drive(world, joint, &d, call), drive->place());
  }
}

bool holds_nothing(const Value& limit) {
  return is_soft_limit(limit) && given_or_boundless(limit, "stiffness", -1) == 0;
}

bool is_soft_limit(const Value& limit) {
  return limit.has("stiffness") && given_or_boundless(limit, "stiffness", -1) >= 0;
}

double stiffness_of_drive(const Value& drive) {
  const bool omi = drive.place().starts_with("/extensions/OMI_");  // there a spring needs a target
  return omi && !drive.has("positionTarget") ? 0 : drive.number_or("stiffness", 0, 0, 1e300);
}

double most_of_drive(const Value& drive) { return given_or_boundless(drive, "maxForce", kAnyForce); }

bool is_told_by_axes(const Value& joint) {
  const auto limits = joint.get("limits");
  for (std::size_t k = 0; limits && k < limits->size(); ++k) {
    const Khr khr = khr_of(limits->at(k));
    // Springs of one stiffness to 0 along several axes are one to the middle, as to turns while these are small.
    const bool at_zero = khr.upper - khr.lower < kZeroWidth && std::fabs(khr.lower) < kZeroWidth;
    if (khr.axes.size() > 1 && !at_zero) return false;
  }
  return true;
}

void read_khr_axes(carom_world* world, carom_joint handle, const Value& joint) {
  std::array<carom_joint_axis, CAROM_AXIS_COUNT> axes;
  for (carom_joint_axis& d : axes) carom_joint_axis_init(&d, sizeof d);
  if (const auto limits = joint.get("limits"))
    for (std::size_t k = 0; k < limits->size(); ++k) take_limit(limits->at(k), axes);
  if (const auto drives = joint.get("drives"))
    for (std::size_t k = 0; k < drives->size(); ++k) take_drive(drives->at(k), axes);
  Call call;
  for (std::uint32_t k = 0; k < CAROM_AXIS_COUNT; ++k)
    call.done(carom_joint_set_axis(world, handle, k, &axes[k], call), joint.place());
}

}  // namespace carom::tools::scenefile
