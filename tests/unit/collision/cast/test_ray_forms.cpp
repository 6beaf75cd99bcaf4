// Rays in closed form beside the same rays by support functions, and beside textbook formulas in long double.
#include "carom_test.h"
#include "cast_truth.h"
#include "collision/cast/ray.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

CastResult ask(const Ray& ray, const Shape& shape, const Frame& frame, bool routines, Real target = 0) {
  CastSettings settings;
  settings.tolerance = 1e-12;
  settings.routines = routines;
  settings.target = target;
  CastResult result;
  SupportFault fault;
  cast_ray(ray, shape, frame, settings, result, fault);
  assert_int_equal(fault.kind, SupportFault::none);
  return result;
}

MaybeStretch truth(const Ray& ray, const Shape& shape, const Frame& frame) {
  const auto r = frame.r.cast<Long>();
  const Long3 o = r.transpose() * (ray.origin.cast<Long>() - frame.p.cast<Long>());
  return through(shape, o, Long3(r.transpose() * ray.direction.cast<Long>()), nullptr);
}

/// Both brackets hold the truth, so they share it; what one proves, the other does not deny.
/// @param at_edges  rays pass edges by less than the walk's slack: its bracket is then of a surface that is off by that
void assert_agree(const CastResult& form, const CastResult& walk, const Ray& ray, bool at_edges = false) {
  assert_int_equal(form.support_calls, 0);
  if (form.outcome == CastOutcome::undecided || walk.outcome == CastOutcome::undecided) return;
  assert_int_equal(static_cast<int>(form.outcome), static_cast<int>(walk.outcome));
  assert_true(form.lower <= form.time && form.time <= form.upper);
  if (form.outcome == CastOutcome::miss) {
    assert_true(form.time == ray.max && form.upper == kInfinity);
    return;
  }
  assert_true(std::fabs(form.normal.norm() - 1) < 1e-14);
  const Real speed = ray.direction.norm(), sine = form.normal.dot(ray.direction) / speed;
  // Where the surface there runs along the ray, one that is off by slack is met anywhere.
  if (at_edges && sine < 1e-6) return;
  const Real off = at_edges && sine > 0 ? (form.slack + walk.slack) / (sine * speed) : 0;
  assert_true(form.lower <= walk.upper + off && walk.lower <= form.upper + off);
  if (form.outcome == CastOutcome::overlap) {
    assert_true((form.normal - walk.normal).norm() == 0 && form.time == 0);
  } else if (sine > 0.01) {  // a point is known to slack over the sine of the angle of incidence, and to the brackets
    const Real widths = form.upper - form.lower + walk.upper - walk.lower;
    const Real rounding =
        8 * kUnitRoundoff * form.point_a.norm();  // slack is of the shape's frame, points of the world's
    const Real error = 4 * (form.slack + walk.slack) / sine + widths * speed + rounding;
    assert_true((form.point_a - walk.point_a).norm() < error && (form.point_b - walk.point_b).norm() < error);
  }
}

}  // namespace

static void forms_agree_with_support_functions_and_the_truth(void**) {
  Random random(71);
  int hits = 0, overlaps = 0, misses = 0, flat = 0;
  constexpr int kWithRoutine[] = {0, 1, 2, 5, 6, 7};  // sphere, box, capsule, cylinder, cone, ellipsoid
  for (int k = 0; k < 6000; ++k) {
    const Shape shape = random_shape(random, kWithRoutine[k % 6]);
    const Frame frame(random_rotation(random).matrix(), random.in_cube(k % 7 == 0 ? 1e4 : 5));
    for (int i = 0; i < 40; ++i) {
      const Vec3 from = frame.p + random.uniform(0, 4) * random.direction();
      Ray ray{from, random.uniform(0.2, 3) * (frame.p + random.in_cube(1) - from), random.uniform(0.1, 2)};
      if (i % 8 == 0) ray.direction = frame.r.col(i / 8 % 3) * (i % 16 ? 2 : -2);  // along an axis of the form
      if (i % 11 == 0) ray.max = kInfinity;
      const CastResult form = ask(ray, shape, frame, true), walk = ask(ray, shape, frame, false);
      if (form.support_calls > 0) {  // nearly along a surface: the walk's own answer
        assert_true((shape.form == Form::capsule || shape.form == Form::cylinder || shape.form == Form::cone) &&
                    form.time == walk.time);
        ++flat;
        continue;
      }
      assert_agree(form, walk, ray);
      hits += form.outcome == CastOutcome::hit;
      overlaps += form.outcome == CastOutcome::overlap;
      misses += form.outcome == CastOutcome::miss;
      if (shape.form == Form::cone) continue;  // has no formula in long double: the walk's bracket alone
      const MaybeStretch real = truth(ray, shape, frame);
      const bool meets = real && real->out >= 0 && real->in <= ray.max;
      if (form.outcome == CastOutcome::miss) assert_false(meets);
      if (form.outcome == CastOutcome::hit && real) {
        const Long in = std::max(real->in, Long(0));
        assert_true(form.lower <= in && in <= form.upper);
      }
    }
  }
  assert_true(hits > 60000 && overlaps > 10000 && misses > 20000 && flat < 4000);
}

