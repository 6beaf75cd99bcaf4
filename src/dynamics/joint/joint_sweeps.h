// Sweeps over joints in lanes: the arithmetic behind JointKernels. Included by one file for each width of registers,
// compiled for it; all that stands here is local to that file.
//
// A joint's equalities are solved together: with K the coupling of its rows (velocity at one per impulse at another),
//   p <- p - K^-1 s (u + error rate + curve) - (1 - s) p,
// s and rate those of a soft constraint. `curve` is what makes a pendulum keep its energy: the pose after a move by h u
// lies off the joint by h^2/2 error'', and the velocity that leads back onto it is asked for at once. With velocities
// put right after the move (relax) that is the scheme of [Andersen1983], of second order where nothing is soft.
#pragma once

#include "core/wide_angle.h"
#include "dynamics/joint/axes_sweep.h"
#include "dynamics/joint/bend_sweep.h"
#include "dynamics/joint/joint_kernels.h"

namespace carom::dynamics {
namespace {

/// Impulses at several rows, added up before they act.
struct Pushes {
  LaneVec p{}, turn_a{}, turn_b{};
  Lanes sum{};  // of all rows; where A is pulled another way, that is what it is pulled with
  CAROM_LANES_INLINE void add(const JointRowLanes& r, Lanes impulse) {
    p = p + impulse * r.d;
    turn_a = turn_a + impulse * r.w_a;
    turn_b = turn_b + impulse * r.w_b;
    sum = sum + impulse;
  }
};

/// Velocities of the four bodies on both sides.
/// @tparam kTwoWays  A is pulled another way than B
template <bool kTwoWays>
struct JointSides {
  Side a, b;
  const JointLanes& joint;
  const LockLanes* locks;  // null: none
  const PullLanes* pull;   // null unless of two ways

