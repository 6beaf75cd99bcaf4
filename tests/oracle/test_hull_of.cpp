// Hulls of shapes against what is known otherwise: closed volumes, libccd's verdicts, the same set made without them.
#include <ccd/ccd.h>

#include <cstdio>
#include <functional>
#include <numbers>
#include <vector>

#include "carom_test.h"
#include "collision/cast/ray.h"
#include "collision/hull_of.h"
#include "collision/narrow/query.h"
#include "collision/verify.h"
#include "collision/volume.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kPi = std::numbers::pi;

struct Put {
  const Shape* shape;
  Vec3 position = Vec3::zero();
  Quat orientation = Quat::identity();
  Vec3 scale = Vec3::constant(1);
};

Shape hull_of(const std::vector<Put>& parts, Real radius = 0) {
  std::vector<const Shape*> shapes;
  std::vector<double> numbers{radius};
  for (const Put& put : parts) {
    shapes.push_back(put.shape);
    numbers.insert(numbers.end(), put.position.data(), put.position.data() + 3);
    numbers.insert(numbers.end(), put.orientation.data(), put.orientation.data() + 4);
    numbers.insert(numbers.end(), put.scale.data(), put.scale.data() + 3);
  }
  Shape shape(std::pmr::get_default_resource());
  make_hull_of(shapes, numbers, std::pmr::get_default_resource(), shape);
  if (shape.form == Form::polytope) shape.farthest.build(shape.vertices);
  SupportFault fault;
  assert_true(verify_support(shape).valid);
  assert_true(derive_bounds(shape, fault));
  return shape;
}

MassProperties mass_of(const Shape& shape) {
  SupportFault fault;
  if (shape.form == Form::polytope) return mass_from_form(shape.form, 0, 0, Vec3::zero(), shape.vertices);
  return mass_from_support(shape, 1e-3, 20000, fault);
}

Real support_of(const Shape& s, const Vec3& d) { return d.dot(support_point(s, d)); }

/// The largest difference of two support functions over many directions, of their size.
Real difference(const std::function<Real(const Vec3&)>& a, const std::function<Real(const Vec3&)>& b) {
  Random random(3);
  Real most = 0, size = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 d = random.direction();
    const Real x = a(d), y = b(d);
    most = std::max(most, std::fabs(x - y)), size = std::max(size, std::fabs(y));
  }
  return most / size;
}

/// Volume, centre and inertia of a solid of revolution about y, by Simpson's rule on its profile.
struct Turned {
  Real volume, centre, across, along;
};
Turned turned(const std::function<Real(Real)>& radius, Real from, Real to) {
  constexpr int kN = 20000;
  const auto integral = [&](const auto& f) {
    Real sum = 0;
    const Real h = (to - from) / kN;
    for (int i = 0; i <= kN; ++i) sum += (i == 0 || i == kN ? 1 : i % 2 ? 4 : 2) * f(from + h * i);
    return sum * h / 3;
  };
  const auto square = [&](Real y) { return radius(y) * radius(y); };
  Turned t{};
  t.volume = integral([&](Real y) { return kPi * square(y); });
  t.centre = integral([&](Real y) { return kPi * square(y) * y; }) / t.volume;
  t.along = integral([&](Real y) { return kPi * square(y) * square(y) / 2; });
  t.across = integral([&](Real y) {
    const Real off = y - t.centre;
    return kPi * square(y) * (square(y) / 4 + off * off);
  });
  return t;
}

/// Profile of the hull of two balls on the axis: of the larger one, the cone that touches both, the smaller one.
Turned tapered(Real bottom, Real top, Real half) {
  const Real s = (bottom - top) / (2 * half), c = std::sqrt(1 - s * s);
  const Real y1 = -half + bottom * s, y2 = half + top * s;
  return turned(
      [=](Real y) {
        if (y < y1) return std::sqrt(std::max(Real(0), bottom * bottom - (y + half) * (y + half)));
        if (y > y2) return std::sqrt(std::max(Real(0), top * top - (y - half) * (y - half)));
        return bottom * c + (top - bottom) * c * (y - y1) / (y2 - y1);
      },
      -half - bottom, half + top);
}

void in_bracket(const MassProperties& m, Real volume) {
  assert_true(m.volume_min * (1 - 1e-12) <= volume && volume <= m.volume_max * (1 + 1e-12));
  assert_true(std::fabs(m.volume - volume) < 1e-3 * volume);
}

