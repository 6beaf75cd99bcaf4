// Box against box where it is hard: patches against a twin, parallel edges, thin and huge boxes, touching and
// containing.
#include <algorithm>
#include <vector>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kReach = 0.01;  // m: the default contact distance
constexpr Real kQuarter = 0.78539816339744830962;

Frame turned(const Vec3& phi, const Vec3& at) { return Frame(exp_map(phi).matrix(), at); }

Candidates contacts(const Shape& a, const Shape& b, const Frame& pose, Real reach = kReach) {
  Candidates found;
  contact_box_box(a, b, pose, reach, found);
  return found;
}

bool has_point(const Candidates& found, const Vec3& on_a, Real tol) {
  return std::any_of(found.point, found.point + found.count,
                     [&](const ContactPoint& p) { return (p.on_a - on_a).norm() <= tol; });
}

Real farthest(const Candidates& found, const Vec3& u) {
  Real most = -kInfinity;
  for (int k = 0; k < found.count; ++k) most = std::max(most, u.dot(found.point[k].on_a));
  return most;
}

}  // namespace

static void stacked_cubes_with_an_offset_touch_over_the_common_rectangle(void**) {
  const Shape cube = box(Vec3(1, 1, 1));
  const Candidates found = contacts(cube, cube, turned(Vec3::zero(), Vec3(0.5, 1.999, -0.25)));
  assert_int_equal(found.count, 4);
  assert_true(found.whole);
  for (const Real x : {-0.5, 1.0})
    for (const Real z : {-1.0, 0.75}) assert_true(has_point(found, Vec3(x, 1, z), 4 * kEpsilon));
  for (int k = 0; k < 4; ++k) {
    assert_true(found.point[k].normal == Vec3::unit_y());
    assert_true(std::fabs(found.point[k].separation + 1e-3) <= 4 * kEpsilon);
  }
}

static void a_turn_of_45_degrees_gives_all_eight_points(void**) {
  const Shape cube = box(Vec3(1, 1, 1));
  const Candidates found = contacts(cube, cube, turned(Vec3(0, kQuarter, 0), Vec3(0, 2, 0)));
  assert_int_equal(found.count, 8);
  const Real cut = std::sqrt(2.0) - 1;  // corners of the octagon |x|, |z| <= 1, |x| + |z| <= sqrt 2
  for (const Real s : {-1.0, 1.0})
    for (const Real t : {-1.0, 1.0}) {
      assert_true(has_point(found, Vec3(s, 1, t * cut), 16 * kEpsilon));
      assert_true(has_point(found, Vec3(t * cut, 1, s), 16 * kEpsilon));
    }
}

static void the_patch_is_all_that_lies_within_reach(void**) {
  // The twin samples B's lower face, and keeps what lies over A's upper face within reach. No sample may lie outside
  // the hull of the points (seen in 32 directions), and every point must be near a sample.
  Random random(21);
  int patches = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Shape a = random_shape(Form::box, 1, random), b = random_shape(Form::box, 1, random);
    const Vec3 tilt{random.uniform(-3e-3, 3e-3), 0, random.uniform(-3e-3, 3e-3)};
    Frame pose = turned(Vec3(0, random.uniform(-3, 3), 0), Vec3::zero());
    pose.r = exp_map(tilt).matrix() * pose.r;
    pose.p = Vec3{random.uniform(-0.7, 0.7), a.half.y() + b.half.y() - 2e-3, random.uniform(-0.7, 0.7)};
    const Candidates found = contacts(a, b, pose);
    if (found.count < 3 || std::fabs(found.point[0].normal.y()) < 0.999 || !found.whole)
      continue;  // beside, or an edge
    ++patches;
    const int n = 60;
    std::vector<Vec3> samples;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; j <= n; ++j) {
        const Vec3 x = pose.apply(Vec3(b.half.x() * (2.0 * i / n - 1), -b.half.y(), b.half.z() * (2.0 * j / n - 1)));
        if (std::fabs(x.x()) <= a.half.x() && std::fabs(x.z()) <= a.half.z() && x.y() - a.half.y() <= kReach)
          samples.push_back(x);
      }
    // The reference face may be B's, tilted by up to 3e-3 against A's: heights differ by the tilt times the height
    // above, at most 1e-2 * 3e-3 across; a sample lies within a cell (diagonal 2 sqrt 2 / 60 of a half extent) of any
    // point.
    const Real cell = 2 * std::sqrt(2.0) / n;
    for (int i = 0; i < 32; ++i) {
      const SinCos u = sin_cos(i * kQuarter / 4);
      const Vec3 dir(u.cos, 0, u.sin);
      Real most = -kInfinity;
      for (const Vec3& x : samples) most = std::max(most, dir.dot(x));
      const Real reached = farthest(found, dir);
      assert_true(most <= reached + 1e-4);
      assert_true(reached <= most + cell + 1e-4);
    }
  }
  assert_true(patches > 100);
}

