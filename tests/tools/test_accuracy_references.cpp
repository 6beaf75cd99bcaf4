// What accuracy scenes are judged by is itself judged: every closed form against an integration that knows only the
// laws, and every arrangement that should stand against a proof that it can.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "accuracy/free_top.h"
#include "accuracy/linkages.h"
#include "accuracy/reference.h"
#include "carom_test.h"

using namespace carom::tools::accuracy;

static void a_bounce_is_a_fall_and_a_reflection(void**) {
  const double drop = 1.3, e = 0.6, h = 1e-4, level = 2e-3;
  double y = drop, v = 0, t = 0, last_above = 0;
  while (t < 2.5) {
    double left = h;
    // Flight is exact; an impact inside the step is met where the parabola comes down to 0.
    for (;;) {
      const double meet = (v + std::sqrt(v * v + 2 * kGravity * std::max(y, 0.0))) / kGravity;
      if (meet >= left || (y <= 0 && v < 1e-6)) break;
      v = e * (kGravity * meet - v), y = 0, left -= meet;
    }
    if (y > 0 || v >= 1e-6) y += v * left - kGravity * left * left / 2, v -= kGravity * left;
    t += h;
    // Thirty impacts until it lies, at 2.1 s; each hands on its rounding, and what the cut-off leaves is below 1e-13 m.
    assert_true(std::fabs(std::max(y, 0.0) - bounce_height(t, drop, e, kGravity)) < 1e-9);
    if (y > level) last_above = t;
  }
  const double closed = bounce_last_above(level, drop, e, kGravity);
  assert_true(closed >= last_above - 1e-9 && closed <= last_above + h + 1e-9);
  // At e = 1/2 the bounces end after 3 times the fall, and not before.
  const double fall = std::sqrt(2 * drop / kGravity);
  assert_true(bounce_height(3.0001 * fall, drop, 0.5, kGravity) == 0);
  assert_true(bounce_height(2.99 * fall, drop, 0.5, kGravity) > 0);
}

static void blocks_slide_as_their_forces_say(void**) {
  const double mu = 0.45, h = 1e-5;
  double x = 0, v = 4, t = 0;
  for (; v > 0; v -= mu * kGravity * h) x += v * h - mu * kGravity * h * h / 2;  // exact but for the last step
  assert_true(std::fabs(x - stopping_distance(4, mu, kGravity)) < mu * kGravity * h * h);
  const double sine = 0.6, cosine = 0.8;
  x = v = 0;
  for (int i = 0; i < 150000; ++i, t += h) {
    const double weight = kGravity * sine, grip = mu * kGravity * cosine, a = weight - grip;
    x += v * h + a * h * h / 2;
    v += a * h;
  }
  assert_true(std::fabs(x - slope_distance(t, mu, sine, cosine, kGravity)) < 1e-9);
}

static void a_pulled_plate_obeys_newton_with_its_balls(void**) {
  const double M = 10, m = 1, pull = 150, mu = 0.4;
  const int n = 25;
  // Unknown: acceleration of plate A and balls a, friction f at each ball. Plate, ball, and no slip: the ball's lowest
  // point moves at a + r f r / (2/5 m r^2).
  Eigen::Matrix3d laws;
  laws << M, 0, n, 0, m, -1, 1, -1, -2.5 / m;
  const Eigen::Vector3d found = laws.fullPivLu().solve(Eigen::Vector3d(pull - mu * (M + n * m) * kGravity, 0, 0));
  const RollingPlate closed = rolling_plate(pull, mu, M, m, n, kGravity);
  assert_true(std::fabs(found[0] - closed.plate) < 1e-13 && std::fabs(found[1] - closed.ball) < 1e-13);
  assert_true(closed.ball > 0 && found[2] < 0.8 * m * kGravity);  // the pull moves the plate, and no ball slips
}

static void a_skidding_ball_loses_speed_and_gains_spin_until_they_meet(void**) {
  const double mu = 0.2, h = 1e-6;
  double v = 5, surface = 0, t = 0;  // m/s: of the centre, and of the surface against it
  for (; v > surface; t += h) v -= mu * kGravity * h, surface += 2.5 * mu * kGravity * h;
  const Skid closed = skid(5, mu, kGravity);
  assert_true(std::fabs(t - closed.onset) < 2 * h && std::fabs(v - closed.final_speed) < 2 * mu * kGravity * h);
}

