// Projected Gauss-Seidel: contacts are solved one after the other, again and again, each as if it were alone.
//
// Velocities: sweeps of friction and normals from the last substep's impulses, none of which pulls (velocity_iterations
// of them). Positions: sweeps that move apart what lies deeper than the position tolerance, a share at a time, without
// a trace in the velocities (position_iterations).   @source [Catto2005]
#pragma once

#include "dynamics/solver/solver.h"
