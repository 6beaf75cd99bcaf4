// Bounds and mass properties: closed forms against each other, against the support function, and the bracket's
// promises.
#include <Eigen/Eigenvalues>
#include <cstdio>

#include "carom_test.h"
#include "collision/support.h"
#include "collision/volume.h"
#include "core/pose.h"
#include "eigen.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

MassProperties form_mass(const Shape& s) { return mass_from_form(s.form, s.radius, s.half_height, s.half, s.vertices); }

Mat3 random_rotation(Random& random) { return exp_map(random.uniform(0, 3.14) * random.direction()).matrix(); }

/// Every closed form with sizes from the given range, and a few general ones.
template <class Visit>
void each_closed_form(Random& random, Real lo, Real hi, Visit visit) {
  const auto size = [&] { return lo * std::pow(hi / lo, random.uniform(0, 1)); };
  const auto three = [&] {
    const Real a = size(), b = size(), c = size();
    return Vec3(a, b, c);
  };
  const Real r = size(), h = size();
  visit(sphere(r));
  visit(capsule(r, h));
  visit(box(three()));
  visit(cylinder(r, h));
  visit(cone(r, h));
  visit(ellipsoid(three()));
  std::vector<Vec3> points;
  const Vec3 stretch = three();
  for (int i = 0; i < 40; ++i) points.push_back(stretch.times(random.direction() + Vec3(0.3, 0.1, -0.2)));
  visit(hull(points));
}

Real spectral_norm(const Mat3& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(test::eigen(m), Eigen::EigenvaluesOnly)
      .eigenvalues()
      .cwiseAbs()
      .maxCoeff();
}

/// The exact answer lies in the bracket. The exact one is itself good to some ten u.
bool holds(const MassProperties& bracket, const MassProperties& exact) {
  const Real slack = 32 * kEpsilon;
  const bool volume =
      bracket.volume_min <= exact.volume * (1 + slack) && exact.volume * (1 - slack) <= bracket.volume_max;
  const bool estimate = bracket.volume_min <= bracket.volume && bracket.volume <= bracket.volume_max;
  const Real size = std::sqrt(exact.inertia.trace() / exact.volume) + exact.centroid.norm();
  const bool centre = (bracket.centroid - exact.centroid).norm() <= bracket.centroid_error + slack * size;
  const bool inertia =
      spectral_norm(bracket.inertia - exact.inertia) <= bracket.inertia_error + slack * exact.inertia.trace();
  return volume && estimate && centre && inertia;
}

}  // namespace

static void world_bounds_touch_the_support_planes_whatever_the_pose(void**) {
  Random random(1);
  for (int trial = 0; trial < 300; ++trial)
    each_closed_form(random, 1e-6, 1e6, [&](const Shape& s) {
      const Mat3 r = random_rotation(random);
      const Vec3 p = random.in_cube(10);
      SupportFault fault;
      const Aabb b = world_bounds(s, r, p, fault);
      assert_int_equal(fault.kind, SupportFault::none);
      for (int i = 0; i < 3; ++i) {
        const Vec3 axis = r.row(i);
        const Real hi = p[i] + axis.dot(support_point(s, axis)), lo = p[i] + axis.dot(support_point(s, -axis));
        // Three products and their sums on either side, of numbers no larger than the reach and p; r's row has length 1
        // +- 4 u.
        const Real tolerance = 16 * kEpsilon * (s.bounding_radius + std::fabs(p[i]));
        assert_true(std::fabs(b.hi[i] - hi) <= tolerance);
        assert_true(std::fabs(b.lo[i] - lo) <= tolerance);
      }
    });
}

