// Pulleys and gears into lanes and back.
#include <cmath>
#include <numbers>

#include "core/wide_angle.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/fill_lanes.h"

namespace carom::dynamics {

void fill_transmission(const World& world, const Joint& joint, const JointEnds& ends, WideJoints& w, JointLanes& lanes,
                       int lane) {
  if (lanes.pulled) {
    PullLanes& pull = w.pulls[lanes.pulled - 1];
    const Ropes ropes = ropes_of(world, joint, ends);
    set(pull.start_rope_a, lane, ropes.a), set(pull.start_rope_b, lane, ropes.b);
    pull.ratio[lane] = joint.transmission.ratio;
    lanes.length[lane] = joint.transmission.length;
  }
  if (lanes.geared) {
    GearLanes& gear = w.gears[lanes.geared - 1];
    gear.ratio[lane] = joint.transmission.ratio, gear.phase[lane] = joint.transmission.phase;
    gear.turned_a[lane] = gear.turned_b[lane] = gear.ahead_a[lane] = gear.ahead_b[lane] = 0;
  }
}

Real phase_of(const World& world, const Joint& joint, const WideJoints& w, const JointLanes& lanes,
              std::uint32_t lane) {
  const GearLanes& gear = w.gears[lanes.geared - 1];
  const JointEnds ends = ends_of(world, joint.def);
  const auto turned = [&](const LaneQuat& from, const Quat& to, Real near) {
    const Quat start(from.w[lane], from.x[lane], from.y[lane], from.z[lane]), turn = to * start.conjugate();
    const Real along = turn.vec().dot(start * Vec3::unit_x()), sign = turn.w() < 0 ? -1 : 1;
    const Real angle = 2 * angle_of<double>(sign * along, sign * turn.w()), whole = 2 * std::numbers::pi;
    return angle + whole * std::nearbyint((near - angle) / whole);
  };
  return get(gear.phase, lane) + turned(lanes.start_frame_a, ends.a.q, get(gear.turned_a, lane)) +
         get(gear.ratio, lane) * turned(lanes.start_frame_b, ends.b.q, get(gear.turned_b, lane));
}

}  // namespace carom::dynamics