static void faces_that_are_parallel_to_a_billionth_still_meet_as_faces(void**) {
  const Shape cube = box(Vec3(1, 1, 1));
  Random random(22);
  for (const Real tilt : {0.0, 1e-16, 1e-12, 1e-9, 1e-8, 3e-8, 1e-7, 1e-6, 1e-5}) {
    for (int trial = 0; trial < 100; ++trial) {
      Frame pose =
          turned(tilt * random.direction(), Vec3{random.uniform(-1.5, 1.5), 1.9999, random.uniform(-1.5, 1.5)});
      const Candidates found = contacts(cube, cube, pose);
      assert_int_equal(found.count, 4);
      for (int k = 0; k < 4; ++k) {
        assert_true(found.point[k].normal.y() >= 1 - tilt * tilt - 4 * kEpsilon);
        // Corners move by the tilt times their distance from the centre, sqrt 3 at most, and lie across a tilted plane.
        assert_true(std::fabs(found.point[k].separation + 1e-4) <= 4 * tilt + 8 * kEpsilon);
      }
    }
  }
}

static void crossed_rods_meet_in_one_point(void**) {
  const Shape rod = box(Vec3(0.1, 0.1, 1));
  // Turned by 45 degrees about their own axes, then across: edge over edge, sqrt(2) / 10 above either axis.
  const Mat3 on_edge = exp_map(Vec3(0, 0, kQuarter)).matrix();
  const Real up = std::sqrt(0.02);
  for (const Real turn : {0.3, 0.8, 1.5707963267948966}) {
    const Mat3 across = exp_map(Vec3(0, turn, 0)).matrix();
    for (const Real overlap : {-0.005, 0.0, 0.005, 0.05}) {
      // Both seen from A, whose edge points up along (1, 1, 0)/sqrt 2 of its own frame.
      const Frame b_in_world(across * on_edge, Vec3(0.03, 2 * up - overlap, 0.02));
      const Frame pose = relative(Frame(on_edge, Vec3::zero()), b_in_world);
      const Candidates found = contacts(rod, rod, pose);
      assert_int_equal(found.count, 1);
      assert_false(found.whole);
      assert_true(std::fabs(found.point[0].separation + overlap) <= 16 * kEpsilon);
      const Vec3 on_a = on_edge * found.point[0].on_a;
      assert_true(std::fabs(on_a.x()) <= 16 * kEpsilon && std::fabs(on_a.y() - up) <= 16 * kEpsilon);
      const Vec3 on_b = b_in_world.apply(found.point[0].on_b);
      assert_true(std::fabs(on_b.x() - on_a.x()) + std::fabs(on_b.z() - on_a.z()) <= 64 * kEpsilon);
    }
  }
}