static void bounds_of_an_undeclared_shape_equal_those_of_the_same_shape_declared(void**) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial)
    each_closed_form(random, 1e-3, 1e3, [&](Shape s) {
      SupportFault fault;
      assert_true(derive_bounds(s, fault));
      const Aabb known = s.bounds;
      const Real reach = s.bounding_radius;
      s.form = Form::none;
      assert_true(derive_bounds(s, fault));
      // Each coordinate to a rounding or two of its own size; the radius at most 8 / sqrt 66 too large, never too
      // small.
      const Vec3 tolerance = 4 * kEpsilon * (known.lo.abs() + known.hi.abs());
      assert_true((s.bounds.lo - known.lo).abs().all_within(tolerance));
      assert_true((s.bounds.hi - known.hi).abs().all_within(tolerance));
      assert_true(s.bounding_radius >= reach * (1 - 16 * kEpsilon));
      assert_true(s.bounding_radius <= reach * std::sqrt(66.0) / 8 * (1 + 16 * kEpsilon));
    });
}

static void no_support_point_lies_outside_the_bounding_radius(void**) {
  Random random(3);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<Vec3> points;
    for (int i = 0; i < 3; ++i) points.push_back(random.in_cube(1));  // a triangle: its corners are the farthest points
    Shape s = hull(points);
    Real farthest = 0;
    for (const Vec3& p : points) farthest = std::max(farthest, p.norm());
    s.form = Form::none;
    SupportFault fault;
    assert_true(derive_bounds(s, fault));
    assert_true(s.bounding_radius >= farthest);
  }
}

static void a_half_space_has_no_bounds(void**) {
  Shape s(std::pmr::get_default_resource());
  s.form = Form::half_space;
  SupportFault fault;
  assert_true(derive_bounds(s, fault));
  assert_true(s.bounds.hi == Vec3::constant(kInfinity) && s.bounds.lo == Vec3::constant(-kInfinity));
  assert_true(s.bounding_radius == kInfinity);
  assert_true(mass_from_support(s, 1e-3, 100, fault).volume == 0);
}

/// In the world one ends at its plane where that is square to an axis, and nowhere where it is not.
static void a_half_space_square_to_an_axis_ends_at_its_plane(void**) {
  Shape s(std::pmr::get_default_resource());
  s.form = Form::half_space;
  s.offset = 0.1;
  const Vec3 p(0.3, -0.7, 1e3);
  SupportFault fault;
  for (int axis = 0; axis < 3; ++axis)
    for (const Real sign : {-1.0, 1.0}) {
      s.normal = sign * Vec3::unit(axis);
      Aabb expected;
      expected.lo = Vec3::constant(-kInfinity), expected.hi = Vec3::constant(kInfinity);
      const Real plane = sign * (s.offset + sign * p[axis]);
      Real& end = (sign > 0 ? expected.hi : expected.lo)[axis];
      end = plane;
      const Aabb b = world_bounds(s, Mat3::identity(), p, fault);
      const Real beyond = sign * ((sign > 0 ? b.hi : b.lo)[axis] - plane);
      assert_true(beyond > 0 && beyond <= 4 * kEpsilon * (0.1 + std::fabs(p[axis])));
      end = (sign > 0 ? b.hi : b.lo)[axis];
      assert_true(b.lo == expected.lo && b.hi == expected.hi);
    }
  s.normal = Vec3(1e-17, 1, 0);  // its plane meets the axis only far out
  const Aabb tilted = world_bounds(s, Mat3::identity(), p, fault);
  assert_true(tilted.hi == Vec3::constant(kInfinity) && tilted.lo == Vec3::constant(-kInfinity));
}

static void the_bracket_holds_the_closed_form_at_every_budget(void**) {
  Random random(4);
  for (int trial = 0; trial < 20; ++trial)
    each_closed_form(random, 1e-6, 1e6, [&](const Shape& s) {
      const MassProperties exact = form_mass(s);
      Real first = 0;
      for (const int budget : {1, 50, 150, 500}) {
        SupportFault fault;
        const MassProperties bracket = mass_from_support(s, 0, budget, fault);
        assert_int_equal(fault.kind, SupportFault::none);
        assert_true(holds(bracket, exact));
        // Not from each step to the next (a new facet's plane may cut worse than the one it replaces), but in the long
        // run:
        const Real width = bracket.volume_max - bracket.volume_min;
        if (first == 0) first = width;
        assert_true(budget < 500 || width <= first);
      }
    });
}

