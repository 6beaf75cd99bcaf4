// Which velocity moves what slides and rolls.
//
// A body in contact moves by the velocity that its solver left, v1, for that one is admissible; the one before may lead
// into the floor. That is of first order: what friction slows is ahead by half of what a substep changes, v h / 2 in
// all. Where what a contact bears does not depend on where the body is, its velocity changes evenly, and it moves by
// the mean:
//
//   x1 = x0 + h (v1 + c),   c = the part of -(v1 - v0) / 2 by which no contact would move     likewise omega
//
// What must not move is the distance at each point that is shut, and the place of each that sticks (that slides, before
// or after, by less than half of what the substep changed). c is projected on what those leave, in the metric of the
// masses: of a block that slides on the level or down a slope in the plane, of a ball all that it skids and rolls by,
// of what rests nothing.
//
// Not of what tips, whose weight has another arm in the next substep, nor on what is curved, which bears another way:
// there the velocity of the end makes up for forces that are those of the beginning (as semi-implicit Euler does), and
// the mean would gain energy. For groups of a few bodies; in a heap other errors are larger.
//
// @oracle  tests/oracle/test_contact_laws, test_surface_velocity; carom accuracy run slide, slip
#pragma once

#include "dynamics/effects.h"

namespace carom::dynamics {

struct MeanMotion {
  explicit MeanMotion(Memory* m) : bodies(m), points(m), groups(m) {}

  struct Body {
    std::uint32_t slot;
    Vec3 v, omega;                // m/s, rad/s: v1, while the state has v1 + c
    Vec3 v_change, omega_change;  // c
  };
  struct Point {
    std::uint32_t row, a, b;  // bodies, by index in their group; kInvalid: it does not move
  };
  struct Group {
    std::uint32_t body, point;  // where its own begin
    bool is_moved = false;      // by c, in this substep
    bool is_first = true;       // nothing of this step was looked at yet
    bool is_curved = false;     // normals are no longer what velocities were made for: no body is moved so in this step
  };

  Array<Body> bodies;   // by group
  Array<Point> points;  // by group
  Array<Group> groups;  // and one more, where all end
};

/// Groups that move so, once they are known. Allocates.
void find_small_groups(const World& world, Owned<MeanMotion>& mean_motion);
/// After a solver: c of each body.
void find_mean_motion(const World& world, const StepTime& time);

/// While it lives, velocities of such bodies in the state are v1 + c. What puts one in quarantine stays.
class MeanVelocities {
 public:
  MeanVelocities(const World& world, Velocities& to);
  ~MeanVelocities();
  MeanVelocities(const MeanVelocities&) = delete;
  MeanVelocities& operator=(const MeanVelocities&) = delete;

 private:
  const World& world_;
  Velocities& to_;
};

}  // namespace carom::dynamics
