// Meshes and height fields as they are kept: corners made one, neighbours, triangles near a box.
#include <algorithm>
#include <random>
#include <set>

#include "carom_test.h"
#include "scenery_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

double bumps(double x, double z) { return 0.3 * std::sin(1.7 * x) * std::cos(2.3 * z); }

Triangle piece_of(const Shape& s, std::uint32_t i) {
  Triangle p;
  assert_true(s.scenery->triangle(i, p));
  return p;
}

/// A triangle by what it is, whoever keeps it.
bool same(const Triangle& a, const Triangle& b) {
  for (std::size_t turn = 0; turn < 3; ++turn) {
    bool equal = true;
    for (std::size_t k = 0; k < 3 && equal; ++k) {
      const std::size_t m = (k + turn) % 3;
      equal = a.corner[k] == b.corner[m] && a.boundary[k] == b.boundary[m] && (a.boundary[k] || a.far[k] == b.far[m]);
    }
    if (equal) return true;
  }
  return false;
}

}  // namespace

static void corners_at_one_place_are_one_and_a_closed_surface_has_no_rim(void**) {
  const Triangles box = box_surface(Vec3(1, 2, 3));
  Triangles loose;  // every triangle with corners of its own, as files of loose triangles have it
  for (const std::uint32_t i : box.index) loose.vertex(box.xyz[3 * i], box.xyz[3 * i + 1], box.xyz[3 * i + 2]);
  for (std::uint32_t i = 0; i < box.index.size(); i += 3) loose.triangle(i, i + 1, i + 2);
  for (const Triangles& given : {box, loose}) {
    const Shape s = mesh(given);
    assert_int_equal(s.scenery->vertex.size(), 8);
    assert_int_equal(s.scenery->triangles(), 12);
    for (std::uint32_t i = 0; i < 12; ++i) {
      const Triangle p = piece_of(s, i);
      assert_true(p.normal.dot(p.corner[0]) > 0);  // outward
      for (std::size_t k = 0; k < 3; ++k) {
        assert_false(p.boundary[k]);
        // What lies beyond is another corner of the box, on or below the triangle's plane.
        assert_true((p.far[k] - p.corner[0]).dot(p.normal) <= 0);
        assert_true(std::find(p.corner.begin(), p.corner.end(), p.far[k]) == p.corner.end());
      }
    }
  }
}

static void triangles_without_area_are_dropped_and_counted(void**) {
  Triangles t = grid(3, 3, 1, 0, 0, bumps);
  t.triangle(0, 1, 1);  // a corner twice
  const std::uint32_t a = t.vertex(10, 0, 0), b = t.vertex(11, 0, 0), c = t.vertex(12, 1e-13, 0);
  t.triangle(a, b, c);  // three on a line
  const Shape s = mesh(t);
  assert_int_equal(s.scenery->triangles(), 18);
  assert_int_equal(s.scenery->dropped, 2);
}

static void where_three_triangles_share_a_side_all_have_a_rim(void**) {
  Triangles t;
  const std::uint32_t a = t.vertex(0, 0, 0), b = t.vertex(1, 0, 0);
  for (int k = 0; k < 3; ++k) t.triangle(a, b, t.vertex(0.5, std::cos(2.0 * k), std::sin(2.0 * k)));
  const Shape s = mesh(t, true);
  for (std::uint32_t i = 0; i < 3; ++i)
    for (const bool boundary : piece_of(s, i).boundary) assert_true(boundary);
}

static void a_height_field_is_the_mesh_of_its_vertices(void**) {
  const Triangles t = grid(12, 9, 0.25, 0, 0, bumps);
  const Shape field =
      height_field(13, 10, 0.25, 0.25, [](std::uint32_t x, std::uint32_t z) { return bumps(0.25 * x, 0.25 * z); });
  const Shape surface = mesh(t);
  assert_int_equal(field.scenery->triangles(), surface.scenery->triangles());
  for (std::uint32_t i = 0; i < field.scenery->triangles(); ++i) {
    const Triangle p = piece_of(field, i);
    bool found = false;
    for (std::uint32_t j = 0; j < surface.scenery->triangles() && !found; ++j) found = same(p, piece_of(surface, j));
    assert_true(found);
    assert_true(p.normal.y() > 0);
  }
}

