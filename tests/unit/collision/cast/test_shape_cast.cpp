// Linear shape casts: closed forms, a brute-force twin (bisection of the distance query), symmetry of roles, margins,
// starts in touch and in overlap, grazes, scale, distance from the origin.
#include "carom_test.h"
#include "collision/cast/shape_cast.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

CastResult ask(const Shape& a, const Frame& fa, const Vec3& motion, const Shape& b, const Frame& fb,
               const CastSettings& settings = {}, SupportFault* fault = nullptr) {
  CastResult result;
  SupportFault ignored;
  cast_shape(a, fa, motion, b, fb, settings, result, fault ? *fault : ignored);
  return result;
}

/// Separation beyond the target when A has gone a fraction t of its motion, to 1e-13.
Real gap_at(const Shape& a, Frame fa, const Vec3& motion, const Shape& b, const Frame& fb, Real target, Real t) {
  fa.p += t * motion;
  QuerySettings settings;
  settings.tolerance = 1e-13;
  settings.epa_cap = 512;
  QueryResult r;
  SupportFault fault;
  generic_distance(a, b, relative(fa, fb), settings, nullptr, r, fault);
  return r.separation - target;
}

/// The brute-force twin. The gap is convex in time: its least value by ternary search, its first zero by bisection.
struct Truth {
  CastOutcome outcome;
  Real time, least;
};
Truth twin(const Shape& a, const Frame& fa, const Vec3& motion, const Shape& b, const Frame& fb, Real target) {
  const auto gap = [&](Real t) { return gap_at(a, fa, motion, b, fb, target, t); };
  if (gap(0) <= 0) return {CastOutcome::overlap, 0, gap(0)};
  Real lo = 0, hi = 1, least = gap(1);
  for (int i = 0; i < 70 && least > 0; ++i) {
    const Real x = lo + (hi - lo) / 3, y = hi - (hi - lo) / 3, gx = gap(x), gy = gap(y);
    if (gx <= 0 || gy <= 0) {
      least = std::min(gx, gy);
      hi = gx <= 0 ? x : y;
      break;
    }
    (gx < gy ? hi : lo) = gx < gy ? y : x;
    least = std::min({least, gx, gy});
  }
  if (least > 0) return {CastOutcome::miss, 1, least};
  for (lo = 0; hi - lo > 1e-13;) {
    const Real middle = 0.5 * (lo + hi);
    if (middle == lo || middle == hi) break;
    (gap(middle) > 0 ? lo : hi) = middle;
  }
  return {CastOutcome::hit, hi, least};
}

}  // namespace

static void spheres_and_boxes_meet_when_the_textbook_says(void**) {
  const Shape ball = sphere(0.5), other = sphere(0.25);
  // Offset 0.45 across: contact at a distance of 0.75, 0.6 before the centre.
  const CastResult r = ask(ball, at(-3, 0.45, 0), Vec3(6, 0, 0), other, at(0, 0, 0));
  assert_true(r.outcome == CastOutcome::hit && r.lower <= 0.4 && 0.4 <= r.upper && r.upper - r.lower < 1e-13);
  assert_true((r.normal - Vec3(0.8, -0.6, 0)).norm() < 1e-12);
  assert_true((r.point_a - Vec3(-0.2, 0.15, 0)).norm() < 1e-12 && (r.point_b - r.point_a).norm() < 1e-12);
  assert_true(ask(ball, at(-3, 0.76, 0), Vec3(6, 0, 0), other, at(0, 0, 0)).outcome == CastOutcome::miss);
  assert_true(ask(ball, at(-3, 0, 0), Vec3(2.2, 0, 0), other, at(0, 0, 0)).outcome == CastOutcome::miss);

  const Shape crate = box(Vec3(1, 2, 3)), cube = box(Vec3(0.5, 0.5, 0.5));
  const CastResult face = ask(cube, at(5, 0.3, 0.1), Vec3(-7, 0.2, 0), crate, at(0, 0, 0));
  assert_true(face.outcome == CastOutcome::hit && std::fabs(face.time - 3.5 / 7) < 1e-13);
  assert_true((face.normal - Vec3(-1, 0, 0)).norm() < 1e-14);
  const CastResult corner = ask(cube, at(4, 5, 6), Vec3(-5, -5, -5), crate, at(0, 0, 0));  // corner to corner, exactly
  assert_true(corner.outcome == CastOutcome::hit && std::fabs(corner.time - 0.5) < 1e-12);
  CastSettings margin;
  margin.target = 0.25;
  const CastResult early = ask(cube, at(5, 0.3, 0.1), Vec3(-7, 0, 0), crate, at(0, 0, 0), margin);
  assert_true(std::fabs(early.time - 3.25 / 7) < 1e-13 && early.separation == 0.25);
  assert_true(std::fabs((early.point_a - early.point_b).norm() - 0.25) < 1e-12);
}

