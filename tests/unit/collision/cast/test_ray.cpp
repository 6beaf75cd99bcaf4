// Ray casts against textbook formulas in long double: brackets, outcomes, normals, starts inside, grazes, extremes of
// scale, lists of shapes, and support functions that misbehave.
#include <limits>

#include "carom_test.h"
#include "cast_truth.h"
#include "collision/cast/ray.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

CastResult ask(const Ray& ray, const Shape& shape, const Frame& frame = Frame(), const CastSettings& settings = {},
               SupportFault* fault = nullptr) {
  CastResult result;
  SupportFault ignored;
  cast_ray(ray, shape, frame, settings, result, fault ? *fault : ignored);
  return result;
}

/// A shape with what its truth needs.
struct Known {
  Shape shape;
  Array<std::uint32_t> triangles;
  explicit Known(Shape s) : shape(std::move(s)) {
    if (shape.form == Form::polytope) convex_hull(shape.vertices, triangles);
  }
  MaybeStretch truth(const Ray& ray, const Frame& frame) const {
    const auto r = frame.r.cast<Long>();
    const Long3 o = r.transpose() * (ray.origin.cast<Long>() - frame.p.cast<Long>());
    return through(shape, o, Long3(r.transpose() * ray.direction.cast<Long>()), &triangles);
  }
};

/// What every answer owes the truth. The bracket holds it; only where the ray goes no deeper than `graze` (m) may a hit
/// be claimed where there is none, or just before it: the claim is of slack.
void assert_true_to(const CastResult& r, const MaybeStretch& truth, const Ray& ray, Real graze = 0) {
  const Real speed = ray.direction.norm();
  const bool meets = truth && truth->out >= 0 && truth->in <= ray.max;
  assert_true(r.lower >= 0 && r.lower <= ray.max && r.lower <= r.time && r.time <= r.upper);
  if (r.outcome == CastOutcome::miss) {
    assert_false(meets && (truth->out - truth->in) * speed > graze);
    return;
  }
  assert_true(carom::finite(r.point_a) && carom::finite(r.point_b) && carom::finite(r.normal));
  if (r.outcome == CastOutcome::undecided) {
    assert_true(graze > 0);
    return;
  }
  if (!meets) {
    assert_true(graze > 0);
    return;
  }
  if (r.outcome == CastOutcome::overlap) {
    assert_true(truth->in * speed <= r.slack && r.time == 0);
    return;
  }
  assert_true(r.lower <= std::max(truth->in, Long(0)));
  if (graze == 0) assert_true(std::max(truth->in, Long(0)) <= r.upper);
  assert_true(std::fabs(r.normal.norm() - 1) < 1e-14 && r.normal.dot(ray.direction) >= 0);
}

const int kKnown[] = {0, 1, 2, 3, 5, 7};  // families with a textbook formula

}  // namespace

static void a_hundred_thousand_rays_never_leave_their_bracket(void**) {
  Random random(41);
  int hits = 0, narrow = 0, overlaps = 0;
  for (int k = 0; k < 1000; ++k) {
    const int family = kKnown[k % 6];
    const Known known(random_shape(random, family));
    const Frame frame(random_rotation(random).matrix(), random.in_cube(5));
    CastSettings settings;
    settings.tolerance = std::pow(10.0, -random.uniform(2, 12));
    for (int i = 0; i < 100; ++i) {
      const Vec3 from = frame.p + random.uniform(0, 4) * random.direction();
      const Vec3 to = frame.p + random.in_cube(1);
      const Ray ray{from, random.uniform(0.2, 3) * (to - from), random.uniform(0.1, 2)};
      const CastResult r = ask(ray, known.shape, frame, settings);
      assert_true_to(r, known.truth(ray, frame), ray);
      if (r.outcome == CastOutcome::overlap) ++overlaps;
      if (r.outcome != CastOutcome::hit) continue;
      ++hits;
      const Real width = (r.upper - r.lower) * ray.direction.norm() + 1e-13;
      assert_true((r.point_a - r.point_b).norm() <= width + 1e-13);
      if (r.status != QueryStatus::exact_enough) continue;
      ++narrow;
      assert_true(width <= settings.tolerance * known.shape.bounding_radius + 2e-13);
    }
  }
  // Nearly all meet their tolerance: 1e-12 of the size is above rounding (3e-14 of it) unless the ray comes in flat.
  assert_true(hits > 25000 && narrow > 0.99 * hits && overlaps > 5000);
}

