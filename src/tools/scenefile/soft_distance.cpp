// A joint that is one soft limit of a distance: a spring between two points is the same.
#include <algorithm>
#include <cmath>

#include "scenefile/axes.h"
#include "scenefile/reader.h"

namespace carom::tools::scenefile {

/// @return false: the joint is another
bool Reader::make_soft_distance(std::size_t i, std::size_t other, const Value& joint) {
  const auto limits = joint.get("limits"), drives = joint.get("drives");
  if (!limits || limits->size() != 1 || (drives && drives->size() > 0)) return false;
  const Value limit = limits->at(0);
  if (limit.has("angularAxes") || !is_soft_limit(limit) || holds_nothing(limit) || limit["linearAxes"].size() != 3)
    return false;
  constexpr double kFar = 1e9, kSame = 1e-9;  // m
  const double least = std::clamp(limit.number_or("min", 0), 0.0, kFar),
               most = std::clamp(limit.number_or("max", kFar), 0.0, kFar);
  const bool rod = most - least < kSame;
  if (most < kSame || most >= kFar || (!rod && least > 0)) return false;  // to a point: axes say that better
  const auto end = [&](std::size_t n, std::size_t& actor, Vec& at) {
    const Node& node = nodes_[n];
    actor = node.body == kNone ? Bungee::kWorld : actor_of_node_[node.body];
    at = node.body == kNone ? node.world.p : node.body == n ? Vec(Vec::Zero()) : node.in_body.p;
  };
  Bungee b;
  end(i, b.a, b.at_a), end(other, b.b, b.at_b);
  const auto moves = [&](std::size_t actor) {
    return actor != Bungee::kWorld && stage_.actors[actor].type == CAROM_BODY_DYNAMIC;
  };
  if (b.a == b.b || (!moves(b.a) && !moves(b.b))) return false;
  b.rest = most, b.only_pulls = !rod;
  b.stiffness = std::min(limit.number_or("stiffness", 0, 0, 1e300), 1e30);
  b.damping = std::min(limit.number_or("damping", 0, 0, 1e300), 1e30);
  stage_.add_spring(b);
  note(limit.place() + ": a soft distance is a spring; bodies on its ends collide");
  return true;
}

}  // namespace carom::tools::scenefile
