// A forest of joints: velocities, responses, impulses of locks, and Newton's steps beside dense solves.
#include <Eigen/Dense>
#include <vector>

#include "carom_test.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/round.h"
#include "eigen.h"
#include "random_pairs.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

enum Kind { kBall, kHinge, kUniversal, kSlider, kWeld };

Vec3 any_vector(Random& random, Real size) {
  return size * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// Bodies on joints without loops, some of them on the ground, and contacts that stick between some.
class Scene {
 public:
  Scene(Random& random, std::uint32_t count, Real most_ratio, bool in_a_line)
      : order_(std::pmr::new_delete_resource()), factor_(std::pmr::new_delete_resource()), random_(random) {
    for (std::uint32_t i = 0; i < count; ++i) add_body(std::pow(most_ratio, random.uniform(0, 1)), in_a_line ? i : 0);
    for (std::uint32_t i = 0; i < count; ++i) {
      const bool on_ground = random.uniform(0, 1) < 0.2;
      if (i > 0 && !on_ground)
        add_joint(in_a_line ? i - 1 : static_cast<std::uint32_t>(random.uniform(0, 0.999) * i), i);
      else if (on_ground)
        add_joint(kInvalid, i);
    }
    for (std::uint32_t i = 0; i + 5 < count; i += 5)
      add_contact(i, i + 1 + static_cast<std::uint32_t>(random.uniform(0, 3.999)));
    order_.clear();
    eliminate(0, count, edges_, forest_, ~std::uint64_t{0}, order_);
    nodes_.resize(count), scratch_.resize(count);
    plant(nodes_, forest_, order_, 0);
    factor_.diagonal.resize(count), factor_.beside.resize(order_.rows.size());
    factor_.is_filled.resize(order_.rows.size());
    for (ConeContact& c : contacts_) {
      const std::uint32_t a = order_.place[c.a], b = order_.place[c.b];
      c.a_later = a > b, c.beside = static_cast<std::uint32_t>(factor_.at(order_, std::max(a, b), std::min(a, b)));
    }
    problem = {.contacts = contacts_,
               .bodies = bodies_.data(),
               .first = 0,
               .last = count,
               .elimination = &order_,
               .nodes = order_.scratch().node_at.data(),
               .factor = &factor_,
               .scratch = scratch_.data(),
               .links = {locks_.data(), 0},
               .locks = locks_,
               .tree = nodes_};
    articulate(problem);
  }

  std::size_t size() const { return 6 * bodies_.size(); }
  std::span<ConeLink> locks() { return locks_; }
  Eigen::MatrixXd masses() const {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(size(), size());
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      m.block(6 * i, 6 * i, 3, 3).diagonal().setConstant(bodies_[i].mass);
      m.block(6 * i + 3, 6 * i + 3, 3, 3) = eigen(bodies_[i].inertia);
    }
    return m;
  }
  Eigen::MatrixXd lock_rows() const {
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(locks_.size(), size());
    for (std::size_t i = 0; i < locks_.size(); ++i) {
      const ConeLink& c = locks_[i];
      if (c.a != kInvalid) g.block(i, 6 * c.a, 1, 6) << -eigen(c.d_a).transpose(), -eigen(c.w_a).transpose();
      if (c.b != kInvalid) g.block(i, 6 * c.b, 1, 6) << eigen(c.d_b).transpose(), eigen(c.w_b).transpose();
    }
    return g;
  }
  /// Sum of w J^T J of the contacts.
  Eigen::MatrixXd stiffness(Real w) const {
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size(), size());
    for (const ConeContact& c : contacts_) {
      Eigen::MatrixXd j = Eigen::MatrixXd::Zero(3, size());
      const auto put = [&](std::uint32_t body, const Vec3& r, Real sign) {
        j.block(0, 6 * body, 3, 3) = sign * Eigen::Matrix3d::Identity();
        for (int i = 0; i < 3; ++i) j.block(0, 6 * body + 3 + i, 3, 1) = sign * eigen(Vec3(Vec3::unit(i)).cross(r));
      };
      put(c.a, c.r_a, -1), put(c.b, c.r_b, 1);
      k += w * j.transpose() * j;
    }
    return k;
  }
  /// Velocities and impulses of [m -g^T; g 0] [v; p] = [momentum; asked].
  Eigen::VectorXd solved(const Eigen::MatrixXd& m, const Eigen::VectorXd& momentum,
                         const Eigen::VectorXd& asked) const {
    const Eigen::MatrixXd g = lock_rows();
    const auto n = m.rows(), rows = g.rows();
    Eigen::MatrixXd whole = Eigen::MatrixXd::Zero(n + rows, n + rows);
    whole.topLeftCorner(n, n) = m, whole.topRightCorner(n, rows) = -g.transpose(), whole.bottomLeftCorner(rows, n) = g;
    Eigen::VectorXd right(n + rows);
    right << momentum, asked;
    return whole.fullPivLu().solve(right);
  }
  template <class F>
  Eigen::VectorXd gathered(F&& of) const {
    Eigen::VectorXd x(size());
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (int k = 0; k < 6; ++k) x[6 * i + k] = of(bodies_[i])[k];
    return x;
  }

  ConeProblem problem;

 private:
  void add_body(Real mass, std::uint32_t along) {
    ConeBody& b = bodies_.emplace_back();
    b.mass = mass, b.inv_mass = 1 / mass, b.turns = true;
    const Vec3 i = Vec3{random_.uniform(0.5, 1), random_.uniform(0.5, 1), random_.uniform(0.5, 1)};
    const Mat3 r = random_rotation(random_).matrix();
    b.inertia = mass * (r * diagonal(i) * r.transpose());
    b.inv_inertia = b.inertia.inverse();
    b.place = any_vector(random_, 1) + Vec3(1.5 * along, 0, 0);
    b.v = {any_vector(random_, 3), any_vector(random_, 3)};
    b.unheld = b.v;
  }
  static Mat3 diagonal(const Vec3& d) {
    Mat3 m = Mat3::identity();
    for (int k = 0; k < 3; ++k) m(k, k) = d[k];
    return m;
  }
  void add_row(std::uint32_t a, std::uint32_t b, const Vec3& d, const Vec3& w_a, const Vec3& w_b) {
    ConeLink& c = locks_.emplace_back();
    c.a = a, c.b = b, c.d_a = c.d_b = d, c.w_a = w_a, c.w_b = w_b, c.p = 0;
    c.low = c.high = random_.uniform(-0.5, 0.5), c.give = 0, c.most = kInfinity;
    c.surface = a == kInvalid || b == kInvalid ? random_.uniform(-0.5, 0.5) : 0;
  }
  void add_joint(std::uint32_t parent, std::uint32_t child) {
    const auto kind = static_cast<Kind>(random_.uniform(0, 4.999));
    const bool swap = random_.uniform(0, 1) < 0.5;
    const std::uint32_t a = swap ? child : parent, b = swap ? parent : child;
    const Vec3 at = bodies_[child].place + any_vector(random_, 0.5);
    const Mat3 axes = random_rotation(random_).matrix();
    const auto arm = [&](std::uint32_t body) {
      return body == kInvalid ? Vec3(Vec3::zero()) : Vec3(at - bodies_[body].place);
    };
    const auto first = static_cast<std::uint32_t>(locks_.size());
    for (int k = kind == kSlider ? 1 : 0; k < 3; ++k) {
      const Vec3 d = axes.col(k);
      add_row(a, b, d, arm(a).cross(d), arm(b).cross(d));
    }
    const int from = kind == kBall ? 3 : kind == kUniversal ? 2 : kind == kHinge ? 1 : 0;
    for (int k = from; k < 3; ++k) add_row(a, b, Vec3::zero(), axes.col(k), axes.col(k));
    forest_.push_back({a, b, first, static_cast<std::uint32_t>(locks_.size()) - first, 0, 0});
    if (parent != kInvalid) edges_.push_back({a, b});
  }
  void add_contact(std::uint32_t a, std::uint32_t b) {
    ConeContact& c = contacts_.emplace_back();
    c = {}, c.a = a, c.b = b;
    c.r_a = any_vector(random_, 1), c.r_b = any_vector(random_, 1);
    edges_.push_back({a, b});
  }

  std::vector<ConeBody> bodies_;
  std::vector<ConeLink> locks_;
  std::vector<ConeContact> contacts_;
  std::vector<TreeJoint> forest_;
  std::vector<Edge> edges_;
  std::vector<TreeNode> nodes_;
  std::vector<Vec6> scratch_;
  Elimination order_;
  BlockFactor factor_;
  Random& random_;
};

