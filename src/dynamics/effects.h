// The plan of a step: which effects have participants, who they are, and what they did.
#pragma once

#include <array>
#include <bit>

#include "dynamics/integrate/rotation/principal.h"
#include "dynamics/part.h"
#include "dynamics/participants.h"

namespace carom::dynamics {

/// Where forces are evaluated: the state itself, or an intermediate one of RK4. By body slot.
struct Motion {
  const Vec3* x;      // m, world, centre of mass
  const Quat* q;      // unit, body -> world, of bodies that rotate: the others keep State::q
  const Vec3* v;      // m/s, world
  const Vec3* omega;  // rad/s, world
};

/// Where accelerations go: target += scale * acceleration. By body slot.
struct Accelerate {
  Real scale;      // h for a kick of the velocities, 1 for a derivative
  Vec3* v;         // m/s or m/s^2, world
  Vec3* omega;     // rad/s or rad/s^2, world
  Real share = 1;  // of what is added here, that goes into the velocities: 1 for a kick, s for a derivative
};

/// A row's work. Exactly one of the two is set in a planned row.
using ForceFn = void (*)(const Scene&, const State&, const Participants&, const Motion& at, const Accelerate& out);
using FlowFn = void (*)(const Scene&, const Participants&, Real h, const Quat* q, Vec3* v, Vec3* omega);

/// What the participants of a row are.
enum class ParticipantKind : std::uint8_t {
  bodies,
  colliders,
  contact_points,
  contact_pairs,
  springs,
  joints,
  particles,
  hosts
};

/// A row of the table.
struct Effect {
  EffectId id{};
  const char* name = nullptr;
  Stage stage{};
  ParticipantKind participants{};
  // Who may be a participant, from what a host changes; null: a stage counts them, @see count_participants()
  void (*find)(const Scene&, const State&, Participants&) = nullptr;
  bool (*wakes)(const Scene&, const State&,
                std::uint32_t slot) = nullptr;  // or: is this one a participant in this step?
  ForceFn force = nullptr;                      // null: served by its stage, not by the integrator
  FlowFn flow = nullptr;                        // null: there is no closed form
  Real (*rate)(const Scene&, const State&, std::uint32_t body) = nullptr;  // 1/s, of decay; null: none decays
  bool reads_velocities = false;  // of a force without a flow: it is given those that no force has changed yet
  void (*everyone)(const Scene&, const State&, Participants&) = nullptr;  // whom it can be forced on; null: on none
  const char* called_by = nullptr;                                        // what participants are: "bodies with ..."
  const char* missing = nullptr;                                          // what a scene without any lacks
};

/// What does the work of a planned row.
enum class Served : std::uint8_t { force, flow, stage };  // effect->force, effect->flow, or neither of them

/// Participants by how fast they decay: too fast for a force, so that the flow serves them; and the others.
struct Decays {
  explicit Decays(Memory* m) : stiff(m), gentle(m) {}
  Participants stiff, gentle;
};

/// A row with its participants.
struct PlannedEffect {
  PlannedEffect(const Effect* e, Memory* m) : effect(e), candidates(m), participants(m) {}
  const Effect* effect;
  Participants candidates;    // of the scene
  Participants participants;  // of this step: the candidates that wake
  Decays* decays = nullptr;   // the plan's; where some of them decay too fast for a force; null until somebody did
  /// Whom the force and the flow serve of a row that has both.
  const Participants& forced() const { return decays && decays->stiff.count > 0 ? decays->gentle : participants; }
  bool has_stiff() const { return decays && decays->stiff.count > 0; }
  Owned<Participants> calling;  // where it is forced on some: the candidates that would be without that; else null
  bool is_forced = false;
  Served served = Served::stage;
  std::uint32_t wanted = 0;       // candidates of the scene, whatever a host forbids or forces
  std::uint64_t evaluations = 0;  // participants served since the world was made
  double seconds = 0;             // of this step, as far as it has a stage of its own, @see World::times_effects
};

struct StepTime {
  Real dt, h;  // s: step, substep
};

/// Poses that an integrator proposes for bodies which no contact touches. By body slot.
struct PredictedPose {
  explicit PredictedPose(Memory* m) : x(m), q(m), omega(m) {}
  Array<Vec3> x;
  Array<Quat> q;
  Array<Vec3> omega;  // rad/s, world: what a rotation method turned the body by, where plan.turns_by_method
};

struct LedBody;          // dynamics/integrate/driven.h
struct FreeFlight;       // dynamics/integrate/free_flight.h: who takes the step in one go
struct Integrator;       // dynamics/integrate/integrator.h
struct Rotation;         // dynamics/integrate/rotation/rotation.h
struct Solver;           // dynamics/solver/solver.h
struct SceneryContacts;  // dynamics/scenery.h

struct Plan {
  explicit Plan(Memory* m);
  ~Plan();