static void polytopes_and_rounded_cores_end_exactly(void**) {
  // A tolerance that cannot be met costs them nothing: the last column ends it, at rounding.
  Random random(42);
  CastSettings settings;
  settings.tolerance = 1e-16;
  for (int i = 0; i < 4000; ++i) {
    const Known known(random_shape(random, i % 4));
    const Vec3 from = 3 * random.direction();
    const Ray ray{from, random.in_cube(0.3) - from, 2};
    const CastResult r = ask(ray, known.shape, Frame(), settings);
    const MaybeStretch truth = known.truth(ray, Frame());
    assert_true_to(r, truth, ray);
    assert_true(r.support_calls <= 30);
    if (r.outcome != CastOutcome::hit) continue;
    // Slack over the sine of the angle of incidence, in time; 4 m is more than the direction's length.
    const Real sine = r.normal.dot(ray.direction) / ray.direction.norm();
    if (sine > 1e-3) assert_true(std::fabs(static_cast<Real>(r.time - truth->in)) < 2 * r.slack / sine);
  }
}

static void normals_point_into_the_surface(void**) {
  Random random(43);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3 radii{random.uniform(0.3, 1), random.uniform(0.3, 1), random.uniform(0.3, 1)};
    const Vec3 from = 3 * random.direction();
    const Ray ray{from, random.in_cube(0.5) - from, 1};
    CastSettings settings;
    settings.tolerance = 1e-10;
    const Shape shapes[] = {ellipsoid(radii), sphere(radii.x()), box(radii)};
    for (const Shape& s : shapes) {
      const CastResult r = ask(ray, s, Frame(), settings);
      if (r.outcome != CastOutcome::hit || r.normal.dot(ray.direction) < 0.3) continue;
      ++met;
      const Vec3 x = r.point_a;
      if (s.form == Form::box) {
        const Vec3 share = x.over(radii);
        const int face = share.abs().max_axis();
        // Away from edges the face it lies on is plain.
        Vec3 others = share.abs();
        others[face] = 0;
        if (others.max_entry() > 1 - 1e-9) continue;
        assert_true((r.normal + std::copysign(1.0, share[face]) * Vec3::unit(face)).norm() < 1e-12);
      } else {
        const Vec3 q = s.form == Form::sphere ? Vec3(Vec3::constant(radii.x())) : radii;
        const Vec3 outward = x.over(q.times(q)).normalized();
        // A plane that misses the surface by a gap g there is turned by sqrt(2 g k), k curvature: at most 1 / 0.3^2
        // here.
        assert_true((r.normal + outward).norm() < std::sqrt(2 * 1e-10 * 12) + 1e-7);
      }
    }
  }
  assert_true(met > 3000);
}

