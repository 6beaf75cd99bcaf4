// One call for n joints: read what they do, in float or double, at any stride.
#include <carom/joint.h>

#include "core/float_scope.h"
#include "abi/records.h"
#include "abi/selection.h"
#include "abi/world.h"
#include "dynamics/joint/axis_parts.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/speeds.h"
#include "dynamics/joint/turns.h"

namespace carom::abi {
namespace {

using dynamics::Joint;

struct JointField {
  const char* name;
  int scalars;
  void (*read)(const World& world, const Joint& joint, double record[]);
};

template <class Numbers>
void put(const Numbers& numbers, double* record) {
  std::copy(numbers.begin(), numbers.end(), record);
}

std::array<double, kAxes> axes_of(const World& world, const Joint& joint) {
  const auto ends = ends_of(world, joint.def);
  return axes_at(ends, counted_angles(world, joint, ends));
}

constexpr JointField kBulkJointFields[CAROM_JOINT_READ_COUNT] = {
    // in the order of CAROM_JOINT_READ_*
    {"coordinates", 4, [](const World& w, const Joint& j, double* r) { put(place_of(w, j).at, r); }},
    {"speeds", 4, [](const World& w, const Joint& j, double* r) { put(speeds_of(w, j).coordinate, r); }},
    {"axes", 6, [](const World& w, const Joint& j, double* r) { put(axes_of(w, j), r); }},
    {"axis_speeds", 6, [](const World& w, const Joint& j, double* r) { put(speeds_of(w, j).axis, r); }},
    {"force", 3, [](const World&, const Joint& j, double* r) { from_vec3(j.force, r); }},
    {"torque", 3, [](const World&, const Joint& j, double* r) { from_vec3(j.torque, r); }},
    {"error", 2,
     [](const World& w, const Joint& j, double* r) {
       const dynamics::JointPlace place = place_of(w, j);
       r[0] = place.gap, r[1] = place.angle;
     }},
    {"broken", 1, [](const World&, const Joint& j, double* r) { *r = j.broken; }},
};

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_read_joints(carom_world* world, uint32_t field, uint32_t scalar, const carom_joint* joints,
                                uint64_t n, void* dst, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !known(call, 2, "field", field, CAROM_JOINT_READ_COUNT) ||
        !known(call, 3, "scalar", scalar, CAROM_SCALAR_F64 + 1) || (n && !present(call, 6, "dst", dst)))
      return;
    const JointField& row = kBulkJointFields[field];
    const Selection selection(reading->joints.slots, joints, {"joints", "a joint of joints"});
    if (!check_stride(call, 7, row.name, row.scalars, scalar, stride, n, 5) || !selection.check(call, n)) return;
    const FloatScope scope;
    selection.for_each(n, [&](std::uint32_t slot, std::uint64_t i) {
      double record[kMostScalars];
      row.read(*reading, reading->joints.joint[slot], record);
      char* const to = static_cast<char*>(dst) + i * stride;
      scalar == CAROM_SCALAR_F32 ? store<float>(record, row.scalars, to) : store<double>(record, row.scalars, to);
      return true;
    });
  });
}

}  // extern "C"
