// One group of one substep: solved, parted, settled.
#pragma once

#include "dynamics/solver/direct.h"

namespace carom::dynamics {

class ConeGroup {
 public:
  ConeGroup(const World& world, std::size_t group);
  /// As if nothing touched.
  static ConeGroup joints_of(const World& world, std::size_t group) {
    ConeGroup of(world, group);
    of.problem_.contacts = {}, of.joints_alone_ = true;
    return of;
  }

  /// Velocities with the impulses that the substep starts from; all there is to do where those are good enough.
  void begin(Velocities& to, Real h, std::uint64_t work);
  /// Of one that asks for a solve.   @param substeps  @see solve_groups()
  void solve(Velocities& to, Real h, int substeps);
  /// A group that overlaps more than the tolerance is parted, to half of it, so that what rests keeps in touch.
  void part(Poses& to, Real h);
  /// Once more, from where that has led.
  void part_again(Poses& to, Real h);
  /// Whether a sweep has led one of its bodies elsewhere in this substep.
  bool is_swept() const;
  /// Displacements that lead it back onto its joints, as far as it moves in a substep: what was swept stays where it is.
  void follow_swept(Poses& to, Real h);
  /// Velocities along what is locked, where the move has ended. Of groups that nothing touches: contacts, whose poses
  /// the solved velocities were to make good, are not asked twice.
  void settle(Velocities& to, Real h);
  void end();
  /// Velocities that lanes have found, led onto its joints.   @param again  @see hold_joints()
  void follow_lanes(Velocities& to, Real h, bool again);
  /// Spins of bodies that turn far, and that the solution has changed, led on to the end of the substep.
  /// @param scratch  of one participant
  void lead_on(Velocities& to, Real h, Participants& scratch);

  bool is_joined() const { return !problem_.joint_rows().empty(); }
  /// What joints and contacts bear is undetermined by the exact law.
  bool shares() const { return is_joined() && !problem_.contacts.empty(); }
  bool is_few() const { return rest_.is_few; }
  bool parts_now() const { return rest_.parts_now(); }
  /// Whether joints gape still, by less than half of what they did before they were parted: once more is worth it.
  bool is_nearer() const;
  /// Whether they gape by more than anybody is to see.
  bool gapes() const;

 private:
  template <class F>
  void each(F&& f) {
    for (std::size_t i = 0; i < problem_.contacts.size(); ++i) f(problem_.contacts[i], row_[i]);
  }
  void allow(std::uint64_t work);
  void allow_steps(std::uint32_t steps);
  void account_work();
  void accumulate_repeats();
  bool repeat(Velocities& to, Real tolerance);
  Real start(Real h);
  void follow_bodies();
  void follow_ground(Real h);
  void bend_ways(Real h);
  void bend_arms(Real h);
  Real loaded_speed2(const ConeBody& b) const;
  bool find_leads();
  /// The record of a row's pair, if its ground leads bodies of the group; else null.
  const TurningPair* led_by(std::uint32_t row) const;
  bool goes_round();
  void take_along(Real h);
  bool turns_far(const ConeBody& b, Real h) const;
  void lead_back(Real h);
  enum class Forest { as_it_began, anew };
  void hold_forest(Forest forest);
  void hold_forest_again();
  void follow_impulses();
  void find(Real h, Real goal);
  Real give_of_sweeps(Real h) const;
  void find_without_work(Real h, Real goal);
  void find_yielding(Real forgets, Real goal);
  void yield_more(Real goal);
  void find_exact(Real goal);
  void find_shares(Real goal);
  Real tolerance() const;
  Real goal(bool is_bounded, Real h) const;
  std::uint64_t own_work(std::uint64_t most) const;
  std::uint64_t work_of_substep(std::uint32_t substeps) const;
  bool takes_all_of(std::uint64_t work) const;
  void go_on_by_sweeps(Velocities& to, Real h);
  void sweep_on(Real h);
  void find_solution(Real h, std::uint64_t work);
  void finish(Velocities& to);
  bool lies_still() const;
  bool is_far_off() const;
  void measure_energy();
  bool may_be_held() const;
  void hold();
  bool stands() const;
  void stop();
  void look_for_change();
  bool stands_on(Velocities& to);
  void catch_up(Velocities& to, Real h, std::uint64_t work);
  bool is_still_at_rest(Real goal);
  bool comes_to_rest(Real goal);
  bool was_solved() const;
  bool gives_energy();
  bool is_sound();
  void keep(Velocities& to);
  bool may_contradict() const;
  Real tolerable_gap() const;
  Real most_closed(Real h) const;
  BodyVelocity& in_lanes(const ConeBody& b) const;
  Real asked() const;
  void part(Poses& to, Real h, Real most_closed, Forest forest);
  Real displacement_share(Real asked, Real most_closed) const;
  void let_locks_yield();
  void turn_frames();
  Real measure();
  void load(ConeBody& b) const { b.v = {s_.v[b.slot], b.is_led_back ? b.begun : s_.omega[b.slot]}; }
  void store(Velocities& to, ConeBody& b);

  const World& world_;
  Contacts& c_;
  const State& s_;
  GroupRest& rest_;
  ConeSolution& solution_;
  ConeProblem problem_;
  const std::uint32_t* row_;
  const DirectGroups::LinkRow* link_row_;
  std::size_t group_;
  std::uint64_t work_;
  bool was_held_ = false;  // all its bodies were at rest, to the bit, as the substep began
  bool is_led_ = false;    // by ground that turns
  bool follows_ = false;   // what a sweep has led elsewhere
  bool joints_alone_ = false;
  bool lasts_ = false;  // contacts start the next substep from impulses that balance its loads
};

}  // namespace carom::dynamics