static void grazes_are_never_called_wrongly(void**) {
  // Lines that pass a surface at 1e-4 .. 1e-15, within and without, in any direction along the tangent plane.
  Random random(44);
  int hit_within = 0, missed_without = 0;
  for (int i = 0; i < 20000; ++i) {
    const int family = kKnown[i % 6];
    const Known known(random_shape(random, family));
    const Real offset = std::pow(10.0, -random.uniform(4, 15)) * (i % 2 ? 1 : -1);
    const Vec3 n = random.direction();
    const Vec3 on = support_point(known.shape, n);
    const Vec3 e = any_perpendicular(n), f = n.cross(e);
    const Real turn = random.uniform(0, 6.28);
    const Vec3 along = std::cos(turn) * e + std::sin(turn) * f;
    const Ray ray{on + offset * n - 2 * along, along, 4};
    const CastResult r = ask(ray, known.shape);
    assert_true_to(r, known.truth(ray, Frame()), ray, 1e-6);
    // Farther off than slack it is never undecided about which.
    if (std::fabs(offset) < 2 * r.slack) continue;
    if (offset > 0) assert_true(r.outcome == CastOutcome::miss), ++missed_without;
    const MaybeStretch truth = known.truth(ray, Frame());
    if (offset < 0 && truth && truth->out > truth->in) assert_true(r.outcome == CastOutcome::hit), ++hit_within;
  }
  assert_true(hit_within > 5000 && missed_without > 7000);
}

static void edges_vertices_and_tips_are_met(void**) {
  const Shape cube = box(Vec3(1, 1, 1)), tip = cone(1, 1);
  struct {
    const Shape& s;
    Vec3 from, d;
    Real t;
  } const cases[] = {
      {cube, Vec3(3, 0, 0), Vec3(-1, 0, 0), 2},     // the middle of a face
      {cube, Vec3(3, 1, 0), Vec3(-1, 0, 0), 2},     // along a face, on its edge
      {cube, Vec3(3, 1, 1), Vec3(-1, 0, 0), 2},     // along an edge
      {cube, Vec3(3, 3, 0.5), Vec3(-1, -1, 0), 2},  // at an edge
      {cube, Vec3(3, 3, 3), Vec3(-1, -1, -1), 2},   // at a vertex
      {tip, Vec3(0, 3, 0), Vec3(0, -1, 0), 2},      // at the tip, along the axis
      {tip, Vec3(2, 1, 0), Vec3(-1, 0, 0), 2},      // at the tip, square to the axis
      {tip, Vec3(0, -3, 0), Vec3(0, 1, 0), 2},      // the middle of the base
      {tip, Vec3(1, -3, 0), Vec3(0, 1, 0), 2},      // the rim
  };
  for (const auto& c : cases) {
    const CastResult r = ask(Ray{c.from, c.d, 10}, c.s);
    // All of these touch: a graze is a hit, at its place. The time follows from slack, along the line as far as a
    // corner of slack is blunt: sqrt where the line is in the surface's plane.
    assert_true(r.outcome == CastOutcome::hit && std::fabs(r.time - c.t) < 1e-6);
  }
  // Not tangents: these must be hits, exactly.
  for (const int i : {0, 3, 4, 5, 7}) {
    const CastResult r = ask(Ray{cases[i].from, cases[i].d, 10}, cases[i].s);
    assert_true(r.outcome == CastOutcome::hit && std::fabs(r.time - cases[i].t) < 1e-13);
  }
}

static void starts_inside_and_behind(void**) {
  const Shape s = box(Vec3(1, 1, 1));
  const CastResult in = ask(Ray{Vec3(0.5, 0, 0), Vec3(1, 0, 0), 10}, s);
  assert_true(in.outcome == CastOutcome::overlap && in.time == 0 && in.lower == 0 && in.upper == 0);
  assert_true((in.normal - Vec3(1, 0, 0)).norm() < 1e-15 && in.point_b == Vec3(0.5, 0, 0));
  assert_true(ask(Ray{Vec3(2, 0, 0), Vec3(1, 0, 0), 10}, s).outcome == CastOutcome::miss);          // past
  assert_true(ask(Ray{Vec3(1 + 1e-12, 0, 0), Vec3(1, 0, 0), 10}, s).outcome == CastOutcome::miss);  // just past
  assert_true(ask(Ray{Vec3(1 - 1e-12, 0, 0), Vec3(1, 0, 0), 10}, s).outcome == CastOutcome::overlap);
  assert_true(ask(Ray{Vec3(1, 0, 0), Vec3(1, 0, 0), 10}, s).outcome == CastOutcome::miss);    // on the surface, leaving
  assert_true(ask(Ray{Vec3(1, 0.3, 0), Vec3(0, 1, 0), 10}, s).outcome == CastOutcome::miss);  // along it
  const CastResult on = ask(Ray{Vec3(1, 0, 0), Vec3(-1, 0, 0), 10}, s);
  assert_true(on.outcome == CastOutcome::hit && on.lower == 0 && on.time < 1e-13);
  // Too short by a hair, long enough by one.
  assert_true(ask(Ray{Vec3(3, 0, 0), Vec3(-1, 0, 0), 2 - 1e-12}, s).outcome == CastOutcome::miss);
  assert_true(ask(Ray{Vec3(3, 0, 0), Vec3(-1, 0, 0), 2 + 1e-12}, s).outcome == CastOutcome::hit);
}

