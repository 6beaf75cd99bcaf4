// What joints in lanes are made of. Who fills, places and sweeps them: wide_joints.h.
#pragma once

#include <algorithm>
#include <span>

#include "dynamics/effects.h"
#include "dynamics/joint/coupling.h"
#include "dynamics/joint/joint.h"
#include "dynamics/joint/joint_kernels.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

struct WideJoints {
  explicit WideJoints(Memory* m)
      : active(m),
        linked(m),
        place(m),
        occupant(m),
        joints(m),
        rows(m),
        drives(m),
        locks(m),
        pulls(m),
        gears(m),
        axes(m),
        colours(m),
        kicked(m),
        gyro(m),
        start(m),
        shift(m),
        bounded(m),
        bounds(m),
        order(m) {}

  const JointKernels* kernels = nullptr;  // of the name of WideContacts::kernels

  Array<std::uint32_t> active;  // slots of joints that hold somebody who is awake, ascending
  Array<std::uint8_t> linked;   // by body slot: some active joint has it; empty if there are none

  struct Place {
    std::uint32_t lanes, lane;
  };
  Array<Place> place;             // by index in active
  Array<std::uint32_t> occupant;  // [4 lanes] index in active, or kInvalid
  Array<JointLanes> joints;
  Array<JointRowLanes> rows;
  Array<JointDriveLanes> drives;
  Array<LockLanes> locks;        // of joints with bodies that are locked
  Array<PullLanes> pulls;        // of joints that pull A another way than B
  Array<GearLanes> gears;        // of gears
  Array<AxesLanes> axes;         // of joints whose axes, or turns as one, are told by themselves
  Array<std::uint32_t> colours;  // in use, from the lowest: where in joints each ends; those up to `swept` stand alone
  std::uint32_t swept = 0;       // joints up to here are swept
  bool is_packed = false;        // place, occupant and colours are those of active, all of it swept

  Owned<Array<CoupledRow>> couplings;  // that are active, ascending; null until there is one
  std::span<CoupledRow> coupled() const {
    return couplings ? std::span<CoupledRow>(*couplings) : std::span<CoupledRow>();
  }

  /// Bodies of groups that have joints and no contacts: they move by the velocity of the middle of a substep. Half of
  /// what forces do to it in a substep is taken off before the solver and given back after the move. What turns about
  /// unlike axes keeps its angular momentum over the move.
  struct Kicked {
    std::uint32_t body;
    Vec3 half;    // m/s: half of what forces did in this substep
    Quat facing;  // before the move
    Vec3 omega;   // rad/s, before the solver
    Vec3 spun;    // rad/s: what keeping the momentum did to omega
  };
  Array<Kicked> kicked;      // ascending
  Array<BodyVelocity> gyro;  // by solver body, @see JointRun; empty: none turns so
  // By solver body: where the step began, and how far bodies have come. Empty where WideContacts has the same.
  Array<Pose> start;
  Array<BodyShift> shift;

  /// Bodies of groups with joints that nothing drives, and those groups: @see energy_bound.h
  struct Bounded {
    std::uint32_t body, group;
    Vec3 v, omega;       // m/s, rad/s: before the solver
    Quat q;              // to which that omega belongs
    Real before, after;  // J, with those velocities and with what the solver made of them: scratch
  };
  struct GroupBound {
    bool is_driven = false, is_held = false, is_unresolved = false, gains = false;
    bool turns_far = false;      // that is why: what gapes may still be led back by the move
    Real surface = 0;            // m/s, of what it meets that impulses do not move
    Real before = 0, after = 0;  // J
    Real mass = 0;               // kg
    Vec3 momentum = Vec3::zero();
  };
  Array<Bounded> bounded;    // ascending
  Array<GroupBound> bounds;  // by group

  // scratch
  struct Order {
    std::uint64_t key;
    std::uint32_t colour, index;
    bool operator<(const Order& o) const {
      return colour != o.colour ? colour < o.colour : key != o.key ? key < o.key : index < o.index;
    }
  };
  Array<Order> order;  // of the lanes

  bool any() const { return !active.empty(); }
  /// @param link  index in active   @return whether it is swept: else the direct solver solves it
  bool is_swept(std::uint32_t link) const { return place[link].lanes < swept; }
};

/// Which way a row pulls at A.
inline const LaneVec& pull_at_a(const WideJoints& w, const JointLanes& joint, const JointRowLanes& row) {
  return joint.pulled ? w.pulls[joint.pulled - 1].d_a : row.d;
}

inline JointRun every_joint(const World& world) {
  WideJoints& w = *world.wide_joints;
  return {w.joints.data(),
          w.joints.size(),
          w.rows.data(),
          w.drives.data(),
          world.wide->velocity.data(),
          w.shift.empty() ? world.wide->shift.data() : w.shift.data(),
          world.wide->first_moved,
          w.locks.data(),
          w.gyro.empty() ? nullptr : w.gyro.data(),
          w.pulls.data(),
          w.gears.data(),
          w.axes.data()};
}

/// The row of a coupling.   @param link  index in active
inline CoupledRow& coupled_at(WideJoints& w, std::uint32_t link) {
  return *std::ranges::lower_bound(w.coupled(), link, {}, &CoupledRow::link);
}

}  // namespace carom::dynamics