static void a_cannon_keeps_momentum_and_energy(void**) {
  for (double ratio : {1.0, 3.0, 10.0}) {
    const Rebound r = cannon(2, ratio);
    assert_true(std::fabs(ratio * r.heavy + r.light - (ratio * 2 - 2)) < 1e-13 * ratio);
    assert_true(std::fabs(ratio * r.heavy * r.heavy + r.light * r.light - (ratio * 4 + 4)) < 1e-12 * ratio);
    assert_true(r.light > r.heavy);
  }
  assert_true(cannon(1, 3).heavy == 0 && cannon(1, 3).light == 2);
}

/// Does a line of thrust pass through every joint of a half circle of stones, inside the middle `share` of its
/// thickness and within the cone of friction? The horizontal thrust H and the height at which it enters the crown are
/// searched for.
static bool stands(double inner, double outer, double mu, double share) {
  const double pi = std::acos(-1), mean = (inner + outer) / 2, width = share * (outer - inner) / 2;
  const int joints = 400;  // cuts, finer than the real joints: a cut that holds everywhere holds at theirs
  const double ring = (outer * outer - inner * inner) / 2;  // area per radian; weights in areas
  for (double height = mean - width; height <= mean + width; height += width / 20)
    for (double thrust = 0.01 * ring; thrust < 3 * ring; thrust += 0.005 * ring) {
      bool fits = true;
      for (int j = 1; j <= joints && fits; ++j) {
        // Part of the ring from the crown to an angle s: weight ring * s, centroid at x = c (1 - cos s) / s.
        const double s = pi / 2 * j / joints, weight = ring * s;
        const double c = 2.0 / 3 * (std::pow(outer, 3) - std::pow(inner, 3)) / (outer * outer - inner * inner);
        const double moment = weight * c * (1 - std::cos(s)) / s;  // about the crown's middle line
        // At radius r of the cut the thrust line has the same moment: H (height - y) = W x - moment; the force is (H,
        // W).
        const double r = (thrust * height + moment) / (thrust * std::cos(s) + weight * std::sin(s));
        const double along = weight * std::sin(s) + thrust * std::cos(s),
                     across = weight * std::cos(s) - thrust * std::sin(s);
        fits = std::fabs(r - mean) <= width && std::fabs(across) <= mu * along;
      }
      if (fits) return true;
    }
  return false;
}

static void the_arch_can_stand(void**) {
  assert_true(stands(1.8, 2.2, 0.6, 1));
  assert_true(stands(1.8, 2.2, 0.6, 0.7));  // with room to spare
  // Heyman's limit: a half circle thinner than 0.106 of its mean radius cannot; nor can a slippery one.
  assert_false(stands(2 * 0.952, 2 * 1.048, 0.6, 1));
  assert_false(stands(1.8, 2.2, 0.2, 1));
}

/// J, per kg/m^2, m of depth and g: what weight does as half an arch begins to fall, its crown straight down. It turns about
/// the foot's outer end, opens inside at joint k, and outside at the joint next to the crown. The rest of it goes along.
static double falling_gains(int stones, double thick, int k) {
  const double pi = std::acos(-1), turn = pi / stones, inner = 1 - thick / 2, outer = 1 + thick / 2;
  const auto at = [](double r, double angle) { return Eigen::Vector2d(r * std::sin(angle), r * std::cos(angle)); };
  const double crown = stones % 2 ? turn / 2 : 0;
  const Eigen::Vector2d foot = at(outer, pi / 2), hip = at(inner, crown + k * turn), top = at(outer, crown);
  const auto turning = [](double rate, const Eigen::Vector2d& arm) {
    return Eigen::Vector2d(-rate * arm.y(), rate * arm.x());
  };
  const Eigen::Vector2d hip_moves = turning(-1, hip - foot);  // outwards
  const double rate = hip_moves.x() / (top - hip).y();        // of the upper part: its top goes straight down
  const auto moves = [&](bool is_upper, const Eigen::Vector2d& p) {
    return Eigen::Vector2d(is_upper ? hip_moves + turning(rate, p - hip) : turning(-1, p - foot));
  };
  double gained = 0;
  for (int i = 0; i < stones / 2; ++i)  // each stone as two triangles about the arch's middle, the inner one taken away
    for (const double r : {inner, outer}) {
      const double a = crown + i * turn, area = r * r * std::sin(turn) / 2;
      const Eigen::Vector2d middle = (at(r, a) + at(r, a + turn)) / 3;
      gained -= (r == outer ? area : -area) * moves(i < k, middle).y();
    }
  const double half_key = stones % 2 ? (outer * outer - inner * inner) * std::sin(turn) / 4 : 0;
  return gained - half_key * moves(true, top).y();
}

