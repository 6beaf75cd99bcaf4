// What a joint leaves free, as speeds: along which ways they move B's point, about which they turn B, as its bodies stand
// now, and how those ways change. Kinds that couple (pulley, gear) or lock a length alone (distance) have no such speeds.
#pragma once

#include "dynamics/body_state.h"
#include "dynamics/world.h"

namespace carom::dynamics {

/// Speeds of a joint are those of B relative to A, each of one axis:
///   hinge      TURN_X, rad/s, about A's x axis
///   slider     X, m/s, along A's x axis
///   ball       TURN_X, _Y, _Z: the angular velocity in A's frame
///   universal  TURN_Y about A's y axis, then TURN_Z about B's z axis
///   six axes   X, Y, Z that are free: of B's point in A's frame. Where all turns are free, as a ball; else the rates of
///              those turns of q = swing * twist that are not locked, @see axis_parts.h
/// All vectors in world axes.
struct Freedom {
  int count = 0;
  std::uint8_t axis[kAxes];  // of each speed; places come first
  int places = 0;            // so many of them are of places
  Vec3 way[kAxes];           // unit vectors but of swings: moves B's point along it, turns B about it

  Vec3 from_a, from_b;  // m, to B's point, from the centres of mass; of the world from anywhere

  bool turns(int k) const { return k >= places; }
  Vec3 move(const Real* speeds) const { return sum(0, places, speeds); }
  Vec3 turn(const Real* speeds) const { return sum(places, count, speeds); }

  /// Of B's angular acceleration beyond A's, what no rate of a speed accounts for.
  ///   sum of way' speed,   way' = omega x way where it stays with a body
  /// @param omega_a, omega_b  rad/s, world   @return rad/s^2, world
  Vec3 turning_bias(const Vec3& omega_a, const Vec3& omega_b, const Real* speeds) const;

  /// The speeds that two bodies have.
  /// @param parting  m/s, world: of B's point beyond what it had, were it fixed to A   @param omega  rad/s, of B beyond A's
  /// @param speeds   out, [count]; 0 along turns that agree with others
  void measure(const Vec3& parting, const Vec3& omega, Real* speeds) const;

 private:
  friend Freedom freedom_of(const World& world, const Joint& joint);
  Vec3 sum(int from, int to, const Real* speeds) const {
    Vec3 s = Vec3::zero();
    for (int k = from; k < to; ++k) s += speeds[k] * way[k];
    return s;
  }
  void add(int axis_of_it, const Vec3& along) {
    axis[count] = static_cast<std::uint8_t>(axis_of_it), way[count++] = along;
  }
  void add_swings(const JointAxes& axes, const JointEnds& ends, const Vec3& turned);

  bool last_is_of_b_ = false;  // a universal's second pin
  bool swings_ = false;        // ways of swing and twist, whose derivatives these make:
  Quat to_world_;              // A's frame
  Vec3 swing_;                 // rad, A's frame: the rotation vector (0, y, z)
};

/// Whether forces do not move it: the world, or a static, kinematic, disabled body, or one in quarantine.
inline bool is_held(const World& world, std::uint32_t body) {
  return body == kInvalid || !responds(world.scene, world.state, body);
}

/// Whether a kind has speeds.
inline bool has_freedom(JointKind kind) {
  return kind != JointKind::distance && !has_transmission(kind) && !is_coupling(kind);
}

/// Of a joint that has speeds.
/// @accuracy  rounding of poses; where all locks hold, what they are off by counts as a fixed place
Freedom freedom_of(const World& world, const Joint& joint);

/// The angular velocity of q = swing * twist. rad/s, as the axes of the outer frame
/// @param swing  rad, (0, y, z)   @param rates  rad/s, of the twist, of y and z
/// @accuracy  1e-15
Vec3 omega_of_angles(const Vec3& swing, const Vec3& rates);

}  // namespace carom::dynamics
