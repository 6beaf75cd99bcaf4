// Couplings: rows that hold the coordinate of one joint to a polynomial of another's. Such a row acts on up to four bodies,
// so it stands beside the lanes, one by one.
//
//     q = f(p):   u = q' - f'(p) p'   is the rate of the error q - f(p)
//
// Under sweeps a coupling is solved together with what its two joints lock: else each would undo what the other does.
#pragma once

#include <span>

#include "dynamics/joint/joint.h"
#include "dynamics/joint/joint_lanes.h"
#include "dynamics/world.h"

namespace carom::dynamics {

struct WideJoints;

/// Of a coupling's polynomial, at a place of the leader.
struct PolynomialAt {
  Real value, slope, bend;  // bend: its second derivative
};
PolynomialAt polynomial_at(const Coupling& coupling, Real leader);

/// Whether what is coupled of a joint is a slide; else it is a twist.
bool is_slide(const World& world, std::uint32_t joint);
/// m or rad: the coordinate of a joint that is coupled, as counted; and by how much a coupling is off.
/// @accuracy  rounding of poses
Real coupled_coordinate(const World& world, std::uint32_t joint);
Real coupling_error(const World& world, const Coupling& coupling);

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

/// Rows of this step, of couplings that are active. After lanes are filled, before they are placed. Allocates.
void begin_couplings(const World& world, Real h);
/// Where bodies are now. After lanes are placed.
void place_couplings(const World& world);
/// How errors bend within a substep. After lanes' rows.
void bend_couplings(const World& world, Real h);
/// Where they are led in a substep of h.
void aim_couplings(const World& world, Real h);

/// Sweeps over those that lanes sweep, after lanes' own.
void start_couplings(const World& world);  // from the impulses kept
void solve_couplings(const World& world);
void relax_couplings(const World& world);
void act_again_by_couplings(const World& world);

/// Impulses and efforts back into the joints.
void end_couplings(const World& world, Joints& joints, Real dt);

/// Whether both joints of a coupling hold, so that it does.
bool couples(const World& world, const Joint& joint);

}  // namespace carom::dynamics
