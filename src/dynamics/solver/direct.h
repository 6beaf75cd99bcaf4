// The direct solver: each contact group as one problem, solved to a residual.
#pragma once

#include <algorithm>

#include "dynamics/contact/contact.h"
#include "dynamics/joint/joint_lanes.h"
#include "dynamics/solver/contact_lanes.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/cone_problem.h"

namespace carom::dynamics {

/// Residual that a group is solved to, over velocity_tolerance. What is left of a body's weight adds up from step to
/// step: 1e-4 m/s would be 6 mm in a minute.
inline constexpr Real kDirectShare = 0.01;

/// Steps of as many substeps as the dial says that a step has, 16 at most: bounds of work are for one of these. An accuracy
/// that is asked for may take more substeps, and has its own bound.
inline std::uint64_t steps_worth(const World& world) {
  constexpr int kMostWorth = 16;
  const int usual = std::max(1, world.scene.dials.whole(Dial::substeps));
  return static_cast<std::uint64_t>(std::clamp(world.plan->substeps / usual, 1, kMostWorth));
}

/// Whether a step of Newton's method over a group costs little, whatever its bodies do.
inline bool is_few(const Contacts& c, std::size_t group) {
  const std::uint32_t joints = c.has_joints(group) ? c.group_link_begin[group + 1] - c.group_link_begin[group] : 0;
  return joints + c.group_size[group].pairs <= kFew;
}

/// Whether contacts of a group may yield in all substeps for half of what few may take.
/// @param work_of_step  block products, of Newton's method
bool yields_for_half(std::uint64_t work_of_step, int substeps);

/// What is known within a step of a group: how it was solved last, and whether it lies still.
struct GroupRest {
  ConeSolution solution;
  bool is_few = false;          // @see dynamics::is_few()
  bool in_lanes = false;        // its velocities are found there; here are its joints alone
  bool is_swept_again = false;  // in lanes, @see WideContacts::swept_again
  bool is_dear = false;         // joined: one factor with its loops is more than there is for a step
  bool is_first = true;         // substep
  std::uint32_t points = 0;     // of contacts in lanes
  std::uint32_t substeps = 0;   // that were solved in this step
  bool is_too_large = false;    // to be factored
  bool asks = false;            // for a solve, in this substep
  bool at_once = false;       // it takes its work in the first substep: at rest, or so large that a share would not do
  bool is_close = false;      // a solution of this step was, to what is right
  bool waits = false;         // for the next step with it; in lanes for the last substep
  bool stood = false;         // @see ConeProblem::stood
  Real load = 0;              // m/s, the fastest that loads alone make a body in a substep
  bool lies = false;          // all its contacts move less than anybody sees
  Real gap = 0;               // m or rad, of joints, before they were parted
  bool parts = false;         // it is parted once more
  bool has_parted = false;    // since joints were placed
  Real least = 0;             // separation, in tolerable depths
  Real goal = 0;              // m/s, residual that is good enough
  bool lasts = false;         // contacts were found at rest
  bool stands = false;        // and no body moves, to the bit
  bool is_unchanged = false;  // it stood so in the last step, and is asked the same: @see unchanged.h
  bool caught_up = false;     // no longer, after some substeps
  bool varies = false;        // a substep did not leave it as it was, or was not like the others
  std::uint64_t problem = 0;  // prints, @see unchanged.h
  std::uint64_t motion = 0;   // of the first substep
  Real residual = 0;          // m/s, of that substep
  bool has_moved = false;     // a little, since its separations were measured
  bool resists = false;       // some of them resist rolling or spinning
  std::uint32_t repeats = 0;  // substeps that repeated its impulses and are not added yet
  std::uint64_t work_of_step = 0;  // block products, of the dearest step of Newton's method
  bool is_bounded = false;         // in what it may take
  std::uint64_t share = 0;         // block products that it may take in this step, if so
  std::uint64_t work = 0;          // of them, those that it may still take
  bool is_far_off = false;         // what was found last came nowhere near the law
  bool gave_up = false;            // that did not do for a substep: nor will it for the next

