// Drives of the joints of one island in one step: which are rows, and what the others do as forces.
//
// A motor and friction ask for a velocity without end, within what they may give; a limit for a place, by a push alone.
// Each is a row while it bears what that takes, and else a force that does not change, or nothing. A step decides as it
// begins, by what they bore last. Where one is found to bear too much, or to pull, the step is done again without it: so
// no step ends with a motor above its bound, and a change of mode costs a try, not the step's order.
//
// Springs are forces; so are dampers as a stage begins. As it ends they are soft rows, for the velocity that they read is
// the one that they lead to: p = -c h / 2 (u - speed). So a stage stays symmetric, and creep is what it should be. Stages
// that go back would let what decays fast grow (c h / 2 m > 0.5): those islands take as many of order 2, up to 16 times as
// many, so that none turns a velocity round. What decays faster is the solver's.
#pragma once

#include <span>

#include "dynamics/joint/rattle/motion.h"
#include "dynamics/joint/rattle/rows.h"

namespace carom::dynamics::rattle {

class Driving {
 public:
  Driving(const World& world, Rattle& r, RattleIsland& island) : world_(world), r_(r), island_(island) {}

  /// As a step begins, rows of locks being where bodies are: rows of drives join them.   @param h  s, the longest stage
  /// @return false: the step is not to be tried so, @see RattleIsland::is_barred, is_changed
  bool decide(Real h) const;
  /// Forces where bodies are, added to what forces do.
  /// @param ends  the stage: what is a soft row then leaves its damping to that
  void pull(bool ends) const;
  /// What they did, to what joints bear.
  void tell(Real share) const;
  /// @param softly  those of a stage's end alone, too
  void tell_rows(bool softly) const;
  /// How far drives are from where what they do ends: motors that push from their speed, limits from being met.
  void look() const;
  /// Likewise as a substep ends.   @see RattleIsland::event   @param begun, whole  of the part of the step: where it began, its length
  /// @return false: one of them was passed
  bool look_back(Real begun, Real whole) const;
  /// As a step begins: a motor that its velocity would ask too much of in h is not there yet.
  bool reach(Real h) const;
  /// Rows that can't all be held: motors among them are no rows any more; where there are but limits, the step is the solver's.
  /// @return whether there are any
  bool give_way() const;
  /// What rows bear on the way of a stage, by impulses of half of it.   @param is_first  a part of a step begins
  void look_at_loads(Real half, bool is_first) const;
  /// As a substep ends: what is a row bears no more than it may. Where that goes up and down by more within a stage and is less
  /// in the mean, bodies turn too far in it to tell: it is taken in halves, and of the shortest the mean counts.
  /// @param begun, whole  as of look_back()
  bool bears(Real begun, Real whole) const;
  /// Likewise of soft rows.   @param half  s, of a stage
  bool soft_rows_bear(Real half) const;

  /// Along a drive, between two poses.
  Placed::Along along(const Placed& placed, const RattleJoint& j, const RattleDrive& d) const {
    return placed.along(d.row, world_.joints.joint[j.slot].turn.target);
  }
  /// f(drive) of a joint's rows beside its locks, in their order.
  template <class F>
  void each_row(const RattleJoint& j, F&& f) const {
    if (j.rows > j.locks) each_by(j, RattleDrive::By::row, f);
  }
  template <class F>
  void each_soft_row(const RattleJoint& j, F&& f) const {
    if (j.soft_rows > 0) each_by(j, RattleDrive::By::soft_row, f);
  }
  /// m or rad, of a row, where a stage may lead.
  Real error(const RattleJoint& j, const RattleDrive& d, const Placed& next) const {
    if (d.row.coordinate < kFirstTurn) {
      const Real off = along(d.law == RattleDrive::Law::motor ? next.without_whole_turns() : next, j, d).at - d.goal;
      return is_angle(d.row) ? nearest_turn(off, 0) : off;
    }
    const Quat from = apart_of(j, now(r_.bodies[j.a]), now(r_.bodies[j.b]));  // how it has turned since then
    return turn_of(apart_of(j, next.a, next.b) * from.conjugate())[d.row.coordinate - kFirstTurn] - d.goal;
  }
  /// Where a motor is to be after h, from where it is. A limit is to stay.
  Real goal(const RattleJoint& j, const RattleDrive& d, const Placed& at) const {
    if (d.law == RattleDrive::Law::limit) return d.goal;
    return d.row.coordinate < kFirstTurn ? along(at.without_whole_turns(), j, d).at : 0;
  }

 private:
  template <class F>
  void each_by(const RattleJoint& j, RattleDrive::By by, F&& f) const {
    for (std::uint32_t k = j.drive; k < j.drive + j.drives; ++k)
      if (r_.drives[k].by == by) f(r_.drives[k]);
  }
  static bool is_angle(const DriveRow& row) {
    return row.coordinate == static_cast<int>(Coordinate::twist) || row.coordinate >= kFirstAxis + int(kPlaces);
  }
  std::span<RattleJoint> joints() const { return {r_.joints.data() + island_.joint, island_.joints}; }
  std::span<RattleDrive> drives(const RattleJoint& j) const { return {r_.drives.data() + j.drive, j.drives}; }
  bool decide(RattleJoint& j, Real h) const;
  static Real left_of(const RattleDrive& d);
  int ends_of(const RattleJoint& j, const RattleDrive& d, Real h, Real apart[2]) const;
  /// @param p  N s or N m s
  void tell(RattleJoint& j, const Vec3& d, const Vec3& w_a, const Vec3& w_b, Real p) const;
  void pull(RattleJoint& j, bool ends) const;
  bool follows(const RattleDrive& d, Real rest, Real h) const;
  bool is_there(const RattleDrive& d, Real off, Real most, Real h) const;

  const World& world_;
  Rattle& r_;
  RattleIsland& island_;
};

/// Velocity at one row per impulse at another of the same joint.
inline Real response(const RattleJoint& j, const RattleRow& at, const RattleRow& by, const RattleBody& a,
                     const RattleBody& b) {
  const Real turned = at.w_a.dot(by.i_a) + at.w_b.dot(by.i_b);
  if (j.two_ways) return j.d_a.dot(speed_of(a, j.d_a)) + at.d.dot(speed_of(b, by.d)) + turned;
  if (a.locks | b.locks) return at.d.dot(speed_of(a, by.d) + speed_of(b, by.d)) + turned;
  return (a.inv_mass + b.inv_mass) * at.d.dot(by.d) + turned;
}
/// m/s or rad/s, of a row.
inline Real rate_of(const RattleJoint& j, const RattleRow& row, const Vec3& v_a, const Vec3& omega_a, const Vec3& v_b,
                    const Vec3& omega_b) {
  const Real turning = row.w_b.dot(omega_b) - row.w_a.dot(omega_a);
  return (j.two_ways ? row.d.dot(v_b) - j.d_a.dot(v_a) : row.d.dot(v_b - v_a)) + turning;
}
inline Real rate_of(const RattleJoint& j, const RattleRow& row, const RattleBody& a, const RattleBody& b) {
  return rate_of(j, row, a.v, a.omega, b.v, b.omega);
}
/// Along which A is pushed by a row, the other way.
inline const Vec3& way_at_a(const RattleJoint& j, const Vec3& d) { return j.two_ways ? j.d_a : d; }

}  // namespace carom::dynamics::rattle