static void a_corner_on_a_face_touches_in_that_corner(void**) {
  const Shape slab = box(Vec3(3, 1, 3)), cube = box(Vec3(0.5, 0.5, 0.5));
  // A diagonal of the cube straight down: y = (1, 1, 1)/sqrt 3 of the cube.
  const Vec3 diagonal = Vec3(1, 1, 1) / std::sqrt(3.0), axis = diagonal.cross(Vec3::unit_y());
  const Mat3 r = exp_map(axis / axis.norm() * std::acos(diagonal.y())).matrix();
  const Real down = std::sqrt(0.75);
  for (const Real depth : {-1e-3, -1e-12, 0.0, 1e-12, 1e-3, 0.1}) {
    const Candidates found = contacts(slab, cube, Frame(r, Vec3(0.3, 1 + down - depth, -0.2)));
    const ContactPoint& p = *deepest(found);
    assert_true(std::fabs(p.separation + depth) <= 8 * kEpsilon);
    assert_true((p.on_a - Vec3(0.3, 1, -0.2)).norm() <= 16 * kEpsilon);
    assert_true((p.on_b - Vec3(-0.5, -0.5, -0.5)).norm() <= 16 * kEpsilon);
  }
}

static void coincident_and_containing_boxes_know_the_shortest_way_out(void**) {
  const Shape outer = box(Vec3(1, 2, 3)), inner = box(Vec3(0.1, 0.2, 0.3));
  const Candidates same = contacts(outer, outer, Frame(), kInfinity);
  assert_true(deepest(same)->separation == -2);
  assert_true(deepest(same)->normal.x() != 0);
  for (const Real y : {0.0, 1.5, -1.5}) {
    const Candidates found = contacts(outer, inner, Frame(Mat3::identity(), Vec3(0.2, y, 0)), kInfinity);
    // To the right 1 + 0.1 - 0.2; up 2 + 0.2 - 1.5.
    const Real depth = y == 0 ? 0.9 : 0.7;
    assert_true(std::fabs(deepest(found)->separation + depth) <= 8 * kEpsilon);
    const Candidates back = contacts(inner, outer, Frame(Mat3::identity(), Vec3(-0.2, -y, 0)), kInfinity);
    assert_true(std::fabs(deepest(back)->separation + depth) <= 8 * kEpsilon);
  }
}

static void an_aspect_ratio_of_ten_thousand_loses_nothing(void**) {
  const Shape sheet = box(Vec3(1, 1e-4, 1)), needle = box(Vec3(1, 1e-4, 1e-4));
  for (const Real turn : {0.0, 0.4, kQuarter, 1.5707963267948966}) {
    // A sheet on a sheet, overlapping by a tenth of its thickness; a needle on a sheet.
    for (const Shape* top : {&sheet, &needle}) {
      const Candidates found = contacts(sheet, *top, turned(Vec3(0, turn, 0), Vec3(0.1, 1.8e-4, 0.2)), 1e-5);
      assert_true(found.count >= 4);
      for (int k = 0; k < found.count; ++k) {
        assert_true(found.point[k].normal == Vec3::unit_y());
        assert_true(std::fabs(found.point[k].separation + 2e-5) <= 16 * kEpsilon);
      }
    }
    // Needles crossed one over the other: the patch is their common square.
    const Candidates crossed = contacts(needle, needle, turned(Vec3(0, turn, 0), Vec3(0, 1.8e-4, 0)), 1e-5);
    assert_true(crossed.count >= 4);
    assert_true(crossed.point[0].normal == Vec3::unit_y());
  }
}

static void a_scale_by_a_power_of_two_scales_every_bit(void**) {
  Random random(23);
  for (int trial = 0; trial < 1000; ++trial) {
    const Shape a = random_shape(Form::box, 1, random), b = random_shape(Form::box, 1, random);
    const Frame pose = random_pose(a, b, random);
    const Candidates one = contacts(a, b, pose, 0x1p-6);
    for (const Real scale : {0x1p-13, 0x1p13}) {  // 1e-4 and 1e4
      const Candidates other =
          contacts(box(scale * a.half), box(scale * b.half), Frame(pose.r, scale * pose.p), scale * 0x1p-6);
      assert_int_equal(one.count, other.count);
      for (int k = 0; k < one.count; ++k) {
        assert_true(other.point[k].separation == scale * one.point[k].separation);
        assert_true(other.point[k].on_a == scale * one.point[k].on_a);
        assert_true(other.point[k].normal == one.point[k].normal);
        assert_int_equal(other.point[k].feature, one.point[k].feature);
      }
    }
  }
}

