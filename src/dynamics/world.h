// A world: scene, state, and what steps keep. The ABI calls these functions with validated arguments; they do not fail
// except by throwing std::bad_alloc before anything has changed.
#pragma once

#include <array>

#include "collision/broad/broad_phase.h"
#include "collision/narrow/narrow_phase.h"
#include "core/jobs.h"
#include "dynamics/contact/old_impulses.h"
#include "dynamics/joint/joint.h"
#include "dynamics/particles/particles.h"
#include "dynamics/scene.h"
#include "dynamics/snapshot/structure_cache.h"
#include "dynamics/state.h"

namespace carom::dynamics {

/// Stages as a host sees them, in the order of CAROM_STAGE_*.
enum class Stage : std::uint32_t { refresh, broad, narrow, group, integrate, solve, relax, observe, count };
inline constexpr std::size_t kStageCount = static_cast<std::size_t>(Stage::count);
const char* stage_name(Stage stage);

/// Times, counts and residuals of one step; fields as carom_step_report.
struct StepReport {
  std::array<double, kStageCount> stage_seconds{};
  double total_seconds = 0;
  std::uint64_t steps = 0;
  double time = 0;
  std::uint64_t bodies = 0, dynamic_bodies = 0, colliders = 0;
  std::uint64_t broad_pairs = 0, contact_pairs = 0, contact_points = 0, groups = 0, largest_group = 0;
  NarrowReport narrow;
  std::uint64_t velocity_impulses = 0, position_moves = 0;
  std::uint64_t quarantined_bodies = 0, faults = 0;
  std::uint64_t asleep_bodies = 0, fell_asleep = 0, woke_up = 0;
  double max_penetration = 0, mean_penetration = 0, max_closing_speed = 0;
  double linear_energy = 0, angular_energy = 0;
  std::uint64_t particles = 0, quarantined_particles = 0;
  std::uint64_t direct_groups = 0;  // of the groups, those that a solver which chooses gave to the direct solver
  double solver_residual = 0;       // m/s; of solvers that solve to one
  std::uint64_t swept_bodies = 0, sweep_hits = 0;
  std::uint64_t wedged_groups = 0, rejected_solutions = 0;  // of groups and substeps: @see solver/direct/yielding.h
  double excess_energy = 0;                                 // J, of groups and substeps: @see solver/direct/yielding.h
};

/// A contact point as a host reads it after the step.
/// A fault of the last step: a support function's, or of the state of a body or particles (then support.kind is none).
struct FaultView {
  SupportFault support{};
  std::uint32_t body = kInvalid;       // slot of a body it concerns
  std::uint32_t particles = kInvalid;  // slot of the set
  std::uint32_t particle = 0;          // the first of it that was put in quarantine in this step
};

/// Why a solver that chooses solves a contact group as it does; as CAROM_REASON_*.
enum class GroupReason : std::uint32_t { ordinary, mass_ratio, sink, too_much, impact, few };

/// A contact group of a step as a host reads it.
struct GroupView {
  std::uint32_t body = 0;  // slot, one of its bodies
  std::uint32_t bodies = 0, points = 0;
  bool direct = false;
  GroupReason reason = GroupReason::ordinary;
  Real mass_ratio = 1;  // most, of two that touch
  Real sink = 0;        // most that soft contacts let a point sink under what it bore in the last step, over the
                        // thickness of the thinner of the two that touch there
};

using FaultViews = Array<FaultView>;
using GroupViews = Array<GroupView>;
using BroadPhases = std::array<Owned<BroadPhase>, 4>;  // by CAROM_BROAD_*, made when first used

struct Plan;         // dynamics/effects.h: which effects have participants
struct Continuous;   // dynamics/ccd/continuous.h: who is swept, and what that met
struct ContactView;  // dynamics/contact_views.h: contacts as a host sees them
class ContactViews;
struct Contacts;      // dynamics/contact/contact.h: rows of the solver, scratch kept between steps
struct Events;        // dynamics/events/events.h: what happened, for who asked
class QueryIndex;     // dynamics/query/index.h: where colliders are, for questions between steps
struct DirectGroups;  // dynamics/solver/direct.h: contact groups as problems of their own
struct Ledger;        // dynamics/ledger/ledger.h: where energy and momentum go, for who asked
struct MeanMotion;    // dynamics/contact/mean_motion.h: which velocity moves what slides and rolls
struct Sleep;         // dynamics/sleep/sleep.h: who sleeps, and what is kept of them
struct WideContacts;  // dynamics/solver/wide_contacts.h: the same rows in lanes
class JointMoves;     // dynamics/joint/tree/joint_moves.h: what a host asks of joints, and where bodies go
struct WideJoints;    // dynamics/joint/wide_joints.h: joints in lanes
struct Accuracy;      // dynamics/accuracy/accuracy.h: islands whose substeps follow from their errors
struct LoneRollers;   // dynamics/contact/lone_rollers.h: bodies that touch flat surfaces and nothing else
struct Rattle;        // dynamics/joint/rattle/rattle.h: islands that joints alone hold

/// Const, it is what a stage reads: what stands in it by value or as Kept does not change, and who writes a part of it
/// is given that part by itself (dynamics/part.h). What hangs on an Owned is made anew in each step (the plan, rows,
/// lanes) or stands beside it (the ledger, what is kept for readers): that may be written all the same.
class World {
 public:
  World(std::uint32_t tag, const Vec3& gravity, std::size_t body_capacity, Memory* memory);
  ~World();
  World(const World&) = delete;
  World& operator=(const World&) = delete;

