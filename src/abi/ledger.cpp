// The ledger: kept or not, and read.
#include "dynamics/ledger/ledger.h"

#include <carom/ledger.h>

#include <array>

#include "abi/copy_out.h"
#include "abi/record_calls.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

void put(const Amount& a, double& kinetic, double& potential, double linear[3], double angular[3]) {
  kinetic = a.kinetic, potential = a.potential;
  from_vec3(a.linear, linear), from_vec3(a.angular, angular);
}

carom_ledger_entry entry(const Ledger& ledger, std::size_t cause) {
  carom_ledger_entry e{};
  e.name = cause_name(cause);
  put(ledger.step[cause].value(), e.kinetic, e.potential, e.linear, e.angular);
  put(ledger.since[cause].value(), e.total_kinetic, e.total_potential, e.total_linear, e.total_angular);
  return e;
}

void fill_state(const Ledger& ledger, carom_ledger_state& s) {
  s.is_kept = 1;
  s.steps = ledger.steps;
  put(ledger.start, s.start_kinetic, s.start_potential, s.start_linear, s.start_angular);
  put(ledger.before, s.before_kinetic, s.before_potential, s.before_linear, s.before_angular);
  put(ledger.now, s.now_kinetic, s.now_potential, s.now_linear, s.now_angular);
  const Rounding &step = ledger.step_rounding, &since = ledger.since_rounding;
  s.rounding_energy = step.energy, s.rounding_linear = step.linear, s.rounding_angular = step.angular;
  s.total_rounding_energy = since.energy, s.total_rounding_linear = since.linear;
  s.total_rounding_angular = since.angular;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_enable_ledger(carom_world* world, uint32_t on, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_enable_ledger(on));
    if (changing && known(call, 2, "on", on, 2)) changing->keep_ledger(on != 0);
  });
}

int32_t carom_world_get_ledger(carom_world* world, carom_ledger_entry* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    std::array<std::size_t, kCauses> named;
    std::uint64_t n = 0;
    for (std::size_t cause = 0; reading->ledger && cause < kCauses; ++cause)
      if (cause_name(cause)) named[n++] = cause;
    copy_elements<carom_ledger_entry>(
        call, n, [&](std::uint64_t i) { return entry(*reading->ledger, named[i]); }, dst, stride, capacity, count);
  });
}

int32_t carom_world_get_ledger_state(carom_world* world, carom_ledger_state* state, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !fillable(call, 2, "state", state)) return;
    carom_ledger_state full{};
    if (reading->ledger) fill_state(*reading->ledger, full);
    write_struct(full, state);
  });
}

}  // extern "C"