static void a_ray_swollen_to_a_ball_agrees_too(void**) {
  Random random(72);
  int hits = 0;
  for (int k = 0; k < 20000; ++k) {
    const Shape shape = random_shape(random, k % 2 ? 0 : 2);
    const Frame frame(random_rotation(random).matrix(), random.in_cube(5));
    const Vec3 from = frame.p + 4 * random.direction();
    const Ray ray{from, frame.p + random.in_cube(1.5) - from, 1.5};
    const Real target = random.uniform(0, 1);
    const CastResult form = ask(ray, shape, frame, true, target), walk = ask(ray, shape, frame, false, target);
    if (form.support_calls > 0) continue;
    assert_agree(form, walk, ray);
    hits += form.outcome == CastOutcome::hit;
    if (form.outcome != CastOutcome::hit) continue;
    assert_true(form.separation == target);
    // Moved from the ray's end to the surface: the target along the normal.
    assert_true(((form.point_b - form.point_a) - target * form.normal).norm() < 1e-12);
  }
  assert_true(hits > 8000);
}

static void grazes_and_edges_are_never_denied(void**) {
  // Rays aimed at the rim to within some ulps: a hit if they pass it by no more than rounding, which slack is three
  // times of; never undecided.
  Random random(73);
  int grazes = 0, decided = 0;
  const Shape shapes[] = {sphere(1), box(Vec3(1, 0.5, 2)), capsule(0.5, 1), cylinder(0.5, 1),
                          ellipsoid(Vec3(0.5, 1, 2))};
  for (int k = 0; k < 50000; ++k) {
    const Shape& shape = shapes[k % 5];
    const Real rim = k % 5 == 0 ? 1 : 0.5;
    const Real off = rim + random.uniform(-1, 1) * std::pow(10.0, random.uniform(-17, -10));
    const Frame frame;
    // Square to y for the box and, for the others, to z: passes at `off`.
    const Ray ray = k % 5 == 1 ? Ray{Vec3(-5, off, random.uniform(-1, 1)), Vec3(1, 0, 0), 10}
                               : Ray{Vec3(off, -5, 0), Vec3(0, 1, 0), 10};
    const CastResult form = ask(ray, shape, frame, true);
    const MaybeStretch real = truth(ray, shape, frame);
    assert_true(form.outcome == CastOutcome::hit || form.outcome == CastOutcome::miss);
    if (form.outcome == CastOutcome::miss) {
      assert_false(real && real->out >= real->in);
      ++decided;
      continue;
    }
    // Within the bracket the ray is as near as the slack; its estimate is, too.
    assert_true(off - rim <= form.slack && form.lower <= form.time && form.time <= form.upper);
    assert_true(std::fabs(form.normal.norm() - 1) < 1e-14);
    if (real && off <= rim - form.slack) assert_true(form.lower <= real->in && real->in <= form.upper);
    if (k % 5 == 1) assert_true(std::fabs(form.time - 4) < 1e-12);  // the box begins at -1
    (form.status == QueryStatus::rounding ? grazes : decided) += 1;
  }
  assert_true(grazes > 1000 && decided > 1000);
}

