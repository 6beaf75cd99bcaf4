// Closed forms that accuracy scenes are judged by.
#include "accuracy/reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace carom::tools::accuracy {

// v_t + (v_0 - v_t) e^-ct, and its integral.
Course thrown_into_air(double t, double speed, double rate, double g) {
  const double last = g / rate, gone = -std::expm1(-rate * t);
  return {last * t + (speed - last) * gone / rate, speed + (last - speed) * gone};
}

// The way is log(cosh(g t / v_t)) / rate; cosh alone would overflow.
Course fallen_through_air(double t, double rate, double g) {
  const double last = std::sqrt(g / rate), x = g * t / last;
  return {(x + std::log1p(std::exp(-2 * x)) - std::numbers::ln2) / rate, last * std::tanh(x)};
}

double bounce_height(double t, double drop, double e, double g) {
  double speed = std::sqrt(2 * g * drop);  // of the next impact
  t -= speed / g;                          // since the first impact
  if (t < 0) return drop - g * (t + speed / g) * (t + speed / g) / 2;
  for (speed *= e; speed > 1e-12; speed *= e) {
    const double flight = 2 * speed / g;
    if (t < flight) return t * (speed - g * t / 2);
    t -= flight;
  }
  return 0;
}

double bounce_last_above(double level, double drop, double e, double g) {
  double speed = std::sqrt(2 * g * drop), start = speed / g, last = std::sqrt(2 * (drop - level) / g);
  for (speed *= e; speed * speed > 2 * g * level; speed *= e) {
    last = start + (speed + std::sqrt(speed * speed - 2 * g * level)) / g;  // on the way down
    start += 2 * speed / g;
  }
  return last;
}

double stopping_distance(double speed, double mu, double g) { return speed * speed / (2 * mu * g); }

double slope_distance(double t, double mu, double sine, double cosine, double g) {
  return g * (sine - mu * cosine) * t * t / 2;
}

RollingPlate rolling_plate(double pull, double mu, double plate_mass, double ball_mass, int balls, double g) {
  const double ground = mu * (plate_mass + balls * ball_mass) * g;
  const double each = (pull - ground) / plate_mass / (3.5 / ball_mass + balls / plate_mass);
  return {3.5 * each / ball_mass, each / ball_mass};
}

Skid skid(double speed, double mu, double g) { return {2 * speed / (7 * mu * g), 5 * speed / 7}; }

Rebound cannon(double speed, double mass_ratio) {
  // heavy at +speed meets light at -speed: the relative velocity turns round, the momentum stays
  const double momentum = (mass_ratio - 1) * speed / (mass_ratio + 1);
  return {momentum - 2 * speed / (mass_ratio + 1), momentum + 2 * speed * mass_ratio / (mass_ratio + 1)};
}

double turned_back(double t, double way, double speed, double e) {
  const double left = way - speed * t;
  return left > 0 ? left : -e * left;
}

// The impulse p at the arm s turns the speed of that point round: p (1/m + s^2/I) = 2 spin s.
HitRod hit_rod(double spin, double half, double thin, double post, double away) {
  const double off = thin + post, inertia = (half * half + thin * thin) / 3;  // of 1 kg
  const double arm2 = away * away - off * off;
  return {std::asin(off / away), spin * (1 - 2 * arm2 / (inertia + arm2))};
}

// The rim touches at r = radius * e - half * n, e down the face and n square to it. Middle and that point rest, so the
// spin is along r; it goes round with the weight's moment.
double Coin::round(double tilt, double g) const {
  const double s = std::sin(tilt), c = std::cos(tilt), a2 = radius * radius, across = a2 / 4 + half * half / 3;
  return std::sqrt(g * (radius * c - half * s) / (s * (across * c - a2 / 2 * (half / radius) * s)));
}

double Coin::energy(double tilt, double g) const {
  const double s = std::sin(tilt), spin = round(tilt, g) * s, ratio = half / radius;
  const double inertia = radius * radius * (0.25 + ratio * ratio / 2) + half * half / 3;
  return g * (radius * s + half * (std::cos(tilt) - 1)) + inertia * spin * spin / 2;
}

double Coin::loss(double tilt, double rolling, double g) const {
  const double s = std::sin(tilt), c = std::cos(tilt), ratio = half / radius;
  const double level = std::sqrt(1 + ratio * ratio - (s + ratio * c) * (s + ratio * c));
  return rolling * g * round(tilt, g) * s * level;
}

