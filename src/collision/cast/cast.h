// Questions about motion: where a ray, a moving shape or a turning one first touches another. Every result is a bracket
// of the time of contact.
#pragma once

#include "collision/narrow/query.h"

namespace carom::collision {

/// hit: they touch within the motion. overlap: one is in the other already at its start. undecided: so near to
/// touching, or so slowly approaching, that neither was proven.
///
/// What counts where rounding hides the truth (within `slack`):
///   - A ray that grazes a surface, or runs along a side of it, is a hit. So a ray finds no gap between flush shapes.
///   - A shape that grazes, or slides flush over another, is a miss. Nothing stops it there.
///   - A motion that starts in touch is a hit at time 0 if it goes into what it touches. Along or away it is a miss.
enum class CastOutcome : std::uint32_t { miss, hit, overlap, undecided };

struct CastSettings {
  Real tolerance = 1e-6;  // width of the bracket wanted, as length of path, relative to the (smaller) bounding radius
  Real target = 0;        // m, >= 0: separation that counts as contact; of a time of impact also < 0: a depth
  int cap = 128;          // support evaluations of a ray or linear cast; distance queries of a time of impact
  bool routines = false;  // rays: use a closed form where the shape declares one that there is a routine for
  bool ignore_touched = false;  // what is touched or overlapped at the start is passed over
};

/// Contact begins at a time in [lower, upper]: before `lower` the separation exceeds the target, and within the bracket
/// it comes down to target + slack or less. A miss has no upper end (infinite); its `lower` is the end of the motion.
/// Points, normal: in the frame in which the poses were given, at time `time`.
struct CastResult {
  CastOutcome outcome = CastOutcome::miss;
  QueryStatus status = QueryStatus::exact_enough;  // of the bracket's width, as asked or not
  Real time = 0;  // in [lower, upper]; fraction of the motion, or s for a time of impact
  Real lower = 0, upper = kInfinity;
  Real separation = 0;          // m, at `time`; negative: depth of an overlap (shape casts)
  Real slack = 0;               // m, see above
  Vec3 normal = Vec3::zero();   // unit, from A (or the ray) to B; zero for a miss
  Vec3 point_a = Vec3::zero();  // m, on A's surface (of a ray: where it is)
  Vec3 point_b = Vec3::zero();  // m, on B's surface
  Vec3 plane = Vec3::zero();    // unit, from A to B: normal of the last plane that a time of impact asked for
  bool at_start = false;        // touched or overlapped at the start
  int iterations = 0, support_calls = 0;
};

}  // namespace carom::collision