/// Rays past a cone's apex, rim and flank by some ulps, and rays that start below it, on its axis and beyond its apex,
/// where the mirrored cone is: beside the walk's own bracket.
static void a_cone_is_met_on_its_own_side(void**) {
  Random random(74);
  const Shape tip = cone(0.7, 1.1);
  const Frame frame;
  int hits = 0, misses = 0, by_walk = 0;
  for (int k = 0; k < 40000; ++k) {
    const Real off = random.uniform(-1, 1) * std::pow(10.0, random.uniform(-17, -1));
    Vec3 at;  // a place to pass
    switch (k % 4) {
      case 0:
        at = Vec3(0, 1.1 + off, 0);
        break;
      case 1:
        at = Vec3(0.7 + off, -1.1, 0);
        break;
      case 2:
        at = Vec3(0.35 + off, 0, 0);
        break;
      default:
        at = Vec3(off, random.uniform(1.1, 3), 0);  // above the apex
    }
    const Vec3 direction = random.direction();
    const Ray ray{at - random.uniform(0, 6) * direction, direction, random.uniform(1, 12)};
    const CastResult form = ask(ray, tip, frame, true), walk = ask(ray, tip, frame, false);
    if (form.support_calls > 0) {
      by_walk += std::fabs(off) > 1e-12;  // nearer by, whether it grazes is the walk's to say
      continue;
    }
    assert_agree(form, walk, ray, true);
    (form.outcome == CastOutcome::hit ? hits : misses) += 1;
  }
  assert_true(hits > 10000 && misses > 10000 && by_walk < 2000);
  const CastResult down = ask({Vec3(0.1, 5, 0), Vec3(0, -1, 0), 10}, tip, frame, true);
  assert_int_equal(down.support_calls, 0);
  assert_true(std::fabs(down.time - (5 - (1.1 - 0.1 * 2.2 / 0.7))) < 1e-13);
  assert_true((down.normal + Vec3(2.2, 0.7, 0).normalized()).norm() < 1e-13);
  const CastResult up = ask({Vec3(0.1, -5, 0), Vec3(0, 1, 0), 10}, tip, frame, true);
  assert_true(std::fabs(up.time - 3.9) < 1e-13 && up.normal.y() == 1);
}

static void starts_on_the_surface(void**) {
  const Shape ball = sphere(1), crate = box(Vec3(1, 1, 1)), pill = capsule(1, 1);
  const Frame frame;
  for (const Shape* s : {&ball, &crate}) {
    const CastResult in = ask({Vec3(0, 1, 0), Vec3(0, -1, 0), 1}, *s, frame, true);
    assert_true(in.outcome == CastOutcome::hit && in.time == 0 && in.normal.y() == -1);
    assert_true(ask({Vec3(0, 1, 0), Vec3(0, 1, 0), 1}, *s, frame, true).outcome == CastOutcome::miss);
    assert_true(ask({Vec3(0, 1, 0), Vec3(1, 0, 0), 1}, *s, frame, true).outcome == CastOutcome::miss);
  }
  const CastResult end = ask({Vec3(0, 5, 0), Vec3(0, -1, 0), 10}, pill, frame, true);
  assert_true(end.outcome == CastOutcome::hit && std::fabs(end.time - 3) < 1e-13 && end.support_calls == 0);
  const CastResult side = ask({Vec3(0.6, 5, 0), Vec3(0, -1, 0), 10}, pill, frame, true);
  assert_true(std::fabs(side.time - 3.2) < 1e-13 && std::fabs(side.normal.x() + 0.6) < 1e-13);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(forms_agree_with_support_functions_and_the_truth),
      cmocka_unit_test(a_ray_swollen_to_a_ball_agrees_too),
      cmocka_unit_test(grazes_and_edges_are_never_denied),
      cmocka_unit_test(a_cone_is_met_on_its_own_side),
      cmocka_unit_test(starts_on_the_surface),
  };
  return cmocka_run_group_tests_name("unit/collision/cast/ray_forms", tests, nullptr, nullptr);
}