static void a_ray_of_no_length_is_a_point(void**) {
  const Shape shapes[] = {box(Vec3(1, 1, 1)), sphere(1), ellipsoid(Vec3(1, 2, 3)), cylinder(1, 1)};
  for (const Shape& s : shapes) {
    for (const Ray& still : {Ray{Vec3(0.4, 0.1, 0.2), Vec3::zero(), 1}, Ray{Vec3(0.4, 0.1, 0.2), Vec3(1, 0, 0), 0},
                             Ray{Vec3(0.4, 0.1, 0.2), Vec3::zero(), kInfinity}}) {
      assert_true(ask(still, s).outcome == CastOutcome::overlap);
      Ray away = still;
      away.origin = Vec3(0, 3.5, 0);
      assert_true(ask(away, s).outcome == CastOutcome::miss);
    }
    const Ray on{support_point(s, Vec3(1, 0, 0)), Vec3::zero(), 1};
    assert_true(ask(on, s).outcome != CastOutcome::miss);
  }
}

static void huge_and_endless_rays_from_far_away(void**) {
  const Shape s = sphere(1);
  for (const Real far : {1e3, 1e6, 1e9, 1e12}) {
    const CastResult r = ask(Ray{Vec3(far, 0.3, 0.4), Vec3(-1, 0, 0), kInfinity}, s);
    const Real truth = far - std::sqrt(0.75);
    assert_true(r.outcome == CastOutcome::hit && r.lower <= truth && truth <= r.upper);
    assert_true(r.slack < 1e-13 * far);
    const CastResult long_one = ask(Ray{Vec3(far, 0.3, 0.4), Vec3(-4 * far, 0, 0), 1}, s);
    assert_true(long_one.outcome == CastOutcome::hit && std::fabs(long_one.time - truth / (4 * far)) < 1e-13);
  }
  for (const Real wild : {1e30, 1e100, 1e200, 1e308}) {
    const Ray rays[] = {{Vec3(wild, 0, 0), Vec3(-1, 0, 0), kInfinity},
                        {Vec3(3, 0, 0), Vec3(-wild, 0, 0), 1},
                        {Vec3(wild, wild, wild), Vec3(wild, wild, -wild), kInfinity}};
    for (const Ray& ray : rays) {
      const CastResult r = ask(ray, s);
      assert_true(!std::isnan(r.time) && !std::isnan(r.lower) && !std::isnan(r.upper) && r.lower <= r.upper);
    }
  }
}

