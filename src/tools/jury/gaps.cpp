// Errors of ball, hinge, slider and weld by the poses of their bodies.
#include "jury/gaps.h"

#include <algorithm>
#include <cmath>

namespace carom::tools::jury {
namespace {

double beyond(const Link& link, double x) { return link.limited ? std::max({link.lower - x, x - link.upper, 0.0}) : 0; }

/// rad, of a turn: from -pi to pi about its x axis, if it is one about x.
double twist(const Quat& turn) { return 2 * std::atan(turn.x() / turn.w()); }
double angle(const Quat& turn) { return 2 * std::atan2(turn.vec().norm(), std::fabs(turn.w())); }

}  // namespace

double gap_of(const Case& c, const Link& link, const Frame& frame) {
  const State &a = frame[link.a], &b = frame[link.b];
  const Quat axes_a = a.orientation * link.axes_a, axes_b = b.orientation * link.axes_b;
  const Quat turn = axes_a.conjugate() * axes_b;  // B's frame in A's
  const Vec apart =
      axes_a.conjugate() * Vec(b.position + b.orientation * link.at_b - a.position - a.orientation * link.at_a);
  const auto radius = [&](std::size_t i) { return c.members[i].moves() ? c.members[i].size / 2 : HUGE_VAL; };
  const double arm = std::min(radius(link.a), radius(link.b));
  if (link.kind == CAROM_JOINT_BALL) return apart.norm();
  if (link.kind == CAROM_JOINT_WELD) return std::max(apart.norm(), angle(turn) * arm);
  if (link.kind == CAROM_JOINT_SLIDER)
    return std::max(std::hypot(apart.y(), apart.z(), beyond(link, apart.x())), angle(turn) * arm);
  const Vec axis = turn * Vec::UnitX();
  const double tilt = std::atan2(std::hypot(axis.y(), axis.z()), axis.x());
  return std::max(apart.norm(), std::max(tilt, beyond(link, twist(turn))) * arm);
}

double gap_limit(const Case& c, const Link& link) {
  const auto size = [&](std::size_t i) { return c.members[i].moves() ? c.members[i].size : 0; };
  return std::max(0.01, 0.02 * std::max(size(link.a), size(link.b)));
}

}  // namespace carom::tools::jury
