// Joints in lanes: four side by side, in the order in which a solver visits them.
//
// Their colours are of one numbering with those of contacts, @see colours.h: a sweep goes through both, colour by
// colour. Joints that the direct solver solves stand after the last colour: their rows are made here too, but none
// sweeps them.
#pragma once

#include "dynamics/joint/wide_joint_data.h"

namespace carom::dynamics {

/// Of a loop that threads share.
inline constexpr std::size_t kJointsAPart = 16;

/// kernel(part of all joints), for kernels that write joints alone.
template <class Kernel>
void over_joints(const World& world, const Kernel& kernel) {
  const JointRun all = every_joint(world);
  in_parts(world.jobs, all.count, kJointsAPart, [&](std::uint32_t begin, std::uint32_t end) {
    JointRun r = all;
    r.joints += begin, r.count = end - begin;
    kernel(r);
  });
}

/// kernel(part of the swept joints), for kernels that write bodies: one colour after the other, and after each
/// `then(colour)`.
template <class Kernel, class Then>
void sweep_joints(const World& world, const Kernel& kernel, const Then& then) {
  const WideJoints& w = *world.wide_joints;
  const JointRun all = every_joint(world);
  const auto part = [&](std::size_t begin, std::size_t end) {
    JointRun r = all;
    r.joints += begin, r.count = end - begin;
    kernel(r);
  };
  std::size_t first = 0;
  for (std::uint32_t colour = 0; colour < kColours; ++colour) {
    const std::size_t end = colour < w.colours.size() ? w.colours[colour] : first;
    in_parts(world.jobs, end - first, kJointsAPart,
             [&](std::size_t from, std::size_t to) { part(first + from, first + to); });
    then(colour);
    first = end;
  }
  part(first, w.swept);
}

/// of_joints(part of the swept joints) and of_contacts(sweeps, part of the pairs), for kernels that write velocities:
/// colour by colour through both; then those beyond the colours, one after the other, and contacts region by region.
template <class OfJoints, class OfContacts>
void sweep_rows(const World& world, const OfJoints& of_joints, const OfContacts& of_contacts) {
  if (!world.wide_joints->any()) return sweep_contacts(world, of_contacts);
  WideContacts& wide = *world.wide;
  if (wide.manifolds.empty()) return sweep_joints(world, of_joints, [](std::uint32_t) {});
  with_lanes(wide, [&](auto& lanes, const auto& sweeps) {
    const auto run = everything(wide, lanes, wide.velocity.data());
    const auto kernel = [&](const auto& part) { of_contacts(sweeps, part); };
    sweep_joints(world, of_joints, [&](std::uint32_t colour) { over_colour(world.jobs, wide, colour, run, kernel); });
    after_colours(world.jobs, wide, run, kernel);
  });
}

/// Who is active: after the scene changed, or somebody fell asleep or woke.
void plan_joints(const World& world, Joints& joints);
/// Bodies that hang together by joints, for groups.
void link_joints(const World& world, const StepTime& time);
/// Part of pack(): colours of joints, which are then taken for contacts. Allocates.
void colour_joints(const World& world);
/// Lanes of this step, with what the last one's impulses left. After pack(). Allocates.
void begin_joints(const World& world, Real h);
/// A joint starts from no impulse.   @param link  index in active
void drop_impulses(WideJoints& w, std::uint32_t link);
// No energy from joints that are not resolved: energy_bound.h.
/// As a step begins, once joints are placed: bodies of groups with joints that nothing drives, and which of these are
/// not resolved. Allocates.
/// @param h  s, a substep
void find_bounded(const World& world, Real h);
/// Before a substep's solver: their motion.
void save_energies(const World& world);
/// After the impulses that sweeps start from: groups whose joints are not resolved start from nothing where those give
/// energy.
void refuse_start(const World& world);
/// After it, before the move and after it: no more energy than that, where joints are not resolved.
void bound_moves(const World& world, Velocities& to);
void bound_energies(const World& world, Velocities& to, Real h);
/// Half of the forces' kick off, before the solver; and back, after the move, with the omega that belongs to the
/// facing of then.
bool is_kicked(const WideJoints& w, std::uint32_t body);
void take_half_kicks(const World& world, Velocities& to);
void give_half_kicks(const World& world, Velocities& to);
/// What one joint, a pulley or a gear, has beside its rows, as a step begins.
void fill_transmission(const World& world, const Joint& joint, const JointEnds& ends, WideJoints& w, JointLanes& lanes,
                       int lane);
/// rad: how far a gear is off where the step has ended, which the last rows were made before if anything was put right.
Real phase_of(const World& world, const Joint& joint, const WideJoints& w, const JointLanes& lanes, std::uint32_t lane);
/// What drives and springs of one joint start a step with.
struct DriveStart {
  Real scale;  // of the impulses kept
  Real h;      // s, a substep
  bool again;  // half a substep's load comes before the move, half after
};
void fill_drives(const World& world, const Joint& joint, const DriveStart& start, WideJoints& w, JointLanes& lanes,
                 int lane);
/// What one joint has beside its rows whose axes are told one by one. Moves A's point and turns B's frame by what is locked at
/// an offset.
void fill_axes(const World& world, const Joint& joint, AxesLanes& to, JointLanes& lanes, int lane);
void keep_drives(const World& world, Joints& joints, Joint& joint, const WideJoints& w, const JointLanes& lanes,
                 std::uint32_t lane);
/// Impulses of bodies that left the finite world within the step may be anything.
bool has_sane_impulses(Joints& joints, Joint& joint);
void start_cold(Joints& joints, Joint& joint);
/// Rows of all joints at the present poses.
void place_joints(const World& world);
/// What a substep's sweeps start from, before the move; and after it, where velocities are taken from the state again
/// and rows are made anew for the poses of then: that wants load_shifts() before.
void bend_joints(const World& world, Real h);
void return_to_joints(const World& world);
/// A joint, whom it kept from touching, and the plan's being stale.
using Breaking = Writes<Joints, PairCounts, Revisions>;
/// Impulses, forces and errors back into the joints; who bears too much breaks, but in a pass, after which it is known.
void end_joints(const World& world, Breaking to, Events& events, const StepTime& time);
void break_overloaded(const World& world, Breaking to, Events& events);
/// It stays, and holds nothing any more.
void break_joint(Breaking to, std::uint32_t joint);

/// Where joints are led in a substep of h, from what a solver made of velocities: which of many turns a pose will stand
/// for. Before the move.
void aim_joints(const World& world, Real h);

}  // namespace carom::dynamics