static void scale_does_not_matter(void**) {
  // Powers of two change no digit; other factors only rounding.
  Random random(45);
  for (int i = 0; i < 600; ++i) {
    const Vec3 half{random.uniform(0.3, 1), random.uniform(0.3, 1), random.uniform(0.3, 1)};
    const Vec3 from = 3 * random.direction(), d = random.in_cube(0.5) - from;
    for (const Real factor : {0x1p-20, 0x1p+20, 1e-6, 1e6}) {
      const Shape small[] = {box(half), ellipsoid(half), cylinder(half.x(), half.y())};
      const Shape large[] = {box(factor * half), ellipsoid(factor * half),
                             cylinder(factor * half.x(), factor * half.y())};
      for (int k = 0; k < 3; ++k) {
        const CastResult r = ask(Ray{from, d, 2}, small[k]), q = ask(Ray{factor * from, factor * d, 2}, large[k]);
        assert_true(r.outcome == q.outcome);
        if (r.outcome != CastOutcome::hit) continue;
        if (factor == 0x1p-20 || factor == 0x1p+20)
          assert_true(r.lower == q.lower && r.upper == q.upper && r.normal == q.normal);
        else
          assert_true(r.lower <= q.upper && q.lower <= r.upper);
      }
    }
  }
}

static void a_ball_instead_of_a_ray_is_a_swollen_shape(void**) {
  Random random(46);
  CastSettings ball;
  ball.target = 0.25;
  for (int i = 0; i < 2000; ++i) {
    const Real r = random.uniform(0.2, 1);
    const Vec3 half{random.uniform(0.3, 1), random.uniform(0.3, 1), random.uniform(0.3, 1)};
    const Vec3 from = 4 * random.direction();
    const Ray ray{from, random.in_cube(1) - from, 1};
    const CastResult a = ask(ray, sphere(r), Frame(), ball), b = ask(ray, sphere(r + 0.25));
    const CastResult c = ask(ray, box(half), Frame(), ball), d = ask(ray, rounded_box(half, 0.25));
    assert_true(a.outcome == b.outcome && c.outcome == d.outcome);
    if (a.outcome == CastOutcome::hit) assert_true(a.lower <= b.upper && b.lower <= a.upper);
    if (c.outcome == CastOutcome::hit) {
      assert_true(c.lower <= d.upper && d.lower <= c.upper);
      assert_true(std::fabs((c.point_a - c.point_b).norm() - 0.25) < 1e-12);
    }
  }
}

static void half_spaces_are_met_where_they_say(void**) {
  const Shape s = half_space(Vec3(0, 1, 0), 0.5);
  const Frame frame(exp_map(Vec3(0, 0, 0.3)).matrix(), Vec3(1, 2, 3));
  const Vec3 n = frame.rotate(Vec3(0, 1, 0));
  const Vec3 above = frame.apply(Vec3(0.2, 1.5, 0.1));
  const CastResult r = ask(Ray{above, -2 * n, 1}, s, frame);
  assert_true(r.outcome == CastOutcome::hit && std::fabs(r.time - 0.5) < 1e-14 && (r.normal + n).norm() < 1e-14);
  assert_true(r.lower <= 0.5 && 0.5 <= r.upper);
  assert_true(ask(Ray{above, n, kInfinity}, s, frame).outcome == CastOutcome::miss);
  assert_true(ask(Ray{above, frame.rotate(Vec3(1, 0, 0)), 1e6}, s, frame).outcome == CastOutcome::miss);
  assert_true(ask(Ray{frame.apply(Vec3(0, 0, 0)), n, 1}, s, frame).outcome == CastOutcome::overlap);
  // On it, to rounding: in is a hit at once; along and out is none.
  const Vec3 on = frame.apply(Vec3(0.3, 0.5, -2));
  const CastResult in = ask(Ray{on, frame.rotate(Vec3(1, -1, 0)), 10}, s, frame);
  assert_true(in.outcome == CastOutcome::hit && in.time < 1e-13 && in.at_start);
  assert_true(ask(Ray{on, frame.rotate(Vec3(1, 0, 0)), 10}, s, frame).outcome == CastOutcome::miss);
  assert_true(ask(Ray{on, frame.rotate(Vec3(1, 1, 0)), 10}, s, frame).outcome == CastOutcome::miss);
}

