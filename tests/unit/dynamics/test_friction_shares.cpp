// A pair's friction is a force and a twist at the middle of its points; rows carry it from step to step, each point its
// share. Added up, the shares are what was shared: what they lack the next step starts without, and bodies never rest.
#include "carom_test.h"
#include "dynamics/solver/wide_contacts.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

Vec3 at(const LaneVec& v, std::uint32_t lane) { return Vec3(v.x[lane], v.y[lane], v.z[lane]); }

}  // namespace

static void shares_of_points_add_up_to_the_friction_of_their_pair(void**) {
  TestWorld t;
  t.world.set_dial(Dial::solver, kSoftChoice);
  t.ground();
  // Loaded off the middle, pushed and turned: loads differ from point to point, and force and twist are not zero.
  const std::uint32_t lower = t.add(t.keep(box(Vec3(0.5, 0.2, 0.7))), Vec3(0, 0.2, 0));
  const std::uint32_t upper = t.add(t.keep(box(Vec3::constant(0.3))), Vec3(0.25, 0.7, 0.3));
  int seen = 0;
  for (int i = 0; i < 60; ++i) {
    t.world.add_force(upper, Vec3(300, 0, -150), Vec3(0, 60, 0));
    t.world.add_force(lower, Vec3(-200, 0, 400), Vec3(0, -90, 0));
    t.world.step(1.0 / 60);
    const WideContacts& wide = *t.world.wide;
    const Contacts& c = *t.world.contacts;
    for (const WideContacts::Manifold& m : wide.manifolds) {
      const PairLanes& pair = wide.in_double.pairs[m.pair];
      const Vec3 n = at(pair.n, m.lane), tangent = at(pair.t, m.lane);
      Vec3 force = Vec3::zero();
      Real twist = 0, load = 0, reach = 0;
      for (std::uint32_t k = 0; k < m.points; ++k) {
        const Vec3 p = c.rows[m.row + k].p, d = at(wide.in_double.points[pair.first + k].d, m.lane);
        const Vec3 sideways = p - p.dot(n) * n;
        force += sideways, twist += d.cross(sideways).dot(n);
        load += p.dot(n), reach = std::max(reach, d.norm());
      }
      const Vec3 was = pair.p_t[m.lane] * tangent + pair.p_s[m.lane] * n.cross(tangent);
      seen += m.points == 4 && was.norm() > 0.01 * load && std::abs(pair.p_w[m.lane]) > 0.001 * load * reach;
      // Sums of four of some load's size: 64 units of rounding are enough.
      assert_true((force - was).norm() <= 64 * kUnitRoundoff * load);
      assert_true(std::abs(twist - pair.p_w[m.lane]) <= 64 * kUnitRoundoff * load * reach);
    }
  }
  assert_true(seen > 50);
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(shares_of_points_add_up_to_the_friction_of_their_pair)};
  return cmocka_run_group_tests_name("unit/dynamics/friction_shares", tests, nullptr, nullptr);
}
