// Couplings: rows that hold the coordinate of one joint to a polynomial of another's. Such a row acts on up to four bodies,
// so it stands beside the lanes, one by one.
//
//     q = f(p):   u = q' - f'(p) p'   is the rate of the error q - f(p)
//
// Under sweeps a coupling is solved together with what its two joints lock: else each would undo what the other does.
#pragma once

#include "dynamics/joint/joint.h"

namespace carom::dynamics {

class World;

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

}  // namespace carom::dynamics
