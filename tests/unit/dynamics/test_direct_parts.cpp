// The parts of the direct solver: nearest points of a cone, orders of elimination, factors of blocks.
#include <Eigen/Cholesky>
#include <Eigen/Dense>
#include <set>
#include <vector>

#include "carom_test.h"
#include "dynamics/solver/direct/block_factor.h"
#include "dynamics/solver/direct/cone.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

Vec3 any_vector(Random& random, Real size) {
  return size * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// A symmetric positive definite system on a graph, dense and in blocks.
struct System {
  explicit System(std::uint32_t nodes, const std::vector<Edge>& edges, Random& random)
      : elimination(std::pmr::new_delete_resource()), factor(std::pmr::new_delete_resource()) {
    elimination.clear();
    products = eliminate(0, nodes, edges, {}, ~std::uint64_t{0}, elimination);
    dense = Eigen::MatrixXd::Identity(6 * nodes, 6 * nodes);
    factor.diagonal.assign(nodes, Block{});
    factor.beside.assign(elimination.rows.size(), Block{});
    factor.is_filled.assign(elimination.rows.size(), 1);
    for (const Edge& e : edges) {
      // J^T J for a random J keeps the sum definite.
      Eigen::MatrixXd j = Eigen::MatrixXd::Zero(3, 6 * nodes);
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 6; ++c)
          j(r, 6 * e.a + c) = random.uniform(-1, 1), j(r, 6 * e.b + c) = random.uniform(-1, 1);
      dense += 10 * j.transpose() * j;
    }
    for (std::uint32_t a = 0; a < nodes; ++a) {
      fill(factor.diagonal[elimination.place[a]], a, a);
      for (std::uint32_t b = 0; b < nodes; ++b)
        if (elimination.place[a] > elimination.place[b] && dense.block(6 * a, 6 * b, 6, 6).norm() > 0)
          fill(factor.beside[factor.at(elimination, elimination.place[a], elimination.place[b])], b, a);
    }
  }
  void fill(Block& to, std::uint32_t a, std::uint32_t b) const {
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < 6; ++k) to.x[i][k] = dense(6 * a + i, 6 * b + k);
  }

  Elimination elimination;
  BlockFactor factor;
  Eigen::MatrixXd dense;
  std::uint64_t products = 0;
};

std::vector<Edge> chain(std::uint32_t nodes) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i + 1 < nodes; ++i) edges.push_back({i, i + 1});
  return edges;
}

std::vector<Edge> grid(std::uint32_t side) {
  std::vector<Edge> edges;
  for (std::uint32_t i = 0; i < side; ++i)
    for (std::uint32_t k = 0; k < side; ++k) {
      if (k + 1 < side) edges.push_back({i * side + k, i * side + k + 1});
      if (i + 1 < side) edges.push_back({i * side + k, (i + 1) * side + k});
    }
  return edges;
}

}  // namespace

static void the_projection_on_a_cone_is_its_nearest_point(void**) {
  Random random(7);
  for (int i = 0; i < 20000; ++i) {
    const Vec3 n = any_vector(random, 1).normalized(), z = any_vector(random, 3);
    const Real mu = i % 5 == 0 ? 0 : random.uniform(0.01, 2);
    const Vec3 p = project_on_cone(z, n, mu);
    const Real p_n = p.dot(n), p_t = (p - p_n * n).norm();
    assert_true(p_t <= mu * p_n + 1e-14 && p_n >= 0);
    // Nearest point of a convex cone: what is left is at right angles to it and in its polar cone (Moreau). Rounding:
    // a few u of |z|^2 <= 27.
    const Vec3 left = z - p;
    assert_true(std::fabs(left.dot(p)) < 1e-13);
    assert_true(mu * (left - left.dot(n) * n).norm() <= -left.dot(n) + 1e-14 * 10);
  }
}

static void the_slope_of_the_projection_is_what_differences_say(void**) {
  Random random(8);
  int judged = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3 n = any_vector(random, 1).normalized(), z = any_vector(random, 1);
    const Real mu = i % 5 == 0 ? 0 : random.uniform(0.05, 2);
    const ConePart part = part_of(z, n, mu);
    // Differences say nothing across an edge, and little where the cone's axis is near.
    if (std::fabs(part.n + mu * part.t) < 1e-3 || std::fabs(part.t - mu * part.n) < 1e-3 || part.t < 0.1) continue;
    const Mat3 slope = slope_of_projection(z, n, mu);
    constexpr Real kH = 1e-5;  // error h^2 / t^2 ~ 1e-8 from curvature, u / h ~ 1e-11 from rounding
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = kH * Vec3::unit(k);
      const Vec3 difference = (project_on_cone(z + d, n, mu) - project_on_cone(z - d, n, mu)) / (2 * kH);
      assert_true((difference - slope.col(k)).norm() < 1e-7);
    }
    assert_true((slope - slope.transpose()).norm() < 1e-14);
    ++judged;
  }
  assert_true(judged > 3000);
}

