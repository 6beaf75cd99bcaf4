// Families of hard pairs whose answer is known from geometry (tests/exact_families.h): every answer right, on every
// dial.
#include <cstdio>

#include "carom_test.h"
#include "collision/narrow/hybrid.h"
#include "exact_families.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kTolerances[] = {1e-3, 1e-6, 1e-9, 1e-12};

struct Tally {
  int pairs = 0, answers = 0, wrong = 0, short_of = 0;
};

/// What is wrong with an answer, or null.
/// @param slack  m, how far the pose that the query got may be from the one that the reference is of
const char* fault_in(const Known& e, const Shape& a, const Shape& b, const Frame& f, const QuerySettings& s, Real shell,
                     Real slack, const QueryResult& r) {
  const Real size = f.p.abs().sum() + a.bounding_radius + b.bounding_radius + shell;
  const Real rounding = kBracketRounding * kUnitRoundoff * size, asked = s.tolerance * size_of_pair(a, b, f);
  const Real width = r.upper - r.lower, radii = a.core_radius + b.core_radius + shell;
  if (!(carom::finite(r.normal) && carom::finite(r.point_a) && carom::finite(r.point_b))) return "not finite";
  if (!(r.lower <= r.separation && r.separation <= r.upper)) return "separation outside its bracket";
  if (!(r.lower - slack <= e.high - shell && e.low - shell <= r.upper + slack)) return "reference outside the bracket";
  if (r.status == QueryStatus::exact_enough && !(width <= asked)) return "not as exact as it says";
  if (r.gjk_iterations > 2 * s.gjk_cap || r.epa_iterations > s.epa_cap) return "iterations";
  // The normal proves the lower bound.
  if (exact_bound(a, b, f, r.normal) - shell < r.lower - rounding) return "normal proves less";
  if (e.normal) {
    // A normal off by x proves less by (1 - cos x) smallest: no more than the bracket is wide.
    const Long lost = (width + slack + (e.high - e.low)) / e.smallest;
    if (lost < 1e-2 && r.normal.dot(*e.normal) < 1 - std::max<Long>(lost, 64 * kUnitRoundoff)) return "normal";
  }
  // Points on the surfaces, the separation apart along the normal.
  const Vec3 v = f.apply(r.point_b) - r.point_a;
  if (std::fabs(r.normal.dot(v) - r.separation) > width + rounding) return "points apart";
  if (r.gjk_iterations > 0 && r.lower + radii > 0 && (v + radii * r.normal).norm() - radii > r.upper + rounding)
    return "core points";
  for (int axis = 0; axis < 6; ++axis) {
    const Vec3 n = (axis < 3 ? 1 : -1) * Vec3::unit(axis % 3);
    const Real reach = 0.5 * shell + width * (r.gjk_iterations == 0) + rounding;
    if (n.dot(r.point_a - support_point(a, n)) > reach || n.dot(r.point_b - support_point(b, n)) > reach)
      return "point outside";
  }
  return nullptr;
}

class Checker {
 public:
  Tally tally;

  void operator()(const ExactPair& e) {
    ++tally.pairs;
    QuerySettings s;
    s.routines = false;
    for (const Real tolerance : kTolerances)
      for (const Simplex simplex : {Simplex::johnson, Simplex::voronoi, Simplex::voronoi_last}) {
        s.tolerance = tolerance;
        s.simplex = simplex;
        ask(e, e.a, e.b, e.b_in_a, s, 0, "direct");
      }
    s.tolerance = 1e-6;
    QuerySettings other = s;
    other.method = Method::hybrid;
    other.margin = 1e-3 * std::min(e.a.bounding_radius, e.b.bounding_radius);
    ask(e, e.a, e.b, e.b_in_a, other, 0, "hybrid");
    other = s;
    other.routines = true;
    ask(e, e.a, e.b, e.b_in_a, other, 0, "routine");
    // A's frame seen from B's: the transpose is the inverse but for 12 u, and the offset rounds.
    const Real size = e.b_in_a.p.abs().sum() + e.a.bounding_radius + e.b.bounding_radius;
    const Frame back(e.b_in_a.r.transpose(), -(e.b_in_a.r.transpose() * e.b_in_a.p));
    Known turned = e;
    if (turned.normal) turned.normal = Vec3(-e.b_in_a.rotate_inverse(*turned.normal));
    ask(turned, e.b, e.a, back, s, 32 * kUnitRoundoff * size, "swapped");
    // Both a thousand kilometres out, at another attitude: a position there is good to its spacing of numbers.
    Frame out(random_rotation(random_).matrix(), 1e6 * random_.direction());
    const Frame placed = out * e.b_in_a;
    const Real spacing = 4 * kUnitRoundoff * (1e6 * 3 + e.b_in_a.p.norm());
    ask(e, e.a, e.b, relative(out, placed), s, kPoseRounding * kUnitRoundoff * size + spacing, "far out");
  }

