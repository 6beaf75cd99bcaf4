// Builds the stacks: shapes of about 1 m, all of whose sizes differ.
#include "closed_forms.h"

#include <numbers>

#include "random_pairs.h"

namespace carom::bench {

namespace {

double bottom(const Shape& shape) { return -shape.bounds.lo.y(); }

Shape block(const Vec3& half) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) corners.push_back(half.times(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  return test::hull(corners);
}

}  // namespace

Stack::Stack(Shape above_it, Shape beneath_it, const Vec3& aside, const Mat3& tilt)
    : upper(std::move(above_it)), lower(std::move(beneath_it)), aside_(aside), tilt_(tilt) {}

Placement Stack::upper_at(double gap, double spin, const Vec3& astray) const {
  const Vec3 origin = aside_ + astray + (bottom(upper.shape) + bottom(lower.shape) + gap) * Vec3::unit_y();
  return placement(Frame(tilt_ * exp_map(spin * Vec3::unit_y()).matrix(), tilt_ * origin));
}

Placement Stack::lower_at(double spin) const {
  const Quat upside_down = exp_map(std::numbers::pi * Vec3::unit_x());
  return placement(Frame(tilt_ * (exp_map(spin * Vec3::unit_y()) * upside_down).matrix(), Vec3::zero()));
}

Vec3 Stack::above(double height, const Vec3& astray) const {
  return tilt_ * (aside_ + astray + (bottom(lower.shape) + height) * Vec3::unit_y());
}

std::deque<Stack> stacks() {
  test::Random random(5000);
  std::deque<Stack> all;
  const auto add = [&](Shape upper, Shape lower, bool faces) {
    const Vec3 aside = faces ? Vec3(0.07, 0, 0.04) : Vec3::zero();
    all.emplace_back(std::move(upper), std::move(lower), aside, test::random_rotation(random).matrix());
  };
  add(test::sphere(0.5), test::sphere(0.8), false);
  add(test::capsule(0.3, 0.4), test::capsule(0.4, 0.6), false);
  add(test::box(Vec3(0.5, 0.6, 0.7)), test::box(Vec3(0.8, 0.4, 0.6)), true);
  add(block(Vec3(0.5, 0.6, 0.7)), block(Vec3(0.8, 0.4, 0.6)), true);
  add(test::cylinder(0.5, 0.6), test::cylinder(0.7, 0.4), true);
  add(test::cone(0.5, 0.6), test::cone(0.7, 0.4), true);
  add(test::ellipsoid(Vec3(0.5, 0.6, 0.7)), test::ellipsoid(Vec3(0.8, 0.4, 0.6)), false);
  return all;
}

}  // namespace carom::bench