static void the_thinnest_arch_falls_by_its_hinges_where_it_is_thinner(void**) {
  for (const int stones : {9, 12, 17, 33, 60}) {
    const double least = least_arch(stones, 1);
    for (const double share : {0.999, 1.001}) {
      double most = -HUGE_VAL;
      for (int k = 1; k < stones / 2; ++k) most = std::max(most, falling_gains(stones, share * least, k));
      assert_true((most > 0) == (share < 1));
    }
  }
  // With ever more stones, Milankovitch's 0.1075 of the mean radius; friction of 0.5 holds as well as any.
  assert_true(std::fabs(least_arch(2001, 1) - 0.1075) < 1e-4);
  for (const int stones : {5, 8, 17, 99})
    assert_true(std::fabs(least_arch(stones, 0.5) - least_arch(stones, 5)) < 1e-12);
}

static void an_arm_loses_what_its_drives_take_and_ends_at_the_mark(void**) {
  using A = ReachingArm;
  for (const double load : {0.5, 15.0, 50.0}) {
    const A arm{load};
    const auto targets = arm.targets();
    const auto energy = [&](const Eigen::Vector4d& x) {
      const double a = x[0], b = x[1], da = x[2], db = x[3];
      const auto speed2 = [&](double along) {  // of a point so far along the forearm
        return A::kUpper * A::kUpper * da * da + along * along * db * db +
               2 * A::kUpper * along * std::cos(a - b) * da * db;
      };
      const auto rod = [](double mass, double length) { return mass * length * length / 12; };
      const double kinetic = A::kUpperMass * A::kUpper * A::kUpper * da * da / 8 +
                             rod(A::kUpperMass, A::kUpper) * da * da / 2 + A::kForeMass * speed2(A::kFore / 2) / 2 +
                             rod(A::kForeMass, A::kFore) * db * db / 2 + load * speed2(A::kFore) / 2 +
                             0.2 * load * A::kRadius * A::kRadius * db * db;
      const double height = A::kUpperMass * A::kUpper / 2 * std::sin(a) +
                            A::kForeMass * (A::kUpper * std::sin(a) + A::kFore / 2 * std::sin(b)) +
                            load * (A::kUpper * std::sin(a) + A::kFore * std::sin(b));
      return kinetic + kGravity * height + A::kStiff[0] * std::pow(targets[0] - a, 2) / 2 +
             A::kStiff[1] * std::pow(targets[1] - (b - a), 2) / 2;
    };
    Eigen::Matrix<double, 5, 1> x = Eigen::Matrix<double, 5, 1>::Zero();  // and what the drives have taken
    const auto rate = [&](const Eigen::Matrix<double, 5, 1>& s) {
      Eigen::Matrix<double, 5, 1> to;
      to << arm.rate(s.head<4>()), A::kDamp[0] * s[2] * s[2] + A::kDamp[1] * std::pow(s[3] - s[2], 2);
      return to;
    };
    const double first = energy(x.head<4>());
    for (int i = 0; i < 200000; ++i) {
      x = runge_kutta(x, 1e-4, rate);  // the elbow comes to rest at 190 / s where the load is light
      assert_true(std::fabs(energy(x.head<4>()) + x[4] - first) < 1e-9 * first);
    }
    assert_true(x[4] > 100 && x.segment<2>(2).norm() < 1e-6);
    assert_true(std::fabs(x[0] - A::kAtMark[0]) < 1e-6 && std::fabs(x[1] - A::kAtMark[1]) < 1e-6);
  }
}

static void what_turns_round_does_so_at_its_moment(void**) {
  const double way = 2, speed = 130, e = 0.4, h = 1e-7;
  double x = -way, v = speed;
  for (int i = 1; i < 300000; ++i) {
    x += h * v;
    if (x > 0 && v > 0) x *= -e, v *= -e;
    if (i % 1000 == 0) assert_true(std::fabs(-x - turned_back(i * h, way, speed, e)) < 1e-9);
  }
}

static void a_rod_that_is_hit_keeps_energy_and_momentum(void**) {
  const double spin = 70, half = 1, thin = 0.03, post = 0.02, away = 0.8;
  const HitRod rod = hit_rod(spin, half, thin, post, away);
  // The face's line, thin above the axis, is as far from the post as that is thick.
  assert_true(std::fabs(away * std::sin(rod.stop) - (thin + post)) < 1e-15);
  // Angular momentum about the post and energy, of 1 kg: the middle leaves square to the arm.
  const double inertia = (half * half + thin * thin) / 3, arm = away * std::cos(rod.stop);
  const double speed = inertia * (spin - rod.spin) / arm;
  assert_true(std::fabs(speed * speed + inertia * rod.spin * rod.spin - inertia * spin * spin) < 1e-9);
  // The point that was hit leaves as fast as it came.
  assert_true(std::fabs((speed - rod.spin * arm) - spin * arm) < 1e-12 * spin);
}

