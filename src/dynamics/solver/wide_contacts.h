// Contacts in lanes: four pairs side by side, point by point, in the order in which a solver visits them.
//
// Pairs of one colour share no body that an impulse moves, so that four of them (or, later, several threads) can be
// solved at once, and the outcome depends on the order of colours alone. Within a colour pairs with the same number of
// points stand together: nobody waits for a neighbour's points.
#pragma once

#include "core/wide.h"
#include "dynamics/contact/contact.h"

namespace carom {

/// What a solver reads and writes of a body: one cache line. Body 0 is nobody: what does not move has no mass here.
struct alignas(64) BodyVelocity {
  double v[3] = {0, 0, 0};      // m/s, world
  double omega[3] = {0, 0, 0};  // rad/s, world
};

/// How far a body has come since the step began.
struct alignas(64) BodyShift {
  double x[3] = {0, 0, 0};  // m, world
  double u[3] = {0, 0, 0};  // axis times sin of half the angle of the turn, world
  double w = 1;             // cos of half the angle
};

/// One point of each of four pairs. Impulses act on B, and on A the other way.
struct PointLanes {
  LaneVec n;         // unit, world, A to B
  LaneVec r_a, r_b;  // m, world axes: from the centres of mass to the point as the step began
  Lanes gap;         // m, separation as the step began
  Lanes separation;  // m, now
  Lanes approach;    // m/s, normal velocity as the step began (negative: closes)
  Lanes reach;       // m, from the middle of the pair's points
  Lanes m_n;         // kg, normal impulse per change of velocity; 0: an empty lane
  Lanes p_n;         // N s, of the present substep
  Lanes sum_n;       // N s, of the step
  Lanes most;        // N s, largest p_n of the step
  Lanes push;        // kg m, of displacements, @see ContactKernels::part
};

inline constexpr int kPairPoints = Manifold::kMaxPoints;

/// Four pairs of one colour. Friction is answered once a pair, at the middle of its points: a force in the plane,
/// within the disc of radius mu times the normal impulses, and a twist about the normal, within mu times their moments.
/// The second tangent is n x t.
struct PairLanes {
  std::uint32_t a[kLanes], b[kLanes];          // solver bodies; 0: nobody, or nobody that moves
  std::uint32_t first, points;                 // in WideContacts::points
  Lanes inv_mass_a, inv_mass_b;                // 1/kg
  LaneSymmetric inv_inertia_a, inv_inertia_b;  // 1/(kg m^2), world, as the step began
  LaneVec n, t;                                // unit, world
  LaneVec r_a, r_b;                            // m, to the middle of the points
  Lanes friction, restitution;
  Lanes m_tt, m_ts, m_ss;                      // kg, impulse per change of velocity in the plane
  Lanes m_w;                                   // kg m^2, likewise of the twist
  Lanes p_t, p_s, p_w;                         // N s, N m s, of the present substep
  Lanes sum_t, sum_s, sum_w;                   // of the step
  Lanes coupling[kPairPoints][kPairPoints];    // 1/kg: normal velocity at one point per normal impulse at another
  Lanes bias_rate, mass_scale, impulse_scale;  // softness, @see soft_step.h
};

/// Where a row went.
struct LanePlace {
  std::uint32_t pair, point;  // in WideContacts
  std::uint32_t lane;
};

struct WideContacts {
  explicit WideContacts(Memory* m)
      : pairs(m),
        points(m),
        velocity(m),
        displacement(m),
        shift(m),
        slot(m),
        body(m),
        start_x(m),
        start_q(m),
        place(m),
        colours(m),
        manifolds(m),
        buckets(m) {}

  Array<PairLanes> pairs;    // in the order of solving
  Array<PointLanes> points;  // [pairs' points] likewise

  // by solver body; 0 is nobody
  Array<BodyVelocity> velocity;
  Array<BodyVelocity> displacement;  // m, rad: of a pass over positions
  Array<BodyShift> shift;
  Array<std::uint32_t> slot;  // of the body

  Array<std::uint32_t> body;  // by slot: solver body, 0 where it does not matter
  Array<Vec3> start_x;        // m, by solver body: as the step began
  Array<Quat> start_q;
  Array<LanePlace> place;  // by row

  // scratch
  Array<std::uint64_t> colours;  // by solver body: bit c, a pair of colour c moves it
  struct Manifold {
    std::uint32_t row, points, bucket;
  };
  Array<Manifold> manifolds;
  Array<std::uint32_t> buckets;
};

/// Colours of pairs beyond this many are solved one pair at a time: a body with so many movable neighbours is rare.
inline constexpr std::uint32_t kColours = 64;

/// Lay this step's rows out in lanes, with the poses and velocities of the present. Allocates.
void pack(World& world, WideContacts& wide);
/// Bodies' velocities from the state, and back. The first marks all bodies as untouched, the second those that a solver
/// moved as touched.
void load_velocities(World& world, WideContacts& wide);
void store_velocities(World& world, const WideContacts& wide);
/// How far bodies have come, from the state.
void load_shifts(const World& world, WideContacts& wide);
/// Moves bodies by their displacements.
void displace(World& world, const WideContacts& wide);
/// Impulses, separations and velocities back into the rows.
void unpack(World& world, const WideContacts& wide);

}  // namespace carom