 private:
  void ask(const Known& e, const Shape& a, const Shape& b, const Frame& f, const QuerySettings& s, Real slack,
           const char* how) {
    QueryResult r;
    SupportFault fault;
    distance(a, b, f, s, nullptr, r, fault);
    ++tally.answers;
    const bool routine = s.routines && r.gjk_iterations == 0;
    const Real shell = routine ? 0 : shells(s);
    const char* what = fault.kind != SupportFault::none ? "fault" : fault_in(e, a, b, f, s, shell, slack, r);
    const Real size = f.p.abs().sum() + a.bounding_radius + b.bounding_radius + shell;
    const Real asked = s.tolerance * size_of_pair(a, b, f);
    const bool reachable = asked > 8 * kBracketRounding * kUnitRoundoff * size;
    tally.short_of += !what && !e.ring && reachable && slack == 0 && r.status != QueryStatus::exact_enough;
    if (!what) return;
    ++tally.wrong;
    if (tally.wrong < 12)
      std::printf(
          "%s, %s: %s; forms %u %u simplex %u tolerance %g: %.17g in [%.17g, %.17g], reference [%.17Lg, %.17Lg], "
          "status %u, %d + %d\n",
          e.name.c_str(), how, what, static_cast<unsigned>(a.form), static_cast<unsigned>(b.form),
          static_cast<unsigned>(s.simplex), s.tolerance, r.separation, r.lower, r.upper, e.low, e.high,
          static_cast<unsigned>(r.status), r.gjk_iterations, r.epa_iterations);
  }

  Random random_{99};
};

void check(void (*family)(Random&, int, const Take&), std::uint64_t seed, int count) {
  Random random(seed);
  Checker checker;
  family(random, count, [&](ExactPair&& e) { checker(e); });
  assert_true(2 * checker.tally.pairs > count);
  assert_int_equal(checker.tally.wrong, 0);
  // Not a promise but a watch: answers that say they fall short of what was asked (their brackets are true, and
  // judged). Of needles, plates and discs 1e8 times as long as thick these are up to 23 in 10,000.
  if (checker.tally.short_of > 0)
    std::printf("%d of %d answers say they fall short\n", checker.tally.short_of, checker.tally.answers);
  assert_true(200 * checker.tally.short_of <= checker.tally.answers);
}

}  // namespace

static void boxes_with_parallel_axes(void**) { check(parallel_boxes, 1, 2000); }
static void a_sphere_and_anything(void**) { check(sphere_and_any, 2, 2000); }
static void round_bodies_with_parallel_axes(void**) { check(parallel_axes, 3, 2000); }
static void anything_over_a_face(void**) { check(over_a_face, 4, 2000); }
static void farthest_points_opposite_each_other(void**) { check(opposite_points, 5, 2000); }
static void boxes_across_each_other(void**) { check(crossed_boxes, 6, 2000); }

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(boxes_with_parallel_axes),
      cmocka_unit_test(a_sphere_and_anything),
      cmocka_unit_test(round_bodies_with_parallel_axes),
      cmocka_unit_test(anything_over_a_face),
      cmocka_unit_test(farthest_points_opposite_each_other),
      cmocka_unit_test(boxes_across_each_other),
  };
  return cmocka_run_group_tests_name("oracle/hard_families", tests, nullptr, nullptr);
}