  std::uint64_t revision = 0;      // of the scene this plan was made for
  std::uint64_t restored = 0;      // revision of a scene that is as it was when pairs were last asked, @see snapshot/
  Array<PlannedEffect> effects;    // every row of the table, in its order; idle rows have no participants
  RowBits acting = 0;              // forces and flows that anybody may be a participant of; most are not
  Participants linear, rotating;   // dynamic bodies that move: without and with rotation
  Participants kinematic;          // moved by their velocity
  Participants solid;              // dynamic bodies that have a collider
  Participants oriented;           // those that rotate and have a collider or a joint
  Array<std::uint32_t> colliders;  // active colliders whose body can move
  Array<Frame> local;              // by collider: shape -> body axes, about the centre of mass
  std::array<bool, kStageCount> runs{};  // stages that have participants
  int substeps = 1;                      // of the world, whoever is in it
  bool in_pass = false;                  // they go by island: the plan has some of them, @see accuracy/passes.h
  bool idle = false;                     // nothing needs them in this step: they are left out
  bool reads_velocities = false;         // some force does: it is given a copy, which forces before it have not changed
  bool watches_speed = false;            // what moves far for its size is swept
  bool host_wrote = false;               // to the state, before this step
  const Integrator* integrator = nullptr;
  const Rotation* rotation_method = nullptr;  // null: the gyroscopic effect is a force, a flow, or absent
  Array<Principal> principal;                 // by body, participants of the rotation method
  Array<std::uint8_t> turns_by_method;        // by body: the rotation method turns it in this step
  const Solver* solver = nullptr;
  PredictedPose predicted;
  std::array<Owned<Decays>, 3> decays;  // of the rows that decay: linear and angular damping, drag
  Owned<FreeFlight> flight;             // null: no body has flown beside others yet
  Array<LedBody> led;                   // kinematic bodies whose velocity changes within the step
  Array<DrivenMemory> driven;           // scratch
  struct Begun {
    Vec3 v, omega;  // m/s, rad/s, world: before the forces of the substep
  };
  Array<Begun> begun;                // by body, of those that somebody asks for, @see begin_substep()
  Array<std::uint8_t> touched;       // by body: a solver changed its velocity in this substep
  Array<Mat3> rotation;              // by body: body -> world, at the start of the step
  Participants sprung;               // bodies that springs act on in this step
  Participants readers;              // bodies whose velocity some force reads, in this step
  Array<std::uint32_t> reader_list;  // scratch
  Array<Vec3> read_v, read_omega;    // by body: that copy, of readers
  Array<Vec3> scratch_vectors;       // of the integrator
  Array<Quat> scratch_rotations;
  Array<const Shape*> faulty;      // shapes in quarantine in this world
  Array<SupportFault> faults;      // of this step
  Array<Pair> pairs;               // of this step
  Owned<SceneryContacts> scenery;  // null until there is some

  PlannedEffect* find(const char* name);  // null: no such row
};

/// f(row), of those that act.
template <class F>
void each_acting(Plan& plan, F&& f) {
  for (RowBits left = plan.acting; left != 0; left &= left - 1)
    f(plan.effects[static_cast<std::size_t>(std::countr_zero(left))]);
}

/// The table, in the order in which effects act within a kick: those that read velocities first.
const std::array<Effect, kEffectCount>& effect_table();

/// For effects whose participants a stage makes or counts: how many there are in this step.
void count_participants(const World& world, EffectId id, std::uint64_t count);

/// A row's candidates: who the scene calls for, but for whom a host forbids it, with whom it forces it on.
void find_candidates(const World& world, PlannedEffect& row);

/// Whether an effect is what a host asked for, for one step.
bool from_host(const Effect& effect);

/// Who sleeps; and what comes and goes with them: boxes, joints that act, records of pairs, impulses.
using Sleepers = Writes<SleepFlags, Sleep>;
using Settling = Writes<SleepFlags, Sleep, Colliders, PlacedPoses, Joints, PairTable, Impulses, Revisions>;
/// Stage refresh: bring the plan up to date, then frames and bounds of what moves.
void refresh(const World& world, Settling to, SpringLoads& springs, Floats& floats, const StepTime& time);
// Parts of it that others need too: which stages have participants; participants of this step; one collider's frame and
// bounds.
void plan_stages(const World& world, Plan& plan);
void find_participants(const World& world, Real h);
/// Who decays too fast for a force, in substeps of h.
void part_stiff(const World& world, Real h);
void place_collider(const World& world, Colliders& c, PlacedPoses& placed, Plan& plan, std::uint32_t slot, Real dt);
/// m, the farthest point of a body's colliders from its centre.
Real radius_of_body(const World& world, std::uint32_t body);

/// All planned forces at one state. Each is a function of that state: none sees what another did to the velocities.
void evaluate_forces(const World& world, const Motion& at, const Accelerate& out);
/// Velocities for a second evaluation, h later: those that the first one read, and twice what it changed since, as if
/// it went on like that. Where no force reads velocities, the world's own.
/// @return  x and q as given
Motion extrapolated(const World& world, const Vec3* x, const Quat* q);
/// All planned flows over h, on the world's velocities.
/// @param q  by body slot: orientations during h
void evaluate_flows(const World& world, Velocities& to, Real h, const Quat* q);

}  // namespace carom::dynamics
