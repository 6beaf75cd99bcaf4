// The energy bound of the convex problem: what its rows may give, and that a row which gives more is found out.
#include <functional>
#include <vector>

#include "carom_test.h"
#include "dynamics/solver/direct/round.h"
#include "dynamics/solver/direct/yielding.h"
#include "random_pairs.h"
#include "shapes.h"

using namespace carom;
using namespace carom::test;

namespace {

Vec3 any_vector(Random& random, Real size) {
  return size * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

/// Bodies that touch and are locked to each other and to the ground, of masses up to `most_ratio` apart.
class Island {
 public:
  Island(Random& random, std::uint32_t count, Real most_ratio)
      : order_(std::pmr::new_delete_resource()), factor_(std::pmr::new_delete_resource()), random_(random) {
    for (std::uint32_t i = 0; i < count; ++i) add_body(std::pow(most_ratio, random.uniform(0, 1)));
    for (std::uint32_t i = 0; i < count; ++i) {
      for (int k = 0; k < 3; ++k) add_contact(i + 1 < count && k > 0 ? i + 1 : kInvalid, i);
      if (i > 0) add_link(i - 1, i);
    }
    order_.clear();
    eliminate(0, count, edges_, {}, ~std::uint64_t{0}, order_);
    scratch_.resize(count);
    factor_.diagonal.resize(2 * count), factor_.beside.resize(2 * order_.rows.size());
    factor_.is_filled.resize(2 * order_.rows.size());
    for (ConeContact& c : contacts_) place(c);
    for (ConeLink& c : links_) place(c);
    problem = {.contacts = contacts_,
               .bodies = bodies_.data(),
               .first = 0,
               .last = count,
               .elimination = &order_,
               .nodes = order_.scratch().node_at.data(),
               .factor = &factor_,
               .scratch = scratch_.data(),
               .links = links_};
  }

  /// From impulses of a substep before, as the solver does it.
  void solve() {
    apply_impulses(problem);
    for (ConeContact& c : contacts_) c.u = c.surface + relative<&ConeBody::v>(bodies_.data(), c);
    for (ConeLink& c : links_) c.u = c.surface + relative<&ConeBody::v>(bodies_.data(), c);
    solve_yielding(problem, 1e-3, 0.1, kTolerance);
    solve_closer(problem, 1e-3, kTolerance, 1e-4);
  }

  ConeProblem problem;
  static constexpr Real kTolerance = 1e-6;  // m/s

 private:
  template <class Row>
  void place(Row& c) {
    c.beside = kInvalid, c.a_later = false;
    if (c.a == kInvalid || c.b == kInvalid) return;
    const std::uint32_t a = order_.place[c.a], b = order_.place[c.b];
    c.a_later = a > b, c.beside = static_cast<std::uint32_t>(factor_.at(order_, std::max(a, b), std::min(a, b)));
  }
  void add_body(Real mass) {
    ConeBody& b = bodies_.emplace_back();
    b.mass = mass, b.inv_mass = 1 / mass, b.turns = true;
    b.inertia = (mass * random_.uniform(0.2, 1)) * Mat3::identity(), b.inv_inertia = b.inertia.inverse();
    b.v = b.unheld = b.before = {any_vector(random_, 3), any_vector(random_, 3)};
  }
  Real response(std::uint32_t body, const Vec3& d, const Vec3& w) const {
    return body == kInvalid ? Real(0) : response_of(bodies_[body], d, w);
  }
  void add_contact(std::uint32_t a, std::uint32_t b) {
    ConeContact& c = contacts_.emplace_back();
    c = {};
    c.a = a, c.b = b, c.n = any_vector(random_, 1).normalized(), c.friction = random_.uniform(0, 1);
    c.r_b = any_vector(random_, 1);
    if (a != kInvalid) c.r_a = any_vector(random_, 1), edges_.push_back({a, b});
    for (int k = 0; k < 3; ++k) {
      const Vec3 d = Vec3::unit(k);
      c.k += (response(a, d, c.r_a.cross(d)) + response(b, d, c.r_b.cross(d))) / 3;
    }
    c.want = random_.uniform(0, 1) < 0.5 ? 0 : -random_.uniform(0, 1);
    if (random_.uniform(0, 1) < 0.5) c.p = c.start_p = (random_.uniform(0, 1) / c.k) * c.n;
    c.borne = c.p.dot(c.n);
  }
  void add_link(std::uint32_t a, std::uint32_t b) {
    ConeLink& c = links_.emplace_back();
    c = {};
    c.a = a, c.b = b, c.d_a = c.d_b = any_vector(random_, 1).normalized();
    c.w_a = any_vector(random_, 1), c.w_b = any_vector(random_, 1), c.most = kInfinity;
    c.k = response(a, c.d_a, c.w_a) + response(b, c.d_b, c.w_b);
    const Real kind = random_.uniform(0, 3);
    if (kind < 1) c.low = c.high = random_.uniform(-1, 1), c.most = random_.uniform(0, 1) / c.k;  // a motor
    if (kind > 2) c.low = -random_.uniform(0, 1), c.high = kInfinity;                             // a limit
    edges_.push_back({a, b});
  }

  Elimination order_;
  BlockFactor factor_;
  Random& random_;
  std::vector<ConeBody> bodies_;
  std::vector<ConeContact> contacts_;
  std::vector<ConeLink> links_;
  std::vector<Vec6> scratch_;
  std::vector<Edge> edges_;
};

/// Islands of which the bound is broken where something was done to them.
/// @param before  they are solved   @param after  likewise; each may be none
int found_out(int islands, const std::function<void(Island&)>& before, const std::function<void(Island&)>& after) {
  Random random(48);
  int found = 0;
  for (int i = 0; i < islands; ++i) {
    Island island(random, 2 + i % 7, i % 3 ? 10 : 1e5);
    if (before) before(island);
    island.solve();
    if (after) after(island);
    assert_true(island.problem.is_proven);
    found += excess_energy(island.problem) > 0;
  }
  return found;
}

/// A body's momentum, changed by impulses of contacts that nobody accounts for.
void give(ConeProblem& problem, Real share) {
  for (ConeBody& b : bodies_of(problem)) b.gradient.set_zero();
  for (const ConeContact& c : problem.contacts) add_impulse<&ConeBody::gradient>(problem, c, share * c.p);
  for (ConeBody& b : bodies_of(problem)) b.v += velocity_of(b, b.gradient);
}

}  // namespace

static void rows_as_they_are_give_no_more_than_they_may(void**) { assert_int_equal(found_out(2000, {}, {}), 0); }

static void a_row_that_pushes_is_found_out(void**) {
  const auto pushes = [](Island& island) {
    for (ConeContact& c : island.problem.contacts) c.want = 20;  // m/s, faster than anything here
  };
  assert_int_equal(found_out(300, pushes, {}), 300);
}

static void impulses_that_act_more_than_once_are_found_out(void**) {
  const auto thrice = [](Island& island) { give(island.problem, 2); };
  assert_true(found_out(300, {}, thrice) > 200);
}

static void a_row_that_pulls_is_found_out(void**) {
  const auto turned = [](Island& island) { give(island.problem, -2); };
  assert_true(found_out(300, {}, turned) > 290);
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(rows_as_they_are_give_no_more_than_they_may),
                              cmocka_unit_test(a_row_that_pushes_is_found_out),
                              cmocka_unit_test(impulses_that_act_more_than_once_are_found_out),
                              cmocka_unit_test(a_row_that_pulls_is_found_out)};
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
