// The ledger: where energy, momentum and angular momentum come from and go to, by cause.
//
// Between any two stages of the step that change the state stands an account. It only reads; a world steps the same
// bits with it and without. Nothing of it exists in a world that did not ask (World::ledger is null then).
//
// What is accounted for, of all dynamic bodies (asleep and in quarantine too) and particles, @see Amount:
//   kinetic    1/2 m v^2 + 1/2 omega.I omega        linear     m v
//   potential  -m f g.x, of uniform gravity         angular    x x m v + I omega, about the world's origin
//
// Velocities. A substep has two phases, before poses move and after: the forces' kicks, torques and the solver; what
// relaxes. In each, a cause c that changes a body's velocities by (dv, dw) gives it
//   linear  m dv      angular  x x m dv + I dw      kinetic  m dv.(v + v')/2 + I dw.(omega + omega')/2
// with v, v' those of the body as its phase begins and ends. Over all causes that is the change to rounding, whatever
// their order: what a force and the floor do to a body at rest is nothing, not the work of one against the other. What
// changes poses and velocities at once (impacts, sweeps, falling asleep) ends a body's phase, and is entered as the
// difference of the two states.
//
// Solvers. What the impulses of contacts and joints give is known by row: P at r gives P.(u + u')/2, u the velocity
// there, to the phase as above; it is split into normal (contact), friction, what joints lock and what drives them.
// What a solver did beyond that (arms and inertias that it keeps while bodies turn) is `unassigned`.
//
// Gravity gives the work that it does along the way a body went, and takes as much potential; what its kicks did beyond
// that is the integrator's. So is what a move does to angular momentum and rotational energy, but that forces act at
// the middle of the way where a body goes the integrator's way; and the gyroscopic term, which is no force: that of a
// free top sums to zero where its method keeps the momentum.
//
// @oracle tests/effects/test_ledger, tests/unit/dynamics/test_ledger
#pragma once

#include <array>
#include <span>

#include "core/sum.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

struct Amount {
  Real kinetic = 0, potential = 0;                     // J
  Vec3 linear = Vec3::zero(), angular = Vec3::zero();  // N s; N m s, about the world's origin

  Amount& operator+=(const Amount& o) {
    kinetic += o.kinetic, potential += o.potential, linear += o.linear, angular += o.angular;
    return *this;
  }
  friend Amount operator+(Amount a, const Amount& b) { return a += b; }
  friend Amount operator-(const Amount& a) { return {-a.kinetic, -a.potential, -a.linear, -a.angular}; }
  friend Amount operator-(const Amount& a, const Amount& b) { return a + -b; }
  Real energy() const { return kinetic + potential; }
};

/// The fixed causes; each row of the table with a force or a flow is one besides, by its own name.
enum class Cause : std::uint32_t {
  host,         // between steps: bodies made, removed, placed, pushed; gravity set
  contact,      // normal impulses
  friction,     // and what surfaces that move do by it
  restitution,  // impacts that are solved before the solver
  resistance,   // to rolling and spinning
  joints,       // what they lock
  drives,       // their motors, springs and limits
  continuous,   // hits on the way
  axis_locks,
  correction,  // poses put right apart from velocities
  sleep,       // velocities of who falls asleep
  quarantine,  // of who left the finite world
  integrator,  // beyond what the forces did
  unassigned,  // of solvers, beyond what their impulses did
  count
};
inline constexpr std::size_t kFixedCauses = static_cast<std::size_t>(Cause::count);
inline constexpr std::size_t kCauses = kFixedCauses + kEffectCount;
const char* cause_name(std::size_t cause);  // null: a row without an account
inline std::size_t index_of(Cause cause) { return static_cast<std::size_t>(cause); }
inline std::size_t cause_of_row(std::size_t row) { return kFixedCauses + row; }

/// Sums of amounts that keep their digits.
class Account {
 public:
  void add(const Amount& a) {
    kinetic_.add(a.kinetic), potential_.add(a.potential), linear_.add(a.linear), angular_.add(a.angular);
  }
  Amount value() const { return {kinetic_.value(), potential_.value(), linear_.value(), angular_.value()}; }

 private:
  Sum<Real> kinetic_{0}, potential_{0};
  Sum<Vec3> linear_{Vec3(Vec3::zero())}, angular_{Vec3(Vec3::zero())};
};

/// Bounds of what rounding may leave between the sum of all causes and the change of the state.
struct Rounding {
  Real energy = 0, linear = 0, angular = 0;  // J, N s, N m s
};

struct Ledger {
  explicit Ledger(const World& world);  // begins with the state as it is

  // ---- what a host reads ----
  std::array<Account, kCauses> step{}, since{};  // of the last step; since the ledger began, with it
  Amount start, before, now;                     // of the state: as the ledger began, before the last step, after it
  Rounding step_rounding, since_rounding;
  std::uint64_t steps = 0;

