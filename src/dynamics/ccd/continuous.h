// Continuous collision: what moves far for its size is swept, so that it never ends a substep beyond something.
//
// Elsewhere a step looks where bodies stand, and a little ahead: bounds and contacts reach as far as a body moves
// within the step, but no farther than the size of its shape, beyond which a contact would stop bodies that merely pass
// by. What moves farther than that is this module's participant, and so is what turns so far that its ends pass what
// its contacts know nothing of, and what a host asks for (BodyDef::continuous). What is long or flat and moves by more than
// its thickness keeps its contacts and is swept beside: an end that lands first may send the other one through something.
// So is what a host moves, if it comes farther in a step than a quarter of its thickness, and dynamic bodies in its way are
// swept against it. No other body costs anything.
//
// In a substep, when the integrator and the solver have had their say, each participant has come from one pose to another.
// Its path between them, straight on and about one axis, is swept by conservative advancement (collision/cast) against
// all that stands or moves in its way: each obstacle on the path of its own. At the first contact the two are solved
// there and then, as by contact/impact.h: one impulse of all points that touch, with the restitution and Coulomb's
// friction of their materials, momentum kept; and both go on from there for the rest of the substep, the one that was
// hit swept from then on as well if it goes far by the end of the step. So contacts of a substep are solved one after
// the other, by time, of equals by slot, whoever's they are, and no time is lost.
//
// Hits of a substep are bounded (ccd/join.cpp). What was hit too often goes on as one with what it hits next, until the
// substep ends. Bodies that impulses move get the velocity of one rigid body: momentum is kept, and energy only lost.
// What impulses do not move carries them, so nothing gets out of what moves, however crowded that is.
//
// The path is a chord of the motion. Under constant forces it sags by h^2 a/8 under the parabola; the moment of an
// impact is found on the parabola, and its impulse changes velocity and place at the end as it would there: energy is
// kept to rounding at restitution 1 under velocity_verlet.
//
// Touching is not hitting. Two that touch or overlap, or meet so slowly that they would sink by no more than a slack
// within a substep (`position_tolerance`, at most a twentieth of the thinner one), are left to the solver, and swept on
// until they have sunk deeper by that slack. So what rests, rolls or slides at 200 m/s is not held up; what was already
// deep in something may leave it, but goes no deeper.
//
// Contacts ahead of a touch (speculative ones) of a participant that closes fast are taken from the solver: at such speeds
// their planes would stop what merely passes by, and the sweep knows better.
//
// The plane that was last found between two is asked first (PartingPlanes): mostly it keeps them apart for the rest of the step.
// What touches and comes no farther than half its thickness is asked at the end of the substep alone whether it sank.
//
// A swept body costs a query of the broad phase's tree, of the sleepers' and of the other participants', and some
// microseconds for each pair of convex shapes whose bounds its path crosses. All on the stepping thread: the order of
// hits is one of time.
//
// A sensor stops nothing, but is told what passed it on the way, thin as it may be, if a host collects such events.
//
// Scenery is swept against, never swept: a mesh that a host drives fast is met where it stands.
//
// A hit changes two bodies as if they were free. What hangs on them by joints follows them within the substep
// (close_joints() in solver/direct.h), and has its share of their velocities in the next.
//
// What this is not: joints that the direct solver does not hold gape after a hit, until they are led back; kinematic bodies that
// crush something between them are not stopped; a half-space that turns is swept as if it did not; a body that has but
// sensors is not swept; obstacles that neither a participant's straight path of the step comes near nor a hit before are
// taken to come from where their velocity tells. Where substeps go by island (dynamics/accuracy/), such an obstacle may
// have its substeps later: who hits it waits there for the rest of the step, and neither changes the other.
//
// @oracle tests/oracle/test_bullet, tests/unit/dynamics/test_ccd
#pragma once

#include "collision/broad/box_tree.h"
#include "dynamics/ccd/path.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

/// The dial's choices.
enum SweepChoice : std::uint32_t { kSweepNone, kSweepFlagged, kSweepFast };

/// An impact that a sweep solved, as events tell of it.
struct SweepHit {
  Pair pair;
  std::uint32_t order;  // in time
  Vec3 point, normal;   // m, world; unit, world, A to B
  Real impulse;         // N s, along the normals, of all its points
  Real speed;           // m/s, at which the fastest of them closed
};

/// A body whose path is known: it is swept, or one that is may meet it.
struct SweptBody {
  std::uint32_t body;
  bool swept = false;                              // else it is somebody else's obstacle
  bool outruns = false;                            // its contacts do not reach as far as it moves in this step
  bool loose = false;                              // it is not in the tree of participants, or has left its box there
  bool changed = false;                            // something hit it in this substep
  bool is_hit = false;                             // likewise, in this step
  bool is_hit_elsewhere = false;                   // not by one and the same pair
  collision::Pair hit = {kInvalid, kInvalid};      // the first that it was hit by
  bool flies = false;                              // its path is a parabola's chord; else a solver's straight line
  static constexpr std::uint32_t kMostHits = 16;   // in a substep, before what impulses do not move holds it
  static constexpr std::uint32_t kMostShared = 4;  // before it joins what they do move
  std::uint32_t hits = 0;                          // in this substep
  std::uint32_t next_as_one = kInvalid;            // place in bodies: a ring of those that go on as one; else none
  std::uint32_t carrier = kInvalid;  // body that impulses do not move, with which it goes on; itself: stays
  bool is_held() const { return carrier != kInvalid; }
  bool is_joined() const { return next_as_one != kInvalid; }
  bool is_spent() const { return hits >= kMostHits || is_joined() || is_held(); }
  bool may_join() const { return hits >= kMostShared || is_joined(); }
  Real sensed = 0;            // s: how far along its path sensors were asked, @see sense.cpp
  std::uint32_t version = 0;  // raised when its path changes
  Real radius = 0;            // m: the farthest of its colliders from its centre
  Path path;                  // of this substep, from the last hit on
  Vec3 accel = Vec3::zero();  // m/s^2, of forces in this substep

