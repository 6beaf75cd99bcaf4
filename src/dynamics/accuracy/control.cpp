// Levels, trials, notes.
#include "dynamics/accuracy/control.h"

#include <algorithm>
#include <cmath>

namespace carom::dynamics::accuracy {
namespace {

// By products and square roots alone, which are the same on every platform; orders are 1, 2, 4 and 6.
Real power(Real x, int n) {
  Real product = 1;
  for (int k = 0; k < n; ++k) product *= x;
  return product;
}
/// The least substeps that divide an error of some order by `by`.   @param most  times as many as there were
int substeps_for(Real by, int order, int there_were, int most) {
  int level = level_within(there_were);
  while (level < kMostLevel && substeps_at(level) < most * there_were &&
         power(Real(substeps_at(level)) / there_were, order) < by)
    ++level;
  return substeps_at(level);
}

}  // namespace

bool is_on(const Dials& dials) { return dials[Dial::accuracy_place] > 0 || dials[Dial::accuracy_turn] > 0; }

int substeps_at(int level) {
  if (level < 2) return 1 + level;
  return level % 2 == 0 ? 2 << (level / 2) : 3 << (level / 2);
}

int level_within(Real substeps) {
  int level = 0;
  while (level < kMostLevel && substeps_at(level + 1) <= substeps) ++level;
  return level;
}

int level_for(Real substeps) {
  int level = 0;
  while (level < kMostLevel && substeps_at(level) < substeps) ++level;
  return level;
}

int Trial::highest_least() const { return level_within(substeps_at(most) / Real(2)); }

void Trial::restart(int at_level) {
  level = at_level;
  coarse = 0;
  run = estimates ? std::max(substeps_at(least), substeps_at(level) / 2) : substeps_at(level);
}

void Trial::begin(const AccuracyMemory& memory, std::uint8_t met, int of_order, int least_substeps, int most_substeps) {
  *this = {};
  order = of_order, most = level_within(most_substeps);
  least = std::min(level_for(least_substeps), highest_least());
  estimates = memory.wait == 0 || memory.met != met;
  if (memory.stalled && memory.met == met) repeated_share = std::max(memory.place, memory.turn);
  restart(std::clamp<int>(memory.level, least, most));
}

void Trial::raise_least(int least_substeps) {
  work += static_cast<std::uint64_t>(run);
  least = std::min(level_for(least_substeps), highest_least());
  restart(std::max(level, least));
}

void Trial::change_order(int to, int at_level) {
  order = to;
  repeated = 0, repeated_share = 0;
  estimates = true;
  restart(std::clamp(at_level, least, most));
}

/// Whether an error over the tolerance is to be left as it is.
bool Trial::stalls(int ended) {
  const Real share = error.most();
  const bool known = repeated == 0 && repeated_share > 0 && share <= kAccuracyStir * repeated_share;
  is_stalled = known || (repeated > 0 && share > repeated_share * std::sqrt(power(Real(repeated) / ended, order)));
  static_assert(kAccuracyStall == 0.5);
  if (repeated == 0 || share < repeated_share) repeated = ended, repeated_share = share;
  return is_stalled;
}

/// The order by which the error fell since it was last estimated in this step, the claimed one at least: what slides to
/// a stop within a step errs by the square of a substep, though contacts are of first order.
int Trial::order_seen(int ended, Real share) const {
  if (order != 1 || repeated == 0 || ended <= repeated) return order;
  const Real fell = repeated_share / share, finer = Real(ended) / repeated;
  return fell * fell >= finer * finer * finer ? 2 : 1;
}

End Trial::end_run(bool went_well, const Shares& apart) {
  const int ended = run;
  work += static_cast<std::uint64_t>(ended);
  taken = ended;
  if (!went_well) {
    estimates = true;
    if (level < most) {
      restart(std::min(level + 2, most));
      return End::dropped;
    }
    hit_bound = true;
    run = coarse == 0 && ended < substeps_at(most) ? substeps_at(most) : 0;
    estimates = false;
    return run ? End::dropped : End::accepted;
  }
  if (!estimates) {
    run = 0;
    return End::accepted;
  }
  if (coarse == 0) {
    coarse = ended, run = 2 * ended;
    return End::compared;
  }
  const Real gain = std::ldexp(Real(1), order);
  error = {apart.place / (gain - 1), apart.turn / (gain - 1)};
  is_estimated = true;
  const Real share = error.most();
  const int seen = order_seen(ended, share);
  const bool at_bound = ended >= substeps_at(most);
  if (share <= 1 || at_bound || stalls(ended)) {
    hit_bound = share > 1 && at_bound;
    run = 0;
    return End::accepted;
  }
  constexpr int kMostAtOnce = 8;
  const int needed = substeps_for(share / kAccuracyAim, seen, ended, kMostAtOnce);
  level = std::min(most, std::max(level_within(ended) + 1, level_within(needed)));
  if (substeps_at(level) == 2 * ended) {
    coarse = ended, run = 2 * ended;
    return End::compared;
  }
  restart(level);
  return End::dropped;
}

AccuracyMemory Trial::memory_after(const AccuracyMemory& before, std::uint8_t met) const {
  AccuracyMemory memory = before;
  memory.met = met;
  if (!is_estimated) {
    memory.level = static_cast<std::uint8_t>(level);
    memory.wait = static_cast<std::uint8_t>(hit_bound || memory.wait == 0 ? 0 : memory.wait - 1);
    return memory;
  }
  memory.place = static_cast<float>(std::min(error.place, Real(1e30))),
  memory.turn = static_cast<float>(std::min(error.turn, Real(1e30)));
  const Real share = error.most();
  const auto predicted = [&](int at) { return share * power(Real(taken) / substeps_at(at), order); };
  int next = level_within(taken);
  while (next > least && predicted(next - 1) <= kAccuracyAim) --next;
  memory.stalled = is_stalled;
  if (is_stalled) {  // as before they were tried, and for a while
    memory.level = static_cast<std::uint8_t>(level_within(repeated));
    memory.wait = kAccuracyEveryQuiet - 1;
    return memory;
  }
  const bool is_quiet = next <= least && predicted(next) <= power(kAccuracyQuiet, order);
  memory.level = static_cast<std::uint8_t>(next);
  memory.wait = static_cast<std::uint8_t>(is_quiet ? kAccuracyEveryQuiet - 1 : next != level ? 0 : kAccuracyEvery - 1);
  return memory;
}

namespace {

// Where orders take as many stages, more or less: 4 substeps of order 2 and 1 of order 4; 8 of order 4 and 4 of
// order 6.
constexpr int kMostAtOrder2 = 4, kMostAtOrder4 = 6;

int most_at(int order) { return order == 2 ? kMostAtOrder2 : order == 4 ? kMostAtOrder4 : 1 << kMostLevel; }
/// Of the next higher order, to begin with.
int level_above(int order, int substeps) { return level_for(order == 2 ? substeps / Real(8) : substeps / Real(4)); }

}  // namespace

void climb(Trial& trial) {
  while (trial.run > 0 && trial.coarse == 0 && substeps_at(trial.level) > most_at(trial.order))
    trial.change_order(trial.order + 2, level_above(trial.order, substeps_at(trial.level)));
}

void choose_order(AccuracyMemory& memory, const Trial& trial, int least) {
  const bool has_climbed = memory.order != 0 && trial.order > memory.order;
  memory.order = static_cast<std::uint8_t>(trial.order);
  if (has_climbed) memory.patience = static_cast<std::uint8_t>(kAccuracyPatience);
  if (!trial.is_estimated || memory.stalled) return;
  if (const int n = substeps_at(memory.level); n > most_at(trial.order)) {
    memory.level = static_cast<std::uint8_t>(level_above(trial.order, n));
    memory.order = static_cast<std::uint8_t>(trial.order + 2);
    memory.patience = static_cast<std::uint8_t>(kAccuracyPatience);
    memory.wait = 0;
    return;
  }
  if (memory.level > 0 || trial.order <= least) return;
  if (memory.patience > 0) {
    --memory.patience;
    return;
  }
  memory.order = static_cast<std::uint8_t>(trial.order - 2);
  memory.level = 1;
  memory.wait = 0;
}

std::uint8_t number_of(std::uint32_t bodies, std::uint32_t rows, std::uint32_t links, bool softly) {
  const std::uint32_t mixed =
      bodies * 0x9E3779B1u + rows * 0x85EBCA77u + links * 0xC2B2AE3Du + std::uint32_t(softly) * 0x27D4EB2Fu;
  return static_cast<std::uint8_t>(mixed >> 24);
}

void join_memory(AccuracyMemory& to, const AccuracyMemory& other, bool is_first) {
  if (is_first) {
    to = other;
    return;
  }
  if (to.level != other.level || to.wait != other.wait || to.met != other.met) to.wait = 0;
  if (to.order != other.order) to.wait = 0;
  to.level = std::max(to.level, other.level), to.order = std::max(to.order, other.order);
  to.patience = std::max(to.patience, other.patience);
  to.place = std::max(to.place, other.place), to.turn = std::max(to.turn, other.turn);
}

}  // namespace carom::dynamics::accuracy
