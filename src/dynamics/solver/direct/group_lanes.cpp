// A group whose velocities sweeps in lanes find, led onto its joints.
#include <algorithm>

#include "dynamics/solver/direct/cone_group.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/load.h"
#include "dynamics/solver/direct/yielding.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {

BodyVelocity& ConeGroup::in_lanes(const ConeBody& b) const { return world_.wide->velocity[world_.wide->body[b.slot]]; }

// Joints that hold again take contacts along, so that those are swept once more where that is to be seen: at least once, and as
// often as there is work for points of sweeps.
void ConeGroup::follow_lanes(Velocities& to, Real h, bool again) {
  constexpr Real kSeen = 0.1;  // of what contacts may overlap by
  if (!again) {
    turn_frames();
    for (ConeBody& b : bodies_of(problem_)) load_mass(world_, b);
    rest_.work = kWorkOfPoint * rest_.points / static_cast<std::uint64_t>(world_.plan->substeps);
  }
  for (ConeBody& b : bodies_of(problem_)) {
    const BodyVelocity& from = in_lanes(b);
    b.v = again ? Vec6(Vec3(from.v[0], from.v[1], from.v[2]), Vec3(from.omega[0], from.omega[1], from.omega[2]))
                : Vec6(s_.v[b.slot], s_.omega[b.slot]);
  }
  if (!again) stiffen(world_, problem_, link_row_, h, Borne::in_step);
  load_links(world_, problem_, link_row_, LinkPhase::settle, h);
  hold_forest(again ? Forest::as_it_began : Forest::anew);
  measure_links(problem_);
  problem_.most.steps = kAlways;
  if (!problem_.links.empty()) solve_yielding(problem_, kGiveOfDisplacements, 1, tolerance());
  find_lock_impulses(problem_);
  accumulate_links(world_, problem_, link_row_);
  Real most2 = 0;  // (m/s)^2
  for (const ConeBody& b : bodies_of(problem_)) {
    most2 = std::max(most2, speed2(b, b.v - b.unheld));
    const Vec3 v = b.v.linear(), omega = b.v.angular();
    BodyVelocity& in = in_lanes(b);
    for (int k = 0; k < 3; ++k) in.v[k] = v[k], in.omega[k] = omega[k];
    if (v == s_.v[b.slot] && omega == s_.omega[b.slot]) continue;
    world_.plan->touched[b.slot] = 1;
    to.v[b.slot] = v, to.omega[b.slot] = omega;
  }
  const std::uint64_t taken = work_ + kWorkOfContact * rest_.points;
  const bool is_seen = std::sqrt(most2) * h > kSeen * world_.scene.dials[Dial::position_tolerance];
  rest_.is_swept_again = rest_.points > 0 && is_seen && (!again || rest_.work >= taken);
  rest_.work -= std::min(rest_.work, taken);
  for (const ConeBody& b : bodies_of(problem_))
    world_.wide->swept_again[world_.wide->body[b.slot]] = rest_.is_swept_again;
}

}  // namespace carom::dynamics