static void the_twin_agrees(void**) {
  Random random(51);
  int hits = 0, misses = 0, overlaps = 0;
  for (int k = 0; k < 1500; ++k) {
    const int i = k % kFamilyCount, j = k / kFamilyCount % kFamilyCount;
    if (i == 4 || j == 4) continue;  // hulls of 1,000: the same as of 32, slower
    const Shape a = random_shape(random, i), b = random_shape(random, j);
    const Frame fa(random_rotation(random).matrix(), random.in_cube(2));
    const Frame fb(random_rotation(random).matrix(), random.in_cube(2));
    const Vec3 motion = random.uniform(0, 6) * random.direction() + random.uniform(0, 1.5) * (fb.p - fa.p);
    CastSettings settings;
    settings.target = k % 3 ? 0 : random.uniform(0, 0.2);
    settings.tolerance = std::pow(10.0, -random.uniform(3, 10));
    const CastResult r = ask(a, fa, motion, b, fb, settings);
    const Truth truth = twin(a, fa, motion, b, fb, settings.target);
    if (std::fabs(truth.least) < 1e-9) continue;  // the twin itself cannot tell
    assert_true(r.outcome == truth.outcome);
    hits += r.outcome == CastOutcome::hit;
    misses += r.outcome == CastOutcome::miss;
    overlaps += r.outcome == CastOutcome::overlap;
    if (r.outcome == CastOutcome::overlap) {
      // truth.least: the depth, to 1e-13; the answer's to its tolerance.
      assert_true(std::fabs(r.separation - settings.target - truth.least) <= settings.tolerance + 1e-12);
    } else if (r.outcome == CastOutcome::hit) {
      // The twin errs by 1e-13 of a metre over the speed of approach.
      const Real approach = std::max(r.normal.dot(motion), 1e-6), error = 1e-12 / approach + 1e-13;
      assert_true(r.lower - error <= truth.time && truth.time <= r.upper + error);
      const Real wanted = settings.tolerance * std::min(a.bounding_radius, b.bounding_radius);
      assert_true((r.upper - r.lower) * motion.norm() <= wanted + 6 * r.slack * motion.norm() / approach);
    }
  }
  assert_true(hits > 250 && misses > 250 && overlaps > 60);
}

static void roles_may_be_swapped(void**) {
  Random random(52);
  for (int k = 0; k < 2000; ++k) {
    const Shape a = random_shape(random, k % 4), b = random_shape(random, 5 + k / 4 % 4);
    const Frame fa(random_rotation(random).matrix(), random.in_cube(2));
    const Frame fb(random_rotation(random).matrix(), random.in_cube(2));
    const Vec3 motion = random.uniform(0, 2) * (fb.p - fa.p);
    const CastResult r = ask(a, fa, motion, b, fb), q = ask(b, fb, -motion, a, fa);
    assert_true(r.outcome == q.outcome);
    if (r.outcome == CastOutcome::hit) assert_true(r.lower <= q.upper && q.lower <= r.upper);
  }
}

