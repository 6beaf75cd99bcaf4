// Residuals read, and the budget that substeps are chosen within.
#include "dynamics/residuals.h"

#include <carom/residuals.h>

#include "abi/copy_out.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

constexpr double kLongestBudget = 10;  // s

carom_residuals as_struct(const World& world) {
  const Residuals r = residuals_of(world);
  carom_residuals s{};
  s.ledger_is_kept = world.ledger ? 1 : 0;
  s.contact_points = r.points, s.joints = r.joints;
  s.max_penetration = r.max_penetration, s.mean_penetration = r.mean_penetration;
  s.joint_gap = r.joint_gap, s.joint_angle = r.joint_angle;
  s.complementarity = r.complementarity, s.cone = r.cone, s.slip = r.slip;
  s.energy = r.energy, s.energy_drift = r.energy_drift;
  return s;
}

void set_budget(Call& call, const Changing& changing, double seconds, std::uint32_t fewest, std::uint32_t most) {
  if (!in_range(call, 2, "seconds", seconds, 0, kLongestBudget)) return;
  if (seconds == 0) return changing.budget(nullptr);
  const auto bound = dial_table()[CAROM_DIAL_SUBSTEPS].max;
  if (!in_range(call, 4, "most", most, 1, bound) || !in_range(call, 3, "fewest", fewest, 1, most)) return;
  changing.budget(make_owned<Budget>(&changing.engine().memory, seconds, fewest, most));
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_get_residuals(carom_world* world, carom_residuals* residuals, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (reading && fillable(call, 2, "residuals", residuals)) write_struct(as_struct(*reading), residuals);
  });
}

int32_t carom_world_set_budget(carom_world* world, double seconds, uint32_t fewest, uint32_t most, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Changing changing(call, world);
    if (changing) set_budget(call, changing, seconds, fewest, most);
  });
}

int32_t carom_world_get_budget(carom_world* world, double* seconds, uint32_t* fewest, uint32_t* most,
                               carom_error* error) {
  return glanced(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !present(call, 2, "seconds", seconds) || !present(call, 3, "fewest", fewest) ||
        !present(call, 4, "most", most))
      return;
    const Budget off(0, 0, 0), &budget = world->budget ? *world->budget : off;
    *seconds = budget.seconds, *fewest = budget.fewest, *most = budget.most;
  });
}

}  // extern "C"