  // ---- editing (between steps). Slots are valid; the caller resolved handles. ----
  Handle add_body(const BodyDef& def);   // 0: all slots taken
  void remove_body(std::uint32_t body);  // its colliders and joints too
  Handle add_collider(std::uint32_t body, const Shape* shape, const Pose& local, Real density, std::uint32_t material,
                      const ColliderSettings& settings = {});
  void remove_collider(std::uint32_t collider);
  Handle add_material(const Material& m);
  void set_material(std::uint32_t material, const Material& m);
  void remove_material(std::uint32_t material);
  void set_material_pair(const MaterialPair& pair);
  void remove_material_pair(std::uint32_t a, std::uint32_t b);
  void set_mass(std::uint32_t body, const MassGiven& given);  // of a dynamic one
  void set_damping(std::uint32_t body, Real linear, Real angular);
  void set_type(std::uint32_t body, BodyType type);  // its joints and shapes bear it
  void set_collider_material(std::uint32_t collider, std::uint32_t material);
  void set_density(std::uint32_t collider, Real density);
  void set_local_pose(std::uint32_t collider, const Pose& local);
  void set_filter(std::uint32_t collider, const Filter& filter);
  void set_body_filter(std::uint32_t body, const Filter& filter);  // of all colliders that it has now
  void set_sensor(std::uint32_t collider, bool sensor);
  void set_surface_velocity(std::uint32_t collider, const SurfaceVelocity& surface);
  void set_attribute(std::uint32_t body, AttributeId id, const AttributeValue& value);  // one that it may have
  void reserve_another(AttributeId id);  // so that the next body may have any value of it without more memory
  void ignore_collision(std::uint32_t body_a, std::uint32_t body_b);  // counted: undo each call
  void restore_collision(std::uint32_t body_a, std::uint32_t body_b);
  void set_transmission(std::uint32_t slot, const Transmission& transmission);
  Handle add_joint(const JointDef& def);  // its bodies are two, or one and the world
  /// The coordinate of one joint follows that of another. Both are alive, each a hinge or a slider, and not the same.
  Handle add_coupling(const Coupling& coupling, std::uint64_t user);
  void set_polynomial(std::uint32_t joint, const std::array<Real, Coupling::kTerms>& polynomial);
  /// Between which bodies a coupling is listed; and its data into a joint that is new, within capacity.
  JointDef coupling_def(const Coupling& coupling) const;
  void fill_coupling(std::uint32_t joint, const Coupling& coupling);
  void remove_joint(std::uint32_t joint);
  void set_joint_drive(std::uint32_t joint, Coordinate coordinate, const JointDrive& drive);
  void set_joint_axis(std::uint32_t joint, std::uint32_t axis, const JointAxis& to);  // of a six-axis joint
  void set_joint_turn(std::uint32_t joint, const TurnDrive& to);                      // of a ball or a six-axis joint
  void break_joint(std::uint32_t joint);  // it stays, and holds nothing any more
  void set_wind(const Vec3& wind);
  void set_water(const WaterDef* water);  // null: none
  Handle add_field(const FieldDef& def);
  void set_field(std::uint32_t field, const FieldDef& def);
  void remove_field(std::uint32_t field);
  Handle add_spring(const SpringDef& def);  // its bodies are two, or one and the world
  void set_spring(std::uint32_t spring, Real rest, Real stiffness, Real damping);
  void remove_spring(std::uint32_t spring);
  void set_mode(std::size_t row, EffectMode mode);  // of an effect, for all bodies
  void set_body_mode(std::uint32_t body, std::size_t row, EffectMode mode);
  void set_dial(Dial dial, Real value);
  void set_gravity(const Vec3& g);