static void the_preferred_axis_costs_no_more_depth_than_its_bias(void**) {
  // Preferring faces may answer a normal that is not the one of least depth: by at most 2 % of the depth and a
  // thousandth of the smallest half extent, once for the faces of A and once for all faces.
  Random random(24);
  for (int trial = 0; trial < 5000; ++trial) {
    const Shape a = random_shape(Form::box, 1, random), b = random_shape(Form::box, 1, random);
    const Frame pose = random_pose(a, b, random);
    const Candidates preferred = contacts(a, b, pose), exact = contacts(a, b, pose, kInfinity);
    if (preferred.count == 0 || exact.count == 0) continue;  // apart: no depth
    const Real s = deepest(preferred)->separation, best = deepest(exact)->separation;
    const Real bias = 0.02 * std::fabs(s) + 1e-3 * std::min(a.half.min_entry(), b.half.min_entry());
    assert_true(s <= best + 1e-7);
    if (best < 0) assert_true(s >= best - 2 * bias - 1e-7);
  }
}

static void a_corner_before_a_face_is_the_distance_of_boxes_apart(void**) {
  // What the routine says of boxes apart is what GJK finds at 1e-12; it knows one pair in four or so, and is asked here
  // from both sides, with thin boxes among them.
  Random random(31);
  int apart = 0, known = 0;
  for (int trial = 0; trial < 4000; ++trial) {
    const Shape a = random_shape(Form::box, 1, random), b = random_shape(Form::box, 1, random);
    const Vec3 way = exp_map(Vec3{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)}) * Vec3(3, 0, 0);
    const Vec3 turn{random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
    const Frame pose = turned(turn, random.uniform(0, 1) * way);
    QuerySettings settings;
    settings.tolerance = 1e-12;
    QueryResult truth;
    SupportFault fault;
    generic_distance(a, b, pose, settings, nullptr, truth, fault);
    if (!(truth.separation > 1e-9)) continue;
    ++apart;
    const Candidates found = contacts(a, b, pose, kInfinity);
    if (found.count == 0) continue;
    ++known;
    assert_int_equal(found.count, 1);
    const ContactPoint& p = found.point[0];
    assert_true(std::fabs(p.separation - truth.separation) < 1e-11);
    assert_true((pose.apply(p.on_b) - p.on_a - p.separation * p.normal).norm() < 1e-13);
    assert_true((p.on_a.abs() - a.half).all_within(Vec3::constant(1e-13)));
    assert_true((p.on_b.abs() - b.half).all_within(Vec3::constant(1e-13)));
  }
  assert_true(apart > 1000);
  assert_true(5 * known > apart);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(stacked_cubes_with_an_offset_touch_over_the_common_rectangle),
      cmocka_unit_test(a_turn_of_45_degrees_gives_all_eight_points),
      cmocka_unit_test(the_patch_is_all_that_lies_within_reach),
      cmocka_unit_test(faces_that_are_parallel_to_a_billionth_still_meet_as_faces),
      cmocka_unit_test(crossed_rods_meet_in_one_point),
      cmocka_unit_test(a_corner_on_a_face_touches_in_that_corner),
      cmocka_unit_test(coincident_and_containing_boxes_know_the_shortest_way_out),
      cmocka_unit_test(an_aspect_ratio_of_ten_thousand_loses_nothing),
      cmocka_unit_test(a_scale_by_a_power_of_two_scales_every_bit),
      cmocka_unit_test(the_preferred_axis_costs_no_more_depth_than_its_bias),
      cmocka_unit_test(a_corner_before_a_face_is_the_distance_of_boxes_apart),
  };
  return cmocka_run_group_tests_name("collision/pairs_box_box", tests, nullptr, nullptr);
}