static void a_box_is_exact_to_rounding_after_32_supports(void**) {
  for (const Vec3& half : {Vec3(1, 2, 3), Vec3(1e4, 1e-4, 1), Vec3(1e-6, 1e-6, 1e-6), Vec3(1e6, 1e6, 1e-2)}) {
    const Shape s = box(half);
    SupportFault fault;
    const MassProperties bracket = mass_from_support(s, 0, 32, fault), exact = form_mass(s);
    // The slack of the frame, 16 u times a sum of three O(1) terms, on both sides of three widths.
    assert_true(bracket.volume_max - bracket.volume_min <= 6 * 16 * 16 * kUnitRoundoff * exact.volume);
    assert_true(std::fabs(bracket.volume - exact.volume) <= 32 * kEpsilon * exact.volume);
    assert_true(holds(bracket, exact));
  }
}

// A curved surface of size 1 under N facets of size e ~ N^(-1/2) bulges e^2 over them, so the width falls like 1/N;
// where one curvature is zero, N facets in a ring are 1/N long and bulge 1/N^2.
static void the_width_falls_like_1_over_n_for_a_sphere_and_1_over_n2_for_a_cylinder_and_a_cone(void**) {
  const auto slope = [](const Shape& s) {
    Real width[2];
    const int budget[2] = {400, 6400};
    for (int i = 0; i < 2; ++i) {
      SupportFault fault;
      const MassProperties m = mass_from_support(s, 0, budget[i], fault);
      width[i] = (m.volume_max - m.volume_min) / m.volume;
    }
    return std::log(width[0] / width[1]) / std::log(Real(budget[1]) / budget[0]);
  };
  // Facets split one at a time, so the finest and coarsest differ by two in area: a factor 2 over 16 is 0.25 in the
  // slope.
  assert_true(std::fabs(slope(sphere(1)) - 1) < 0.25);
  assert_true(std::fabs(slope(ellipsoid(Vec3(1e-2, 1, 30))) - 1) < 0.25);
  assert_true(std::fabs(slope(cylinder(1, 1)) - 2) < 0.25);
  assert_true(std::fabs(slope(cone(1, 1)) - 2) < 0.25);
}

static void tolerance_stops_the_growth_when_the_bracket_is_that_narrow(void**) {
  for (const Real tolerance : {1e-1, 1e-2, 1e-3}) {
    const Shape s = cylinder(0.3, 2);
    SupportFault fault;
    const MassProperties m = mass_from_support(s, tolerance, 100000, fault);
    const Real width = (m.volume_max - m.volume_min) / m.volume;
    // One more fan of facets at the worst place never halves the width twice.
    assert_true(width <= tolerance && width > tolerance / 4);
  }
}

static void the_mass_of_a_moved_hull_obeys_the_parallel_axis_theorem(void**) {
  Random random(5);
  for (int trial = 0; trial < 100; ++trial) {
    const Mat3 r = random_rotation(random);
    const Vec3 p = random.in_cube(3), half(random.uniform(0.1, 2), random.uniform(0.1, 2), random.uniform(0.1, 2));
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i)
      corners.push_back(r * half.times(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)) + p);
    const Shape moved = hull(corners);
    const MassProperties m = form_mass(moved), b = form_mass(box(half));
    // Corners are rounded to u of 4 m against features of 0.2 m, and volumes of 1 m^3 come from tetrahedra of up to 30
    // m^3.
    const Real u = 4 / 0.2 * 30 * kEpsilon;
    assert_true(std::fabs(m.volume - b.volume) <= u * b.volume);
    assert_true((m.centroid - p).norm() <= u * 4);
    const Mat3 expected = r * b.inertia * r.transpose();
    assert_true((m.inertia - expected).norm() <= u * expected.norm());
    SupportFault fault;
    assert_true(holds(mass_from_support(moved, 0, 100, fault), m));
    // About the shape's origin instead: I_o = I_c + V (|p|^2 1 - p p^T), as signed tetrahedra from the origin would
    // give.
    const Mat3 about_origin = m.inertia + m.volume * (p.squared_norm() * Mat3::identity() - outer(p, p));
    assert_true(spectral_norm(about_origin) >= spectral_norm(m.inertia) * (1 - u));
  }
}