/// Scenes of 1 to 30 bodies, trees and chains, of masses up to 1 : 1e4.
template <class F>
void each_scene(F&& f) {
  Random random(20261129);
  for (int i = 0; i < 60; ++i) {
    Scene scene(random, 1 + static_cast<std::uint32_t>(i / 2), i % 3 == 0 ? 1e4 : 1, i % 4 == 0);
    f(scene, random);
  }
}

/// Of a dense solve of masses 1 : 1e4 over some hundred rows.
constexpr Real kNear = 1e-9;

void assert_near(const Eigen::VectorXd& got, const Eigen::VectorXd& want, Real size) {
  assert_true((got - want).lpNorm<Eigen::Infinity>() <= kNear * size);
}

}  // namespace

static void what_locks_ask_is_obeyed_at_the_least_change(void**) {
  each_scene([](Scene& s, Random&) {
    Eigen::VectorXd asked(s.locks().size());
    for (std::size_t i = 0; i < s.locks().size(); ++i) asked[i] = s.locks()[i].low - s.locks()[i].surface;
    const Eigen::VectorXd before = s.gathered([](const ConeBody& b) { return b.v; });
    const Eigen::VectorXd want = s.solved(s.masses(), s.masses() * before, asked);
    obey_locks(s.problem);
    assert_near(s.gathered([](const ConeBody& b) { return b.v; }), want.head(s.size()), 10);
    for (const ConeLink& c : s.locks())
      assert_true(std::fabs(c.surface + relative<&ConeBody::v>(s.problem.bodies, c) - c.low) < 1e-12);
    // And the impulses that hold them, where nothing else acts.
    s.problem.contacts = {};
    find_lock_impulses(s.problem);
    for (std::size_t i = 0; i < s.locks().size(); ++i)
      assert_true(std::fabs(s.locks()[i].p - want[static_cast<Eigen::Index>(s.size() + i)]) <
                  1e-7 * want.tail(s.locks().size()).lpNorm<Eigen::Infinity>() + 1e-12);
  });
}