  CAROM_LANES_INLINE JointSides(const JointLanes& j, const JointRun& run)
      : joint(j), locks(locks_of(run, j)), pull(kTwoWays ? pull_of(run, j) : nullptr) {
    a.load(run.velocity, j.a);
    b.load(run.velocity, j.b);
  }
  CAROM_LANES_INLINE void store(const JointRun& run) const {
    a.store(run.velocity, run.first_moved, joint.a);
    b.store(run.velocity, run.first_moved, joint.b);
  }
  CAROM_LANES_INLINE Lanes along(const JointRowLanes& r) const {
    const Lanes turning = dot(r.w_b, b.omega) - dot(r.w_a, a.omega);
    if constexpr (kTwoWays) return (dot(r.d, b.v) - dot(pull->d_a, a.v)) + turning;
    return dot(r.d, b.v - a.v) + turning;
  }
  CAROM_LANES_INLINE void push(const Pushes& pushes) {
    const LaneVec& p = pushes.p;
    LaneVec at_a = p;
    if constexpr (kTwoWays) at_a = pushes.sum * pull->d_a;
    a.v = a.v - joint.inv_mass_a * (locks ? each(locks->free_a, at_a) : at_a);
    a.omega = a.omega - joint.inv_inertia_a * pushes.turn_a;
    b.v = b.v + joint.inv_mass_b * (locks ? each(locks->free_b, p) : p);
    b.omega = b.omega + joint.inv_inertia_b * pushes.turn_b;
  }
  CAROM_LANES_INLINE void push(const JointRowLanes& r, Lanes p) { push({p * r.d, p * r.w_a, p * r.w_b, p}); }
};

/// @tparam kRows  how many there are; 0: the layout says so
template <bool kPush, int kRows, class Sides>
CAROM_LANES_INLINE void hold(Sides& sides, const JointLanes& joint, JointRowLanes* rows) {
  const int n = kRows ? kRows : static_cast<int>(joint.layout.equalities);
  Lanes x[kRows ? kRows : kMostRows];
  for (int k = 0; k < n; ++k) {
    const JointRowLanes& r = rows[k];
    x[k] = sides.along(r);
    if constexpr (kPush) x[k] = joint.mass_scale * (x[k] + r.curve + joint.bias_rate * r.error);
  }
  if constexpr (kRows)
    solve_coupled<kRows>(joint.factor, x);
  else
    solve_any(joint, x);
  Pushes pushes;
  for (int k = 0; k < n; ++k) {
    Lanes change = -x[k];
    if constexpr (kPush) change -= joint.impulse_scale * rows[k].p;
    rows[k].p += change;
    pushes.add(rows[k], change);
  }
  sides.push(pushes);
}

/// A coordinate's impulse within its bounds; those of the lower end push, those of the upper pull.
template <bool kPush, class Sides>
CAROM_LANES_INLINE void limit(Sides& sides, const JointLanes& joint, JointDriveLanes& drive, double inv_h) {
  const Lanes u = sides.along(drive.row), p = drive.row.p;
  const Lanes above = drive.row.error - drive.lower, below = drive.upper - drive.row.error;
  const auto wanted = [&](Lanes distance, Lanes closing) __attribute__((always_inline)) {
    const LaneMask open = distance > 0;
    if constexpr (kPush) {
      const Lanes lack = closing - (open ? distance * inv_h : joint.bias_rate * distance);
      return (open ? all(1) : joint.mass_scale) * drive.m * lack;
    } else {
      return drive.m * (closing - (open ? distance * inv_h : all(0)));
    }
  };
  const auto kept = [&](Lanes distance) __attribute__((always_inline)) {
    if constexpr (kPush) return distance > 0 ? p : p - joint.impulse_scale * p;
    return p;
  };
  const Lanes next = larger(kept(above) + wanted(above, -u), all(0)) + smaller(kept(below) - wanted(below, u), all(0));
  sides.push(drive.row, next - p);
  drive.row.p = next;
}

/// A soft stop: beyond either end a spring's law, by impulses that only push back.
template <bool kPush, class Sides>
CAROM_LANES_INLINE void stop(Sides& sides, JointDriveLanes& drive) {
  if constexpr (!kPush) return;
  const Lanes u = sides.along(drive.row), p = drive.row.p;
  const Lanes above = drive.row.error - drive.lower, below = drive.upper - drive.row.error;
  const Lanes kept = drive.drag * p, dragged = drive.drag * u;
  const Lanes pushed = kept - drive.m * (drive.pull * above + dragged),
              pulled = kept + drive.m * (drive.pull * below - dragged);
  const Lanes next = (above < 0 ? larger(pushed, all(0)) : all(0)) + (below < 0 ? smaller(pulled, all(0)) : all(0));
  sides.push(drive.row, next - p);
  drive.row.p = next;
}

/// A rotor resists what changes its speed, after the move as before it, where nothing keeps the impulse.
template <bool kPush, class Sides>
CAROM_LANES_INLINE void turn(Sides& sides, JointDriveLanes& drive) {
  const Lanes u = sides.along(drive.row), p = drive.row.p;
  const Lanes next = drive.drag * (p - drive.m * (u - drive.speed));
  sides.push(drive.row, next - p);
  drive.row.p = next;
  if constexpr (!kPush) turn_rotor(drive);
}

/// @tparam kAxed  it may be a stop, a rotor, or a spring whose target moves
template <bool kPush, bool kAxed, class Sides>
CAROM_SHARED_PART void act(Sides& sides, const JointLanes& joint, JointDriveLanes& drive, DriveKind kind,
                           double inv_h) {
  // A pace is a limit of how far an axis goes in a substep.
  if (kind == DriveKind::limit || (kAxed && kind == DriveKind::pace)) return limit<kPush>(sides, joint, drive, inv_h);
  if constexpr (kAxed)
    if (kind == DriveKind::stop) return stop<kPush>(sides, drive);
  const Lanes u = sides.along(drive.row), p = drive.row.p;
  Lanes next = p;
  if (kind == DriveKind::motor) next = p - drive.m * (u - drive.speed);
  if (kAxed && kind == DriveKind::rotor) return turn<kPush>(sides, drive);
  if (kind == DriveKind::spring) {
    if constexpr (!kPush) return;  // its law holds for the whole substep, with the place where that began
    next = drive.drag * p -
           drive.m * (drive.pull * (drive.row.error - drive.lower) + drive.drag * (kAxed ? u - drive.speed : u));
  }
  next = larger(smaller(next, drive.max_impulse), -drive.max_impulse);
  sides.push(drive.row, next - p);
  drive.row.p = next;
}

template <bool kPush, class Sides>
CAROM_SHARED_PART void hold_all(Sides& sides, const JointLanes& joint, JointRowLanes* rows) {
  if constexpr (kFewCopies) {
    if (joint.layout.equalities) hold<kPush, 0>(sides, joint, rows);
    return;
  }
  switch (joint.layout.equalities) {
    case 1:
      return hold<kPush, 1>(sides, joint, rows);
    case 2:
      return hold<kPush, 2>(sides, joint, rows);
    case 3:
      return hold<kPush, 3>(sides, joint, rows);
    case 4:
      return hold<kPush, 4>(sides, joint, rows);
    case 5:
      return hold<kPush, 5>(sides, joint, rows);
    case 6:
      return hold<kPush, 6>(sides, joint, rows);
    default:
      return;
  }
}

CAROM_SHORT_PART Pushes all_of(const JointRun& run, const JointLanes& joint) {
  Pushes pushes;
  for (std::uint32_t k = 0; k < joint.layout.equalities; ++k)
    pushes.add(run.rows[joint.first + k], run.rows[joint.first + k].p);
  for (std::uint32_t k = 0; k < joint.layout.drives; ++k)
    pushes.add(run.drives[joint.first_drive + k].row, run.drives[joint.first_drive + k].row.p);
  return pushes;
}

/// Let impulses act on the bodies of a joint.
CAROM_SHORT_PART void push_both(const JointRun& run, const JointLanes& joint, const Pushes& pushes) {
  const auto push = [&](auto sides) __attribute__((always_inline)) {
    sides.push(pushes);
    sides.store(run);
  };
  if (joint.pulled)
    push(JointSides<true>(joint, run));
  else
    push(JointSides<false>(joint, run));
}

/// What acts again: not what springs and stops do, which is all of a substep's, nor what holds an axis to a speed.
void act_again(const JointRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    JointLanes& joint = run.joints[i];
    Pushes pushes;
    for (std::uint32_t k = 0; k < joint.layout.equalities; ++k)
      pushes.add(run.rows[joint.first + k], joint.again * run.rows[joint.first + k].p);
    for (std::uint32_t k = 0; k < joint.layout.drives; ++k)
      if (!acts_once(joint.layout.drive[k].kind) && joint.layout.drive[k].kind != DriveKind::pace)
        pushes.add(run.drives[joint.first_drive + k].row, joint.again * run.drives[joint.first_drive + k].row.p);
    joint.force = joint.force + pushes.p;
    joint.torque = joint.torque + (pushes.turn_b - cross(joint.r_b, pushes.p));
    push_both(run, joint, pushes);
  }
}

CAROM_LANES_INLINE void accumulate_one(const JointRun& run, JointLanes& joint) {
  const Pushes pushes = all_of(run, joint);
  joint.force = joint.force + pushes.p;
  joint.torque = joint.torque + (pushes.turn_b - cross(joint.r_b, pushes.p));
}

/// What holds an axis to a speed starts from nothing: a rotor would take what it did before for a push, and be slowed by it.
CAROM_SHARED_PART void forget_paces(const JointRun& run, const JointLanes& joint) {
  for (std::uint32_t k = 0; k < joint.layout.drives; ++k)
    if (joint.layout.drive[k].kind == DriveKind::pace) run.drives[joint.first_drive + k].row.p = all(0);
}

void warm_start(const JointRun& run) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const JointLanes& joint = run.joints[i];
    if (joint.axed) forget_paces(run, joint);
    push_both(run, joint, all_of(run, joint));
  }
}

