// Carry-over: a bracket widened by the motion since holds the truth, is as narrow as asked, and saves most queries.
#include "carom_test.h"
#include "coherent_pairs.h"
#include "collision/narrow/carry_over.h"
#include "collision/narrow/hybrid.h"

using namespace carom;
using namespace carom::test;

namespace {

QueryResult fresh(const CoherentPair& p, const Frame& pose, const QuerySettings& settings = {}) {
  QueryResult r;
  SupportFault fault;
  generic_distance(p.a, p.b, pose, settings, nullptr, r, fault);
  return r;
}

struct Count {
  int frames = 0, carried = 0;
};

/// Follows a pair as the narrow phase does and holds every carried answer against a fresh one.
void follow(const CoherentPair& p, Real width, const QuerySettings& settings, Count& count) {
  const Real shell = shells(settings);
  Certificate certificate;
  for (const Frame& pose : p.b_in_a) {
    ++count.frames;
    const QueryResult truth = fresh(p, pose, settings);
    QueryResult r;
    if (!carry_over(p.a, p.b, pose, width, shell, certificate, r)) {
      certify(truth, pose, shell, certificate);
      continue;
    }
    ++count.carried;
    assert_true(r.lower <= truth.upper && truth.lower <= r.upper);
    assert_true(r.lower <= r.separation && r.separation <= r.upper && r.upper - r.lower <= width);
    assert_int_equal(static_cast<int>(r.status), static_cast<int>(QueryStatus::exact_enough));
    assert_true(std::fabs(r.normal.norm() - 1) <= 8 * kEpsilon && r.support_calls <= 2);
    // The normal attains the answer: no point of B - A lies before its plane.
    const Vec3 n_b = pose.rotate_inverse(-r.normal);
    const Real plane = r.normal.dot(pose.apply(support_point(p.b, n_b)) - support_point(p.a, r.normal)) - shell;
    assert_true(std::fabs(plane - r.separation) <= 1e-13);
    // The points are points of the shapes, so they lie behind their planes, apart along the normal by no less than the
    // answer; and by no more than it and what both have moved since: width on each side.
    const Real apart = r.normal.dot(pose.apply(r.point_b) - r.point_a);
    assert_true(apart >= r.separation - 1e-13 && apart <= r.upper + 2 * width);
  }
}

Count follow_all(Real speed, Real width, int family, const QuerySettings& settings = {}) {
  Random random(static_cast<std::uint64_t>(70 + family));
  Count count;
  for (int i = 0; i < 12; ++i)
    follow(coherent_pair(random, family, i % 3 ? family : 1, random.uniform(-0.15, 0.1), speed, 120), width, settings,
           count);
  return count;
}

}  // namespace

static void every_carried_answer_is_a_true_bracket(void**) {
  for (int family = 0; family < kFamilyCount; ++family) {
    if (family == 4) continue;  // a thousand vertices: as 32
    for (const Real speed : {0.05, 1.0, 20.0})
      for (const Real width : {1e-4, 5e-3, 5e-2}) follow_all(speed, width, family);
  }
}

static void a_small_shape_far_out_on_a_large_one_feels_its_turning(void**) {
  // The ball stays, the plate tips about its own centre 4 m away: in the ball's frame the plate's origin does not move.
  CoherentPair p{sphere(0.1), box(Vec3(5, 0.1, 5)), {}};
  for (int i = 0; i < 200; ++i) {
    const Mat3 tip = exp_map(Vec3(0, 0, 2e-4 * i)).matrix();
    p.b_in_a.push_back(Frame(tip, Vec3(-4, -0.18, 0)));
  }
  Count count;
  follow(p, 2e-2, QuerySettings(), count);
  assert_true(count.carried > count.frames / 2);
  assert_true(count.carried < count.frames - 200 * 2e-4 * 4 / 2e-2);  // it tips 0.16 m there: eight times the width
}

static void slow_motion_is_mostly_carried(void**) {
  // A frame moves points by D <= 0.2 mm + 1 mrad * 1.7 m = 1.9 mm, so a bracket of 20 mm lasts 20 / (2 * 1.9) = 5
  // frames at the very least: four of five queries are saved.
  for (const int family : {1, 3, 7}) {
    const Count count = follow_all(1, 2e-2, family);
    assert_true(5 * count.carried >= 4 * (count.frames - 12));
  }
}

static void the_hybrid_carries_its_shells(void**) {
  QuerySettings hybrid;
  hybrid.method = Method::hybrid;
  const Count count = follow_all(1, 2e-2, 1, hybrid);
  assert_true(count.carried > count.frames / 2);
  // A certificate of other shells says nothing.
  Random random(3);
  const CoherentPair p = coherent_pair(random, 1, 1, 0.1, 1, 1);
  Certificate certificate;
  certify(fresh(p, p.b_in_a[0], hybrid), p.b_in_a[0], shells(hybrid), certificate);
  QueryResult r;
  assert_true(carry_over(p.a, p.b, p.b_in_a[0], 1, shells(hybrid), certificate, r));
  assert_false(carry_over(p.a, p.b, p.b_in_a[0], 1, 0, certificate, r));
}

static void what_proves_nothing_is_not_carried(void**) {
  Random random(4);
  const CoherentPair p = coherent_pair(random, 3, 7, 0.5, 1, 1);
  Certificate certificate;
  QueryResult r;
  assert_false(carry_over(p.a, p.b, p.b_in_a[0], 1, 0, certificate, r));
  QuerySettings near;
  near.max_distance = 0.1;
  certify(fresh(p, p.b_in_a[0], near), p.b_in_a[0], 0, certificate);
  assert_false(certificate.known);
  certify(fresh(p, p.b_in_a[0]), p.b_in_a[0], 0, certificate);
  assert_true(certificate.known);
  // Poses that are no poses.
  Frame lost = p.b_in_a[0];
  lost.p.x() = std::nan("");
  assert_false(carry_over(p.a, p.b, lost, 1, 0, certificate, r));
  lost = p.b_in_a[0];
  lost.r(0, 0) = kInfinity;
  assert_false(carry_over(p.a, p.b, lost, 1, 0, certificate, r));
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_carried_answer_is_a_true_bracket),
      cmocka_unit_test(a_small_shape_far_out_on_a_large_one_feels_its_turning),
      cmocka_unit_test(slow_motion_is_mostly_carried),
      cmocka_unit_test(the_hybrid_carries_its_shells),
      cmocka_unit_test(what_proves_nothing_is_not_carried),
  };
  return cmocka_run_group_tests_name("unit/collision/carry_over", tests, nullptr, nullptr);
}