static void bricards_ring_is_shut_and_its_motion_keeps_energy(void**) {
  const double d = 1e-6;
  for (double s = -7; s < 7; s += 0.37) {
    const BricardPose pose = bricard(s), next = bricard(s + d), last = bricard(s - d);
    // The held bar goes from (0, 0, 1) to the origin; the hinge before it is square to it and the same all the time.
    assert_true((pose.end - Eigen::Vector3d(0, 0, 1)).norm() < 1e-14);
    assert_true((pose.end_axis - Eigen::Vector3d(-1, 0, 0)).norm() < 1e-14);
    for (std::size_t k = 0; k < pose.bars.size(); ++k) {
      const Eigen::Vector3d moved = (next.bars[k].middle - last.bars[k].middle) / (2 * d);
      const Eigen::Matrix3d turned = (next.bars[k].axes - last.bars[k].axes) / (2 * d) * pose.bars[k].axes.transpose();
      assert_true((moved - pose.bars[k].middle_rate).norm() < 1e-8);
      const Eigen::Vector3d spin(turned(2, 1), turned(0, 2), turned(1, 0));
      assert_true((spin - pose.bars[k].turn_rate).norm() < 1e-8);
      // Each bar meets the one before it at its end, at right angles to their hinge.
      const Eigen::Vector3d before = k == 0 ? Eigen::Vector3d(0, 0, -1) : Eigen::Vector3d(pose.bars[k - 1].axes.col(0));
      assert_true(std::fabs(pose.bars[k].axes.col(1).dot(before)) < 1e-14);
    }
  }
  // As let go: along edges of a cube, each bar square to the next.
  const BricardPose cube = bricard(0);
  for (std::size_t k = 1; k < cube.bars.size(); ++k)
    assert_true(std::fabs(cube.bars[k].axes.col(0).dot(cube.bars[k - 1].axes.col(0))) < 1e-15);
  Eigen::Vector2d state(0, 0);
  const double start = kGravity * BricardMotion::height_of(0);
  double most = 0;
  for (int i = 0; i < 6000; ++i) {
    state = runge_kutta(state, 1e-3, BricardMotion::rate);
    const double energy = BricardMotion::mass_of(state[0]) * state[1] * state[1] / 2;
    assert_true(std::fabs(energy + kGravity * BricardMotion::height_of(state[0]) - start) < 1e-7);
    most = std::max(most, state[0]);
  }
  // It comes to the mirror image of where it began, and no farther; seen half a step early at worst, s'' (h / 2)^2 / 2
  // with s'' < 3.
  assert_true(std::fabs(most - std::acos(-1)) < 4e-7);
  assert_true(std::fabs(BricardMotion::height_of(most) - BricardMotion::height_of(0)) < 1e-6);
}

static void a_governor_loses_what_its_dampers_take(void**) {
  using G = Governor;
  const double spin = G::around(G::kAngle) * G::kSpin, h = 2e-5;
  const auto stretch = [](const Eigen::Vector4d& x) {
    return std::hypot(std::cos(x[0]) / 2, G::kHead - std::sin(x[0]) / 2 - x[2]);
  };
  const auto energy = [&](const Eigen::Vector4d& x) {
    const double arm = G::kRod / 4 + G::rod_inertia().y() + G::kBall, s = stretch(x) - G::kRest;
    return arm * x[1] * x[1] + spin * spin / G::around(x[0]) / 2 + G::kSlider * (x[3] * x[3] / 2 + kGravity * x[2]) -
           2 * kGravity * (G::kRod / 2 + G::kBall) * std::sin(x[0]) + G::kStiff * s * s;
  };
  Eigen::Vector4d x = G::start();
  assert_true(std::fabs(stretch(x) - G::kRest) < 1e-15);
  const double first = energy(x);
  double taken = 0, least = x[0], most = x[0];
  for (int i = 0; i < 100000; ++i) {
    const double before = stretch(x);
    x = runge_kutta(x, h, G::rate);
    const double rate = (stretch(x) - before) / h;
    taken += 2 * G::kDamp * rate * rate * h;
    least = std::min(least, x[0]), most = std::max(most, x[0]);
  }
  // Mean rates of steps in place of rates: off by the share of a step in what changes as fast as K / C = 20 / s, but
  // for the first moments.
  assert_true(taken > 1e-3 && std::fabs(energy(x) + taken - first) < 1e-3 * taken);
  assert_true(most - least > 0.1);  // it swings
}