CAROM_LANES_INLINE bool has_limit(const JointLayout& layout) {
  for (std::uint32_t k = 0; k < layout.drives; ++k)
    if (layout.drive[k].kind == DriveKind::limit) return true;
  return false;
}

template <bool kPush, bool kTwoWays, bool kAxed>
CAROM_LANES_INLINE void sweep_one(const JointRun& run, const JointLanes& joint, double inv_h) {
  JointSides<kTwoWays> sides(joint, run);
  // Locks first, too. What they have yet to do to a coordinate's velocity is none of what a limit solves, whose mass is
  // the one that locks leave it: m times that velocity is more than twice what would stop it where the mass alone is
  // less than half of m, and gives energy. (Joints of other kinds that have none keep their bits: a damped spring on one
  // whose weight hangs off its axis rests off by c / k of such a velocity, in first order.)
  if (kAxed ? joint.layout.drives > 0 : has_limit(joint.layout)) hold_all<kPush>(sides, joint, run.rows + joint.first);
  for (std::uint32_t k = 0; k < joint.layout.drives; ++k)
    act<kPush, kAxed>(sides, joint, run.drives[joint.first_drive + k], joint.layout.drive[k].kind, inv_h);
  hold_all<kPush>(sides, joint, run.rows + joint.first);
  sides.store(run);
}

/// Apart, so that sweeps over other kinds are as they were.
template <bool kPush>
[[gnu::noinline]] void sweep_axed(const JointRun& run, const JointLanes& joint, double inv_h) {
  sweep_one<kPush, false, true>(run, joint, inv_h);
}

template <bool kPush>
CAROM_LANES_INLINE void sweep(const JointRun& run, double inv_h) {
  for (std::size_t i = 0; i < run.count; ++i) {
    JointLanes& joint = run.joints[i];
    if (joint.axed)
      sweep_axed<kPush>(run, joint, inv_h);
    else if (joint.pulled)
      sweep_one<kPush, true, false>(run, joint, inv_h);
    else
      sweep_one<kPush, false, false>(run, joint, inv_h);
    if constexpr (!kPush) accumulate_one(run, joint);
  }
}

void solve(const JointRun& run, double inv_h) { sweep<true>(run, inv_h); }
void relax(const JointRun& run, double inv_h) { sweep<false>(run, inv_h); }

constexpr JointKernels joint_kernels_named(const char* name) {
  return {name, place, bend, warm_start, solve, act_again, relax};
}

}  // namespace
}  // namespace carom::dynamics