  // The first contact ahead:
  Real when = kInfinity;             // s; infinite: there is none
  std::uint32_t own = 0, other = 0;  // collider slots
  std::uint32_t met_version = 0;     // of the other's path, that this was found with
  SweptPart own_part, other_part;
  Vec3 normal, point;  // unit, from own to other; m, world
};

/// What was found between two in this step, by their colliders: a plane that may keep them apart for longer. As many as there is
/// capacity for, the newer of two that share a place.
class PartingPlanes {
 public:
  explicit PartingPlanes(Memory* m) : planes_(m) {}
  /// Forgets all.   @param bodies  how many are known: each has some neighbours
  void clear(std::size_t bodies);
  /// @return zero: none is known
  Vec3 find(std::uint32_t a, std::uint32_t b) const;
  /// @param normal  unit, world, from A to B
  void keep(std::uint32_t a, std::uint32_t b, const Vec3& normal);

 private:
  struct Plane {
    Pair pair;
    Vec3 normal;  // from the lower slot to the higher
  };
  std::size_t place(const Pair& pair) const;
  Array<Plane> planes_;
};

struct Continuous {
  explicit Continuous(Memory* m);

  // Bounds of a step are made in refresh; who was seen to go beyond them, by collider; it may repeat and overflow.
  Array<std::uint32_t> seen;
  bool too_many_seen = false;
  bool waits = false;  // a part of the step goes on in which nothing is swept
  void see(std::uint32_t body) {
    if (seen.size() < seen.capacity())
      seen.push_back(body);
    else
      too_many_seen = true;
  }

  Array<std::uint32_t> index;                  // by body: in bodies, or kInvalid; empty until there is a participant
  Array<SweptBody> bodies;                     // of this step: participants first, ascending
  std::size_t participants = 0;                // of bodies
  BoxTree tree;                                // of participants, by place in bodies; boxes of this substep
  Array<Aabb> boxes;                           // m, by place in bodies
  Array<std::uint32_t> loose;                  // places in bodies
  Array<SweepHit> hits;                        // of this step, by time; as many as are reserved
  Array<Pair> passed;                          // with a sensor, of this step; as many as are reserved; may repeat
  PartingPlanes planes;                        // of this step
  std::size_t most_bodies = 0, most_hits = 0;  // of this step: not what arrays have grown to, which is of the past
  Array<std::uint32_t> near;                   // slots of bodies within a participant's way, wherever a hit turns it
  Array<std::uint32_t> found;                  // scratch: colliders
  Participants one, more, merged;              // scratch, for rotation methods
  SupportFault fault;                          // the first of this step

  /// The tree of the boxes of participants, afresh.
  void build_tree() {
    found.clear();
    for (std::uint32_t k = 0; k < participants; ++k) found.push_back(k);
    tree.build(found, boxes);
  }
  SweptBody* find(std::uint32_t body) {
    const std::uint32_t at = body < index.size() ? index[body] : kInvalid;
    return at == kInvalid ? nullptr : &bodies[at];
  }
};

/// Whether sensors are to be told what passes them swept.
bool senses_sweeps(const World& world);

/// Row of the table: bodies that a host wants swept.
namespace continuous {
void find(const Scene&, const State&, Participants&);
}

/// Take up a body that is not known yet.
SweptBody& know(const World& world, std::uint32_t body);

/// Whether a collider moves by more than a quarter of its thickness in a step.
bool comes_far(const World& world, std::uint32_t collider, Real dt);
/// Part of refresh(), when bounds are made: who outruns its contacts, and with those that a host asked for, who is
/// swept.
void find_swept(const World& world, Colliders& table, Real dt);
/// Whether a participant's straight path in this step meets a sleeper. Stage refresh.
bool sweeps_into(const World& world, std::uint32_t collider, std::uint32_t sleeper, Real dt);
/// m, world: bounds of a collider and, if its body is a participant, of its straight path in this step.
Aabb swept_bounds(const World& world, std::uint32_t collider, Real dt);

/// Within begin_substep(): where its paths begin.
void begin_paths(const World& world);

/// Stage functions of the page.
/// Take from the solver the contacts that the sweep knows better.
void leave_to_sweep(const World& world, BroadPhases& broad, PairTable& pairs, const StepTime& time);
/// Reserves for all that the substeps may do; who stands in the way; and near it, where substeps go by island.
void begin_sweeps(const World& world, BroadPhases& broad, StepReport& report, const StepTime& time);
/// What forces did to velocities in this substep.
void save_accelerations(const World& world, const StepTime& time);
/// Who has just been made so fast by contacts that these don't reach as far: swept from this substep on.
void find_sped_up(const World& world, StepReport& report, const StepTime& time);
/// The hits of a substep. Who sleeps and is hit wakes.
using Sweeping = Writes<Poses, Velocities, SleepFlags, Sleep, BroadPhases, StepReport>;
void sweep(const World& world, Sweeping to, const StepTime& time);
/// Whether a hit has led a body off the way of this substep.
bool is_led_by_sweep(const World& world, std::uint32_t body);
bool any_led_by_sweep(const World& world);
/// What the step's sweeps leave behind.
void end_sweeps(const World& world, Revisions& scene, FaultViews& views, const StepTime& time);

}  // namespace carom::dynamics