/// A disk that rolls without slip, from its laws of motion alone: spin, and which way its face looks.
struct RollingDisk {
  double radius, half, rolling;
  Eigen::Vector3d n, spin;

  Eigen::Vector3d rim(const Eigen::Vector3d& face) const {  // from the middle to the point that touches
    const Eigen::Vector3d up(0, 1, 0);
    return radius * (face * face.y() - up).normalized() - half * face;
  }
  Eigen::Matrix3d inertia() const {
    const double across = radius * radius / 4 + half * half / 3;
    return across * Eigen::Matrix3d::Identity() + (radius * radius / 2 - across) * n * n.transpose();
  }
  static Eigen::Matrix3d cross(const Eigen::Vector3d& v) {
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
  }
  /// I w' + w x I w = r x (v' - g) + moment, and v = -w x r.
  Eigen::Vector3d spin_rate() const {
    const Eigen::Vector3d r = rim(n), turned = spin.cross(n), g(0, -kGravity, 0);
    const double d = 1e-6;
    const Eigen::Vector3d r_rate = (rim(n + d * turned) - rim(n - d * turned)) / (2 * d);
    const Eigen::Vector3d level(spin.x(), 0, spin.z());
    const Eigen::Vector3d moment = -rolling * kGravity * level.normalized();
    const Eigen::Vector3d rest = -spin.cross(inertia() * spin) + r.cross(-spin.cross(r_rate) - g) + moment;
    return (inertia() - cross(r) * cross(r)).inverse() * rest;
  }
  double energy() const {
    const Eigen::Vector3d r = rim(n), v = -spin.cross(r);
    return kGravity * (-r.y() - half) + v.squaredNorm() / 2 + spin.dot(inertia() * spin) / 2;
  }
  void step(double h) {  // midpoint rule
    RollingDisk middle = *this;
    middle.n = (n + h / 2 * spin.cross(n)).normalized(), middle.spin += h / 2 * spin_rate();
    n = (n + h * middle.spin.cross(middle.n)).normalized(), spin += h * middle.spin_rate();
  }
};

/// By its laws of motion alone its spin turns about the vertical, and does not change otherwise.
static void a_wheel_keeps_its_lean(void**) {
  for (const TurningWheel& wheel : {TurningWheel{0.3, 0.006, 1.2, 0.8}, {1, 0.1, 0.7, 2}, {0.05, 0.001, 1.4, 5}}) {
    const Eigen::Vector3d spin = wheel.spin(kGravity);
    const RollingDisk disk{wheel.radius, wheel.half, 0, wheel.axis(), spin};
    const Eigen::Vector3d about(0, wheel.round, 0);
    assert_true((disk.rim(disk.n) - wheel.to_ground()).norm() < 1e-12);
    assert_true((disk.spin_rate() - about.cross(spin)).norm() < 1e-5 * spin.norm() * wheel.round);
    assert_true((spin.cross(disk.n) - about.cross(disk.n)).norm() < 1e-12);  // its axis goes round with it
  }
}

/// Of the cone's points: its energy is that of a body that turns about the line on which it lies.
static void a_cone_on_its_side_turns_about_its_line(void**) {
  for (const SlopeCone& cone : {SlopeCone{1, 0.436, 0.1}, {0.3, 0.9, 0.1}, {2, 0.2, 0.3}}) {
    const double radius = cone.height * std::tan(cone.half_angle), c = std::cos(cone.half_angle);
    // About its apex, along its axis and across; going round at 1 rad/s it turns at cot(half_angle) about its line.
    const double along = 0.3 * radius * radius, across = 0.6 * (cone.height * cone.height + radius * radius / 4);
    const double spin = 1 / std::tan(cone.half_angle), s = std::sin(cone.half_angle);
    const double twice_energy = spin * spin * (along * c * c + across * s * s);
    assert_true(std::fabs(cone.inertia() - twice_energy) < 1e-12 * twice_energy);
  }
}
static void a_ladder_keeps_its_energy_and_leaves_the_wall(void**) {
  for (const Ladder& ladder : {Ladder{1, 0.02}, {0.2, 0.05}, {5, 0.01}}) {
    Ladder::Motion motion(1.1);
    const auto energy = [&] {
      return motion.velocity(ladder).squaredNorm() / 2 + ladder.inertia() * motion.rate() * motion.rate() / 2 +
             kGravity * motion.middle(ladder).y();
    };
    const double before = energy();
    double off_at = 0;
    while (motion.angle() > 0.1) {
      const bool was_off = motion.is_off();
      motion.step(ladder, 1e-4, kGravity);
      if (motion.is_off() && !was_off) off_at = std::sin(motion.angle());
      assert_true(std::fabs(energy() - before) < 1e-10 * before);
    }
    assert_true(std::fabs(off_at - 2.0 / 3 * std::sin(1.1)) < 1e-3 / std::sqrt(ladder.half));  // at 2/3 of its height
  }
}