  /// Whether its overlaps and joints are put right in this substep.
  bool parts_now() const { return !is_too_large && !(in_lanes && waits); }
};

/// What a group that stands was asked in the last step, and left as it was; by a slot of it. @see unchanged.h
struct StoodGroup {
  std::uint64_t problem = 0, motion = 0;
  Real residual = 0;          // m/s
  std::uint32_t repeats = 0;  // of its substeps, as GroupRest has them
};

/// The stages of the direct solver over the groups it solves, for it and for what chooses among solvers.
/// What lanes solve is here with its joints alone. Allocates.
/// @param h            s, substep
/// @param most_factor  block products of a factorisation; a group that takes more is solved by sweeps
void gather_groups(const World& world, SolverMemory& memory, Real h, std::uint64_t most_factor = ~std::uint64_t{0});
/// Velocities.
/// @param work      most block products that all groups may take in the step, for velocities and overlaps together,
///                  beyond two factorisations a substep for each that moves; 0: no bound
/// @param substeps  that share it, where a group moves. Where it lies still the first takes what it needs: one that is
///                  solved, which the others repeat, is worth more than all of them solved in part.
void solve_groups(const World& world, Velocities& to, StepReport& report, Real h, std::uint64_t work, int substeps);
/// Velocities that sweeps in lanes have found, led onto joints.
/// @param again  what was swept again, in the same substep
/// @return whether contacts of some, WideContacts::swept_again, are to be swept once more
bool hold_joints(const World& world, Velocities& to, Real h, bool again);
/// Overlaps.
void part_groups(const World& world, Poses& to, StepReport& report, Real h);
/// Velocities after the move, of groups that hang together by joints alone; places of all that have joints come first.
/// Rows are those of where the bodies are. Nothing to do where no group has joints.
void settle_joints(const World& world, Poses& poses, Velocities& motion, Real h);
/// What lanes have parted, led back onto joints.
void return_lanes_to_joints(const World& world, Poses& poses, Real h);
/// Stage function of the page: what a sweep has led elsewhere stays there, and what hangs on it by joints of the direct solver
/// is led back onto them. Velocities are left to the next substep.
void close_joints(const World& world, Poses& poses, const StepTime& time);
/// Impulses of the step, and separations, from plan.rotation.
void end_groups(const World& world);

/// What the direct solver keeps over a step.
struct DirectGroups {
  /// Of groups whose joints hold bodies to each other.
  struct Forest {
    explicit Forest(Memory* m) : joints(m), ordered(m), nodes(m), root(m), more(m) {}
    Array<TreeJoint> joints;    // by group
    Array<TreeJoint> ordered;   // what elimination is for
    Array<TreeNode> nodes;      // of groups that have any, by place
    Array<std::uint32_t> root;  // scratch of gather_links()
    Array<LinkMore> more;       // by coupling, as WideJoints::coupled
  };

  explicit DirectGroups(Memory* m)
      : contacts(m),
        links(m),
        link_row(m),
        row(m),
        begin(m),
        bodies(m),
        body(m),
        elimination(m),
        factor(m),
        scratch(m),
        rest(m),
        stood(m) {}

  struct Begin {
    std::uint32_t contact, body, link, edge;
    std::uint32_t forest, tree;  // in Forest::joints, in Forest::nodes
    std::uint32_t lock;          // in `links`: from there on rows of the forest's joints
  };
  /// Where a row of a joint stands in WideJoints.
  struct LinkRow {
    std::uint32_t row, lane;  // in rows, or in drives
    std::uint32_t joint;      // in joints
    bool is_drive;
    DriveKind kind;            // of a drive
    bool is_coupling = false;  // then `row` is in coupled
  };
  Array<ConeContact> contacts;  // by group, ascending rows
  Array<ConeLink> links;        // by group: rows of joints, those of its forest last
  Array<LinkRow> link_row;      // by link
  Array<std::uint32_t> row;     // by contact
  Array<Begin> begin;           // [groups + 1]
  Array<ConeBody> bodies;       // by group
  Array<std::uint32_t> body;    // by slot: in bodies; kInvalid: in no group
  Elimination elimination;
  BlockFactor factor;
  Array<Vec6> scratch;
  Array<GroupRest> rest;    // by group
  Array<StoodGroup> stood;  // by slot of a group's first body