static void a_hole_of_a_height_field_has_rims_around_it(void**) {
  const Shape field =
      height_field(6, 6, 1, 1, [](std::uint32_t x, std::uint32_t z) { return x == 2 && z == 2 ? NAN : 0.0; });
  int there = 0, rims = 0;
  for (std::uint32_t i = 0; i < field.scenery->triangles(); ++i) {
    Triangle p;
    if (!field.scenery->triangle(i, p)) continue;
    ++there;
    for (const bool boundary : p.boundary) rims += boundary;
  }
  assert_int_equal(there, 2 * (25 - 4));
  assert_int_equal(rims, 20 + 8);  // around the field, and around the hole of two by two cells
}

static void pieces_near_a_box_are_those_whose_bounds_overlap_it(void**) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> at(-1, 4), size(0, 0.8);
  const Shape shapes[] = {
      mesh(grid(12, 9, 0.25, 0, 0, bumps)),
      height_field(13, 10, 0.25, 0.25, [](std::uint32_t x, std::uint32_t z) { return bumps(0.25 * x, 0.25 * z); })};
  for (const Shape& s : shapes)
    for (int i = 0; i < 500; ++i) {
      Aabb box;
      box.lo = Vec3(at(random), 0.3 * at(random), at(random));
      box.hi = box.lo + Vec3(size(random), size(random), size(random));
      std::set<std::uint32_t> near;
      s.scenery->each_near(box, [&](std::uint32_t k) { assert_true(near.insert(k).second); });
      for (std::uint32_t k = 0; k < s.scenery->triangles(); ++k) {
        const Triangle p = piece_of(s, k);
        Aabb own;
        for (const Vec3& c : p.corner) own.lo = own.lo.min(c), own.hi = own.hi.max(c);
        if (own.overlaps(box)) assert_true(near.count(k) == 1);  // the tree may name more
      }
    }
}

/// Of a box, n points out of a corner's cone exactly if all three of its sides fall.
static void a_surface_falls_away_around_a_corner_within_its_normals(void**) {
  const Shape s = mesh(box_surface(Vec3(1, 2, 3)));
  std::mt19937_64 random(5);
  std::normal_distribution<double> any;
  for (std::uint32_t i = 0; i < s.scenery->triangles(); ++i) {
    const Triangle p = piece_of(s, i);
    for (int k = 0; k < 3; ++k)
      for (int j = 0; j < 200; ++j) {
        const Vec3 n = Vec3(any(random), any(random), any(random)).normalized();
        const Vec3 toward = n.times(p.corner[static_cast<std::size_t>(k)]);
        if (toward.abs().min_entry() < 1e-6) continue;
        assert_int_equal(s.scenery->falls_away_around(p, k, n), toward.min_entry() > 0);
      }
  }
}

/// A face that a line runs along belongs to the box, from however far off the line comes.
void a_line_along_a_face_meets_the_box(void**) {
  QueryTree tree(std::pmr::new_delete_resource());
  Aabb unit;
  unit.lo.set_zero(), unit.hi = Vec3::constant(1);
  tree.build({0u}, {unit});
  Aabb point;
  point.lo.set_zero(), point.hi.set_zero();
  for (Real far = 1; far < QueryTree::kReach; far *= 10)
    for (int axis = 0; axis < 3; ++axis)
      for (int corner = 0; corner < 8; ++corner) {
        Vec3 from(corner & 1, corner >> 1 & 1, corner >> 2), to = Vec3::zero();
        to[axis] = from[axis] > 0 ? -1 : 1;
        from[axis] = -to[axis] * far;
        float limit = QueryTree::above(4 * far);
        int met = 0;
        tree.search(QueryTree::Line(tree, from, to, point), limit, [&](std::uint32_t) { ++met; });
        assert_int_equal(met, 1);
      }
}

int main() {
  const struct CMUnitTest tests[] = {
      cmocka_unit_test(corners_at_one_place_are_one_and_a_closed_surface_has_no_rim),
      cmocka_unit_test(triangles_without_area_are_dropped_and_counted),
      cmocka_unit_test(where_three_triangles_share_a_side_all_have_a_rim),
      cmocka_unit_test(a_height_field_is_the_mesh_of_its_vertices),
      cmocka_unit_test(a_hole_of_a_height_field_has_rims_around_it),
      cmocka_unit_test(pieces_near_a_box_are_those_whose_bounds_overlap_it),
      cmocka_unit_test(a_surface_falls_away_around_a_corner_within_its_normals),
      cmocka_unit_test(a_line_along_a_face_meets_the_box),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
