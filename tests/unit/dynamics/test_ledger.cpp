// What a body has, against its points; sums that keep their digits; names of causes.
#include <set>
#include <string>

#include "carom_test.h"
#include "dynamics/ledger/ledger.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

static void a_body_has_what_its_points_have(void**) {
  // Eight points of m/8 at the corners of a box: moments m (b^2 + c^2).
  const Vec3 half(0.3, 0.5, 0.2), x(3, -2, 1), v(0.4, -1, 2), omega(1.5, -0.7, 2.2), g(0.3, -9, 1);
  const Real m = 2.4, factor = 0.7;
  TestWorld t(g);
  BodyDef def;
  def.has_mass = def.has_inertia = true;
  def.mass = m;
  const Vec3 squares = half.times(half);
  def.inertia = Mat3::diagonal(m * (Vec3::constant(squares.sum()) - squares));
  def.pose = {Quat(0.8, 0.2, -0.5, 0.1).normalized(), x};
  const std::uint32_t body = handle_slot(t.world.add_body(def));
  t.world.set_attribute(body, AttributeId::gravity_factor, {factor});
  Amount by_points;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 arm = half;
    for (int i = 0; i < 3; ++i)
      if (corner >> i & 1) arm[i] = -arm[i];
    arm = def.pose.q * arm;
    const Vec3 at = x + arm, u = v + omega.cross(arm);
    by_points += {m / 16 * u.squared_norm(), -m / 8 * factor * g.dot(at), m / 8 * u, m / 8 * at.cross(u)};
  }
  const Amount off = amount_of(t.world, body, x, def.pose.q, v, omega) - by_points;
  const Real rounding = 64 * kEpsilon;  // some dozens of operations on numbers of up to 100
  assert_true(std::fabs(off.kinetic) < 100 * rounding && std::fabs(off.potential) < 100 * rounding);
  assert_true(off.linear.norm() < 100 * rounding && off.angular.norm() < 100 * rounding);
}

static void accounts_keep_their_digits(void**) {
  Account account;
  const Amount one{0.1, -0.1, Vec3(0.1, 0, 0), Vec3(0, 0, 0.1)};
  account.add({1e6, 0, Vec3::zero(), Vec3::zero()});
  for (int i = 0; i < 1000000; ++i) account.add(one);
  account.add({-1e6, 0, Vec3::zero(), Vec3::zero()});
  const Amount sum = account.value();
  // 1e6 times the double nearest to 0.1, to a rounding of each; a plain sum is off by 1e-6 and more.
  assert_true(std::fabs(sum.kinetic - 1e5) < 1e-10 && std::fabs(sum.potential + 1e5) < 1e-10);
  assert_true(std::fabs(sum.linear[0] - 1e5) < 1e-10 && std::fabs(sum.angular[2] - 1e5) < 1e-10);
}

static void every_cause_has_a_name_of_its_own(void**) {
  std::set<std::string> names;
  std::size_t silent = 0;
  for (std::size_t c = 0; c < kCauses; ++c)
    if (const char* name = cause_name(c))
      assert_true(names.insert(name).second);
    else
      ++silent;
  for (std::size_t row = 0; row < kEffectCount; ++row) {
    const Effect& effect = effect_table()[row];
    const bool acts = effect.force || effect.flow;
    assert_true((cause_name(cause_of_row(row)) != nullptr) == (acts && row != +EffectId::gyroscopic));
  }
  assert_int_equal(names.size() + silent, kCauses);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(a_body_has_what_its_points_have),
      cmocka_unit_test(accounts_keep_their_digits),
      cmocka_unit_test(every_cause_has_a_name_of_its_own),
  };
  return cmocka_run_group_tests_name("unit/dynamics/ledger", tests, nullptr, nullptr);
}
