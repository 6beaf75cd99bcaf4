// A mesh as convex parts: they are convex, hold the mesh, stand out of it no farther than is said, and their volumes
// are what they should be. What has no inside is refused.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <random>

#include "carom_test.h"
#include "host/host.h"
#include "mesh/parts.h"
#include "mesh/solid.h"
#include "scenes/run.h"
#include "sliced.h"

using namespace carom::tools;
using Eigen::Vector3d;

namespace {

/// Boxes side by side as one surface: each wall of the grid of unit cubes between what is filled and what is not.
Mesh blocks(const std::vector<Eigen::Vector3i>& filled) {
  Mesh mesh;
  const auto is_filled = [&](const Eigen::Vector3i& c) { return std::ranges::find(filled, c) != filled.end(); };
  for (const Eigen::Vector3i& c : filled)
    for (int axis = 0; axis < 3; ++axis)
      for (int side = 0; side < 2; ++side) {
        Eigen::Vector3i next = c;
        next[axis] += side ? 1 : -1;
        if (is_filled(next)) continue;
        const auto first = static_cast<std::uint32_t>(mesh.points.size());
        for (int k = 0; k < 4; ++k) {
          Vector3d p = c.cast<double>();
          p[axis] += side;
          p[(axis + 1) % 3] += k == 1 || k == 2;
          p[(axis + 2) % 3] += k >= 2;
          mesh.points.push_back(p);
        }
        const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t d) {
          mesh.faces.push_back({first + a, first + (side ? b : d), first + (side ? d : b)});
        };
        face(0, 1, 2), face(0, 2, 3);
      }
  return mesh;
}

/// Corners of a block in its neighbours' frame: an L of three, a frame round a hole, and what a staircase is.
const std::vector<Eigen::Vector3i> kCorner = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
const std::vector<Eigen::Vector3i> kFrame = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0},
                                             {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}};

