// Six-axis joints, and drives to an orientation, in scene files.
#pragma once

#include "scenefile/document.h"
#include "scenes/scene.h"

namespace carom::tools::scenefile {

inline constexpr const char* kCoordinates[] = {"twist", "swing", "slide", "distance"};  // by CAROM_COORDINATE_*
inline constexpr double kMostTurned = 1e3;  // rad: as far as a limit or a target of a turn may be

/// An entry of physicsJoints. Of a pulley or a gear other tools see a joint that locks nothing.
/// @param all  joints of the file, in its order
json joint_json(carom_world* world, carom_joint joint, const carom_joint_desc& desc,
                const std::vector<carom_joint>& all);

/// What CAROM_physics says of a joint's axes and its drive to an orientation is added to `own`, and locks, limits and drives to
/// `entry`, as KHR_physics_rigid_bodies has them.
void write_axes(carom_world* world, carom_joint joint, bool has_axes, json& own, json& entry);
/// The same, back into a joint.   @throws Error
void read_own_axes(carom_world* world, carom_joint joint, const Value& own);

/// Whether all limits of a joint of KHR_physics_rigid_bodies are of one axis each, or lock: then axes say it.
bool is_told_by_axes(const Value& joint);
/// What its parts say in the terms of their extension: OMI_physics_joint has its own words for infinity.
bool is_soft_limit(const Value& limit);
bool holds_nothing(const Value& limit);  ///< it is soft, of no stiffness
double stiffness_of_drive(const Value& drive);
double most_of_drive(const Value& drive);
/// Its limits and drives as those of the axes of a joint.   @throws Error
void read_khr_axes(carom_world* world, carom_joint handle, const Value& joint);

}  // namespace carom::tools::scenefile