// Simpson's rule in the root of the tilt, in which all is smooth.
double Coin::time_between(double tilt, double smaller, double rolling, double g) const {
  constexpr int kPairs = 200;
  const double from = std::sqrt(smaller), h = (std::sqrt(tilt) - from) / (2 * kPairs);
  const auto slow = [&](double root) {
    const double at = root * root, d = 1e-5 * at;
    return 2 * root * (energy(at + d, g) - energy(at - d, g)) / (2 * d) / loss(at, rolling, g);
  };
  double sum = 0;
  for (int i = 0; i <= 2 * kPairs; ++i) sum += (i == 0 || i == 2 * kPairs ? 1 : i % 2 ? 4 : 2) * slow(from + i * h);
  return sum * h / 3;
}

double Coin::tilt_of(double wanted, double g) const {
  double low = 0, high = 1.2;  // rad; energy grows with the tilt
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (energy(middle, g) < wanted ? low : high) = middle;
  }
  return (low + high) / 2;
}

namespace {

/// A joint of half an arch: from the upright, and what of the arch is between it and the crown.
struct ArchJoint {
  double angle, weight, moment;  ///< rad; m^2; m^3, about the crown's upright
};

std::vector<ArchJoint> joints_of(int stones, double inner, double outer) {
  const double turn = std::numbers::pi / stones, half = turn / 2;
  const double squares = outer * outer - inner * inner, cubes = std::pow(outer, 3) - std::pow(inner, 3);
  const double weight = squares * std::sin(turn) / 2, middle = 2 * cubes / (3 * squares) * std::cos(half);
  ArchJoint at{0, 0, 0};
  if (stones % 2)
    at = {half, weight / 2, cubes / 6 * std::pow(std::sin(half), 2) * std::cos(half)};  // half a key stone
  std::vector<ArchJoint> joints = {at};
  for (int i = 0; i < stones / 2; ++i) {
    at.moment += weight * middle * std::sin(at.angle + half);
    at.weight += weight, at.angle += turn;
    joints.push_back(at);
  }
  return joints;
}

/// The crown bears a level thrust, at a height that each joint bounds from below and from above. How far the bounds are
/// apart is concave in the thrust: by thirds to where that is most.
bool arch_stands(int stones, double mu, double thick) {
  const double inner = 1 - thick / 2, outer = 1 + thick / 2;
  const std::vector<ArchJoint> joints = joints_of(stones, inner, outer);
  double least = 0, most = HUGE_VAL;
  for (const ArchJoint& j : joints) {
    const double s = std::sin(j.angle), c = std::cos(j.angle);
    least = std::max(least, j.weight * (c - mu * s) / (s + mu * c));
    if (s > mu * c) most = std::min(most, j.weight * (c + mu * s) / (s - mu * c));
  }
  const auto space = [&](double thrust) {
    double low = -HUGE_VAL, high = HUGE_VAL;
    for (const ArchJoint& j : joints) {
      const double along = thrust * std::cos(j.angle) + j.weight * std::sin(j.angle);
      low = std::max(low, inner * along - j.moment), high = std::min(high, outer * along - j.moment);
    }
    return high - low;
  };
  for (int i = 0; i < 200 && least < most; ++i) {
    const double low = least + (most - least) / 3, high = most - (most - least) / 3;
    if (space(low) < space(high))
      least = low;
    else
      most = high;
  }
  return least <= most && space((least + most) / 2) >= 0;
}

}  // namespace

double least_arch(int stones, double mu) {
  double low = 0, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (arch_stands(stones, mu, middle) ? high : low) = middle;
  }
  return high;
}

double LeaningRod::x() const { return -half * std::cos(angle) + thin * std::sin(angle); }
double LeaningRod::y() const { return -half * std::sin(angle) - thin * std::cos(angle); }
double LeaningRod::inertia() const { return (half * half + thin * thin) / 3; }
double LeaningRod::yields(double mu) const { return 1 + x() * (x() - mu * y()) / inertia(); }
double LeaningRod::spin_after(double speed) const { return -speed * y() / (inertia() + x() * x() + y() * y()); }

}  // namespace carom::tools::accuracy
