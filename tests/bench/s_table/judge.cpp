// Penetration by sweep along x and Carom's exact distance on the generic path; energy, escape and fall from the states.
#include "judge.h"

#include <algorithm>
#include <cmath>

namespace carom::bench {
namespace {

bool is_finite(const BodyState& s) {
  return vec(s.position).allFinite() && quat(s.orientation).coeffs().allFinite() && vec(s.velocity).allFinite() &&
         vec(s.omega).allFinite();
}

}  // namespace

Judge::Judge(const Plan& plan) : plan_(plan) {
  for (const JointPlan& joint : plan.joints()) joined_.insert(std::minmax(joint.a, joint.b));
}

Verdict Judge::judge(const std::vector<BodyState>& states, double time) const {
  const tools::Stage& stage = plan_.stage();
  const Vec gravity = vec(plan_.world(false).gravity);
  Verdict v;
  std::vector<std::size_t> shaped;  // finite bodies with a shape
  std::vector<Vec> positions;
  std::size_t dynamic = 0;
  for (std::size_t i = 0; i < states.size(); ++i) {
    const BodyState& s = states[i];
    const Member& body = plan_.members()[i];
    positions.push_back(vec(s.position));
    if (!is_finite(s)) {
      ++v.lost;
      continue;
    }
    if (body.shape != CAROM_NULL_HANDLE) shaped.push_back(i);
    if (body.is_static) continue;
    ++dynamic;
    const Vec omega_b = quat(s.orientation).conjugate() * vec(s.omega);
    v.mean_energy += 0.5 * body.mass * vec(s.velocity).squaredNorm() + 0.5 * omega_b.dot(body.inertia * omega_b);
    v.escaped += (positions[i].array() < stage.bounds_min.array()).any() ||
                 (positions[i].array() > stage.bounds_max.array()).any();
    if (body.shape == CAROM_NULL_HANDLE) {
      const tools::Actor& start = stage.actors[i];
      const Vec parabola = start.position + time * start.linear_velocity + 0.5 * time * time * gravity;
      v.flight_error = std::max(v.flight_error, (positions[i] - parabola).norm());
    }
  }
  if (dynamic) v.mean_energy /= static_cast<double>(dynamic);
  judge_overlap(states, shaped, v);
  judge_joints(states, v);
  v.standing = tools::standing(stage, positions);
  return v;
}

/// Joints' points are told in principal frames: back to those of the bodies, about their centres.
void Judge::judge_joints(const std::vector<BodyState>& states, Verdict& v) const {
  const auto end = [&](std::size_t i, const double(&on)[3]) {
    const Member& body = plan_.members()[i];
    return Vec(vec(states[i].position) + quat(states[i].orientation) * (body.center + body.axes * vec(on)));
  };
  for (const JointPlan& joint : plan_.joints()) {
    const double gap = (end(joint.b, joint.on_b) - end(joint.a, joint.on_a)).norm();
    v.max_gap = std::max(v.max_gap, gap);
    v.mean_gap += gap / static_cast<double>(plan_.joints().size());
  }
}

/// @param order  bodies to judge; sorted by the lower ends of their bounding spheres along x, half-spaces first
void Judge::judge_overlap(const std::vector<BodyState>& states, std::vector<std::size_t>& order, Verdict& v) const {
  const std::vector<Member>& bodies = plan_.members();
  std::vector<double> lower(states.size());
  const auto is_plane = [&](std::size_t i) { return bodies[i].solid == Solid::half_space; };
  for (std::size_t i : order) lower[i] = is_plane(i) ? -HUGE_VAL : states[i].position[0] - bodies[i].radius;
  std::sort(order.begin(), order.end(), [&](auto a, auto b) { return lower[a] < lower[b]; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t a = order[i];
    for (std::size_t j = i + 1; j < order.size(); ++j) {
      const std::size_t b = order[j];
      if (!is_plane(a) && lower[b] > states[a].position[0] + bodies[a].radius) break;
      if (bodies[a].is_static && bodies[b].is_static) continue;
      const double reach = bodies[a].radius + bodies[b].radius;
      if (!is_plane(a) && (vec(states[a].position) - vec(states[b].position)).squaredNorm() > reach * reach) continue;
      if (joined_.count(std::minmax(a, b))) continue;
      const double depth = -separation(states[a], bodies[a].shape, states[b], bodies[b].shape);
      if (depth <= 0) continue;
      ++v.overlaps;
      v.mean_penetration += depth;
      v.max_penetration = std::max(v.max_penetration, depth);
    }
  }
  if (v.overlaps) v.mean_penetration /= static_cast<double>(v.overlaps);
}

double Judge::separation(const BodyState& a, carom_shape shape_a, const BodyState& b, carom_shape shape_b) const {
  const Quat qa = quat(a.orientation).normalized(), qb = quat(b.orientation).normalized();
  carom_distance result;
  result.struct_size = sizeof result;
  tools::Call call;
  call.done(carom_shape_distance(plan_.stage().engine().get(), shape_a, a.position, qa.coeffs().data(), shape_b,
                                 b.position, qb.coeffs().data(), nullptr, &result, call),
            "measuring a pair");
  return result.separation;
}

}  // namespace carom::bench