struct Seen {
  const Shape* shape;
  Frame frame;
};
void ccd_support(const void* object, const ccd_vec3_t* dir, ccd_vec3_t* out) {
  const auto* seen = static_cast<const Seen*>(object);
  Vec3 d = seen->frame.rotate_inverse(Vec3(dir->v[0], dir->v[1], dir->v[2]));
  const Real length = d.norm();
  d = length > 0 ? Vec3(d / length) : Vec3(Vec3::unit_x());
  const Vec3 x = seen->frame.apply(support_point(*seen->shape, d));
  ccdVec3Set(out, static_cast<ccd_real_t>(x.x()), static_cast<ccd_real_t>(x.y()), static_cast<ccd_real_t>(x.z()));
}
void ccd_centre(const void* object, ccd_vec3_t* out) {
  const auto* seen = static_cast<const Seen*>(object);
  const Vec3 x = seen->frame.apply(seen->shape->mass.centroid);
  ccdVec3Set(out, static_cast<ccd_real_t>(x.x()), static_cast<ccd_real_t>(x.y()), static_cast<ccd_real_t>(x.z()));
}

}  // namespace

static void two_balls_are_a_tapered_capsule(void**) {
  const struct { Real bottom, top, half; } cases[] = {{0.5, 0.2, 1}, {0.3, 0.3, 0.7}, {0.01, 0.6, 0.5}, {2, 1.9, 0.2}};
  for (const auto& c : cases) {
    const Shape low = sphere(c.bottom), high = sphere(c.top);
    const Shape hull = hull_of({{&low, Vec3(0, -c.half, 0)}, {&high, Vec3(0, c.half, 0)}});
    assert_true(hull.core_radius == std::min(c.bottom, c.top));  // what both have in common stays a radius
    assert_true(difference([&](const Vec3& d) { return support_of(hull, d); },
                           [&](const Vec3& d) { return std::max(c.bottom - c.half * d.y(), c.top + c.half * d.y()); }) <
                1e-14);
    const Turned truth = tapered(c.bottom, c.top, c.half);
    const MassProperties m = mass_of(hull);
    in_bracket(m, truth.volume);
    assert_true(std::fabs(m.centroid.y() - truth.centre) <= m.centroid_error + 1e-9);
    assert_true(std::fabs(m.inertia(1, 1) - truth.along) <= m.inertia_error + 1e-9);
    assert_true(std::fabs(m.inertia(0, 0) - truth.across) <= m.inertia_error + 1e-9);
  }
}

static void a_radius_rounds_and_a_scale_scales(void**) {
  const Real a = 0.5, b = 0.7, c = 0.2, r = 0.1;
  const Shape block = box(Vec3(a, b, c)), ball = sphere(1), stick = capsule(0.2, 0.5);
  const Shape rounded = hull_of({{&block}}, r);
  in_bracket(mass_of(rounded), 8 * a * b * c + 8 * r * (a * b + b * c + c * a) + 2 * kPi * r * r * (a + b + c) +
                                   4 * kPi / 3 * r * r * r);  // Steiner's formula
  assert_true(rounded.form == Form::none && rounded.core_radius == r);

  const Shape egg = hull_of({{&ball, Vec3::zero(), Quat::identity(), Vec3(a, b, -c)}});
  const Shape like = ellipsoid(Vec3(a, b, c));
  assert_true(difference([&](const Vec3& d) { return support_of(egg, d); },
                         [&](const Vec3& d) { return support_of(like, d); }) < 1e-14);
  in_bracket(mass_of(egg), 4 * kPi / 3 * a * b * c);

  const Shape larger = hull_of({{&stick, Vec3::zero(), Quat::identity(), Vec3::constant(3)}});
  const Shape capsule_of = capsule(0.6, 1.5);
  assert_true(std::fabs(larger.core_radius - 0.6) < 1e-15);  // evenly scaled, a radius stays one
  assert_true(difference([&](const Vec3& d) { return support_of(larger, d); },
                         [&](const Vec3& d) { return support_of(capsule_of, d); }) < 1e-14);

  const Shape wedge = hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0.5, 1}});
  const Shape mirrored = hull_of({{&wedge, Vec3::zero(), Quat::identity(), Vec3(-1, 1, 1)}});
  assert_true(difference([&](const Vec3& d) { return support_of(mirrored, d); },
                         [&](const Vec3& d) { return support_of(wedge, Vec3(-d.x(), d.y(), d.z())); }) == 0);
}