static void a_wider_margin_is_met_no_later(void**) {
  Random random(53);
  for (int k = 0; k < 500; ++k) {
    const Shape a = random_shape(random, k % 9), b = random_shape(random, k / 9 % 9);
    const Frame fa(random_rotation(random).matrix(), 4 * random.direction()), fb = at(0, 0, 0);
    const Vec3 motion = random.in_cube(0.5) - fa.p;
    Real later = kInfinity;
    for (const Real target : {0.0, 1e-9, 1e-6, 1e-3, 0.1, 0.5}) {
      CastSettings settings;
      settings.target = target;
      const CastResult r = ask(a, fa, motion, b, fb, settings);
      assert_true(r.lower <= later);
      later = r.upper;
    }
  }
}

static void starts_in_touch_and_a_hair_apart(void**) {
  const Shape cube = box(Vec3(0.5, 0.5, 0.5));
  for (const Real apart : {1e-3, 1e-6, 1e-9, 1e-12}) {
    const CastResult r = ask(cube, at(0, 1 + apart, 0), Vec3(0.3, -1, 0.1), cube, at(0, 0, 0));
    assert_true(r.outcome == CastOutcome::hit && r.lower <= apart * (1 + 1e-3) && apart * (1 - 1e-3) <= r.upper);
    assert_true((r.normal - Vec3(0, -1, 0)).norm() < 1e-12);
    // Leaving, and sliding along: proven apart although so near.
    assert_true(ask(cube, at(0, 1 + apart, 0), Vec3(0, 1, 0), cube, at(0, 0, 0)).outcome == CastOutcome::miss);
    assert_true(ask(cube, at(0, 1 + apart, 0), Vec3(1, 0, 0), cube, at(0, 0, 0)).outcome == CastOutcome::miss);
    const CastResult in = ask(cube, at(0, 1 - apart, 0), Vec3(0, 1, 0), cube, at(0, 0, 0));
    assert_true(in.outcome == CastOutcome::overlap && std::fabs(in.separation + apart) < 1e-14 + 1e-6 * apart);
  }
  const CastResult touch = ask(cube, at(0, 1, 0), Vec3(0, -1, 0), cube, at(0, 0, 0));
  assert_true(touch.outcome == CastOutcome::hit && touch.lower == 0 && touch.time < 1e-12);
  // In exact touch, of every shape alike: on is a hit at once; along and away is none. So it is a hair beside.
  const Shape on[] = {cube,
                      sphere(0.5),
                      capsule(0.3, 0.2),
                      cylinder(0.4, 0.5),
                      cone(0.5, 0.5),
                      ellipsoid(Vec3(0.3, 0.5, 0.4)),
                      rounded_box(Vec3(0.3, 0.4, 0.3), 0.1)};
  const Shape floors[] = {box(Vec3(3, 0.5, 3)), half_space(Vec3(0, 1, 0), 0.5), cylinder(3, 0.5)};
  CastSettings ignoring;
  ignoring.ignore_touched = true;
  for (const Shape& s : on)
    for (const Shape& floor : floors)
      for (const Real hair : {0.0, 1e-15, -1e-15}) {
        const Frame from = at(0.1, 1 + hair, -0.2);
        assert_true(ask(s, from, Vec3(0.4, -1, 0), floor, at(0, 0, 0)).outcome == CastOutcome::hit);
        assert_true(ask(s, from, Vec3(0.4, -1, 0), floor, at(0, 0, 0)).time < 1e-12);
        assert_true(ask(s, from, Vec3(2, 0, 1), floor, at(0, 0, 0)).outcome == CastOutcome::miss);
        assert_true(ask(s, from, Vec3(-8, 0, 0), floor, at(0, 0, 0)).outcome == CastOutcome::miss);  // off its end
        assert_true(ask(s, from, Vec3(0, 1, 0), floor, at(0, 0, 0)).outcome == CastOutcome::miss);
        assert_true(ask(s, from, Vec3(0, -1, 0), floor, at(0, 0, 0), ignoring).outcome == CastOutcome::miss);
        assert_true(ask(s, at(0, 0.7, 0), Vec3(0, 1, 0), floor, at(0, 0, 0), ignoring).outcome == CastOutcome::miss);
        // The next floor is flush with this one: nothing to stop at. A step up is.
        if (floor.form != Form::box) continue;
        assert_true(ask(s, from, Vec3(8, 0, 0), floor, at(6, 0, 0)).outcome == CastOutcome::miss);
        assert_true(ask(s, from, Vec3(8, 0, 0), floor, at(6, 1e-3, 0)).outcome == CastOutcome::hit);
      }
  const CastResult deep = ask(cube, at(0.1, 0.7, 0), Vec3(0, 1, 0), cube, at(0, 0, 0));
  assert_true(deep.outcome == CastOutcome::overlap && std::fabs(deep.separation + 0.3) < 1e-6 && deep.time == 0);
  assert_true((deep.normal - Vec3(0, -1, 0)).norm() < 1e-6);
  const CastResult same = ask(cube, at(0, 0, 0), Vec3(0, 1, 0), cube, at(0, 0, 0));
  assert_true(same.outcome == CastOutcome::overlap && std::fabs(same.separation + 1) < 1e-6);
  for (const Real y : {0.5, 3.0}) {  // no motion at all
    const CastResult still = ask(cube, at(0, y, 0), Vec3::zero(), cube, at(0, 0, 0));
    assert_true(still.outcome == (y < 1 ? CastOutcome::overlap : CastOutcome::miss));
  }
}