  // ---- what the above do to a slot that is taken, its arrays large enough: for snapshots, which bring slots along ----
  void fill_body(std::uint32_t slot, const BodyDef& def);
  void fill_collider(std::uint32_t slot, std::uint32_t body, const Shape* shape, const Pose& local, Real density,
                     std::uint32_t material);  // the body's mass is not yet that
  void settle_mass(std::uint32_t body);
  void keep_axes(std::uint32_t slot, bool any);              // properties of a hinge's or slider's axis, or none
  void move_joints(const JointMoves& moves);                 // found, @see tree/joint_moves.h
  void fill_joint(std::uint32_t slot, const JointDef& def);  // not yet in the lists of its bodies
  void fill_spring(std::uint32_t slot, const SpringDef& def);

  Pose pose(std::uint32_t body) const;  // body frame -> world
  void set_pose(std::uint32_t body, const Pose& pose);
  void set_velocity(std::uint32_t body, const Vec3& linear, const Vec3& angular);
  // False, and nothing is changed, where the sum is beyond what a number holds.
  bool add_impulse(std::uint32_t body, const Vec3& impulse, const Vec3& point);
  bool add_force(std::uint32_t body, const Vec3& force, const Vec3& torque);  // for the next step, about the centre
  void set_force(std::uint32_t body, const Vec3& force, const Vec3& torque);  // replaces what is pending

  void wake_body(std::uint32_t body);  // and its island
  bool asleep(std::uint32_t body) const;
  void set_continuous(std::uint32_t body, SweepMode mode);
  void set_enabled(std::uint32_t body, bool enabled);
  void keep_ledger(bool on);  // anew, from the present state on; or not any more

  // ---- stepping: src/dynamics/stages.cpp ----
  void step(Real dt);
  /// After a step that a callback did not let come to its end, by ending the thread or by an exception. Bodies are where
  /// it left them, the next step finds all pairs anew, and all bodies are awake. Allocates nothing.
  void abandon_step();

  // ---- reading ----
  std::uint64_t hash() const;
  /// Contacts of the last step, ascending by collider pair; any number of readers at a time.
  const Array<ContactView>& contact_views() const;

  Scene scene;
  State state;
  Particles particles;
  Joints joints;
  StepReport report;
  Owned<ContactViews> views;
  GroupViews group_views;  // of the last step, of a solver that chooses
  FaultViews fault_views;  // of the last step

  // ---- what stages keep between steps ----
  PairTable pairs;
  Impulses impulses;
  BroadPhases broad;
  Owned<Plan> plan;
  Owned<Contacts> contacts;
  Owned<MeanMotion> mean_motion;    // null until there are rows
  Owned<LoneRollers> lone_rollers;  // null until there are two colliders
  Owned<WideContacts> wide;
  Owned<WideJoints> wide_joints;
  Owned<Rattle> rattle;      // null until rattle::is_asked()
  Owned<Accuracy> accuracy;  // null where no accuracy is asked for
  Owned<DirectGroups> direct;
  Kept<Sleep> sleep;
  Kept<Events> events;
  Owned<Continuous> continuous;
  Owned<Ledger> ledger;       // null: no host asked for it
  StructureCache structure;   // likewise by readers
  Owned<QueryIndex> queries;  // brought up to date by readers, who see to it that one does so at a time
  Memory* memory;
  bool times_effects = false;  // a host wants to know how long each effect takes
#ifdef NDEBUG
  bool watches_stages = false;  // slow: each writes only what it declares, or the program ends, @see stages.h
#else
  bool watches_stages = true;
#endif
  Jobs* jobs = nullptr;  // who shares a step's loops; null: none
};

}  // namespace carom::dynamics
