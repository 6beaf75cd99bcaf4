// Passes: islands that take the same number of substeps go through a part of the step together, the others out of the
// lists. README.md in this folder says how; step.cpp goes through them.
//
// Between two passes the world is as the step began; where islands end is kept here, and put in place after the last
// one. So is what a pass does to bodies that a host moves, and whom it puts in quarantine.
#pragma once

#include "dynamics/accuracy/measure.h"
#include "dynamics/contact/contact.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/plan_lists.h"

namespace carom::dynamics {

struct Passes {
  explicit Passes(Memory* m);

  struct Island {
    std::uint32_t first, bodies;  // of `members`
    std::uint32_t rows, links;    // how many
    std::uint8_t met;             // @see accuracy::Trial::begin()
    bool runs;                    // in this pass
    bool is_swept;                // something of it may be hit by a sweep: it takes the dial's substeps, with no trial
    bool is_soft;                 // contacts of it were springs, in its last run
    AccuracyMemory memory;
    accuracy::Trial trial;
  };
  Array<Island> islands;
  Array<std::uint32_t> movers;     // slots of bodies that are in an island, ascending
  Array<std::uint32_t> members;    // places in movers, by island
  Array<std::uint32_t> island_of;  // by slot; kInvalid: none
  Array<std::uint32_t> parent;     // by slot, scratch: union-find

  // ---- bodies: as the step began, where islands end, and the end to compare with; by place in movers ----
  struct Kept {
    Vec3 x, v, omega, momentum, force, torque;
    Quat q, held_q;
    std::uint8_t loaded_steps, cooldown_steps;
    std::uint8_t held_out;  // in quarantine, in this step
  };
  Array<Kept> begun, ended;
  Array<accuracy::BodyEnd> coarse;
  struct Stand {
    Vec3 x;
    Quat q;
  };
  Array<Stand> driven_begun;  // bodies that a host moves, in their order

  // ---- joints: by place in all_active ----
  struct KeptJoint {
    std::array<Real, kMostEqualities> p;
    std::array<Real, kMostDrives> drive_p;
    Real p_h, phase;
    Vec3 turned, force, torque, turn_p;
    std::array<std::array<Real, kAxisSources>, kAxes> axes_p;
  };
  Array<KeptJoint> joint_begun, joint_ended;
  Array<std::uint32_t> all_active, active, packed_active;

  // ---- contacts: as they were made, and all of the lists of which a pass has a part ----
  Array<Row> rows;
  Array<RowGeometry> geometry;
  Array<ContactPair> contact_pairs;
  Array<std::uint32_t> bouncing;
  Array<Resistance> resisting, resisting_ended;  // as the step began; of the runs that were accepted
  Array<Driven> driven;
  Array<TurningPair> turning_pairs;
  GroupViews group_views;  // of runs that were accepted

  Participants those, scratch;
  PlanLists lists;            // of a pass; while it runs, of all
  bool is_accounted = false;  // somebody keeps a ledger, which is told of no trials
  bool is_planned = false;    // in this step
  bool is_running = false;
  bool is_to_sweep = false;    // the pass of all that is swept is still to come
  bool is_sweeping = false;    // it goes on; trials are over
  bool is_accounting = false;  // both are over, and what was accepted runs once more for the ledger
  int substeps = 1;            // of the plan
  std::uint64_t revision = 0, collider_revision = 0, quarantined = 0, groups = 0, largest_group = 0;
  bool alarm = false;
  std::size_t faults = 0;
};

/// What passes change and put back.
using Passing = Writes<Poses, Velocities, HostForces, Quarantine, Revisions, FaultViews, SolverMemory, Joints,
                       PairCounts, GroupViews, StepReport>;

namespace accuracy {

/// Whether substeps go by island.
bool goes_by_island(const World& world);
/// Islands of this step, and what they begin with. Allocates.
void plan_passes(const World& world, const StepTime& time);
/// The next pass is set up: the plan has its substeps and its bodies.   @return whether there is one
bool begin_pass(const World& world, SpringLoads& springs, Floats& floats, Passing to, const StepTime& time);
/// It has gone through its stages: judge what ended, keep it, go back to where the step began. Allocates.
void end_pass(const World& world, Passing to, const StepTime& time);
/// Islands stand where their accepted runs led.
void end_passes(const World& world, Passing to, Events& events, const StepTime& time);
/// A step that is not completed: the world is as it began.
void drop_passes(const World& world, Passing to);

// Parts of it.
/// keep.cpp: to and from what is kept.
void keep_begun(const World& world, Passes& p);
void go_back(const World& world, Passing to);
void keep_ended(const World& world, const Passes::Island& island);
void keep_joint(const World& world, std::size_t at);  // in all_active
void put_ended(const World& world, Passing to);
/// islands.cpp
void find_islands(const World& world, Passes& p, Real dt);
int order_of(const World& world, const Passes& p, const Passes::Island& island);

/// f(place in movers, slot) of an island's bodies.
template <class F>
void each_member(const Passes& p, const Passes::Island& island, F&& f) {
  for (std::uint32_t k = island.first; k < island.first + island.bodies; ++k) f(p.members[k], p.movers[p.members[k]]);
}
inline bool runs(const Passes& p, std::uint32_t body) {
  return body < p.island_of.size() && p.island_of[body] != kInvalid && p.islands[p.island_of[body]].runs;
}

}  // namespace accuracy
}  // namespace carom::dynamics