static void grazes_terminate_and_are_never_called_wrongly(void**) {
  // A passes B's surface at 1e-4 .. 1e-15, in a plane both touch: round against round, flat against flat, edge, vertex.
  Random random(54);
  int right = 0;
  for (int k = 0; k < 6000; ++k) {
    const Shape a = random_shape(random, k % 4), b = random_shape(random, std::array{0, 1, 2, 3, 5, 7}[k / 4 % 6]);
    const Real offset = std::pow(10.0, -random.uniform(4, 15)) * (k % 2 ? 1 : -1);
    const Frame fa(random_rotation(random).matrix(), Vec3::zero());
    const Vec3 n = random.direction(), e = any_perpendicular(n);
    const Vec3 on_a = fa.rotate(support_point(a, fa.rotate_inverse(-n))), on_b = support_point(b, n);
    Frame from = fa;
    from.p = on_b - on_a + offset * n - 3 * e;
    const CastResult r = ask(a, from, 6 * e, b, at(0, 0, 0));
    assert_true(r.support_calls <= 2 * CastSettings().cap);
    assert_true(!std::isnan(r.time) && r.lower <= r.time && r.time <= r.upper);
    // Supports and poses of this test err by some u: 1e-14 here.
    if (std::fabs(offset) < r.slack + 1e-14) continue;
    assert_true(r.outcome == (offset > 0 ? CastOutcome::miss : CastOutcome::hit));
    ++right;
  }
  assert_true(right > 4500);
}

static void far_from_the_origin_and_at_any_scale(void**) {
  Random random(55);
  for (int k = 0; k < 300; ++k) {
    const Vec3 half{random.uniform(0.3, 1), random.uniform(0.3, 1), random.uniform(0.3, 1)};
    const Mat3 ra = random_rotation(random).matrix(), rb = random_rotation(random).matrix();
    const Vec3 start = 4 * random.direction(), motion = random.in_cube(0.5) - start;
    const CastResult near = ask(box(half), Frame(ra, start), motion, ellipsoid(half), Frame(rb, Vec3::zero()));
    // 2^20 m away: positions keep 2^-32 m, so the start given there is the start rounded to that.
    const Vec3 away = 0x1p20 * Vec3(1, -1, 1);
    Frame moved(ra, start + away);
    const CastResult far = ask(box(half), moved, motion, ellipsoid(half), Frame(rb, away));
    assert_true(near.outcome == far.outcome);
    if (near.outcome == CastOutcome::hit) {
      const Real off = 0x1p-31 / std::max(near.normal.dot(motion), 1e-3);
      assert_true(near.lower <= far.upper + off && far.lower <= near.upper + off);
    }
    for (const Real factor : {0x1p-20, 0x1p20}) {
      const CastResult scaled = ask(box(factor * half), Frame(ra, factor * start), factor * motion,
                                    ellipsoid(factor * half), Frame(rb, Vec3::zero()));
      assert_true(scaled.outcome == near.outcome && scaled.lower == near.lower && scaled.upper == near.upper);
    }
  }
}

