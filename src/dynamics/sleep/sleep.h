// Sleeping: islands that came to rest leave the arrays that a step goes through, and come back exactly as they went.
//
// An island (bodies that hang together through contacts and joints, or one body alone) falls asleep whole at the end of
// a step if all of its bodies were slow for `sleep_time`. Slow is a body none of whose points moves faster than
// `sleep_speed`:
//   |v| + |omega| r <= sleep_speed,     r: the farthest point of its colliders from its centre
// and that has not come farther since it became slow than such a speed would carry it: what a solver moves without a
// velocity (undone penetration) keeps a body awake too. Not while it rests on a kinematic body or a surface that moves,
// nor if one of its bodies must stay awake (BodyDef::stays_awake).
//
// What is kept. Velocities become zero; that is all that falling asleep changes. Poses, the records of all its pairs
// with each other and with what does not move (manifolds, ages, warm directions, patches) and the impulses that the
// next step starts from are kept to the bit. So the step in which it wakes computes what the step after it fell asleep
// would have: time has not passed for it.
//
// What wakes it, the whole of it: a body that moves (dynamic and awake, or kinematic with a velocity) and comes near
// enough for a contact, in the same step and before contacts are made; a kinematic body that moves and that it is
// joined to; a joint of it set, made or removed; whatever a host writes to one of its bodies, but for zero velocity,
// force and impulse; a material it touches; a static or kinematic body beneath it moved, removed or newly there;
// gravity; any dial; a fault that disables a shape or quarantines a body.
//
// Two layers. Whether a body sleeps (`asleep`) is changed at once. The arrays follow (`inactive`) where a step may
// allocate: refresh() settles what has changed, wake_touched() what the step itself wakes. Nothing in a step is
// proportional to the number of sleepers: whom a mover may touch is asked of a tree of their boxes.
//
// @oracle tests/unit/dynamics/test_sleep, tests/oracle/test_waking
#pragma once

#include "collision/broad/box_tree.h"
#include "dynamics/contact/contact.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

/// An impulse to start from, kept for a pair of sleepers.
struct KeptImpulse {
  OldImpulse impulse;
  Real h;               // s, the substep that made it
  std::uint32_t order;  // within its pair
  std::uint32_t next;   // of the same body, or kInvalid
};

struct Sleep {
  explicit Sleep(Memory* m);

  // By body slot; empty until a step with the dial on. Who sleeps, the state says.
  Array<std::uint8_t> inactive;  // it has left the arrays of the step
  Array<std::uint32_t> ring;     // the next sleeper of its island, around to the first
  Array<Real> sleep_timer;       // s, for how long it has been slow
  Array<Vec3> anchor_x;          // m, where it became slow
  Array<Quat> anchor_q;
  Array<Real> radius;               // m, the farthest point of its colliders from its centre
  Array<RowBits> rows;              // of the table that have it for a participant when awake
  Array<std::uint32_t> kept_first;  // its first KeptImpulse, or kInvalid
  Array<std::uint32_t> root;        // scratch: its island
  Array<std::uint8_t> restless;     // scratch: by root

  Array<std::uint32_t> fallen, woken;    // bodies since lists were last settled; some may have changed their mind
  Array<std::uint32_t> touched_by_host;  // static and kinematic bodies that a host moved: they touch once like movers
  Array<std::uint32_t> rejoined;         // colliders that came back: what no pair reclaims is dropped
  std::uint64_t count = 0;               // bodies asleep
  std::uint64_t woke = 0;                // bodies woken since the last report
  bool replant = false;                  // the tree below is empty, and is to be made of all inactive bodies

  BoxTree tree;                 // colliders of inactive bodies, by their bounds
  Array<std::uint8_t> in_tree;  // by collider
  Array<KeptImpulse> kept;
  Array<std::uint32_t> kept_free;
  Array<Pair> near;  // pairs of movers and sleepers whose bounds overlap, ascending, of this step

  // scratch
  Array<std::uint32_t> bodies, colliders, asking, hits;
  Array<std::uint8_t> holders;
  Array<KeptImpulse> returning;
  Participants spare;
};

/// Whether anybody may fall asleep at all.
inline bool anyone_sleeps(const Scene& scene) {
  return scene.dials.choice(Dial::sleep) != 0 && !scene.modes.forbids(+EffectId::sleep);
}
/// Row of the table: who may fall asleep. Its participants are all dynamic bodies that are awake.
namespace sleeping {
void find(const Scene&, const State&, Participants&);
}

// ---- a host's edits (between steps); a body is a slot. None allocates but stir(). ----
/// Wake a body's island; a body that is awake starts to be slow anew.
void wake(const World& world, Sleepers to, std::uint32_t body);
inline void wake(World& world, std::uint32_t body) { wake(world, Sleepers(world), body); }
void wake_all(const World& world, Sleepers to);
inline void wake_all(World& world) { wake_all(world, Sleepers(world)); }
/// Wake who touches a collider.
void wake_touching(World& world, std::uint32_t collider);
/// Wake who is joined to a body, or hangs on it by a spring.
void wake_joined(const World& world, Sleepers to, std::uint32_t body);
/// Wake who wears a material, or touches what wears it.
void wake_wearing(World& world, std::uint32_t material);
/// A host changed what a body is or where it stands: it wakes; who touched a static or kinematic one wakes; whom that
/// one touches now wakes in the next step.
void mark_touched_by_host(World& world, std::uint32_t body);
/// A collider, or a body without colliders, is about to be removed: nothing here names it any longer.
void unlist_collider(World& world, std::uint32_t collider);
void unlist_body(World& world, std::uint32_t body);

// ---- within refresh() ----
/// After a plan was made for everybody: cut its lists down to who is awake.
void plan_sleep(const World& world, Settling to, Plan& plan);
/// Let the arrays follow who fell asleep or woke.
/// @return whether participants changed
bool settle_sleepers(const World& world, Settling to);

// ---- stages of the page ----
/// Stage refresh: wake the islands that something moving touches, and note the pairs that come near.
void wake_touched(const World& world, Settling to, SpringLoads& springs, StepReport& report, const StepTime& time);
/// Stage observe: put to sleep the islands that came to rest.
void fall_asleep(const World& world, Velocities& motion, Sleepers to, StepReport& report, const StepTime& time);

/// Settle, for stages that wake: bodies of sleep.woken back into arrays and lists of the plan.
void rejoin(const World& world, Settling to);
using ClearingSleepers = Writes<SleepFlags, Sleep, PairTable, Impulses, Revisions>;
/// Where memory ran out half-way: everybody is awake, and caches are gone.
void clear_sleepers(const World& world, ClearingSleepers to);

}  // namespace carom::dynamics
