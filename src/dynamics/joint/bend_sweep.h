// How the errors of joints in lanes bend away from their tangents within a substep. Part of joint_sweeps.h.
#pragma once

#include "dynamics/joint/couple_rows.h"

namespace carom::dynamics {
namespace {

/// m/s^2: how the length of a rope bends, its far end being that of an arm.
CAROM_LANES_INLINE Lanes rope_bend(const JointRun& run, const std::uint32_t* body, const Side& side, const LaneVec& arm,
                                   const LaneVec& rope) {
  const LaneVec turns = cross(side.omega, arm), moves = side.v + turns;
  LaneVec inward = cross(side.omega, turns);
  if (run.gyro) {
    Side gyro;
    gyro.load(run.gyro, body);
    inward = inward - cross(gyro.omega, arm);
  }
  const Lanes far = square_root(dot(rope, rope)), inverse = inverse_or_zero(far > 1e-9 ? far : all(0));
  const Lanes out = inverse * dot(rope, moves);
  return (dot(moves, moves) - out * out) * inverse + inverse * dot(rope, inward);
}

/// Of a velocity of B's point at A's, what locks along A's axes leave: they undo the rest in the same substep.
CAROM_LANES_INLINE LaneVec as_locks_let(const JointRun& run, const JointLanes& joint, LaneVec parting) {
  const JointRowLanes* r = run.rows + joint.first;
  for (std::uint32_t k = 0; k < joint.layout.parts; ++k) {
    const JointPart part = joint.layout.part[k];
    const bool undoes = part == JointPart::line || part == JointPart::place_x || part == JointPart::place_y ||
                        part == JointPart::place_z;
    for (std::uint32_t rows = rows_of(part); rows > 0; --rows, ++r)
      if (undoes) parting = parting - dot(r->d, parting) * r->d;
  }
  return parting;
}

// With g the gap and d a direction that turns with A,
//   (d.g)'' = d''.g + 2 d'.g' + d.g'',   d' = w_a x d,
//   g'' = w_b x (w_b x r_b) - a_b x r_b - (w_a x (w_a x r_a) - a_a x r_a);
// for a distance |g|'' = (g'^2 - (d.g')^2) / |g| + d.g''. Angles are taken to be straight. a is how omega changes while
// nothing acts: what a rotation method carries is turned by the mean of its omega before and after, which is the one
// after, w, less h a / 2.
void bend(const JointRun& run, double h) {
  for (std::size_t i = 0; i < run.count; ++i) {
    const JointLanes& joint = run.joints[i];
    Side a, b;
    a.load(run.velocity, joint.a), b.load(run.velocity, joint.b);
    const LaneVec turns_a = cross(a.omega, joint.r_a), turns_b = cross(b.omega, joint.r_b);
    LaneVec inward = cross(b.omega, turns_b) - cross(a.omega, turns_a);
    if (run.gyro) {
      Side gyro_a, gyro_b;
      gyro_a.load(run.gyro, joint.a), gyro_b.load(run.gyro, joint.b);
      inward = inward - (cross(gyro_b.omega, joint.r_b) - cross(gyro_a.omega, joint.r_a));
    }
    // Beyond a radian a substep nothing is straight nor bends like a parabola: then less is asked for, not more.
    const Lanes half = (h / 2) / (1 + (h * h / 4) * (dot(a.omega, a.omega) + dot(b.omega, b.omega)));
    JointRowLanes* r = run.rows + joint.first;
    const LaneVec parting = (b.v + turns_b) - (a.v + turns_a), slides = as_locks_let(run, joint, parting);
    for (std::uint32_t k = 0; k < joint.layout.parts; ++k) {
      switch (joint.layout.part[k]) {
        case JointPart::point:
          r[0].curve = half * inward.x;
          r[1].curve = half * inward.y;
          r[2].curve = half * inward.z;
          r += 3;
          break;
        case JointPart::line:
        case JointPart::place_x:
        case JointPart::place_y:
        case JointPart::place_z:
          for (int l = joint.layout.part[k] == JointPart::line ? 0 : 1; l < 2; ++l, ++r) {
            const LaneVec d1 = cross(a.omega, r->d), d2 = cross(a.omega, d1);
            r->curve = half * (dot(d2, joint.gap) + 2 * dot(d1, slides) + dot(r->d, inward));
          }
          break;
        case JointPart::rod: {
          const Lanes closing = dot(r->d, parting), far = r->error + joint.length;
          const Lanes across = dot(parting, parting) - closing * closing;
          r->curve = half * (across * inverse_or_zero(far > 1e-9 ? far : all(0)) + dot(r->d, inward));
          r += 1;
          break;
        }
        case JointPart::orientation:
          r += 3;
          break;
        case JointPart::direction:
          r += 2;
          break;
        case JointPart::pins:
        case JointPart::turn_x:
        case JointPart::turn_y:
        case JointPart::turn_z:
        case JointPart::across_y:
        case JointPart::across_z:
        case JointPart::gears:
          r += 1;
          break;
        case JointPart::ropes: {
          const PullLanes& pull = *pull_of(run, joint);
          r->curve = half * (rope_bend(run, joint.a, a, joint.r_a, pull.rope_a) +
                             pull.ratio * rope_bend(run, joint.b, b, joint.r_b, pull.rope_b));
          r += 1;
          break;
        }
      }
    }
  }
}

}  // namespace
}  // namespace carom::dynamics