  // ---- within a step ----
  struct Body {
    Vec3 x;                   // m
    Quat q;                   // with x: as its phase began, which is as it has been throughout
    Vec3 v, omega;            // m/s, rad/s, as its phase began
    Vec3 seen_v, seen_omega;  // as the last account saw them
    bool kicked;              // half of what forces did comes after the move
    bool held;                // in quarantine
  };
  struct Kick {
    Vec3 v, omega;  // m/s, rad/s
  };
  /// Columns of kicks: these, then one for each row of the table that acts in this step.
  enum : std::size_t { kTurn, kLock, kResist, kSolve, kFixedColumns };
  Array<Body> body;   // by slot; between steps as the state has it
  Array<Kick> kicks;  // [slots][columns]; zero between phases
  std::size_t columns = kFixedColumns;
  std::array<std::uint8_t, kEffectCount> column_of{};                 // by row of the table
  std::array<std::uint8_t, kFixedColumns + kEffectCount> cause_of{};  // by column
  Array<Kick> probe;                                                  // by slot: velocities before a row
  std::size_t gravity = 0;                                            // cause

  // what bodies and sets of particles had after the last step
  Array<Amount> body_amount;  // by slot
  Array<Amount> set_amount;   // by set
  Array<Vec3> set_moment;     // kg m, by set: sum of m x
  Array<std::uint64_t> set_held;
  std::uint64_t revision = 0;  // of the scene
  bool is_open = false;        // a step began, and has not ended
  bool is_paused = false;      // what happens is a trial, @see dynamics/accuracy/

  // impulses as a phase begins, N s: of points and pairs in lanes, of rows of joints, of impacts
  Array<Real> old_points, old_pairs, old_rows, old_drives;
  Array<Vec3> old_impacts;

  void account(Cause cause, const Amount& a) { step[index_of(cause)].add(a); }
  std::span<Kick> kicks_of(std::uint32_t i) { return {&kicks[i * columns], columns}; }
};

/// What a body has, of mass 0 nothing.
Amount amount_of(const World& world, std::uint32_t body, const Vec3& x, const Quat& q, const Vec3& v,
                 const Vec3& omega);
/// Who may move in this step: dynamic bodies that are awake.
template <class F>
void each_awake(const World& world, F&& f) {
  each_of_both(world.plan->linear, world.plan->rotating, f);
}

/// Whether there is a ledger: a host asked for it, and does not forbid it.
inline bool keeps_ledger(const World& world) {
  return world.ledger && !world.ledger->is_paused && !world.scene.modes.forbids(+EffectId::ledger);
}

/// How the ledger accounts for what a stage did, @see stages.cpp, which says so of each.
enum class LedgerAccount : std::uint8_t {
  none,       // it changes nothing that the ledger counts
  with_host,  // before the accounts of a step open: its changes count among the host's
  by_itself,  // it enters what it does on the way
  opens,      // the accounts of a step, with what the host did since the last one
  reserves,   // for what solvers give
  forces,
  impacts,
  moments,
  solver,
  moves,
  relaxation,
  resistance,
  sweeps,
  particles,
  corrections,
  lost_bodies,  // who left the finite world
  sleepers,
  closes
};

/// After a stage: account for what it did.
void account_stage(const World& world, LedgerAccount account, const StepTime& time);

// Within integrate_velocity().
void before_row(const World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega);
void after_row(const World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega, Real share);
/// Enters what a row of the table does, in this scope, to velocities or to what becomes of them. It writes to no body
/// but its participants.
class AccountForRow {
 public:
  /// @param v, omega  by body slot   @param share  @see Accelerate
  AccountForRow(const World& world, const PlannedEffect& row, const Vec3* v, const Vec3* omega, Real share)
      : world_(world), row_(row), v_(v), omega_(omega), share_(share) {
    if (keeps_ledger(world_)) before_row(world_, row_, v_, omega_);
  }
  ~AccountForRow() {
    if (keeps_ledger(world_)) after_row(world_, row_, v_, omega_, share_);
  }
  AccountForRow(const AccountForRow&) = delete;
  AccountForRow& operator=(const AccountForRow&) = delete;

 private:
  const World& world_;
  const PlannedEffect& row_;
  const Vec3 *v_, *omega_;
  const Real share_;
};
/// After the integrator and before locks: what is not of a row.
void account_turns(const World& world);

// ---- shares.cpp: of a solver's impulses ----
/// Reserves what the next two keep. Allocates.
void reserve_shares(const World& world);
/// Impulses as the phase after the move begins with them.
void save_impulses(const World& world);
/// Friction of a pair in lanes counts from nothing again.
void clear_friction(const World& world, std::uint32_t pair, std::uint32_t lane);
void save_impacts(const World& world);  // likewise before impacts are solved
/// Split what the solver did into its causes; bodies have the velocities with which their phases end.
void share_solved(const World& world);
void share_relaxed(const World& world);
void share_impacts(const World& world);

}  // namespace carom::dynamics