Mesh ring(double around, double tube) {
  constexpr std::uint32_t kAround = 32, kAcross = 12;
  Mesh mesh;
  for (std::uint32_t i = 0; i < kAround; ++i)
    for (std::uint32_t j = 0; j < kAcross; ++j) {
      const double a = 2 * std::numbers::pi * i / kAround, b = 2 * std::numbers::pi * j / kAcross;
      const double out = around + tube * std::cos(b);
      mesh.points.emplace_back(out * std::cos(a), tube * std::sin(b), out * std::sin(a));
      const auto at = [&](std::uint32_t x, std::uint32_t y) { return x % kAround * kAcross + y % kAcross; };
      mesh.faces.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  return mesh;
}

/// m: how far p is outside of a convex hull's planes, below 0 inside.
double outside_of(const Mesh& hull, const Vector3d& p) {
  double most = -1e30;
  for (const auto& f : hull.faces) {
    const Vector3d n = (hull.points[f[1]] - hull.points[f[0]]).cross(hull.points[f[2]] - hull.points[f[0]]);
    if (n.norm() > 0) most = std::max(most, n.normalized().dot(p - hull.points[f[0]]));
  }
  return most;
}
double outside_of(const std::vector<Mesh>& hulls, const Vector3d& p) {
  double least = 1e30;
  for (const Mesh& hull : hulls) least = std::min(least, outside_of(hull, p));
  return least;
}

/// By the sum over all faces, no tree.
double winding(const Mesh& mesh, const Vector3d& p) {
  double sum = 0;
  for (const auto& f : mesh.faces) {
    const Vector3d a = mesh.points[f[0]] - p, b = mesh.points[f[1]] - p, c = mesh.points[f[2]] - p;
    sum += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                 b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return sum / (4 * std::numbers::pi);
}
double distance(const Mesh& mesh, const Vector3d& p) {
  double best2 = 1e30;
  for (const auto& f : mesh.faces)
    best2 = std::min(best2, distance_squared(p, mesh.points[f[0]], mesh.points[f[1]], mesh.points[f[2]]));
  return std::sqrt(best2);
}

/// Points of a mesh's bounding box, on its faces and of its parts, against what take_apart() says.
void check_parts(const Mesh& mesh, const Parts& parts, double most_out) {
  std::mt19937 random(7);
  const auto uniform = [&] { return std::generate_canonical<double, 32>(random); };
  double size = 0;
  for (const Vector3d& p : mesh.points) size = std::max(size, p.norm());
  const double rounding = 1e-12 * size;
  double sum = 0;
  for (std::size_t k = 0; k < parts.hulls.size(); ++k) {
    const Mesh& hull = parts.hulls[k];
    for (const Vector3d& p : hull.points) assert_true(outside_of(hull, p) < rounding);  // convex
    assert_true(parts.volumes[k] > 0 && std::fabs(parts.volumes[k] - volume_of(hull)) < 1e-12 * parts.volumes[k]);
    if (k > 0) assert_true(parts.volumes[k] <= parts.volumes[k - 1]);
    sum += parts.volumes[k];
  }
  assert_true(sum >= parts.mesh_volume * (1 - 1e-9) - parts.lost * size * size * 24);
  // All of the mesh's surface, and all that it encloses.
  for (const auto& f : mesh.faces)
    for (int i = 0; i < 4; ++i) {
      double u = uniform(), v = uniform();
      if (u + v > 1) u = 1 - u, v = 1 - v;
      const Vector3d p =
          mesh.points[f[0]] + u * (mesh.points[f[1]] - mesh.points[f[0]]) + v * (mesh.points[f[2]] - mesh.points[f[0]]);
      assert_true(outside_of(parts.hulls, p) < parts.lost + rounding);
    }
  int inside = 0;
  double out = 0;
  for (int i = 0; i < 4000; ++i) {
    const Vector3d p = size * Vector3d(2 * uniform() - 1, 2 * uniform() - 1, 2 * uniform() - 1);
    const double in_parts = outside_of(parts.hulls, p);
    if (winding(mesh, p) > 0.5)
      ++inside, assert_true(in_parts < parts.lost + rounding);
    else if (in_parts < 0)
      out = std::max(out, distance(mesh, p));
  }
  assert_true(inside > 20);
  // It is sampled at a half of a cell: a corner in between stands out by no more than that farther.
  std::printf("  %zu parts stand out by %.4g, seen %.4g, wanted %.4g\n", parts.hulls.size(), parts.outside, out,
              most_out);
  assert_true(out <= parts.outside + size / 32 && parts.outside <= most_out);
}

bool is_refused(const Mesh& mesh, const PartsWanted& wanted, const char* why) {
  try {
    take_apart(mesh, wanted);
  } catch (const Error& error) {
    return std::string(error.what()).find(why) != std::string::npos && !error.remedy.empty();
  }
  return false;
}

}  // namespace

static void a_box_is_one_part_and_blocks_are_as_many_as_they_need(void**) {
  const Mesh box = blocks({{0, 0, 0}});
  const Parts one = take_apart(box, {});
  assert_int_equal(one.hulls.size(), 1);
  assert_true(std::fabs(one.volumes[0] - 1) < 1e-12 && one.outside == 0 && one.lost == 0);
  check_parts(box, one, 0);
  // Cuts fall on planes of a grid of 60 to 90 cells, so that a cut may miss an edge by half of one.
  const Mesh corner = blocks(kCorner);
  PartsWanted coarse;
  coarse.concavity = 0.1;
  const Parts two = take_apart(corner, coarse);
  assert_int_equal(two.hulls.size(), 2);
  assert_true(std::fabs(two.mesh_volume - 3) < 1e-12 && std::fabs(two.hull_volume - 3.5) < 1e-12);
  check_parts(corner, two, 0.1);
  const Mesh frame = blocks(kFrame);
  const Parts four = take_apart(frame, coarse);
  assert_int_equal(four.hulls.size(), 4);
  check_parts(frame, four, 0.1);
}

static void one_part_is_the_hull_and_says_how_far_it_stands_out(void**) {
  PartsWanted wanted;
  wanted.most = 1;
  const Parts one = take_apart(blocks(kFrame), wanted);
  assert_int_equal(one.hulls.size(), 1);
  assert_true(std::fabs(one.volumes[0] - 9) < 1e-12);
  // The middle of the hole, on a face of the hull, is half a block from the frame; samples are half a cell apart.
  assert_true(one.outside <= 0.5 && one.outside > 0.5 - 3.0 / 64);
  check_parts(blocks(kFrame), one, 0.5);
}

[[maybe_unused]] static void a_ring_keeps_its_hole_and_finer_parts_follow_it_closer(void**) {
  const Mesh mesh = ring(0.35, 0.09);
  double last = 1;
  for (const double concavity : {0.06, 0.04}) {
    PartsWanted wanted;
    wanted.concavity = concavity, wanted.most = 32;
    const Parts parts = take_apart(mesh, wanted);
    check_parts(mesh, parts, concavity);
    assert_true(outside_of(parts.hulls, Vector3d::Zero()) > 0.1);
    assert_true(parts.outside < last);
    last = parts.outside;
    if (concavity < carom::test::sliced(0.0, 0.05, 0.05)) continue;
    // The same again, to the bit.
    const Parts again = take_apart(mesh, wanted);
    assert_true(again.outside == parts.outside && again.volumes == parts.volumes);
  }
  // Fewer vertices lose what they say.
  PartsWanted few;
  few.vertices = 12, few.concavity = 0.05;
  const Parts parts = take_apart(mesh, few);
  assert_true(parts.lost > 0);
  for (const Mesh& hull : parts.hulls) assert_true(hull.points.size() <= 12);
  check_parts(mesh, parts, 0.05);
}

static void a_hole_in_the_surface_does_no_harm(void**) {
  Mesh mesh = ring(0.35, 0.09);
  mesh.faces.erase(mesh.faces.begin() + 100, mesh.faces.begin() + 104);
  PartsWanted wanted;
  wanted.concavity = 0.05;
  check_parts(mesh, take_apart(mesh, wanted), 0.05);
}

static void what_has_no_inside_is_refused(void**) {
  const Mesh box = blocks({{0, 0, 0}});
  Mesh faceless = box, flat = box, sheet;
  faceless.faces.clear();
  for (Vector3d& p : flat.points) p.y() = 0;
  for (int i = 0; i < 9; ++i) sheet.points.emplace_back(i % 3, 0.3 * (i % 2), i / 3);
  for (std::uint32_t i : {0u, 1u, 3u, 4u})
    sheet.faces.push_back({i, i + 3, i + 1}), sheet.faces.push_back({i + 1, i + 3, i + 4});
  assert_true(is_refused(faceless, {}, "no faces"));
  assert_true(is_refused(flat, {}, "convex hull"));
  assert_true(is_refused(sheet, {}, "encloses nothing"));
  PartsWanted wanted;
  wanted.most = 0;
  assert_true(is_refused(box, wanted, "number of parts"));
  wanted = {}, wanted.concavity = -1;
  assert_true(is_refused(box, wanted, "concavity"));
  wanted.concavity = NAN;
  assert_true(is_refused(box, wanted, "concavity"));
  wanted = {}, wanted.vertices = 7;
  assert_true(is_refused(box, wanted, "vertices"));
}

static void parts_are_written_and_read_back(void**) {
  const char* path = "parts_test.obj";
  PartsWanted coarse;
  coarse.concavity = 0.2;
  const Parts parts = take_apart(blocks(kFrame), coarse);
  write_parts(path, parts.hulls);
  const std::vector<Mesh> back = read_parts(path);
  assert_int_equal(back.size(), parts.hulls.size());
  for (std::size_t k = 0; k < back.size(); ++k) {
    assert_true(back[k].points == parts.hulls[k].points);
    assert_true(back[k].faces == parts.hulls[k].faces);
  }
  std::ofstream(path) << "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  assert_int_equal(read_parts(path).size(), 1);
  std::remove(path);
  bool refused = false;
  try {
    write_parts("/nowhere/parts.obj", parts.hulls);
  } catch (const Error& error) {
    refused = !error.remedy.empty();
  }
  assert_true(refused);
}

[[maybe_unused]] static void rings_of_parts_slide_down_a_post_and_hulls_of_rings_do_not(void**) {
  for (const int parts : {12, 1}) {
    const Scene& scene = find_scene("quoits");
    Engine engine(PluginPath({CAROM_PLUGIN_DIR}));
    Stage stage(engine);
    const auto observer = build(scene, {{{"n", 3}, {"parts", parts}}, ""}, stage);
    simulate(stage, observer.get(), 3, scene.dt);
    for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
    assert_true(observer->came_off(stage) == (parts > 1));
  }
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_box_is_one_part_and_blocks_are_as_many_as_they_need),
      cmocka_unit_test(one_part_is_the_hull_and_says_how_far_it_stands_out),
      cmocka_unit_test(a_hole_in_the_surface_does_no_harm),
      cmocka_unit_test(what_has_no_inside_is_refused),
      cmocka_unit_test(parts_are_written_and_read_back),
#ifndef CAROM_SANITIZED
      cmocka_unit_test(a_ring_keeps_its_hole_and_finer_parts_follow_it_closer),
      cmocka_unit_test(rings_of_parts_slide_down_a_post_and_hulls_of_rings_do_not),
#endif
  };
  return cmocka_run_group_tests_name("tools/parts", tests, nullptr, nullptr);
}