static void momentum_moves_what_joints_let_it_move(void**) {
  each_scene([](Scene& s, Random& random) {
    for (ConeBody& b : bodies_of(s.problem)) b.gradient = {any_vector(random, 1), any_vector(random, 1)};
    const Eigen::VectorXd momentum = s.gathered([](const ConeBody& b) { return b.gradient; });
    const Eigen::VectorXd want = s.solved(s.masses(), momentum, Eigen::VectorXd::Zero(s.locks().size()));
    respond(s.problem);
    assert_near(s.gathered([](const ConeBody& b) { return b.step; }), want.head(s.size()), 10);
  });
}

/// With contacts of a thousand times the masses: fill beyond the joints.
static void a_step_with_contacts_is_that_of_the_dense_matrix(void**) {
  constexpr Real kStiff = 1e3;
  each_scene([](Scene& s, Random& random) {
    for (ConeBody& b : bodies_of(s.problem)) b.gradient = {any_vector(random, 1), any_vector(random, 1)};
    const Eigen::VectorXd momentum = s.gathered([](const ConeBody& b) { return b.gradient; });
    const Eigen::VectorXd want =
        s.solved(s.masses() + s.stiffness(kStiff), momentum, Eigen::VectorXd::Zero(s.locks().size()));
    assemble_masses(s.problem, s.problem.factor->all());
    for (const ConeContact& c : s.problem.contacts) add_sticking(s.problem, c, kStiff);
    assert_true(factor(*s.problem.elimination, 0, s.problem.last, s.problem.tree, *s.problem.factor));
    solve_for_steps(s.problem, 1);
    assert_near(s.gathered([](const ConeBody& b) { return b.step; }), want.head(s.size()), 100);
  });
}

namespace {

/// Limits along what each joint lets go; where it is one way, with a rotor beside.
std::vector<ConeLink> drives_on(Scene& s, Random& random) {
  std::vector<ConeLink> drives;
  for (std::uint32_t j = 0; j < s.problem.tree.size(); ++j) {
    TreeNode& node = s.problem.tree[j];
    if (!node.is_held() || node.freedom == 0) continue;
    const std::uint32_t child = s.problem.body_at(j);
    const std::uint32_t parent = node.parent == kInvalid ? kInvalid : s.problem.body_at(node.parent);
    node.first_drive = static_cast<std::uint32_t>(drives.size()), node.drives = node.freedom == 1 ? 2 : 1;
    for (std::uint32_t i = 0; i < node.drives; ++i) {
      ConeLink& c = drives.emplace_back();
      c = {}, c.k = 1, c.most = kInfinity;
      c.a = node.child_is_a ? child : parent, c.b = node.child_is_a ? parent : child;
      c.d_a = c.d_b = any_vector(random, 1), c.w_a = c.w_b = any_vector(random, 1);
      if (i == 1) c.give = random.uniform(0.01, 3);
      if (i == 0) c.high = 1;  // a limit, which no rotor is
    }
  }
  return drives;
}

}  // namespace

