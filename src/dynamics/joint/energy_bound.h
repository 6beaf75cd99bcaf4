// What joints and pushes may not give: energy, where they are not resolved.
//
// Between two bodies a joint does no work. In a substep it does some all the same: half a substep's force is that of where
// bodies were, an error is led back by a velocity, and sweeps end before all joints agree. Where bodies turn by small
// angles and joints hold, that comes back. Where a body turns by more than a radian a substep, or a joint gapes, nothing
// says that it does, and energy may grow without end. Likewise where RATTLE gave its island up. So there a contact group
// has at most the kinetic energy that it had after the forces of the substep: else what its bodies do relative to each
// other is slowed to that. So it is before the move, which would lift a heavy body as well, and after. Linear momentum
// stays where nothing fixed holds them. Others are not touched, to the bit. Its functions are in wide_joints.h.
#pragma once

#include "core/constant.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kUnresolvedTurn{
    "joint_unresolved_turn", 1, "rad",
    "by which a body with unlike moments may turn in a substep before its group may gain no energy: where sine and angle "
    "differ by a sixth",
    "larger: needles that spin gain energy; smaller: what swings fast loses some"};
inline constexpr Constant<Real> kUnresolvedGap{
    "joint_unresolved_gap", 0.1, "1",
    "of a joint's longer arm, and four position tolerances, or of a radian, by which it may gape before its group may "
    "gain no energy",
    "larger: what is torn apart gains energy; smaller: what hangs on soft joints loses some"};
inline constexpr Constant<Real> kThrow{
    "surface_throw", 4, "1",
    "times the speed of surfaces that nothing moves: what bodies they meet may reach; an elastic surface that comes at u "
    "throws at 2 u, and bodies that hang on those faster",
    "larger: bodies between surfaces that close are shot out; smaller: what surfaces throw falls short"};

inline constexpr ConstantRow kEnergyBoundConstants[] = {kUnresolvedTurn, kUnresolvedGap, kThrow};

}  // namespace carom::dynamics