static void what_is_touched_at_the_start_may_be_passed_over(void**) {
  CastSettings ignoring;
  ignoring.ignore_touched = true;
  const Shape shapes[] = {box(Vec3(1, 1, 1)), sphere(1),     ellipsoid(Vec3(1, 1, 2)),
                          cylinder(1, 1),     capsule(1, 1), half_space(Vec3(1, 0, 0), 1)};
  for (const Shape& s : shapes)
    for (const bool routines : {false, true}) {
      ignoring.routines = routines;
      for (const Real x : {1.0, 1 - 1e-9, 0.5, 0.0}) {
        CastSettings plain = ignoring;
        plain.ignore_touched = false;
        const Ray ray{Vec3(x, 0, 0), Vec3(-1, 0.1, 0), 10};
        assert_true(ask(ray, s, Frame(), plain).outcome != CastOutcome::miss);
        assert_true(ask(ray, s, Frame(), ignoring).outcome == CastOutcome::miss);
      }
      assert_true(ask({Vec3(1 + 1e-9, 0, 0), Vec3(-1, 0.1, 0), 10}, s, Frame(), ignoring).outcome == CastOutcome::hit);
    }
}

static void flat_and_pointlike_shapes(void**) {
  const Shape plate = box(Vec3(1, 0, 1)), line = box(Vec3(0, 1, 0)), point = box(Vec3::zero());
  assert_true(std::fabs(ask(Ray{Vec3(0.3, 2, 0.2), Vec3(0, -1, 0), 5}, plate).time - 2) < 1e-13);
  assert_true(ask(Ray{Vec3(1.1, 2, 0.2), Vec3(0, -1, 0), 5}, plate).outcome == CastOutcome::miss);
  // In the plate's plane, across a line, at a point: contact of measure zero, within slack.
  for (const Shape* s : {&plate, &line, &point}) {
    const CastResult r = ask(Ray{Vec3(3, 0, 0), Vec3(-1, 0, 0), 5}, *s);
    assert_true(r.outcome == CastOutcome::hit && std::fabs(r.time - (s == &plate ? 2 : 3)) < 1e-6);
    assert_true(ask(Ray{Vec3(3, 1e-12, 1e-12), Vec3(-1, 0, 0), 5}, s == &line ? point : *s).outcome ==
                CastOutcome::miss);
  }
  std::vector<Vec3> coplanar = {Vec3(0, 0, 0), Vec3(1, 0, 0),     Vec3(0, 0, 1),
                                Vec3(1, 0, 1), Vec3(0.5, 0, 0.5), Vec3(0, 0, 0)};
  const CastResult r = ask(Ray{Vec3(0.5, -1, 0.5), Vec3(0, 1, 0), 2}, hull(coplanar));  // at its inner point
  assert_true(r.outcome == CastOutcome::hit && std::fabs(r.time - 1) < 1e-13);
}

static void the_first_of_many_is_found(void**) {
  Random random(47);
  std::vector<Shape> shapes;
  std::vector<Placed> placed;
  for (int i = 0; i < 40; ++i) shapes.push_back(random_shape(random, i % kFamilyCount));
  for (Shape& s : shapes) placed.push_back({&s, Frame(random_rotation(random).matrix(), 6 * random.direction())});
  int met = 0;
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{random.in_cube(3), 12 * random.direction(), 1};
    CastResult first;
    SupportFault fault;
    const int index = cast_ray(ray, placed, CastSettings(), first, fault);
    int best = -1;
    Real soonest = kInfinity;
    for (int k = 0; k < 40; ++k) {
      const CastResult one = ask(ray, shapes[static_cast<std::size_t>(k)], placed[static_cast<std::size_t>(k)].frame);
      if (one.outcome == CastOutcome::miss || !(one.time < soonest)) continue;
      soonest = one.time;
      best = k;
    }
    assert_int_equal(index, best);
    if (best < 0) continue;
    ++met;
    assert_true(first.time == soonest);
  }
  assert_true(met > 200);
  CastResult none;
  SupportFault fault;
  assert_int_equal(cast_ray(Ray{Vec3::zero(), Vec3(1, 0, 0), 1}, {}, CastSettings(), none, fault), -1);
  assert_true(none.outcome == CastOutcome::miss);
}

