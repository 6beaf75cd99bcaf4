// Contacts of four pairs side by side, as the kernels see them: plain data.
//
// Files that are compiled for newer machines include this and core/wide.h, so neither may have anything that the linker
// could take for the whole library: no inline function but those that are inlined always, no template of others.
#pragma once

#include <cstddef>

#include "core/wide.h"

namespace carom::dynamics {

/// What a solver reads and writes of a body: one cache line. Body 0 is none: what does not move has no mass here.
/// Kinematic bodies come next: read by many pairs of a colour, written by none.
struct alignas(64) BodyVelocity {
  double v[3] = {0, 0, 0};      // m/s, world
  double omega[3] = {0, 0, 0};  // rad/s, world
  double unused[2] = {0, 0};
};

/// How far a body has come since the step began.
struct alignas(64) BodyShift {
  double x[3] = {0, 0, 0};  // m, world
  double u[3] = {0, 0, 0};  // axis times sin of half the angle of the turn, world
  double w = 1;             // cos of half the angle
  double unused = 0;
};

/// How a body turns in a substep, for what it takes round: @see turning_ground.h
struct alignas(16) BodyTurn {
  double x[3] = {0, 0, 0};      // m, world
  double u[3] = {0, 0, 0};      // axis times sin of half the angle by which it turns, world
  double w = 1;                 // cos of half the angle
  double omega[3] = {0, 0, 0};  // rad/s, world
};

inline constexpr int kPairPoints = 4;
inline constexpr int kCouplings = kPairPoints * (kPairPoints - 1) / 2;

/// One point of each of four pairs. Impulses act on B, and on A the other way.
template <class Number>
struct PointLanesOf {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  LaneVec d;         // m, world axes: from where the pair's friction acts, as the step began
  Lanes gap;         // m, separation as the step began
  Lanes separation;  // m, now
  Lanes reach;       // m, |d|; where the pair slides, mean distance of what it stands for: @see twist_share()
  Lanes m_n;         // kg, normal impulse per change of velocity; 0: an empty lane
  Lanes p_n;         // N s, of the present substep
  Lanes sum_n;       // N s, of the step
  LaneVec n;         // unit, world, A to B; @see PairLanes::one_normal
};

/// Four pairs of one colour. Friction is solved once a pair, a force in the plane and a twist about the normal: of
/// what sticks at the middle of its points, within bounds apart, of what slides at the middle of its loads as the step
/// began, within one limit surface (rub()). The second tangent is n x t.
template <class Number>
struct PairLanesOf {
  using Lanes = LanesOf<Number>;
  using LaneVec = LaneVecOf<Number>;
  using LaneSymmetric = LaneSymmetricOf<Number>;
  std::uint32_t a[kLanes], b[kLanes];          // solver bodies; 0: none, or none that moves
  std::uint32_t first, points;                 // in WideContacts::points
  std::uint32_t one_normal;                    // 1: all points of each pair have its n, and PointLanes::n is not read
  std::uint32_t driven, locked;                // in LaneRun::drives and locks, from 1; 0: none of the four is
  std::uint32_t slides;                        // 1: one of the four does
  Lanes inv_mass_a, inv_mass_b;                // 1/kg
  LaneSymmetric inv_inertia_a, inv_inertia_b;  // 1/(kg m^2), world, as the step began
  LaneVec n, t;                                // unit, world
  LaneVec r_a, r_b;                            // m, from the centres of mass to where friction acts
  Lanes radius_a, radius_b;                    // m, core radii, @see RowGeometry
  Lanes friction;
  Lanes bounce_speed;                          // m/s, what closes faster bounces; infinite: nothing does
  Lanes bias_rate, mass_scale, impulse_scale;  // softness, @see soft_step.h
  Lanes thickness;                             // m, of the thinner of the two; infinite in an empty lane
  Lanes pull;                                  // m/s^2, by gravity on what it pulls harder
  Lanes m_tt, m_ts, m_ss;                      // kg, impulse per change of velocity in the plane
  Lanes m_w;                                   // kg m^2, likewise of the twist
  Lanes slide;                                 // above 0: slides as the step began, @see Row::slides; 0: sticks
  Lanes k_slide;                               // 1/kg, most response in the plane; set only where a pair slides
  Lanes p_t, p_s, p_w;                         // N s, N m s, of the present substep
  Lanes sum_t, sum_s, sum_w;                   // of the step
  Lanes coupling[kCouplings];  // 1/kg: normal velocity at one point per normal impulse at another: 01 02 12 03 13 23
};

/// Four pairs of which some have a surface that moves of itself, or ground that turns: what B's does relative to A's,
/// beside the bodies.
template <class Number>
struct DriveLanesOf {
  using Lanes = LanesOf<Number>;
  Lanes t, s;              // m/s, along the tangents, where friction acts
  Lanes w;                 // rad/s, about the normal
  Lanes own_t, own_s;      // m/s, of t and s: what the surface does; the rest is the lead of this substep
  Lanes share_a, share_b;  // of the turns of A and B, in the lead; 0 where the ground does not turn
};

/// Four pairs or joints of which some have a body that is locked along world axes: 1 where it is free, 0 where not.
template <class Number>
struct LockLanesOf {
  using LaneVec = LaneVecOf<Number>;
  LaneVec free_a, free_b;
};

/// A run of pairs with their points and all bodies.
template <class Number>
struct LaneRunOf {
  PairLanesOf<Number>* pairs;
  std::size_t count;
  PointLanesOf<Number>* points;
  BodyVelocity* velocity;
  const BodyShift* shift;
  std::uint32_t first_moved;  // bodies below are not written
  DriveLanesOf<Number>* drives;
  const LockLanesOf<Number>* locks;
};

/// Where the rows of four pairs are found when lanes are filled, all in doubles: vectors of three, matrices of nine,
/// column by column. Empty lanes find zeros.
struct LaneSources {
  const double *rotation_a[kLanes], *rotation_b[kLanes];        // world from body axes
  const double *held_a[kLanes], *held_b[kLanes];                // @see held_arms.h
  const double *inv_inertia_a[kLanes], *inv_inertia_b[kLanes];  // 1/(kg m^2), world
  const double *x_a[kLanes], *x_b[kLanes];                      // m
  const double *row[kLanes], *geometry[kLanes];                 // Row, RowGeometry of the first point
  Lanes inv_mass_a, inv_mass_b;                                 // 1/kg
  Lanes to_b;                                                   // @see Arms
  Lanes friction;
  Lanes slide;         // @see Row::slides: 1; 2 where it rubs by load, 0 where it sticks
  Lanes bounce_speed;  // m/s
  Lanes thickness;     // m
  Lanes pull;          // m/s^2
};
/// Where the rows of four pairs are put back, and what of their bodies that takes. Empty lanes find zeros and are
/// put nowhere.
struct LaneTargets {
  const double *rotation_a[kLanes], *rotation_b[kLanes];  // world from body axes
  const double *x_a[kLanes], *x_b[kLanes];                // m
  const double *v_a[kLanes], *v_b[kLanes];                // m/s
  const double *omega_a[kLanes], *omega_b[kLanes];        // rad/s
  const double *row[kLanes], *geometry[kLanes];           // Row, RowGeometry of the first point
  double *to_row[kLanes], *to_geometry[kLanes];           // the same, or null
};
/// The points of one pair side by side, for solvers that go pair by pair: what of its rows and bodies says where they
/// are and how they move. All in doubles; lanes beyond its points repeat the first.
struct PointSources {
  const double *rotation_a, *rotation_b;        // world from body axes
  const double *held_a, *held_b;                // @see held_arms.h
  const double *inv_inertia_a, *inv_inertia_b;  // 1/(kg m^2), world; zeros where impulses do not turn it
  const double *x_a, *x_b;                      // m
  const double *v_a, *v_b;                      // m/s
  const double *omega_a, *omega_b;              // rad/s
  const double* surface[kLanes];                // m/s, what B's does relative to A's by itself
  const double *row[kLanes], *geometry[kLanes];
  double inv_mass_a, inv_mass_b;  // 1/kg; 0 where impulses do not move it
  double to_b;                    // @see Arms
};
/// Where they are.
struct PointPlaces {
  LaneVec r_a, r_b;  // m, from the centres of mass, as the bodies are held
  Lanes response;    // 1/kg, mean velocity at the point per impulse there
};
/// What they do and bear.
struct PointMotions {
  Lanes closing;   // m/s along the normal
  Lanes response;  // 1/kg, normal velocity per normal impulse
  Lanes p_n;       // N s, normal impulse that the substep starts from
};

// In those, counted in doubles (wide_contacts.cpp holds them to it).
inline constexpr int kRowNumbers = 24, kRowVelocity = 0, kRowNormal = 3, kRowImpulse = 16, kRowTwistShare = 21;
inline constexpr int kGeometryNumbers = 17, kGeometryA = 0, kGeometryB = 3, kGeometryRadiusA = 6, kGeometryRadiusB = 7,
                     kGeometryImpulse = 8, kGeometrySeparation = 14;

using PairLanes = PairLanesOf<double>;
using PointLanes = PointLanesOf<double>;
using LockLanes = LockLanesOf<double>;
using LaneRun = LaneRunOf<double>;

}  // namespace carom::dynamics
