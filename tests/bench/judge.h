// Judges a heap of bodies from its poses alone, the same way whichever engine put them there.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "scenes/scene.h"

namespace carom::bench {

using tools::Quat;
using tools::Vec;

struct BodyState {
  Vec position = Vec::Zero();  // m, world: origin of the body frame
  Quat orientation = Quat::Identity();
  Vec velocity = Vec::Zero();  // m/s, world, of the centre of mass
  Vec omega = Vec::Zero();     // rad/s, world
};

struct Verdict {
  double max_penetration = 0;   // m, over pairs of bodies
  double mean_penetration = 0;  // m, over the pairs that overlap
  std::size_t overlaps = 0;     // pairs of bodies that overlap
  double mean_energy = 0;       // J, kinetic, a dynamic body
  std::size_t escaped = 0;      // bodies outside the stage's bounds
  std::size_t lost = 0;         // bodies whose state is not finite; in no other number
};

/// Knows the shapes of a stage whose actors have one part each, at the body's origin, with the centre of mass there.
class Judge {
 public:
  explicit Judge(tools::Stage& stage) : stage_(stage) {
    for (const tools::Actor& actor : stage.actors) {
      const tools::Part& part = actor.parts.at(0);
      Body body;
      body.is_static = actor.type == CAROM_BODY_STATIC;
      body.is_plane = part.shape == "half_space";
      body.shape = body.is_plane ? stage.engine().half_space(part.params.data(), part.params.at(3))
                                 : stage.engine().shape(part.shape, part.params);
      const carom_shape_info info = stage.engine().info(body.shape);
      body.radius = info.bounding_radius;
      body.mass = part.density * info.volume;
      body.inertia = part.density * Eigen::Map<const Eigen::Matrix3d>(info.inertia);
      bodies_.push_back(body);
    }
  }

  double mass(std::size_t actor) const { return bodies_[actor].mass; }

  /// @param states [actors] of the stage, in its order
  Verdict judge(const std::vector<BodyState>& states) const {
    Verdict v;
    std::vector<std::size_t> order;  // finite bodies by the lower end of their bounding spheres along x; planes first
    std::vector<double> lower(states.size());
    std::size_t dynamic = 0;
    for (std::size_t i = 0; i < states.size(); ++i) {
      const BodyState& s = states[i];
      const Body& body = bodies_[i];
      if (!s.position.allFinite() || !s.orientation.coeffs().allFinite() || !s.velocity.allFinite() ||
          !s.omega.allFinite()) {
        ++v.lost;
        continue;
      }
      lower[i] = body.is_plane ? -HUGE_VAL : s.position.x() - body.radius;
      order.push_back(i);
      if (body.is_static) continue;
      ++dynamic;
      const Vec omega_b = s.orientation.conjugate() * s.omega;
      v.mean_energy += 0.5 * body.mass * s.velocity.squaredNorm() + 0.5 * omega_b.dot(body.inertia * omega_b);
      v.escaped += (s.position.array() < stage_.bounds_min.array()).any() ||
                   (s.position.array() > stage_.bounds_max.array()).any();
    }
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return lower[a] < lower[b]; });
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t a = order[i];
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const std::size_t b = order[j];
        if (!bodies_[a].is_plane && lower[b] > states[a].position.x() + bodies_[a].radius) break;
        if (bodies_[a].is_static && bodies_[b].is_static) continue;
        const double reach = bodies_[a].radius + bodies_[b].radius;
        if (!bodies_[a].is_plane && (states[a].position - states[b].position).squaredNorm() > reach * reach) continue;
        const double depth = -separation(states, a, b);
        if (depth <= 0) continue;
        ++v.overlaps;
        v.mean_penetration += depth;
        v.max_penetration = std::max(v.max_penetration, depth);
      }
    }
    if (v.overlaps) v.mean_penetration /= static_cast<double>(v.overlaps);
    if (dynamic) v.mean_energy /= static_cast<double>(dynamic);
    return v;
  }

 private:
  struct Body {
    carom_shape shape;
    bool is_static, is_plane;
    double radius, mass;
    Eigen::Matrix3d inertia;
  };

  double separation(const std::vector<BodyState>& states, std::size_t a, std::size_t b) const {
    const Quat qa = states[a].orientation.normalized(), qb = states[b].orientation.normalized();
    carom_distance result;
    result.struct_size = sizeof result;
    tools::Call call;
    call.done(
        carom_shape_distance(stage_.engine().get(), bodies_[a].shape, states[a].position.data(), qa.coeffs().data(),
                             bodies_[b].shape, states[b].position.data(), qb.coeffs().data(), nullptr, &result, call),
        "measuring a pair");
    return result.separation;
  }

  tools::Stage& stage_;
  std::vector<Body> bodies_;
};

}  // namespace carom::bench