static void flat_thin_and_needle_shapes(void**) {
  const Shape plate = box(Vec3(1, 0, 1)), needle = box(Vec3(0, 1, 0)), point = box(Vec3::zero()),
              sheet = box(Vec3(1e3, 1e-5, 1e3));
  const CastResult down = ask(needle, at(0.2, 3, 0.3), Vec3(0, -4, 0), plate, at(0, 0, 0));
  assert_true(down.outcome == CastOutcome::hit && std::fabs(down.time - 0.5) < 1e-12);
  const CastResult fall = ask(plate, at(0, 3, 0), Vec3(0, -4, 0), plate, at(0, 0, 0));
  assert_true(fall.outcome == CastOutcome::hit && std::fabs(fall.time - 0.75) < 1e-12);
  CastSettings fine;  // relative to the sheet: a point has no size
  fine.tolerance = 1e-13;
  const CastResult speck = ask(point, at(0, 3, 0), Vec3(0, -6, 0), sheet, at(0, 0, 0), fine);
  assert_true(speck.outcome == CastOutcome::hit && std::fabs(speck.time - (3 - 1e-5) / 6) < 1e-9);
  const CastResult tunnel = ask(sphere(1e-3), at(0, 1e3, 0), Vec3(0, -1e6, 0), sheet, at(0, 0, 0));
  assert_true(tunnel.outcome == CastOutcome::hit && std::fabs(tunnel.time - (1e3 - 1.01e-3) / 1e6) < 1e-14);
  assert_true(ask(point, at(0, 1, 0), Vec3(0, -1, 0), point, at(0, 0.3, 0)).outcome != CastOutcome::miss);
  assert_true(ask(point, at(0, 1, 1e-9), Vec3(0, -1, 0), point, at(0, 0.3, 0)).outcome == CastOutcome::miss);
}

/// What slides flush over ground and comes to the next piece just as it ends is not stopped, as if it went on; what comes
/// head-on and ends as it touches is a hit.
static void motions_that_end_as_they_touch(void**) {
  const Shape tile = box(Vec3(0.5, 1, 0.5));
  const Shape all[] = {box(Vec3(0.25, 0.5, 0.125)), sphere(0.5),     capsule(0.25, 0.25),
                       cylinder(0.25, 0.5),         cone(0.25, 0.5), ellipsoid(Vec3(0.25, 0.5, 0.375))};
  for (const Shape& a : all) {
    for (const bool along_z : {false, true})
      for (const Real aside : {0.0, 0.5, 0.125, -0.3125}) {
        // The tile's near edge is 1.5 m ahead, at the height of the lowest point.
        const auto turned = [&](Real ahead, Real y) { return along_z ? at(aside, y, ahead) : at(ahead, y, aside); };
        const Vec3 way = along_z ? Vec3(0, 0, 1) : Vec3(1, 0, 0);
        const Real foremost = way.dot(support_point(a, way)), lowest = way.dot(support_point(a, Vec3(0, -1, 0)));
        for (const Real length : {1.5 - foremost, 1.5 - lowest, 1.5, 4.0})
          assert_true(ask(a, at(0, 0, 0), length * way, tile, turned(2, -1.5)).outcome == CastOutcome::miss);
      }
    const CastResult down = ask(a, at(0, 2, 0), Vec3(0, -1.5, 0), tile, at(0, -1, 0));
    assert_true(down.outcome == CastOutcome::hit && down.upper > 1 - 1e-6);
  }
}