static void a_drive_makes_of_its_own_velocity_what_the_dense_matrix_does(void**) {
  each_scene([](Scene& s, Random& random) {
    if (s.size() > 100) return;  // larger ones: so_it_does_in_long_chains()
    std::vector<ConeLink> drives = drives_on(s, random);
    s.problem.links = drives;
    articulate(s.problem);
    const auto row_of_drive = [&](const ConeLink& c) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s.size()));
      if (c.a != kInvalid) row.segment(6 * c.a, 6) << -eigen(c.d_a), -eigen(c.w_a);
      if (c.b != kInvalid) row.segment(6 * c.b, 6) << eigen(c.d_b), eigen(c.w_b);
      return row;
    };
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(s.locks().size()));
    for (std::size_t i = 0; i < drives.size(); i += 1 + drives.size() / 3) {
      Eigen::MatrixXd m = s.masses();
      for (std::size_t k = i; k <= i + 1 && k < drives.size(); ++k)
        if (drives[k].a == drives[i].a && drives[k].b == drives[i].b && drives[k].give > 0)
          m += row_of_drive(drives[k]) * row_of_drive(drives[k]).transpose() / drives[k].give;
      const Eigen::VectorXd row = row_of_drive(drives[i]);
      const Real want = row.dot(s.solved(m, row, none).head(static_cast<Eigen::Index>(s.size())));
      assert_true(std::fabs(drives[i].k - want) <= kNear * want + 1e-12);
    }
  });
}

/// Of chains and trees of hundreds of bodies, against what an impulse makes of all of them.
static void so_it_does_in_long_chains(void**) {
  Random random(20261130);
  for (const bool in_a_line : {true, false}) {
    Scene s(random, 600, in_a_line ? 1 : 1e4, in_a_line);
    std::vector<ConeLink> drives = drives_on(s, random);
    for (ConeLink& c : drives) c.give = 0;
    s.problem.links = drives;
    articulate(s.problem);
    for (std::size_t i = 0; i < drives.size(); i += 7) {
      for (ConeBody& b : bodies_of(s.problem)) b.gradient.set_zero();
      add_impulse<&ConeBody::gradient>(s.problem, drives[i], 1);
      respond(s.problem);
      const Real want = relative<&ConeBody::step>(s.problem.bodies, drives[i]);
      assert_true(want > 0 && std::fabs(drives[i].k - want) <= kNear * want + 1e-12);
    }
  }
}

/// Two hinges on one line between two bodies, as of a door: ten rows, of which five say it all.
static void rows_that_others_imply_bear_nothing(void**) {
  Random random(7);
  Scene s(random, 2, 1, true);
  ConeBody* const bodies = s.problem.bodies;
  std::vector<ConeLink> rows(6);
  const auto point = [&](ConeLink& c, const Vec3& d, const Vec3& at) {
    c = {}, c.a = 0, c.b = 1, c.d_a = c.d_b = d, c.most = kInfinity;
    c.w_a = (at - bodies[0].place).cross(d), c.w_b = (at - bodies[1].place).cross(d);
  };
  const Vec3 one(0.5, 0, 0), other(0.5, 1, 0);
  for (int k = 0; k < 3; ++k) point(rows[k], Vec3::unit(k), one), point(rows[3 + k], Vec3::unit(k), other);
  const TreeJoint joint[] = {{0, 1, 0, 6, 0, 0}};
  const Edge edge[] = {{0, 1}};
  Elimination order(std::pmr::new_delete_resource());
  order.clear();
  eliminate(0, 2, edge, joint, ~std::uint64_t{0}, order);
  std::vector<TreeNode> nodes(2);
  plant(nodes, joint, order, 0);
  s.problem.contacts = {}, s.problem.elimination = &order, s.problem.nodes = order.scratch().node_at.data();
  s.problem.links = {rows.data(), 0}, s.problem.locks = rows, s.problem.tree = nodes;
  articulate(s.problem);
  assert_int_equal(nodes[0].freedom, 1);
  obey_locks(s.problem);
  for (const ConeLink& c : rows) assert_true(std::fabs(relative<&ConeBody::v>(bodies, c)) < 1e-13);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(what_locks_ask_is_obeyed_at_the_least_change),
      cmocka_unit_test(momentum_moves_what_joints_let_it_move),
      cmocka_unit_test(a_step_with_contacts_is_that_of_the_dense_matrix),
      cmocka_unit_test(a_drive_makes_of_its_own_velocity_what_the_dense_matrix_does),
      cmocka_unit_test(so_it_does_in_long_chains),
      cmocka_unit_test(rows_that_others_imply_bear_nothing),
  };
  return cmocka_run_group_tests_name("unit/dynamics/forest", tests, nullptr, nullptr);
}
