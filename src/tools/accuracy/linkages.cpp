// Equations of motion that mechanisms of accuracy scenes are judged by.
#include "accuracy/linkages.h"

#include <cmath>
#include <numbers>

#include "accuracy/reference.h"

namespace carom::tools::accuracy {
namespace {

using Eigen::Vector3d;

/// A turn theta with cos theta = 2^(sin s) - 1, its sign such that it is smooth, and how it changes with s.
struct Turn {
  double angle, rate;
};

// 1 - sin s = 2 root^2, so sin theta = sqrt(2^u (2 - 2^u)) = root * shape with u = sin s: no digit is lost where both
// vanish, and root has the sign that the turn has.
Turn turn_at(double s) {
  constexpr double kLn2 = std::numbers::ln2;
  const double root = std::sin(std::numbers::pi / 4 - s / 2), along = std::cos(std::numbers::pi / 4 - s / 2);
  const double power = std::exp2(std::sin(s)), left = 2 * root * root;
  const double share = left > 0 ? -std::expm1(-kLn2 * left) / left : kLn2;  // (1 - 2^-left) / left
  const double shape = std::sqrt(4 * power * share);
  return {std::atan2(root * shape, power - 1), -kLn2 * 2 * along * power / shape};
}

}  // namespace

BricardPose bricard(double s) {
  const Turn one = turn_at(s), other = turn_at(-s);
  BricardPose pose;
  Vector3d along(0, 0, -1), hinge(0, -1, 0), at = Vector3d::Zero(), at_rate = Vector3d::Zero();
  Vector3d turn_rate = Vector3d::Zero();
  for (std::size_t k = 0; k < pose.bars.size(); ++k) {
    const double angle = k % 2 == 0 ? one.angle : other.angle, rate = k % 2 == 0 ? one.rate : -other.rate;
    along = Eigen::AngleAxisd(angle, hinge) * along;
    turn_rate += rate * hinge;
    BricardPose::Bar& bar = pose.bars[k];
    bar.middle = at + along / 2, bar.middle_rate = at_rate + turn_rate.cross(along) / 2;
    bar.axes << along, hinge, along.cross(hinge);
    bar.turn_rate = turn_rate;
    at += along, at_rate += turn_rate.cross(along);
    hinge = along.cross(hinge) * (k % 2 == 0 ? 1 : -1);
  }
  pose.end = at, pose.end_axis = hinge;
  return pose;
}

Vector3d BricardMotion::inertia() {
  const double thin = kThick * kThick;
  return Vector3d(2 * thin, 1 + thin, 1 + thin) / 12;
}

double BricardMotion::mass_of(double s) {
  double sum = 0;
  for (const BricardPose::Bar& bar : bricard(s).bars) {
    const Vector3d spin = bar.axes.transpose() * bar.turn_rate;
    sum += bar.middle_rate.squaredNorm() + spin.dot(inertia().cwiseProduct(spin));
  }
  return sum;
}

double BricardMotion::height_of(double s) {
  double sum = 0;
  for (const BricardPose::Bar& bar : bricard(s).bars) sum += bar.middle.y();
  return sum;
}

// M s'' + M' s'^2 / 2 + g V' = 0. M' by differences: of the eighth digit.
Eigen::Vector2d BricardMotion::rate(const Eigen::Vector2d& state) {
  constexpr double kStep = 1e-4;
  const double s = state[0], rate = state[1];
  const double change = (mass_of(s + kStep) - mass_of(s - kStep)) / (2 * kStep);
  double fall = 0;
  for (const BricardPose::Bar& bar : bricard(s).bars) fall += bar.middle_rate.y();
  return {rate, -(change * rate * rate / 2 + kGravity * fall) / mass_of(s)};
}

Vector3d Governor::rod_inertia() {
  constexpr double kThin = 0.01 * 0.01;
  return kRod / 12 * Vector3d(2 * kThin, 1 + kThin, 1 + kThin);
}

double Governor::around(double angle) {
  const Vector3d rod = rod_inertia();
  const double c = std::cos(angle), s = std::sin(angle), middle = kOff + c / 2, end = kOff + c;
  const double arm = kRod * middle * middle + rod.y() * c * c + rod.x() * s * s + kBall * end * end;
  return 2 * arm + kSlider * 0.01 / 6 + kShaft * 2e-4 / 12;  // sides of 0.1 and 0.01 m
}

// Lagrange's equations of one arm and of half the slider; the angular momentum about the axis stays.
Eigen::Vector4d Governor::rate(const Eigen::Vector4d& state) {
  const double angle = state[0], swing = state[1], height = state[2], rise = state[3];
  const double c = std::cos(angle), s = std::sin(angle);
  const Vector3d rod = rod_inertia();
  const double spin = around(kAngle) * kSpin / around(angle);
  const double half_change = -kRod * (kOff + c / 2) * s / 2 - (rod.y() - rod.x()) * c * s - kBall * (kOff + c) * s;
  const double across = c / 2, down = kHead - s / 2 - height, length = std::hypot(across, down);
  const double by_angle = (-across * s / 2 - down * c / 2) / length, by_height = -down / length;
  const double pull = kStiff * (length - kRest) + kDamp * (by_angle * swing + by_height * rise);
  const double inertia = kRod / 4 + rod.y() + kBall;
  return {swing, (half_change * spin * spin + (kRod / 2 + kBall) * kGravity * c - pull * by_angle) / inertia, rise,
          -kGravity - 2 * pull * by_height / kSlider};
}

Vector3d HeavyTop::start() { return {std::numbers::pi / 2, 0, 0}; }

// About the upright there is no angular momentum at first, and nothing gives any; about the axis there is that of its
// spin: I sin^2(theta) phi' = -J cos(theta).
Vector3d HeavyTop::rate(const Vector3d& state) {
  const double c = std::cos(state[0]), s = std::sin(state[0]), about = axial() * kSpin;
  const double inertia = across() + kArm * kArm, round = -about * c / (inertia * s * s);
  return {state[1], (inertia * round * round * s * c - about * round * s + kGravity * kArm * s) / inertia, round};
}

Vector3d HeavyTop::middle(const Vector3d& state) {
  const double s = std::sin(state[0]);
  return kArm * Vector3d(s * std::cos(state[2]), std::cos(state[0]), -s * std::sin(state[2]));
}

// Rods of thickness 0, the load fixed to the forearm. With a and b the angles, the kinetic energy is
// A a'^2 / 2 + B b'^2 / 2 + C cos(a - b) a' b', and weight pulls them by U cos a and V cos b.
std::array<double, 2> ReachingArm::targets() const {
  const double beyond = kFore * (kForeMass / 2 + load), all = kUpper * (kUpperMass / 2 + kForeMass + load);
  const double fore = kGravity * beyond * std::cos(kAtMark[1]), upper = kGravity * all * std::cos(kAtMark[0]);
  return {kAtMark[0] + (upper + fore) / kStiff[0], kAtMark[1] - kAtMark[0] + fore / kStiff[1]};
}

Eigen::Vector4d ReachingArm::rate(const Eigen::Vector4d& state) const {
  const auto [upper_to, fore_to] = targets();
  const double a = state[0], b = state[1], da = state[2], db = state[3];
  const double beyond = kFore * (kForeMass / 2 + load), all = kUpper * (kUpperMass / 2 + kForeMass + load);
  const double upper = kUpper * kUpper * (kUpperMass / 3 + kForeMass + load),
               fore = kFore * kFore * (kForeMass / 3 + load) + 0.4 * load * kRadius * kRadius,
               both = kUpper * beyond * std::cos(a - b), swing = kUpper * beyond * std::sin(a - b);
  const double shoulder = kStiff[0] * (upper_to - a) - kDamp[0] * da,
               elbow = kStiff[1] * (fore_to - (b - a)) - kDamp[1] * (db - da);
  const double on_upper = shoulder - elbow - kGravity * all * std::cos(a) - swing * db * db,
               on_fore = elbow - kGravity * beyond * std::cos(b) + swing * da * da;
  const double det = upper * fore - both * both;
  return {da, db, (fore * on_upper - both * on_fore) / det, (upper * on_fore - both * on_upper) / det};
}

Vector3d ReachingArm::elbow(double shoulder) {
  return {kUpper * std::cos(shoulder), kShoulder + kUpper * std::sin(shoulder), 0};
}

Vector3d ReachingArm::hand(double shoulder, double elbow_angle) {
  return elbow(shoulder) + kFore * Vector3d(std::cos(elbow_angle), std::sin(elbow_angle), 0);
}

Eigen::Vector3d TurningWheel::axis() const { return {std::sin(lean), std::cos(lean), 0}; }

Eigen::Vector3d TurningWheel::to_ground() const {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ().cross(axis());  // in the disk
  return -radius * up - half * axis();
}

Eigen::Vector3d TurningWheel::spin(double g) const {
  const Eigen::Vector3d up = Eigen::Vector3d::UnitZ().cross(axis()), about = round * Eigen::Vector3d::UnitY(),
                        r = to_ground();
  const double axial = radius * radius / 2, across = radius * radius / 4 + half * half / 3;
  const auto omega = [&](double own) { return Eigen::Vector3d(about.dot(up) * up + own * axis()); };
  // N m a kg about the level line, linear in the spin about the axis: what the ground's push has beyond what turns it.
  const auto rest = [&](double own) {
    const Eigen::Vector3d w = omega(own), momentum = across * about.dot(up) * up + axial * own * axis();
    const Eigen::Vector3d push = about.cross(-w.cross(r)) + g * Eigen::Vector3d::UnitY();
    return (r.cross(push) - about.cross(momentum)).z();
  };
  return omega(-rest(0) / (rest(1) - rest(0)));
}

double SlopeCone::inertia() const {
  const double c = std::cos(half_angle);
  return 3.0 / 20 * height * height * (1 + 5 * c * c);
}
Eigen::Vector2d SlopeCone::rate(const Eigen::Vector2d& state, double g) const {
  const double arm = 0.75 * height * std::cos(half_angle);  // of its weight, from the apex along the slope
  return {state.y(), -g * std::sin(slope) * arm * std::sin(state.x()) / inertia()};
}

void Ladder::Motion::step(const Ladder& ladder, double h, double g) {
  const double a = ladder.half;
  const auto on_both = [&](const Eigen::Vector2d& s) {
    return Eigen::Vector2d(s.y(), -0.75 * g / a * std::cos(s.x()));
  };
  const auto on_floor = [&](const Eigen::Vector2d& s) {
    const double c = std::cos(s.x());
    return Eigen::Vector2d(s.y(), (-g * c / a + std::sin(s.x()) * c * s.y() * s.y()) / (1.0 / 3 + c * c));
  };
  const auto wall = [&](const Eigen::Vector2d& s) {  // N
    return -a * (std::cos(s.x()) * s.y() * s.y() + std::sin(s.x()) * on_both(s).y());
  };
  if (is_off_) {
    state_ = runge_kutta(state_, h, on_floor), x_ += h * x_rate_;
    return;
  }
  Eigen::Vector2d next = runge_kutta(state_, h, on_both);
  double until = h;
  if (wall(next) < 0) {
    double bears = 0;
    for (int i = 0; i < 40; ++i) {
      const double middle = (bears + until) / 2;
      (wall(runge_kutta(state_, middle, on_both)) < 0 ? until : bears) = middle;
    }
    state_ = runge_kutta(state_, until, on_both), is_off_ = true;
    x_rate_ = -a * std::sin(state_.x()) * state_.y(), x_ = ladder.radius + a * std::cos(state_.x());
    step(ladder, h - until, g);
    return;
  }
  state_ = next;
}
Eigen::Vector3d Ladder::Motion::middle(const Ladder& ladder) const {
  const double x = is_off_ ? x_ : ladder.radius + ladder.half * std::cos(state_.x());
  return {x, ladder.radius + ladder.half * std::sin(state_.x()), 0};
}
Eigen::Vector3d Ladder::Motion::velocity(const Ladder& ladder) const {
  const double x = is_off_ ? x_rate_ : -ladder.half * std::sin(state_.x()) * state_.y();
  return {x, ladder.half * std::cos(state_.x()) * state_.y(), 0};
}

}  // namespace carom::tools::accuracy