static void half_spaces_stop_everything_in_time(void**) {
  const Shape floor = half_space(Vec3(0, 1, 0), 0);
  Random random(56);
  for (int k = 0; k < 900; ++k) {
    const Shape a = random_shape(random, k % 9);
    const Frame fa(random_rotation(random).matrix(), Vec3(0, 3, 0));
    const Real lowest = 3 + fa.rotate(support_point(a, fa.rotate_inverse(Vec3(0, -1, 0)))).y();
    const CastResult r = ask(a, fa, Vec3(2, -4, 1), floor, at(0, 0, 0)),
                     q = ask(floor, at(0, 0, 0), Vec3(-2, 4, -1), a, fa);
    for (const CastResult& c : {r, q}) {
      assert_true(c.outcome == CastOutcome::hit && c.lower <= lowest / 4 && lowest / 4 <= c.upper);
      assert_true(c.upper - c.lower < 1e-12);
    }
    assert_true((r.normal - Vec3(0, -1, 0)).norm() < 1e-14 && (q.normal - Vec3(0, 1, 0)).norm() < 1e-14);
    assert_true(ask(a, fa, Vec3(1, 0, 0), floor, at(0, 0, 0)).outcome == CastOutcome::miss);
    assert_true(ask(a, at(0, -1, 0), Vec3(0, 5, 0), floor, at(0, 0, 0)).outcome == CastOutcome::overlap);
  }
}

static void wild_poses_give_no_nan(void**) {
  const Shape a = box(Vec3(1, 1, 1)), b = sphere(1), floor = half_space(Vec3(0, 1, 0), 0);
  for (const Real wild : {1e30, 1e99, 1e150, 1e308}) {
    for (const Shape* other : {&b, &floor}) {
      for (const CastResult& r : {ask(a, at(wild, 0, 0), Vec3(-wild, 1, 0), *other, at(0, 0, 0)),
                                  ask(a, at(0, 3, 0), Vec3(0, -wild, 0), *other, at(0, 0, 0)),
                                  ask(a, at(0, wild, 0), Vec3(0, -1, 0), *other, at(0, wild, 0))})
        assert_true(!std::isnan(r.time) && !std::isnan(r.lower) && !std::isnan(r.upper) && r.lower <= r.upper);
    }
  }
}

static void a_failing_support_function_is_named(void**) {
  const Shape invalid_plugin = make_shape(Form::none, failing_support, {1}, Vec3(1, 1, 1), 1.8),
              cube = box(Vec3(1, 1, 1));
  for (const bool first : {true, false}) {
    SupportFault fault;
    const CastResult r = first ? ask(invalid_plugin, at(0, 4, 0), Vec3(0, -4, 0), cube, at(0, 0, 0), {}, &fault)
                               : ask(cube, at(0, 4, 0), Vec3(0, -4, 0), invalid_plugin, at(0, 0, 0), {}, &fault);
    assert_true(r.status == QueryStatus::fault && fault.kind == SupportFault::returned &&
                fault.shape == &invalid_plugin);
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(spheres_and_boxes_meet_when_the_textbook_says),
      cmocka_unit_test(the_twin_agrees),
      cmocka_unit_test(roles_may_be_swapped),
      cmocka_unit_test(a_wider_margin_is_met_no_later),
      cmocka_unit_test(starts_in_touch_and_a_hair_apart),
      cmocka_unit_test(grazes_terminate_and_are_never_called_wrongly),
      cmocka_unit_test(far_from_the_origin_and_at_any_scale),
      cmocka_unit_test(flat_thin_and_needle_shapes),
      cmocka_unit_test(motions_that_end_as_they_touch),
      cmocka_unit_test(half_spaces_stop_everything_in_time),
      cmocka_unit_test(wild_poses_give_no_nan),
      cmocka_unit_test(a_failing_support_function_is_named),
  };
  return cmocka_run_group_tests_name("collision/shape_cast", tests, nullptr, nullptr);
}
