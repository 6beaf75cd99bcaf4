// Arithmetic of four bodies side by side that move and turn, compiled once for each width of registers.
//
// Lanes give the bits of the functions that they stand for. They take what bodies nearly always do, and leave the rest to
// those: far turns, places out of range.
#pragma once

#include <cstdint>
#include <span>

#include "dynamics/integrate/rotation/principal.h"

namespace carom::dynamics {

/// Where bodies are and how they move, by slot: Vec3, Quat.
struct Motions {
  const double *x, *v;                    // m, m/s
  const double *q, *omega;                // unit; rad/s, world
  const std::uint8_t* turned;             // a rotation method has turned it already; null: none
  const double *turned_q, *turned_omega;  // to this, by that: what its omega is more turns it on
  double *to_x, *to_q;
  double most_x;  // m: no component of a place is larger
};

/// Tops, by slot, as carry_tops() has them.
struct Tops {
  const Principal* principal;
  const double *q, *omega, *momentum;
  double *to_momentum, *to_omega, *predicted_q, *predicted_omega;
  double agree2;  // share of omega, squared: momentum and omega that differ by less belong together
};

/// Poses by slot, and those of as many bodies as are asked for, one after the other.
struct Shifts {
  const double *x, *q;
  const double *start_x, *start_q;  // of the four
  double* to;                       // [4][8]: x - start_x, the vector of q start_q^-1, its scalar, 0
};

/// Places and spins, by slot.
struct Leads {
  const double *x, *omega;
  double* to;  // [4][10] of the four: x, the vector of exp(h omega), its scalar, omega
};

/// The same functions for one width; same bits from each. Those that return false where lanes are not for one of the four
/// write nothing then.
struct TurnKernels {
  const char* name;
  /// x + h v, and exp(h omega) q.   @param body  [4] slots   @param h  s
  bool (*move)(const Motions& all, const std::uint32_t* body, double h);
  /// A step of splitting, of second order.
  bool (*split)(const Tops& all, const std::uint32_t* body, double h);
  void (*shift)(const Shifts& of, const std::uint32_t* body);
  bool (*lead)(const Leads& of, const std::uint32_t* body, double h);
};

/// The widest that this machine has.
const TurnKernels& turn_kernels();
/// All that this machine can run, the baseline first.
std::span<const TurnKernels* const> all_turn_kernels();

}  // namespace carom::dynamics