static void an_affine_image_has_its_volume_times_the_determinant(void**) {
  Random random(6);
  std::vector<Vec3> points;
  for (int i = 0; i < 200; ++i) points.push_back(random.direction());
  const MassProperties m = form_mass(hull(points));
  for (int trial = 0; trial < 50; ++trial) {
    Mat3 a;
    for (int i = 0; i < 9; ++i) a.data()[i] = random.uniform(-1, 1);
    const Real det = std::fabs(a.determinant()), condition = std::pow(a.norm(), 3) / det;
    if (condition > 1e6) continue;
    std::vector<Vec3> image;
    for (const Vec3& x : points) image.push_back(a * x);
    const MassProperties n = form_mass(hull(image));
    // Each image is rounded by a few u of |a|; across the thinnest direction that is `condition` times more.
    const Real tolerance = 16 * kEpsilon * condition;
    assert_true(std::fabs(n.volume - det * m.volume) <= tolerance * n.volume);
    assert_true((n.centroid - a * m.centroid).norm() <= tolerance * a.norm());
    const auto second = [](const MassProperties& x) {  // int x x^T = tr(I)/2 - I
      return Mat3(x.inertia.trace() / 2 * Mat3::identity() - x.inertia);
    };
    const Mat3 expected = det * a * second(m) * a.transpose();
    assert_true((second(n) - expected).norm() <= tolerance * expected.norm());
  }
}

static void the_core_radius_is_part_of_volume_and_bounds(void**) {
  // A rounded box by Steiner's formula: V = V0 + S r + (sum of edges) r^2 pi / 4 + 4/3 pi r^3, edges 8 (a + b + c).
  const Vec3 h(0.5, 0.7, 0.9);
  const Real r = 0.25, pi = 3.14159265358979323846;
  Shape s = rounded_box(h, r);
  const Real volume = 8 * h.product() + 8 * (h.x() * h.y() + h.y() * h.z() + h.z() * h.x()) * r +
                      8 * h.sum() * r * r * pi / 4 + 4 * pi / 3 * r * r * r;
  SupportFault fault;
  const MassProperties m = mass_from_support(s, 0, 2000, fault);
  assert_true(m.volume_min <= volume && volume <= m.volume_max);
  assert_true((m.volume_max - m.volume_min) / volume < 0.02);  // the sphere's 3 % at this budget, on a part of the body
  assert_true(derive_bounds(s, fault));
  assert_true(s.bounds.hi == h + Vec3::constant(r));
  assert_true(s.bounding_radius >= h.norm() + r);
}

static void a_flat_or_thin_hull_has_no_volume_and_breaks_nothing(void**) {
  Random random(7);
  for (int trial = 0; trial < 60; ++trial) {
    const Mat3 r = random_rotation(random);
    std::vector<Vec3> points;
    const int dimension = trial % 3;  // a point, a segment, a square, somewhere in space
    for (int i = 0; i < 12; ++i) {
      Vec3 x = Vec3::zero();
      for (int k = 0; k < dimension; ++k) x[k] = random.uniform(-1, 1);
      points.push_back(r * x + Vec3(1, 2, 3));
    }
    Shape s = hull(points);
    SupportFault fault;
    assert_true(derive_bounds(s, fault));
    const MassProperties exact = form_mass(s), bracket = mass_from_support(s, 1e-3, 200, fault);
    assert_int_equal(fault.kind, SupportFault::none);
    assert_true(exact.volume == 0 && exact.inertia == Mat3::zero());
    // Coordinates of up to 5 leave a plane by their rounding, over an area of at most 4 (2 x 2).
    assert_true(bracket.volume_min == 0 && bracket.volume_max <= 4 * 4 * 32 * 32 * kEpsilon * 5);
    assert_true(finite(bracket.centroid) && bracket.inertia.all_finite());
  }
}

