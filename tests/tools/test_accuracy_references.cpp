// What accuracy scenes are judged by is itself judged: every closed form against an integration that knows only the
// laws, and every arrangement that should stand against a proof that it can.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

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

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_bounce_is_a_fall_and_a_reflection),
      cmocka_unit_test(what_turns_round_does_so_at_its_moment),
      cmocka_unit_test(a_rod_that_is_hit_keeps_energy_and_momentum),
      cmocka_unit_test(blocks_slide_as_their_forces_say),
      cmocka_unit_test(a_pulled_plate_obeys_newton_with_its_balls),
      cmocka_unit_test(a_skidding_ball_loses_speed_and_gains_spin_until_they_meet),
      cmocka_unit_test(a_cannon_keeps_momentum_and_energy),
      cmocka_unit_test(the_arch_can_stand),
  };
  return cmocka_run_group_tests_name("tools/accuracy_references", tests, nullptr, nullptr);
}