static void a_coin_goes_round_as_its_weight_asks_and_falls_as_its_moment_takes(void**) {
  for (double half : {0.01, 0.1}) {
    const Coin coin{0.5, half};
    const double tilt = 0.3, s = std::sin(tilt), c = std::cos(tilt), ratio = half / coin.radius;
    const double round = coin.round(tilt, kGravity);
    RollingDisk disk{coin.radius, half, 0, {s, c, 0}, round * s * Eigen::Vector3d(ratio * s - c, s + ratio * c, 0)};
    assert_true(std::fabs(disk.energy() - coin.energy(tilt, kGravity)) < 1e-12);
    RollingDisk steady = disk;
    for (int i = 0; i < 10000; ++i) steady.step(1e-4);
    assert_true(std::fabs(steady.n.y() - c) < 1e-4);  // a step of the midpoint rule is off by (round h)^2 / 6
    // Slow against going round: it follows to the share of a turn's energy that a turn takes, some ten of rolling /
    // radius.
    disk.rolling = 1e-3 * coin.radius;
    double t = 0;
    const double to = 0.25, wanted = coin.energy(to, kGravity);
    for (; disk.energy() > wanted; t += 1e-4) disk.step(1e-4);
    assert_true(std::fabs(t / coin.time_between(tilt, to, disk.rolling, kGravity) - 1) < 0.01);
    assert_true(std::fabs(coin.tilt_of(wanted, kGravity) - to) < 1e-12);
  }
  // A thin one has 3/2 of its height's energy, and a time that the law of a small tilt gives.
  const Coin thin{0.5, 1e-9};
  assert_true(std::fabs(thin.energy(0.2, kGravity) / (1.5 * kGravity * 0.5 * std::sin(0.2)) - 1) < 1e-8);
  const double small = 1e-3, end = 1e-5, rolling = 1e-3;
  const double law = 1.5 * 0.5 / rolling * std::sqrt(0.5 / kGravity) * (std::sqrt(small) - std::sqrt(end));
  assert_true(std::fabs(thin.time_between(small, end, rolling, kGravity) / law - 1) < 1e-5);
}

static void a_leaning_rod_has_one_answer(void**) {
  const double speed = 1, h = 1e-4;
  const LeaningRod rod{0.5, 0.002, 72 * std::acos(-1) / 180};
  Eigen::Matrix2d w;  // velocity of the end, along and up, per impulse there
  w << 1 + rod.y() * rod.y() / rod.inertia(), -rod.x() * rod.y() / rod.inertia(), -rod.x() * rod.y() / rod.inertia(),
      1 + rod.x() * rod.x() / rod.inertia();
  for (double mu : {1.3, 1.5}) {
    const Eigen::Vector2d free(-speed, -kGravity * h);
    int answers = 0;
    // It leaves: it would have to move up. It slides on: friction against it, a force that pushes.
    answers += free.y() >= 0;
    const Eigen::Vector2d drag(mu, 1);
    assert_true(std::fabs((w * drag).y() - rod.yields(mu)) < 1e-14);
    const double push = -free.y() / rod.yields(mu);
    answers += push >= 0 && (free + push * (w * drag)).x() < 0;
    // It stops: within the cone.
    const Eigen::Vector2d stop = w.ldlt().solve(-free);
    const bool stops = stop.y() >= 0 && std::fabs(stop.x()) <= mu * stop.y();
    answers += stops;
    assert_int_equal(answers, 1);
    assert_true(stops == (mu == 1.5));  // although the step is short
    if (!stops) continue;
    const double spin = (rod.x() * stop.y() - rod.y() * stop.x()) / rod.inertia();
    assert_true(std::fabs(spin - rod.spin_after(speed)) < 10 * kGravity * h);
  }
}