static void where_all_have_corners_the_hull_has(void**) {
  const Shape block = box(Vec3(0.5, 0.25, 1)),
              peg = hull(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  const Quat turn = Quat(0.9, 0.1, -0.3, 0.2).normalized();
  const Shape both = hull_of({{&block}, {&peg, Vec3(1, 2, 3), turn, Vec3(1, 2, 0.5)}});
  assert_true(both.form == Form::polytope && both.vertices.size() == 3 * 12);
  std::vector<Vec3> corners;
  for (int k = 0; k < 8; ++k) corners.emplace_back(k & 1 ? 0.5 : -0.5, k & 2 ? 0.25 : -0.25, k & 4 ? 1 : -1);
  for (std::size_t i = 0; i < peg.vertices.size(); i += 3)
    corners.push_back(turn * Vec3::from(&peg.vertices[i]).times(Vec3(1, 2, 0.5)) + Vec3(1, 2, 3));
  const Shape plain = hull(corners);
  const MassProperties mine = mass_of(both), truth = mass_of(plain);
  assert_true(std::fabs(mine.volume - truth.volume) < 1e-14 * truth.volume && mine.exact);
  const Shape of_hulls =
      hull_of({{&both, Vec3(1, 0, 0)}, {&block, Vec3(-1, 0, 0)}});  // of a hull of shapes: flat again
  assert_true(of_hulls.form == Form::polytope && of_hulls.vertices.size() == 3 * 20);
}

static void the_sweep_of_a_ball_is_a_capsule_for_distances_and_rays(void**) {
  const Shape ball = sphere(0.3), truth = capsule(0.3, 0.8);
  const Shape sweep = hull_of({{&ball, Vec3(0, -0.8, 0)}, {&ball, Vec3(0, 0.8, 0)}});
  Random random(7);
  int overlapping = 0, hits = 0;
  for (int i = 0; i < 3000; ++i) {
    const Shape other =
        shape_of(kForms[i % kFormCount], Vec3(random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.2, 1)));
    const Frame pose(random_turn(random), random.in_cube(1.8));
    QueryResult mine, known;
    SupportFault fault;
    distance(sweep, other, pose, QuerySettings{}, nullptr, mine, fault);
    distance(truth, other, pose, QuerySettings{}, nullptr, known, fault);
    assert_true(mine.lower <= known.upper + 1e-12 &&
                known.lower <= mine.upper + 1e-12);                     // both brackets hold the truth
    assert_true(std::fabs(mine.separation - known.separation) < 4e-6);  // the tolerance of a query
    overlapping += known.separation < 0;
    const Vec3 from = 3 * random.direction();
    const Ray ray{from, (random.in_cube(0.9) - from).normalized(), 10};
    CastResult cast, as_capsule;
    cast_ray(ray, sweep, Frame(), CastSettings{}, cast, fault);
    cast_ray(ray, truth, Frame(), CastSettings{}, as_capsule, fault);
    if (cast.outcome != as_capsule.outcome) {  // grazing, within the bracket's width
      assert_true(cast.outcome == CastOutcome::undecided || std::fabs(as_capsule.time - cast.time) < 1e-5);
      continue;
    }
    if (cast.outcome != CastOutcome::hit) continue;
    ++hits;
    assert_true(std::fabs(cast.time - as_capsule.time) < 2e-6);
  }
  assert_true(overlapping > 300 && hits > 300);
}

static void hulls_of_round_parts_and_libccd_agree_on_overlap(void**) {
  Random random(11);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < 1500; ++i) {
    const auto part = [&] {
      return shape_of(kForms[static_cast<int>(random.uniform(0, 5.999))],
                      Vec3(random.uniform(0.2, 0.8), random.uniform(0.2, 0.8), random.uniform(0.2, 0.8)));
    };
    const Shape p[4] = {part(), part(), part(), part()};
    const auto put = [&](const Shape& s) {
      return Put{&s, random.in_cube(0.7), Quat(random_turn(random)).normalized(),
                 Vec3(random.uniform(0.5, 1.5), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5))};
    };
    Shape a = hull_of({put(p[0]), put(p[1])}, i % 3 ? 0 : 0.1), b = hull_of({put(p[2]), put(p[3])});
    a.mass = mass_of(a), b.mass = mass_of(b);
    const Frame pose(random_turn(random), random.in_cube(2.2));
    QueryResult result;
    SupportFault fault;
    distance(a, b, pose, QuerySettings{}, nullptr, result, fault);
    assert_int_equal(fault.kind, SupportFault::none);
    if (std::fabs(result.separation) <= 1e-5) continue;
    Seen seen_a{&a, Frame()}, seen_b{&b, pose};
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = ccd_support;
    ccd.center1 = ccd.center2 = ccd_centre;
    ccd.max_iterations = 1000;
    const bool overlap = ccdGJKIntersect(&seen_a, &seen_b, &ccd) != 0;
    if (overlap != (result.separation < 0)) std::printf("pair %d: separation %g\n", i, result.separation);
    assert_int_equal(overlap, result.separation < 0);
    ++(overlap ? overlapping : apart);
  }
  assert_true(apart > 200 && overlapping > 200);
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(two_balls_are_a_tapered_capsule),
                              cmocka_unit_test(a_radius_rounds_and_a_scale_scales),
                              cmocka_unit_test(where_all_have_corners_the_hull_has),
                              cmocka_unit_test(the_sweep_of_a_ball_is_a_capsule_for_distances_and_rays),
                              cmocka_unit_test(hulls_of_round_parts_and_libccd_agree_on_overlap)};
  return cmocka_run_group_tests_name("oracle/hull_of", tests, nullptr, nullptr);
}