  /// The body of a slot, new to the present group or not; kInvalid where impulses do not move it.
  std::uint32_t node(bool moves, std::uint32_t slot) {
    if (!moves) return kInvalid;
    if (body[slot] == kInvalid) {
      bodies.emplace_back().slot = slot;
      body[slot] = static_cast<std::uint32_t>(bodies.size()) - 1;
    }
    return body[slot];
  }

  /// Of the group that a row is in; null: another solver solves it.
  GroupRest* rest_of(const Row& at) {
    const std::uint32_t of = body[at.moves_a ? at.a : at.b];
    if (of == kInvalid) return nullptr;
    const auto after = std::ranges::upper_bound(begin, of, {}, [](const Begin& group) { return group.body; });
    return &rest[static_cast<std::size_t>(after - begin.begin()) - 1];
  }

  /// Block products that a step of Newton's method takes as long as, of a group.
  std::uint64_t newton_work(std::size_t group) const {
    return elimination.scratch().products[group] + kWorkOfContact * (begin[group + 1].contact - begin[group].contact);
  }

  std::span<const TreeJoint> forest_of(std::size_t group) const {
    if (!has_forest()) return {};
    return {forest_->joints.data() + begin[group].forest, begin[group + 1].forest - begin[group].forest};
  }
  bool has_forest() const { return forest_ != nullptr; }
  /// Made when first asked for: most worlds have no joints.
  Forest& forest() {
    if (!forest_) forest_ = make_owned<Forest>(links.get_allocator().resource(), links.get_allocator().resource());
    return *forest_;
  }

  /// Groups of the last step: as one begins, whichever solver it has.
  void forget();

  StoodGroup& stood_of(std::size_t group) { return stood[bodies[begin[group].body].slot]; }

  std::span<ConeBody> bodies_of(std::size_t group) {
    return {bodies.data() + begin[group].body, begin[group + 1].body - begin[group].body};
  }
  /// Of contacts, as WideContacts has them.
  std::span<const std::uint32_t> rows_of(std::size_t group) const {
    return {row.data() + begin[group].contact, begin[group + 1].contact - begin[group].contact};
  }

  bool is_few(std::size_t group) const { return rest[group].is_few; }
  /// Whether all substeps may yield for half of the work that few have: then the exact law is tried in each of them, and
  /// where that does not end contacts yield.
  bool may_yield(std::size_t group, int substeps) const;
  bool is_joined(std::size_t group) const { return begin[group].link < begin[group + 1].link; }
  std::size_t groups() const { return begin.empty() ? 0 : begin.size() - 1; }
  std::span<TreeNode> nodes_of(const Begin& from, const Begin& to) {
    if (from.tree == to.tree) return {};
    return {forest_->nodes.data() + from.tree, to.tree - from.tree};
  }
  ConeProblem problem(std::size_t group) {
    const Begin &from = begin[group], &to = begin[group + 1];
    return {{contacts.data() + from.contact, to.contact - from.contact},
            bodies.data(),
            from.body,
            to.body,
            &elimination,
            links.empty() ? nullptr : elimination.scratch().node_at.data(),
            &factor,
            scratch.data(),
            0,
            0,
            {links.data() + from.link, from.lock - from.link},
            {links.data() + from.lock, to.link - from.lock},
            nodes_of(from, to)};
  }

 private:
  Owned<Forest> forest_;
};

}  // namespace carom::dynamics