using Long3 = Eigen::Matrix<long double, 3, 1>;
using Long4 = Eigen::Matrix<long double, 4, 1>;

static void air_slows_as_its_law_says(void**) {
  const double g = kGravity, rate = 0.3, speed = -4;
  using Long2 = Eigen::Matrix<long double, 2, 1>;  // way, speed
  Long2 slow(0, speed), fast(0, 0);
  const int n = 100000;
  const double T = 10, h = T / n;
  for (int i = 0; i < n; ++i) {
    slow = runge_kutta(slow, h, [&](const Long2& x) { return Long2(x[1], g - rate * x[1]); });
    fast = runge_kutta(fast, h, [&](const Long2& x) { return Long2(x[1], g - rate * x[1] * x[1]); });
  }
  const Course thrown = thrown_into_air(T, speed, rate, g), fallen = fallen_through_air(T, rate, g);
  assert_true(std::fabs(thrown.way - static_cast<double>(slow[0])) < 1e-12 * thrown.way);
  assert_true(std::fabs(thrown.speed - static_cast<double>(slow[1])) < 1e-12 * thrown.speed);
  assert_true(std::fabs(fallen.way - static_cast<double>(fast[0])) < 1e-12 * fallen.way);
  assert_true(std::fabs(fallen.speed - static_cast<double>(fast[1])) < 1e-12 * fallen.speed);
  // Thin air: a parabola but for rate (v t^2 / 2 + g t^3 / 6). Long after: an even fall.
  const double thin = 1e-5, way = 2 * speed + 2 * g - thin * (2 * speed + 4 * g / 3);
  assert_true(std::fabs(thrown_into_air(2, speed, thin, g).way - way) < 16 * thin * thin * g);
  assert_true(fallen_through_air(1e6, rate, g).speed == std::sqrt(g / rate));
}

/// A rigid body about a point that rests, from the laws alone: (turn, angular momentum), world axes.
struct Turning {
  Long3 inertia, arm;      ///< kg m^2, principal, about the point; m, of the weight from it, body axes
  long double weight = 0;  ///< N, along -y
  using State = Eigen::Matrix<long double, 7, 1>;
  using LongQuat = Eigen::Quaternion<long double>;

  static LongQuat turn(const State& x) { return LongQuat(Long4(x.head<4>())).normalized(); }
  Long3 spin(const State& x) const {  // body axes
    return (turn(x).conjugate() * Long3(x.tail<3>())).cwiseQuotient(inertia);
  }
  State rate(const State& x) const {
    const LongQuat q = turn(x);
    const Long3 half = q * spin(x) / 2;
    State d;
    d << (LongQuat(0, half.x(), half.y(), half.z()) * LongQuat(Long4(x.head<4>()))).coeffs(),
        Long3(q * arm).cross(Long3(0, -weight, 0));
    return d;
  }
  State run(const Long3& omega, long double seconds, int steps) const {
    State x;
    x << 0, 0, 0, 1, inertia.cwiseProduct(omega);
    for (int i = 0; i < steps; ++i)
      x = runge_kutta(x, static_cast<double>(seconds / steps), [&](const State& s) { return rate(s); });
    return x;
  }
};

static void a_free_top_turns_as_euler_s_equations_say(void**) {
  // Scenes 3, 4 and 5, until after a flip; one that circles its smallest moment. Steps of 2e-5 s: (h w)^4 w T / 120 is
  // below 1e-17, and what leaves the middle axis takes a difference along, 500 times larger.
  const struct {
    Eigen::Vector3d sides, omega;
    double seconds;
  } cases[] = {{{1, 4, 9}, {0.1, 5, 0.1}, 3},
               {{1, 2, 3}, {4, 1, 2}, 3},
               {{1, 2, 3}, {0.01, 5, 0.01}, 4},
               {{1, 2, 3}, {-1, 2, 6}, 2}};
  for (const auto& c : cases) {
    const Eigen::Vector3d squares = c.sides.cwiseProduct(c.sides);
    const Eigen::Vector3d inertia = (Eigen::Vector3d::Constant(squares.sum()) - squares) / 12;
    const FreeTop top(inertia, c.omega);
    const Turning body{inertia.cast<long double>(), Long3::Zero()};
    const Turning::State end = body.run(c.omega.cast<long double>(), c.seconds, static_cast<int>(c.seconds / 2e-5));
    const Eigen::Quaterniond turn = Turning::turn(end).cast<double>(), closed = top.orientation(c.seconds);
    assert_true((top.omega(c.seconds) - body.spin(end).cast<double>()).norm() < 1e-12 * c.omega.norm());
    assert_true(2 * (closed.conjugate() * turn).vec().norm() < 1e-12 * c.omega.norm() * c.seconds);
    // The closed form's own momentum and energy.
    const Eigen::Vector3d w = top.omega(40), start = inertia.cwiseProduct(c.omega);
    assert_true((top.orientation(40) * inertia.cwiseProduct(w) - start).norm() < 1e-12 * start.norm());
    assert_true(std::fabs(w.dot(inertia.cwiseProduct(w)) / c.omega.dot(start) - 1) < 1e-12);
  }
  // A flip is where the spin about the middle axis is gone.
  const FreeTop plank({13, 10, 5}, {0.01, 5, 0.01});
  assert_int_equal(plank.middle(), 1);
  assert_true(plank.zero(0) > 0 && plank.zero(0) < plank.period() / 2);
  assert_true(std::fabs(plank.zero(2) - plank.zero(0) - plank.period()) < 1e-12);
  const Turning body{Long3(13, 10, 5), Long3::Zero()};
  const Turning::State flip = body.run(Long3(0.01L, 5, 0.01L), plank.zero(0), 150000);
  assert_true(std::fabs(static_cast<double>(body.spin(flip).y())) < 1e-11);  // 12 rad/s^2 there: a picosecond
}

