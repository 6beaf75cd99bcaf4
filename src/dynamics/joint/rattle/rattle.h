// Islands that joints alone hold, moved by RATTLE. How and why: README.md in this folder.
//
// A step is tried to the side before its solver is laid out (try_rattle()): from the state, in arrays of its own. What
// went well is hidden from the rest of the step, and takes its place as the step ends (take_rattle()); what did not (a
// limit, joints that can't be) has changed nothing, and is solved as without the dial.
#pragma once

#include "core/constant.h"
#include "dynamics/accuracy/measure.h"
#include "dynamics/effects.h"
#include "dynamics/force/trial.h"
#include "dynamics/joint/joint_lanes.h"
#include "dynamics/joint/turns.h"
#include "dynamics/joint/wide_joints.h"
#include "dynamics/plan_lists.h"
#include "dynamics/solver/direct/elimination.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kRattleGap{
    "rattle_gap", 1e-3, "m or rad",
    "by which joints may be off as a step begins for their island to be moved by RATTLE, which shuts them at once",
    "larger: what the solver has torn apart is put together with a jerk; smaller: islands come back later"};
inline constexpr Constant<Real> kRattleRest{
    "rattle_rest", 1e-11, "1",
    "of a row's own response, below which what other rows leave of it is taken to be implied by them: an angle of 3e-6",
    "larger: joints that almost lock each other are left open; smaller: rounding counts as a lock"};
inline constexpr Constant<int> kRattleRounds{
    "rattle_rounds", 40, "1", "of Newton's method a stage may take before its island is left to the solver",
    "larger: steps that are too long are finished; smaller: long chains are left to the solver"};
inline constexpr Constant<std::uint64_t> kRattleWork{
    "rattle_work", 100, "block products a joint",
    "that a factorisation may take before an island is left to the solver, where order 4 or 6 or an accuracy is asked "
    "for: "
    "chains and trees take 3",
    "larger: a net of 30 by 30 takes seconds in a step; smaller: loops that are small are left to the solver, too"};
inline constexpr Constant<std::uint64_t> kRattleWorkOfFew{
    "rattle_work_of_few", 20000, "block products",
    "that a factorisation may take in any case, where order 4 or 6 or an accuracy is asked for: a star of 30 joints on "
    "one "
    "body takes 5,000",
    "larger: stars of hundreds of joints take milliseconds; smaller: they are left to the solver"};
inline constexpr Constant<std::uint64_t> kRattleLessAtOrder2{
    "rattle_less_at_order_2", 8, "1",
    "times less work may a factorisation take at order 2, which is to cost no more than the solver",
    "smaller: nets take many times as long as by the solver; larger: rings and stars of 20 joints are left to it"};
inline constexpr Constant<Real> kRattleSwing{
    "rattle_swing", 1.2, "rad",
    "by which the forces of joints may swing a body in a stage before its island takes twice as many: steps that are "
    "explicit in directions hold up to 2, and loads grow within a step",
    "larger: long chains gain energy; smaller: they take more stages than they need"};
inline constexpr Constant<Real> kRattleGain{
    "rattle_gain", 0.003, "1",
    "share of an island's kinetic energy that impulses of its joints may add to it in a step before it takes twice as "
    "many: "
    "joints do no work, but turns of half a radian a stage err by as much, and so do false roots of Newton's method",
    "larger: what spins fast gains energy; smaller: it takes more stages than it need"};
inline constexpr Constant<int> kRattleHalvings{
    "rattle_halvings", 4, "1", "of a substep that an island may take in any case before it is left to the solver",
    "larger: chains of thousands of links take 100 ms a step; smaller: they gape"};
inline constexpr Constant<std::uint64_t> kRattleParts{
    "rattle_parts", 10000, "1",
    "joints times parts of a step up to which an island may take further halvings: some 6 ms",
    "larger: a step in which a whip cracks stalls; smaller: the solver takes it over, and takes its energy"};
inline constexpr int kMostHalvings = 10;
inline constexpr ConstantRow kRattleConstants[] = {kRattleGap,       kRattleRest,         kRattleRounds, kRattleWork,
                                                   kRattleWorkOfFew, kRattleLessAtOrder2, kRattleSwing,  kRattleGain,
                                                   kRattleHalvings,  kRattleParts};