static void a_cap_is_kept_and_said(void**) {
  Random random(48);
  CastSettings settings;
  int capped = 0;
  for (int cap = 1; cap < 20; ++cap) {
    settings.cap = cap;
    settings.tolerance = 1e-12;
    for (int i = 0; i < 100; ++i) {
      const Known known(random_shape(random, kKnown[i % 6]));
      const Vec3 from = 3 * random.direction();
      const Ray ray{from, random.in_cube(0.5) - from, 2};
      const CastResult r = ask(ray, known.shape, Frame(), settings);
      assert_true(r.support_calls <= cap);
      if (r.outcome == CastOutcome::miss || r.outcome == CastOutcome::hit)
        assert_true_to(r, known.truth(ray, Frame()), ray);
      if (r.status == QueryStatus::capped) ++capped;
    }
  }
  assert_true(capped > 100);
}

namespace {

int countdown = 0;

std::int32_t lying_support(void*, const double* p, std::uint64_t count, const double* d, double* out) {
  box_support(nullptr, p, count, d, out);
  if (--countdown > 0) return 0;
  switch (static_cast<int>(p[3])) {
    case 1:
      return 7;
    case 2:
      out[1] = std::numeric_limits<double>::quiet_NaN();
      return 0;
    case 3:
      out[0] = 1e7;
      return 0;
    default:
      for (int i = 0; i < 3; ++i) out[i] = -out[i];  // the farthest the other way
      return 0;
  }
}

}  // namespace

static void invalid_plugins_are_named(void**) {
  for (const int kind : {1, 2, 3, 4}) {
    int named = 0;
    for (int from = 1; from < 6; ++from) {
      Shape s = make_shape(Form::none, lying_support, {1, 1, 1, static_cast<double>(kind)}, Vec3(1, 1, 1), 1.8);
      countdown = from;
      SupportFault fault;
      const CastResult r = ask(Ray{Vec3(3, 0.2, 0.1), Vec3(-1, 0.05, 0.02), 5}, s, Frame(), {}, &fault);
      assert_true(!std::isnan(r.time) && !std::isnan(r.lower));
      if (r.status != QueryStatus::fault) {
        assert_true(kind == 4 || countdown > 0);  // over before the lie, or a lie that contradicted nothing
        continue;
      }
      ++named;
      assert_true(fault.shape == &s && static_cast<int>(fault.kind) == kind);
    }
    assert_true(named >= (kind == 4 ? 1 : 3));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_hundred_thousand_rays_never_leave_their_bracket),
      cmocka_unit_test(polytopes_and_rounded_cores_end_exactly),
      cmocka_unit_test(normals_point_into_the_surface),
      cmocka_unit_test(grazes_are_never_called_wrongly),
      cmocka_unit_test(edges_vertices_and_tips_are_met),
      cmocka_unit_test(starts_inside_and_behind),
      cmocka_unit_test(a_ray_of_no_length_is_a_point),
      cmocka_unit_test(huge_and_endless_rays_from_far_away),
      cmocka_unit_test(scale_does_not_matter),
      cmocka_unit_test(a_ball_instead_of_a_ray_is_a_swollen_shape),
      cmocka_unit_test(half_spaces_are_met_where_they_say),
      cmocka_unit_test(what_is_touched_at_the_start_may_be_passed_over),
      cmocka_unit_test(flat_and_pointlike_shapes),
      cmocka_unit_test(the_first_of_many_is_found),
      cmocka_unit_test(a_cap_is_kept_and_said),
      cmocka_unit_test(invalid_plugins_are_named),
  };
  return cmocka_run_group_tests_name("collision/ray", tests, nullptr, nullptr);
}
