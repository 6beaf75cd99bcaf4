// Errors of ball, hinge, slider and weld by the poses of their bodies.
#include "jury/gaps.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace carom::tools::jury {
namespace {

double beyond(const Link& link, double x) { return link.limited ? std::max({link.lower - x, x - link.upper, 0.0}) : 0; }

/// rad, of a turn: from -pi to pi about its x axis, if it is one about x.
double twist(const Quat& turn) { return 2 * std::atan(turn.x() / turn.w()); }
double angle(const Quat& turn) { return 2 * std::atan2(turn.vec().norm(), std::fabs(turn.w())); }

}  // namespace

double coordinate_of(const Link& link, const Frame& frame) {
  const State &a = frame[link.a], &b = frame[link.b];
  const Quat axes_a = a.orientation * link.axes_a, axes_b = b.orientation * link.axes_b;
  if (link.kind == CAROM_JOINT_HINGE) return twist(axes_a.conjugate() * axes_b);
  return (axes_a.conjugate() * Vec(b.position + b.orientation * link.at_b - a.position - a.orientation * link.at_a))
      .x();
}

double weight_along(const Case& c, const Link& link, const Frame& frame) {
  Eigen::Matrix<double, 6, 6> inverse =
      Eigen::Matrix<double, 6, 6>::Zero();  // of places, then turns, axes of A's frame
  const Quat axes = frame[link.a].orientation * link.axes_a;
  for (const auto& [i, at] : {std::pair(link.a, link.at_a), std::pair(link.b, link.at_b)}) {
    const Member& m = c.members[i];
    if (!m.moves()) continue;
    const Eigen::Matrix3d turned = (axes.conjugate() * frame[i].orientation).toRotationMatrix();
    const Vec arm = turned * Vec(at - m.center);
    Eigen::Matrix3d cross;  // of a turn to how the place moves
    cross << 0, arm.z(), -arm.y(), -arm.z(), 0, arm.x(), arm.y(), -arm.x(), 0;
    const Eigen::Matrix3d turns = turned * m.inertia.inverse() * turned.transpose();
    inverse.topLeftCorner<3, 3>() += Eigen::Matrix3d::Identity() / m.mass + cross * turns * cross.transpose();
    inverse.topRightCorner<3, 3>() += cross * turns;
    inverse.bottomLeftCorner<3, 3>() += turns * cross.transpose();
    inverse.bottomRightCorner<3, 3>() += turns;
  }
  // Of its inverse one diagonal entry: by elimination of all others, one after the other.
  const int free = link.kind == CAROM_JOINT_HINGE ? 3 : 0;
  for (int k = 0; k < 6; ++k) {
    if (k == free) continue;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; i != k && j < 6; ++j)
        if (j != k) inverse(i, j) -= inverse(i, k) * inverse(k, j) / inverse(k, k);
  }
  return 1 / inverse(free, free);
}

double most_work(const Link& link, const Drive& drive, const Frame& before, const Frame& now, double dt) {
  if (drive.aim == Drive::Aim::none) return 0;
  // It pushes forwards only while the joint is slower than its goal.
  if (drive.aim == Drive::Aim::speed) return drive.most * std::fabs(drive.goal) * dt;
  const auto off = [&](const Frame& frame) {
    const double by = std::fabs(coordinate_of(link, frame) - drive.goal);
    return link.kind == CAROM_JOINT_HINGE ? std::min(by, std::fabs(2 * std::numbers::pi - by)) : by;
  };
  return drive.most * std::max(0.0, off(before) - off(now));
}

double gap_of(const Case& c, const Link& link, const Frame& frame) {
  const State &a = frame[link.a], &b = frame[link.b];
  const Quat axes_a = a.orientation * link.axes_a, axes_b = b.orientation * link.axes_b;
  const Quat turn = axes_a.conjugate() * axes_b;  // B's frame in A's
  const Vec apart =
      axes_a.conjugate() * Vec(b.position + b.orientation * link.at_b - a.position - a.orientation * link.at_a);
  const auto radius = [&](std::size_t i) { return c.members[i].moves() ? c.members[i].size / 2 : HUGE_VAL; };
  const double arm = std::min(radius(link.a), radius(link.b));
  if (link.kind == CAROM_JOINT_BALL) {
    const Vec turned = turn * Vec::UnitX();
    const double swing = std::atan2(std::hypot(turned.y(), turned.z()), turned.x());
    return std::max(apart.norm(), link.swing > 0 ? (swing - link.swing) * arm : 0);
  }
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