/// Two joints on one body: a block of the matrix beside its diagonal.
struct RattlePair {
  std::uint32_t high, low;  // joints, by when they are eliminated
  std::uint32_t at;         // in Elimination::rows
  std::uint32_t body;
  bool is_a_of_high, is_a_of_low;
  std::uint8_t end_of_high, end_of_low;  // of a coupling: which of its bodies
};

struct RattleBody {
  std::uint32_t slot = kInvalid;
  Real inv_mass = 0;     // 1/kg; 0: impulses do not move it
  bool turns = false;    // they turn it
  Locks locks = 0;       // axes along which, or about which, it does not move: of turns none, two or all
  bool travels = false;  // it is kinematic, and under way
  Principal top;
  Mat3 inertia = Mat3::zero(), inv_inertia = Mat3::zero();  // body axes
  // Where it is; inv_world: 1/(kg m^2), world; l: kg m^2/s, world, about the centre
  Vec3 x = Vec3::zero(), v = Vec3::zero(), omega = Vec3::zero(), l = Vec3::zero();
  Quat q = Quat::identity();
  Mat3 r = Mat3::identity(), inv_world = Mat3::zero();
  Vec3 driven_p = Vec3::zero(), driven_l = Vec3::zero();  // N s, N m s: of drives of joints, since the step began
  // where a stage may lead; kick and twist: what impulses do on the way
  Real swing = 0;  // 1/s^2: of what joints pull, scratch
  Vec3 x1 = Vec3::zero(), v1 = Vec3::zero(), l1 = Vec3::zero();
  Quat q1 = Quat::identity();
  Mat3 r1 = Mat3::identity();
};

/// A row of a joint: u = d.(v_b - v_a) + w_b.omega_b - w_a.omega_a is the rate of its error.
struct RattleRow {
  Vec3 d, w_a, w_b;  // world
  Vec3 i_a, i_b;     // w over the inertias
  Real p;            // N s or N m s, of half a stage
  Real load;         // N or N m: the last such over its time
};

/// A motor, a spring, a limit or the friction of a joint, along one of its coordinates:
///   f = effort - k (x - target) - c (u - speed), within bounds
/// A motor and friction have no end of c, a limit none of k: while they bear what that asks of them they are rows.
struct RattleDrive {
  enum class Law : std::uint8_t { pull, motor, limit };
  enum class By : std::uint8_t { nothing, force, soft_row, row };
  DriveRow row;
  Law law;
  By by;              // in this step
  bool per_mass;      // k and c are told for each kg, or kg m^2, that the coordinate has
  Real k, c, effort;  // N/m, N s/m, N; likewise of turns
  Real lower, upper;  // m or rad: between them k does nothing
  Real speed;         // m/s or rad/s
  Real most;          // N or N m
  Real stiffest;      // 1/s^2, at most
  Real goal;          // m or rad: of a row, where it is to be as a stage ends; of a spring how far it is off
  Real damping;       // N s/m, as it acts
  Real load;          // N or N m: what it did last
  Real led;           // N or N m: of a row, what it bore on the way of a stage
  bool gave_way;      // it was a row of this part of the step, and can't be
  int way;            // of a motor that is a force; of a limit that was just met: 1 the lower, -1 the upper end
  Real before[2];     // how far it was from where that ends as a substep began; of a limit from both ends
  Vec3 d, w_a, w_b;   // along which it does that, as of a row
};

