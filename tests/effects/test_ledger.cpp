// The ledger: causes that have a closed form, and books that close in every step whatever happens in it.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "core/trig.h"
#include "dynamics/ledger/ledger.h"
#include "joint_scenes.h"
#include "world_builder.h"

#include "carom_test.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr Real kStep = 1.0 / 64;
enum : int { kExplicitChoice, kSemiImplicitChoice, kRungeKuttaChoice, kVerletChoice, kIntegratorChoices };
enum : int { kSeverityChoice, kSolverChoices = 5 };

const Vec3 kDown(0, -9.81, 0);

Amount total(const TestWorld& t, Cause cause) { return t.world.ledger->since[index_of(cause)].value(); }
Amount total(const TestWorld& t, std::string_view row) {
  for (std::size_t c = kFixedCauses; c < kCauses; ++c)
    if (cause_name(c) == row) return t.world.ledger->since[c].value();
  fail_msg("no cause %s", std::string(row).c_str());
  return {};
}

/// How far a sum of causes is from the change that it should be, over the rounding that it may have.
Real gap(const std::array<Account, kCauses>& causes, const Amount& change, const Rounding& rounding) {
  Account sum;
  for (const Account& cause : causes) sum.add(cause.value());
  const Amount off = sum.value() - change;
  const auto over = [](Real error, Real bound) { return error == 0 ? 0 : error / bound; };
  return std::max({over(std::fabs(off.energy()), rounding.energy), over(off.linear.norm(), rounding.linear),
                   over(off.angular.norm(), rounding.angular)});
}

/// The books of the last step close, and those of all steps.
void assert_closes(const TestWorld& t, const char* where = "") {
  const Ledger& l = *t.world.ledger;
  const Real step = gap(l.step, l.now - l.before, l.step_rounding), since = gap(l.since, l.now - l.start, l.since_rounding);
  if (!(step <= 1) || !(since <= 1))
    fail_msg("%s step %llu: off by %g of what rounding may leave in the step, %g in all", where,
             static_cast<unsigned long long>(l.steps), step, since);
}

void run(TestWorld& t, int steps, Real dt = kStep, const char* where = "") {
  for (int i = 0; i < steps; ++i) t.world.step(dt), assert_closes(t, where);
}

void print(const TestWorld& t, const char* title) {
  print_message("%s\n", title);
  for (std::size_t c = 0; c < kCauses; ++c) {
    if (!cause_name(c)) continue;
    const Amount a = t.world.ledger->since[c].value();
    if (a.kinetic == 0 && a.potential == 0 && a.linear == Vec3::Zero() && a.angular == Vec3::Zero()) continue;
    print_message("  %-16s %12.5g %12.5g  (%.4g %.4g %.4g)  (%.4g %.4g %.4g)\n", cause_name(c), a.kinetic, a.potential,
                  a.linear[0], a.linear[1], a.linear[2], a.angular[0], a.angular[1], a.angular[2]);
  }
}

}  // namespace
