// One joint into a scene file: limits that other tools read, and all of it in our own words.
#include <algorithm>

#include "scenefile/axes.h"

namespace carom::tools::scenefile {
namespace {

/// What a pulley's rope runs over, or how a gear's wheels turn; nothing of a pulley that is not strung yet.
void write_transmission(carom_world* world, carom_joint joint, const carom_joint_desc& d, json& own) {
  carom_joint_transmission t;
  carom_joint_transmission_init(&t, sizeof t);
  Call call;
  call.done(carom_joint_get_transmission(world, joint, &t, call), "reading a transmission");
  if (t.ratio == 0) return;
  own["ratio"] = t.ratio;
  if (d.kind == CAROM_JOINT_GEAR) return;
  own["anchorA"] = {t.anchor_a[0], t.anchor_a[1], t.anchor_a[2]};
  own["anchorB"] = {t.anchor_b[0], t.anchor_b[1], t.anchor_b[2]};
  own["length"] = t.length;
}

/// Which joints of the file a coupling couples, and how.
void write_coupling(carom_world* world, carom_joint joint, const std::vector<carom_joint>& all, json& own) {
  carom_joint_coupling c;
  carom_joint_coupling_init(&c, sizeof c);
  Call call;
  call.done(carom_joint_get_coupling(world, joint, &c, call), "reading a coupling");
  const auto number = [&](carom_joint of) { return std::find(all.begin(), all.end(), of) - all.begin(); };
  own["follower"] = number(c.follower), own["leader"] = number(c.leader);
  own["polynomial"] = std::vector<double>(c.polynomial, c.polynomial + 5);
}

}  // namespace

json joint_json(carom_world* world, carom_joint joint, const carom_joint_desc& d, const std::vector<carom_joint>& all) {
  const bool has_axes = d.kind == CAROM_JOINT_SIX_AXIS, is_coupling = d.kind == CAROM_JOINT_COUPLING,
             couples = d.kind == CAROM_JOINT_PULLEY || d.kind == CAROM_JOINT_GEAR || is_coupling;
  json own = {{"kind", carom_joint_kind_name(d.kind)}}, limits = json::array();
  const auto lock = [&](const char* axes, std::vector<int> which) {
    limits.push_back({{axes, which}, {"min", 0}, {"max", 0}});
  };
  if (d.kind == CAROM_JOINT_DISTANCE) own["length"] = d.length;
  if (d.fields & CAROM_JOINT_ACCELERATIONS) own["accelerations"] = true;
  if (d.break_force > 0) own["breakForce"] = d.break_force;
  if (d.break_torque > 0) own["breakTorque"] = d.break_torque;
  if (d.kind == CAROM_JOINT_SLIDER)
    lock("linearAxes", {1, 2});
  else if (d.kind != CAROM_JOINT_DISTANCE && !has_axes && !couples)
    lock("linearAxes", {0, 1, 2});
  if (d.kind == CAROM_JOINT_HINGE) lock("angularAxes", {1, 2});
  if (d.kind == CAROM_JOINT_UNIVERSAL) lock("angularAxes", {0});
  if (d.kind == CAROM_JOINT_WELD || d.kind == CAROM_JOINT_SLIDER) lock("angularAxes", {0, 1, 2});
  bool free_length = true;
  for (std::uint32_t k = 0; k < CAROM_COORDINATE_COUNT; ++k) {
    carom_joint_limit limit;
    carom_joint_motor motor;
    carom_joint_spring spring;
    carom_joint_limit_init(&limit, sizeof limit), carom_joint_motor_init(&motor, sizeof motor),
        carom_joint_spring_init(&spring, sizeof spring);
    if (carom_joint_get_limit(world, joint, k, &limit, nullptr) == CAROM_OK && limit.enabled) {
      own["limits"][kCoordinates[k]] = {limit.lower, limit.upper};
      json shown = {{"min", limit.lower}, {"max", limit.upper}};
      if (k == CAROM_COORDINATE_SLIDE) shown["linearAxes"] = {0};
      if (k == CAROM_COORDINATE_DISTANCE) shown["linearAxes"] = {0, 1, 2}, free_length = false;
      if (k == CAROM_COORDINATE_TWIST) shown["angularAxes"] = {0};
      if (k == CAROM_COORDINATE_SWING) shown["angularAxes"] = {1, 2};
      if (!couples) limits.push_back(std::move(shown));
    }
    if (carom_joint_get_motor(world, joint, k, &motor, nullptr) == CAROM_OK && motor.enabled)
      own["motors"][kCoordinates[k]] = {{"speed", motor.speed}, {"maxForce", motor.max_force}};
    if (carom_joint_get_spring(world, joint, k, &spring, nullptr) == CAROM_OK && spring.enabled) {
      own["springs"][kCoordinates[k]] = {{"target", spring.target},
                                         {"frequency", spring.frequency},
                                         {"damping", spring.damping},
                                         {"maxForce", spring.max_force}};
      if (k == CAROM_COORDINATE_DISTANCE) free_length = false;
    }
  }
  if (d.kind == CAROM_JOINT_DISTANCE && free_length)
    limits.push_back({{"linearAxes", {0, 1, 2}}, {"min", d.length}, {"max", d.length}});
  if (is_coupling) write_coupling(world, joint, all, own);
  if (couples && !is_coupling) write_transmission(world, joint, d, own);
  json entry = {{"limits", std::move(limits)}};
  write_axes(world, joint, has_axes, own, entry);
  entry["extensions"]["CAROM_physics"] = std::move(own);
  return entry;
}

}  // namespace carom::tools::scenefile