struct RattleJoint {
  std::uint32_t slot, a, b;        // a joint; bodies of this module
  std::uint32_t row, rows;         // its rows: first, how many: of its locks, then of its drives in this step
  std::uint32_t soft_rows;         // behind them: of dampers, of a stage's end alone
  std::uint32_t locks, most_rows;  // rows of its locks; that there are at most
  std::uint32_t drive, drives;     // in Rattle::drives
  std::uint32_t parts;
  JointPart part[kMostParts];
  SwingPlane plane;  // how its swing is told
  bool is_counted;   // something looks at its angles
  Real twist;        // rad: where it is locked, beside one swing
  bool two_ways;     // a pulley: its rows act along d at B, along d_a at A
  bool is_gear;
  std::uint32_t coupling;  // in Rattle::couplings, from 1; 0: it is none
  Transmission over;       // of both; the phase of a gear as a stage begins
  Vec3 d_a;
  Real length;            // m, of a rod
  Real swing_a, swing_b;  // 1/(kg m): of a newton, how fast it swings the bodies, squared
  Vec3 arm_a, arm_b;      // m, body axes, from the centres of mass
  Quat frame_a, frame_b;  // joint -> body
  Mat3 axes_a, axes_b;    // the same
  Vec3 r_b;               // m, world: where its torque is told
  Vec3 turned;            // rad, as Joint::turned, where it has a limit or a spring
  Vec3 force, torque;     // N s, N m s, world, on B, about its point: since the step began
};

/// What a coupling has beside: its row acts on up to four bodies, u = sum of d.v + w.omega.
struct RattleCoupling {
  static constexpr std::size_t kMostBodies = 4;
  std::uint32_t follower, leader;  // joints of this module
  std::uint32_t count, body[kMostBodies];
  struct End {
    Vec3 d, w, i;  // world; i: w over the inertia
  };
  End now[kMostBodies], ahead[kMostBodies];  // where bodies are, and where the stage may lead
};

struct RattleIsland {
  std::uint32_t body, bodies, movers;  // first, how many; the first so many are moved
  std::uint32_t joint, joints;
  std::uint32_t pair, pairs;
  int block, least_block;        // rows that a joint has in the matrix in this step; of locks alone
  std::size_t diagonal, beside;  // of the matrix, where it begins
  Real reach;                    // m: the longest arm
  Real rounding;                 // m or rad, of errors, in this step
  Real energy, gain;  // J, of motion as a stage began; what impulses of locks added to it since the step began
  Real stage;         // s, that goes on
  Real kicked;        // J, at a stage's end before its last impulses
  bool is_held;       // its joints can be held so at all
  bool is_met;        // something touches it in this step, or may
  int halvings, most_halvings;  // of the substeps that it takes in this step; that it may
  bool was_tried, is_moving;    // in this try
  bool was_well;                // scratch: it went well before others are tried again
  bool went_well;               // in this step
  bool is_barred;               // a limit is met in this step, or a gap is too wide
  bool is_decided, is_changed;  // which drives are rows in this step; that is to be another
  Real event;                   // of a part of the step: where a motor reaches its speed or a limit is met; 0: nowhere
  std::uint32_t event_drive;    // whose: in Rattle::drives; twice that, of an upper limit and 1
  Real late;                    // of a part that ends there: how much later it really is
  bool goes_on, takes_events;   // it is a later part of a step; whether it is to be told of such
  bool is_new;                  // no stage of the part has gone yet
  bool has_drives;              // joints of it do more than lock
  bool has_soft_rows;
  bool is_stiff;          // its dampers ask for stages that go on alone
  int finer;              // by how many times as many
  int work;               // stages of this step that were done again for what drives do
  bool is_first, agrees;  // try of a stage's end; velocities that forces read are those that they lead to
  bool gave_up;           // nothing but its motion keeps it from being moved so in this step
};

struct Rattle {
  explicit Rattle(Memory* m);

  // of the scene: made where it, or who is awake, has changed
  std::uint64_t revision = 0;
  int order = 0;                    // for which they were made
  Array<std::uint32_t> all_active;  // joints, as WideJoints::active then
  Array<std::uint32_t> island_of;   // by body slot; kInvalid: none
  Array<std::uint32_t> parent;      // scratch: union-find by slot
  Array<std::uint32_t> body_of;     // by slot, in bodies: scratch
  Array<RattleIsland> islands;
  Array<RattleBody> bodies;   // by island; the first is the world
  Array<RattleJoint> joints;  // by island
  Array<RattleRow> rows;      // by joint
  Array<RattleCoupling> couplings;
  Array<RattleDrive> drives;  // by joint
  Array<RattlePair> pairs;
  Array<std::uint32_t> by_slot;  // islands' bodies that are moved, ascending by slot
  Elimination elimination;       // nodes are joints
  Array<Edge> edges;             // scratch
  struct Seat {
    std::uint32_t body, joint;
    bool is_a;
    std::uint8_t end = 0;  // of a coupling
    bool operator<(const Seat& o) const { return body != o.body ? body < o.body : joint < o.joint; }
  };
  Array<Seat> seats;  // scratch
  // of the matrices, block by block
  Array<Real> diagonal, below, above;
  Array<Real> left, right;  // by joint, kMostRows each: vectors