static void an_order_of_elimination_names_every_node_once_and_has_room_for_all_fill(void**) {
  Random random(9);
  for (int trial = 0; trial < 50; ++trial) {
    const auto n = static_cast<std::uint32_t>(2 + random.uniform(0, 30));
    std::vector<Edge> edges;
    for (std::uint32_t i = 1; i < n; ++i) edges.push_back({static_cast<std::uint32_t>(random.uniform(0, i)), i});
    for (std::uint32_t i = 0; i < n; ++i) {
      const auto a = static_cast<std::uint32_t>(random.uniform(0, n)),
                 b = static_cast<std::uint32_t>(random.uniform(0, n));
      if (a != b) edges.push_back({a, b});
    }
    Elimination e(std::pmr::new_delete_resource());
    e.clear();
    eliminate(0, n, edges, {}, ~std::uint64_t{0}, e);
    // Elimination as the textbook has it, on sets.
    std::vector<std::set<std::uint32_t>> near(n);
    for (const Edge& edge : edges) {
      const std::uint32_t a = e.place[edge.a], b = e.place[edge.b];
      near[a].insert(b), near[b].insert(a);
    }
    for (std::uint32_t j = 0; j < n; ++j) {
      const std::vector<std::uint32_t> later(near[j].upper_bound(j), near[j].end());
      assert_true(std::vector<std::uint32_t>(e.rows.begin() + e.column[j], e.rows.begin() + e.column[j + 1]) == later);
      for (const std::uint32_t a : later)
        for (const std::uint32_t b : later)
          if (a != b) near[a].insert(b);
    }
  }
}

static void a_chain_fills_nothing_in_and_a_grid_little(void**) {
  Random random(10);
  const System line(40, chain(40), random), square(100, grid(10), random);
  assert_int_equal(line.elimination.rows.size(), 39);
  // Row by row, a column of a 10 x 10 grid would hold 10 blocks: 945 in all.
  assert_true(square.elimination.rows.size() < 600);
}

static void factors_solve_as_dense_ones_do(void**) {
  Random random(11);
  for (const auto& [nodes, edges] : {std::pair(1u, chain(1)), std::pair(12u, chain(12)), std::pair(25u, grid(5))}) {
    System s(nodes, edges, random);
    assert_true(factor(s.elimination, 0, nodes, {}, s.factor));
    Eigen::VectorXd b(6 * nodes);
    for (Eigen::Index i = 0; i < b.size(); ++i) b[i] = random.uniform(-1, 1);
    std::vector<Vec6> x(nodes);
    for (std::uint32_t i = 0; i < nodes; ++i)
      x[s.elimination.place[i]] = {Vec3::from(b.data() + 6 * i), Vec3::from(b.data() + 6 * i + 3)};
    solve(s.elimination, 0, nodes, {}, s.factor, x.data());
    const Eigen::VectorXd truth = s.dense.llt().solve(b);
    // Condition below 1e4 (eigenvalues from 1 to 10 |J|^2): both are within 1e4 * 150 u.
    for (std::uint32_t i = 0; i < nodes; ++i)
      assert_true(
          (x[s.elimination.place[i]] - Vec6(Vec3::from(truth.data() + 6 * i), Vec3::from(truth.data() + 6 * i + 3)))
              .norm() < 1e-10);
  }
}

static void a_matrix_that_is_not_definite_is_refused(void**) {
  Random random(12);
  System s(3, chain(3), random);
  s.factor.diagonal[2].x[4][4] = -1;
  assert_false(factor(s.elimination, 0, 3, {}, s.factor));
  System nan(3, chain(3), random);
  nan.factor.diagonal[0].x[0][0] = std::nan("");
  assert_false(factor(nan.elimination, 0, 3, {}, nan.factor));
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_projection_on_a_cone_is_its_nearest_point),
      cmocka_unit_test(the_slope_of_the_projection_is_what_differences_say),
      cmocka_unit_test(an_order_of_elimination_names_every_node_once_and_has_room_for_all_fill),
      cmocka_unit_test(a_chain_fills_nothing_in_and_a_grid_little),
      cmocka_unit_test(factors_solve_as_dense_ones_do),
      cmocka_unit_test(a_matrix_that_is_not_definite_is_refused),
  };
  return cmocka_run_group_tests_name("unit/dynamics/direct_parts", tests, nullptr, nullptr);
}
