// Closed forms that accuracy scenes are judged by.
#include "accuracy/reference.h"

#include <cmath>
#include <numbers>

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

double LeaningRod::x() const { return -half * std::cos(angle) + thin * std::sin(angle); }
double LeaningRod::y() const { return -half * std::sin(angle) - thin * std::cos(angle); }
double LeaningRod::inertia() const { return (half * half + thin * thin) / 3; }
double LeaningRod::yields(double mu) const { return 1 + x() * (x() - mu * y()) / inertia(); }
double LeaningRod::spin_after(double speed) const { return -speed * y() / (inertia() + x() * x() + y() * y()); }

}  // namespace carom::tools::accuracy