  Trial trial;  // of a step: velocities as what reads them is given them
  bool reads_velocities = false;
  Array<Vec3> middle_v, middle_l;  // by body, of a stage: what its end is tried from again
  Array<Vec3> kicks;               // likewise, of the ledger
  // of an island, as a part of its step begins
  Array<RattleBody> part_bodies;
  Array<RattleJoint> part_joints;
  Array<Vec3> part_kicks;
  // of trials, where a host asks for an accuracy, @see accurate.cpp
  Array<accuracy::Trial> trials;    // by island
  Array<accuracy::BodyEnd> coarse;  // by body: the end to compare with

  Participants held, others, scratch;  // bodies
  PlanLists of_held, of_all;           // between the two stages `of_all` are the plan's, which has those of the others
  bool in_parts = false;               // somebody took this step in parts: lists were others since
  Array<std::uint32_t> active, left_active;
  bool is_hidden = false;  // between the two stages
};

/// Stage functions of the page. Try the step of every island that joints alone hold; hide those that went well.
/// Allocates.
void try_rattle(const World& world, const StepTime& time);
/// They stand where that led.
void take_rattle(const World& world, Poses& poses, Velocities& motion, Breaking to, Events& events,
                 const StepTime& time);

// Parts of it.
namespace rattle {
/// Whether islands without a joint are moved so, too: bodies that springs, drag, fields, magnets or water move. Then a
/// host asks for more than second order, whatever else there is in the world.
bool moves_by_forces(const World& world);
/// Whether a world has what is to be moved so: until then it has no Rattle.
bool is_asked(const World& world);
/// Islands, bodies, joints and orders of elimination, where the scene, who is awake or the order of the error has
/// changed.
void make_islands(const World& world, Rattle& r, int order);
/// Which of them something meets, or what they bear can't be told by forces.
void find_met(const World& world, Rattle& r, const StepTime& time);
/// The step of the islands that are tried, to the side, with their forces.
void move_tried(const World& world, Rattle& r, Real dt, int substeps, int order);
/// Likewise of all, each with the order and substeps that its error asks for; those that are accepted went well.
void try_accurately(const World& world, Rattle& r, Real dt, int least_order);
/// How many stages make a step of an order.
int stages_of(int order);
/// One step of all islands that are moving. Those that still are went well; of the others some want more halvings.
/// @param from  s, since the step began, where their part of it does   @param dt, substeps  of that part
void move_islands(const World& world, Rattle& r, Real from, Real dt, int substeps, int order);
/// Their beginning: joints shut, velocities along them and along what drives hold.
void begin_islands(const World& world, Rattle& r, Real dt, int substeps, int order);
/// What the ledger has of who moves.
void save_kicks(const World& world, const Rattle& r, Array<Vec3>& kicks);
void restore_kicks(const World& world, const Rattle& r, const Array<Vec3>& kicks);
/// s, of the impulse that is kept of a drive, as solvers keep it in substeps of h.
inline Real kept_for(DriveKind kind, Real h) { return acts_once(kind) ? h : h / 2; }
/// What joints' drives are set to, in substeps of h.
void read_drives(const World& world, Rattle& r, Real h);
/// Lists of `held` bodies, and of the others.
void list_held(const World& world, Rattle& r);
/// What is hidden is there again. As a step begins: of one that was not completed.
void come_back(const World& world);
/// Whether a body is left to the solver in this step because its island moves too fast.
bool is_given_up(const World& world, std::uint32_t body);
/// The ledger of what went well.
void account(const World& world, const Rattle& r);

/// f(island) that went well and is not yet in its place, or is since this step.
template <class F>
void each_held(const Rattle& r, F&& f) {
  for (const RattleIsland& island : r.islands)
    if (island.went_well) f(island);
}
}  // namespace rattle

}  // namespace carom::dynamics