static std::int32_t failing(void*, const double*, std::uint64_t, const double*, double*) { return 7; }
static std::int32_t not_a_number(void*, const double*, std::uint64_t, const double* d, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = d[i] > 0 ? NAN : -1;
  return 0;
}
static std::int32_t far_away(void*, const double*, std::uint64_t, const double* d, double* out) {
  for (int i = 0; i < 3; ++i) out[i] = d[i] > 0 ? 1e12 : -1;
  return 0;
}
static std::int32_t nearest(void*, const double*, std::uint64_t, const double* d,
                            double* out) {  // the corner on the wrong side
  for (int i = 0; i < 3; ++i) out[i] = d[i] > 0 ? -1 : 1;
  return 0;
}

static void a_failing_support_function_is_reported_with_its_evidence(void**) {
  const struct {
    SupportFn support;
    SupportFault::Kind kind;
  } cases[] = {
      {failing, SupportFault::returned}, {not_a_number, SupportFault::not_finite}, {far_away, SupportFault::outside}};
  for (const auto& c : cases) {
    Shape s(std::pmr::get_default_resource());
    s.support = c.support;
    SupportFault bounds_fault, mass_fault, world_fault;
    assert_false(derive_bounds(s, bounds_fault));
    assert_true(mass_from_support(s, 1e-3, 100, mass_fault).volume == 0);
    const Aabb b = world_bounds(s, Mat3::identity(), Vec3::zero(), world_fault);
    assert_true(b.lo.x() > b.hi.x());
    for (const SupportFault* f : {&bounds_fault, &mass_fault, &world_fault}) {
      assert_int_equal(f->kind, c.kind);
      assert_ptr_equal(f->shape, &s);
      assert_true(std::fabs(f->dir[0]) + std::fabs(f->dir[1]) + std::fabs(f->dir[2]) > 0);
    }
  }
  Shape s(std::pmr::get_default_resource());
  s.support = nearest;
  SupportFault fault;
  const MassProperties m = mass_from_support(s, 1e-3, 200, fault);
  assert_true(m.volume == 0 && m.inertia.all_finite());
}

static void a_point_that_leaves_the_measured_shape_at_run_time_is_a_fault(void**) {
  Shape s = rounded_box(Vec3(1, 1, 1), 0.1);
  SupportFault fault;
  assert_true(derive_bounds(s, fault));
  s.params[0] = 2;  // as if the function had changed its mind
  const Aabb b = world_bounds(s, Mat3::identity(), Vec3::zero(), fault);
  assert_true(b.lo.x() > b.hi.x());
  assert_int_equal(fault.kind, SupportFault::outside);
  assert_true(std::fabs(fault.out[0]) == 2);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(world_bounds_touch_the_support_planes_whatever_the_pose),
      cmocka_unit_test(bounds_of_an_undeclared_shape_equal_those_of_the_same_shape_declared),
      cmocka_unit_test(no_support_point_lies_outside_the_bounding_radius),
      cmocka_unit_test(a_half_space_has_no_bounds),
      cmocka_unit_test(a_half_space_square_to_an_axis_ends_at_its_plane),
      cmocka_unit_test(the_bracket_holds_the_closed_form_at_every_budget),
      cmocka_unit_test(a_box_is_exact_to_rounding_after_32_supports),
      cmocka_unit_test(the_width_falls_like_1_over_n_for_a_sphere_and_1_over_n2_for_a_cylinder_and_a_cone),
      cmocka_unit_test(tolerance_stops_the_growth_when_the_bracket_is_that_narrow),
      cmocka_unit_test(the_mass_of_a_moved_hull_obeys_the_parallel_axis_theorem),
      cmocka_unit_test(an_affine_image_has_its_volume_times_the_determinant),
      cmocka_unit_test(the_core_radius_is_part_of_volume_and_bounds),
      cmocka_unit_test(a_flat_or_thin_hull_has_no_volume_and_breaks_nothing),
      cmocka_unit_test(a_failing_support_function_is_reported_with_its_evidence),
      cmocka_unit_test(a_point_that_leaves_the_measured_shape_at_run_time_is_a_fault),
  };
  return cmocka_run_group_tests_name("collision/volume", tests, nullptr, nullptr);
}