static void a_heavy_top_nods_as_a_rigid_body_does(void**) {
  using H = HeavyTop;
  const double hung = H::across() + H::kArm * H::kArm, T = 2;
  const Turning body{Long3(H::axial(), hung, hung), Long3(H::kArm, 0, 0), kGravity};
  const Turning::State end = body.run(Long3(H::kSpin, 0, 0), T, 200000);
  Eigen::Vector3d x = H::start();
  const auto energy = [&] {  // about its axis it keeps what it has
    const double s = std::sin(x[0]), round = H::rate(x)[2];
    return hung * (x[1] * x[1] + round * round * s * s) / 2 + kGravity * H::kArm * std::cos(x[0]);
  };
  double lowest = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) x = runge_kutta(x, T / n, H::rate), lowest = std::max(lowest, x[0]);
  const Eigen::Vector3d there = (Turning::turn(end) * body.arm).cast<double>();
  assert_true((H::middle(x) - there).norm() < 1e-12);
  assert_true(std::fabs(energy()) < 1e-12);
  // It nods: by 2 m g l I / J^2 at most, and always the same way round.
  const double spin = H::axial() * H::kSpin;
  assert_true(lowest > std::acos(-1) / 2 + 0.05 &&
              lowest - std::acos(-1) / 2 < 2 * kGravity * H::kArm * hung / (spin * spin));
  assert_true(x[2] > 0);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(air_slows_as_its_law_says),
      cmocka_unit_test(a_free_top_turns_as_euler_s_equations_say),
      cmocka_unit_test(a_heavy_top_nods_as_a_rigid_body_does),
      cmocka_unit_test(a_bounce_is_a_fall_and_a_reflection),
      cmocka_unit_test(what_turns_round_does_so_at_its_moment),
      cmocka_unit_test(a_rod_that_is_hit_keeps_energy_and_momentum),
      cmocka_unit_test(blocks_slide_as_their_forces_say),
      cmocka_unit_test(a_pulled_plate_obeys_newton_with_its_balls),
      cmocka_unit_test(a_skidding_ball_loses_speed_and_gains_spin_until_they_meet),
      cmocka_unit_test(a_cannon_keeps_momentum_and_energy),
      cmocka_unit_test(the_arch_can_stand),
      cmocka_unit_test(the_thinnest_arch_falls_by_its_hinges_where_it_is_thinner),
      cmocka_unit_test(an_arm_loses_what_its_drives_take_and_ends_at_the_mark),
      cmocka_unit_test(bricards_ring_is_shut_and_its_motion_keeps_energy),
      cmocka_unit_test(a_governor_loses_what_its_dampers_take),
      cmocka_unit_test(a_wheel_keeps_its_lean),
      cmocka_unit_test(a_cone_on_its_side_turns_about_its_line),
      cmocka_unit_test(a_ladder_keeps_its_energy_and_leaves_the_wall),
      cmocka_unit_test(a_coin_goes_round_as_its_weight_asks_and_falls_as_its_moment_takes),
      cmocka_unit_test(a_leaning_rod_has_one_answer),
  };
  return cmocka_run_group_tests_name("tools/accuracy_references", tests, nullptr, nullptr);
}
