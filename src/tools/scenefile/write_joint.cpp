// One joint into a scene file: limits that other tools read, and all of it in our own words.
#include <iterator>

#include "scenefile/axes.h"

namespace carom::tools::scenefile {

json joint_json(carom_world* world, carom_joint joint, const carom_joint_desc& d) {
  static constexpr const char* kKinds[] = {"ball", "hinge", "slider", "weld", "distance", "universal"};
  static constexpr const char* kCoordinates[] = {"twist", "swing", "slide", "distance"};
  const bool has_axes = d.kind == CAROM_JOINT_SIX_AXIS;
  if (!has_axes && d.kind >= std::size(kKinds))
    throw Error("a pulley or a gear stands in the scene, and KHR_physics_rigid_bodies has no such joint",
                "take it out first, or keep the world as a snapshot: carom run SCENE --save FILE");
  json own = {{"kind", has_axes ? "six_axis" : kKinds[d.kind]}}, limits = json::array();
  const auto lock = [&](const char* axes, std::vector<int> which) {
    limits.push_back({{axes, which}, {"min", 0}, {"max", 0}});
  };
  if (d.kind == CAROM_JOINT_DISTANCE) own["length"] = d.length;
  if (d.break_force > 0) own["breakForce"] = d.break_force;
  if (d.break_torque > 0) own["breakTorque"] = d.break_torque;
  if (d.kind == CAROM_JOINT_SLIDER)
    lock("linearAxes", {1, 2});
  else if (d.kind != CAROM_JOINT_DISTANCE && !has_axes)
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
      limits.push_back(std::move(shown));
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
  json entry = {{"limits", std::move(limits)}};
  write_axes(world, joint, has_axes, own, entry);
  entry["extensions"]["CAROM_physics"] = std::move(own);
  return entry;
}

}  // namespace carom::tools::scenefile
