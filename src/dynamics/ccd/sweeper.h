// A substep's sweeps: what each participant meets first, and what the contact does.
#pragma once

#include "dynamics/ccd/continuous.h"
#include "dynamics/contact/impact_points.h"
#include "dynamics/scenery.h"
#include "dynamics/sleep/sleep.h"

namespace carom::dynamics {

class Sweeper {
 public:
  Sweeper(const World& world, Sweeping to, const StepTime& time);
  void run();

 private:
  /// Bodies that go on as one.
  struct Whole {
    Real mass = 0;  // kg
    Vec3 centre = Vec3::zero(), v = Vec3::zero(), omega = Vec3::zero();
    Mat3 inertia = Mat3::zero();  // kg m^2, world, about its centre
  };
  /// One of two that meet.
  struct Side {
    std::uint32_t body, collider;
    SweptPart part;
    Path path;
    const SweptBody* known;  // null: it stands still, or has no path yet
    Whole whole{};           // at the moment of a hit, if it is joined
    bool is_joined() const { return known && known->is_joined(); }
  };
  /// Velocities at a moment of the substep, as the forces and hits so far have it.
  struct Velocity {
    Vec3 v, omega;  // m/s, rad/s, world
    Vec3 at(const Vec3& arm) const { return v + omega.cross(arm); }
  };
  struct FirstContact {
    Real when = kInfinity;  // s
    Vec3 normal, point;     // unit, A to B; m, world
  };
  struct Strike;
  // Of the slack, by how much what is as deep already may sink on in a substep.
  static constexpr Real kDeeper = 0.1;

  // sweep.cpp: paths, and who meets whom
  void lay_paths();
  void lay_path(SweptBody& b);
  void box_participants();
  void look_ahead(SweptBody& b, Real now);
  Aabb swept_box(const SweptBody& b, std::uint32_t collider, Real now);
  void gather(const SweptBody& b, const Aabb& box, Real now);
  bool goes_far(const SweptBody& b) const;
  void try_pair(SweptBody& b, Real now, std::uint32_t own, std::uint32_t other);
  SweptBody* next();
  void move_bodies();
  Path path_of(std::uint32_t body) const;
  std::uint32_t version_of(std::uint32_t body) const;
  bool moved_by_hits(std::uint32_t body) const;
  bool turns_by_own_method(std::uint32_t body) const;
  bool has_its_turn_later(std::uint32_t body) const;

  // sense.cpp: which sensors it passes
  void sense(SweptBody& b, Real to);
  bool passes(const SweptBody& b, std::uint32_t own, std::uint32_t other, Real from, Real to);

  // meet.cpp: when do two meet
  FirstContact meet(const Side& a, const Side& b, Real from, Real to);
  bool is_parted(const Side& a, const Side& b, Real from, Real to);
  bool is_slow(const Side& a, const Side& b, const FirstContact& m);
  bool is_at_seam(const Side& a, const Side& b, const FirstContact& m);
  Real thinner(const Side& a, const Side& b) const;
  Real slack(const Side& a, const Side& b) const;
  bool ends_above(const Side& a, const Side& b, Real time, Real allowed);
  Velocity velocity(const Side& side, Real moment, Real now);
  Vec3 turned(const Side& side, Real from, Real by, const Vec3& omega);

  // strike.cpp: what it does
  void strike(SweptBody& b);
  void go_on(SweptBody& b);
  void find_points(const Strike& s, const Side& b, Manifold& manifold);
  template <class F>
  void each_beside(const Strike& s, const F& f);
  void scenery_points(const SceneryPair& pair, const NarrowSettings& settings, const Vec3& normal, Manifold& manifold);
  ImpactBody body_of(const Side& side, Real now) const;
  bool exchange(Strike& s);
  void turn_off(Side& side, Strike& s, const Velocity& change);
  void brace(Strike& s);
  void wait_at(Strike& s);
  void aim(const Side& side, Real now);
  SweptBody* take_up(std::uint32_t body);

  // join.cpp: what goes on as one
  template <class F>
  void each_as_one(SweptBody& b, F&& f) {
    SweptBody* one = &b;
    do {
      SweptBody& now = *one;
      one = now.is_joined() ? &c_.bodies[now.next_as_one] : &b;
      f(now);
    } while (one != &b);
  }
  bool is_one_with(SweptBody& b, const SweptBody& other);
  bool is_movable(std::uint32_t body) const;
  bool may_meet(SweptBody& b, std::uint32_t other);
  Whole whole_of(SweptBody& b, Real now);
  void lay_whole(SweptBody& b, const Whole& whole, Real now);
  bool can_join(std::uint32_t body) const;
  void join(std::uint32_t other, SweptBody& b, SweptBody* partner, Real now);
  void hold(SweptBody& b, std::uint32_t carrier, Real now);

  const World& world_;
  Poses& poses_;
  Velocities& motion_;
  Sleepers sleep_;
  BroadPhases& broad_;
  StepReport& report_;
  Continuous& c_;
  StepTime time_;
  Real lag_, tolerance_;  // s; m, what is left unresolved
  bool filtered_;         // somebody is held apart
  bool listens_;          // a host asks what sensors see
};

}  // namespace carom::dynamics
