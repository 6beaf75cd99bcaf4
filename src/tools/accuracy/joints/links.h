// Rods, balls and joints of accuracy scenes: bodies without colliders, which joints alone move.
#pragma once

#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

/// A thin rod of a length along x, or a ball, drawn but touching nothing.
/// @param inertia  kg m^2, principal, body axes   @return index into stage.actors
std::size_t add_link(Stage& stage, const std::string& kind, const Vec& position, double mass, const Vec& inertia,
                     const Part& looks, const Quat& orientation = Quat::Identity());
Vec inertia_of_rod(double length, double mass);
Vec inertia_of_ball(double radius, double mass);
std::size_t add_rod(Stage& stage, const Vec& position, double length, double mass);
std::size_t add_bob(Stage& stage, const Vec& position, double radius, double mass);

/// Join two bodies as they stand.   @param a, b  CAROM_NULL_HANDLE: the world   @param at  m, world
/// @param axes  joint -> world: a hinge turns about its x
carom_joint join(Stage& stage, std::uint32_t kind, carom_body a, carom_body b, const Vec& at,
                 const Quat& axes = Quat::Identity());

/// Energy of dynamic bodies without colliders, J: kinetic, and m g y.
class Mechanism {
 public:
  void add(std::size_t actor, double mass, const Vec& inertia) { members_.push_back({actor, mass, inertia}); }
  void add(carom_joint joint) { joints_.push_back(joint); }
  double energy(const Stage& stage) const;
  double worst_gap(const Stage& stage) const;  ///< m, of all joints

 private:
  struct Member {
    std::size_t actor;
    double mass;
    Vec inertia;
  };
  std::vector<Member> members_;
  std::vector<carom_joint> joints_;
};

}  // namespace carom::tools::accuracy
