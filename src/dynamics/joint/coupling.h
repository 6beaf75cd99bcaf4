// Couplings: what they ask of their joints, and their rows in a step. What is done with rows is in coupled_rows.h.
#pragma once

#include <array>
#include <span>

#include "dynamics/joint/joint.h"
#include "dynamics/world.h"

namespace carom::dynamics {

/// Of a coupling's polynomial, at a place of the leader.
struct PolynomialAt {
  Real value, slope, bend;  // bend: its second derivative
};
PolynomialAt polynomial_at(const Coupling& coupling, Real leader);

/// Whether what is coupled of a joint is a slide; else it is a twist.
bool is_slide(const World& world, std::uint32_t joint);
/// Whether both joints of a coupling hold, so that it does.
bool couples(const World& world, const Joint& joint);

/// A body of a coupling, and how its row acts there: u = sum of d.v + w.omega.
struct CoupledBody {
  std::uint32_t body = kInvalid, solver = 0;  // slot; solver body
  bool moves = false;                         // impulses move it
  Real inv_mass = 0;                          // 1/kg
  Vec3 free = Vec3::zero();                   // 1 along axes on which it may move, else 0
  Mat3 inv_inertia = Mat3::zero();            // 1/(kg m^2), world
  Vec3 d = Vec3::zero(), w = Vec3::zero();    // world
};

/// A coupling in a step.
struct CoupledRow {
  static constexpr int kMostBodies = 4, kMostLocks = 2 * kMostEqualities, kMostOfAll = kMostLocks + 1;
  /// One of its two joints.
  struct Side {
    std::uint32_t joint = kInvalid, link = 0;  // slot; index in WideJoints::active
    int a = -1, b = -1;                        // in `bodies`; -1: the world
    Real at = 0, ahead = 0;                    // m or rad, as counted, and how far it goes on in the move to come
  };
  std::uint32_t joint = kInvalid;  // slot
  std::uint32_t link = 0;          // index in WideJoints::active
  Side follower, leader;
  int count = 0;
  std::array<CoupledBody, kMostBodies> bodies;
  Real error = 0;            // m or rad
  Real curve = 0;            // m/s or rad/s, as of JointRowLanes
  Real slope = 0, bend = 0;  // of the polynomial
  Real p = 0;                // N s or N m s, of the present substep
  Real again = 0;            // 1: half a substep's load comes before the move, half after; else 0
  Real effort = 0;           // N s or N m s, since the step began
  Real old_p = 0;            // before the move: the ledger's
  // Under sweeps: locks of both joints, then its own row, and how they are coupled: L D L^T by rows, 1/D in its diagonal
  int locks = 0;
  std::array<Real, kMostOfAll*(kMostOfAll + 1) / 2> factor{};

  std::span<const CoupledBody> ends() const { return {bodies.data(), static_cast<std::size_t>(count)}; }
};

}  // namespace carom::dynamics
