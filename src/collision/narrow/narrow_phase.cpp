// From pairs of bounds to contact points: dispatch, then the manifold of each pair.
#include "collision/narrow/narrow_phase.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <new>
#include <utility>

#include "collision/narrow/carry_over.h"
#include "collision/narrow/hybrid.h"
#include "collision/narrow/pair.h"
#include "collision/support.h"
#include "core/float_guard.h"

namespace carom::collision {
namespace {

/// Points found in the first shape's frame become points between A and B in the world.
void to_world(const Frame& first, bool swapped, Candidates& found) {
  for (int i = 0; i < found.count; ++i) {
    ContactPoint& p = found.point[i];
    p.normal = swapped ? Vec3(-(first.r * p.normal)) : Vec3(first.r * p.normal);
    if (swapped) std::swap(p.on_a, p.on_b);
  }
}

/// The generic path: one point, the pair's nearest.
void collide_generic(const Shape& a, const Frame& frame_a, const Shape& b, const Frame& frame_b,
                     const NarrowSettings& settings, QueryMemory& memory, Certificate* certificate, Candidates& found,
                     NarrowReport& report, SupportFault& fault) {
  const Frame b_in_a = relative(frame_a, frame_b);
  if (!usable(b_in_a)) return;
  QuerySettings query = settings.query;
  query.max_distance = settings.manifold.contact_distance;
  QueryResult result;
  const Real shell = shells(query), width = certificate ? settings.carry_over * size_of_pair(a, b, b_in_a) : 0;
  if (width > 0 && carry_over(a, b, b_in_a, width, shell, *certificate, result)) {
    report.reused += 1;
  } else {
    generic_distance(a, b, b_in_a, query, settings.warm_separation ? &memory : nullptr, result, fault);
    if (width > 0) certify(result, b_in_a, shell, *certificate);
    report.gjk_calls += 1;
    report.epa_calls += result.epa_iterations > 0;
  }
  report.support_calls += static_cast<std::uint64_t>(result.support_calls);
  if (result.status == QueryStatus::fault) return;
  found.gap = result.lower;
  if (result.farther) return;
  const Vec3 normal = frame_a.rotate(result.normal);
  add_contact(found, query.max_distance, result.point_a, result.point_b, normal, result.separation, 0);
}

/// The manifold of a pair from what was found, in the way that the dial asks for.
void update_manifold(const PatchPair& pair, const Candidates& found, const ManifoldSettings& settings,
                     PairRecord& record, NarrowReport& report, SupportFault& fault) {
  if (settings.kind == ManifoldKind::single)
    keep_deepest(found, settings, record.manifold);
  else if (settings.kind == ManifoldKind::cache)
    update_cache(pair.frame_a, pair.frame_b, found, settings, record.manifold);
  else if (found.whole)
    adopt_patch(pair, found, settings, record.manifold, record.patch);
  else
    update_patch(pair, found, settings, record.manifold, record.patch, report.support_calls, fault);
}

/// The horizon of a pair that was just found without points, @see narrow_phase(). Bounding spheres know a gap where
/// routines do not.
Real horizon_of(const Colliders& table, const Pair& pair, const Candidates& found) {
  const Shape &a = *table.shape[pair.a], &b = *table.shape[pair.b];
  const Real apart = (table.frame[pair.b].p - table.frame[pair.a].p).norm(), radii = extent(a) + extent(b);
  const bool flat = a.form == Form::half_space || b.form == Form::half_space;
  const Real gap = flat ? found.gap : std::max(found.gap, apart - radii);
  // What gaps may be off by: rounding of poses and of the query (rounding.h), and support functions as bad as is let
  // pass, now and when the pair would be asked again.
  const Real doubt = (512 * kUnitRoundoff + 8 * kSloppiness) * (apart + radii);
  return (gap - doubt) + (table.travel[pair.a] + table.travel[pair.b]) * (1 - 4 * kUnitRoundoff);
}

/// Pairs that a part of the loop takes: support functions of some hosts are for the stepping thread alone.
enum class Whose { everybodys, any_threads, host_threads };

/// No routine finds a point where shapes are farther apart than this times their reach: two edges may meet at the reach
/// along their normal and as much beside it.
constexpr Real kFarthestPair = 1.5;

constexpr std::uint32_t kPairsAhead = 12;  // pairs: most of them are not asked

/// Some microseconds of a loop, where most pairs lie still.
constexpr std::size_t kPairsAPart = 64;

/// What the parts of the loop found, put together in the order of pairs whatever part was done first.
class Findings {
 public:
  Findings(NarrowReport& report, Memory& memory) : report_(report), faults_(&memory) {}

  void add(const NarrowReport& part) {
    const std::lock_guard lock(mutex_);
    report_ += part;
  }
  /// Faults are rare: their list grows, on whichever thread.
  void add(std::uint32_t pair, const SupportFault& fault) {
    const std::lock_guard lock(mutex_);
    try {
      faults_.push_back({pair, fault});
    } catch (const std::bad_alloc&) {
      out_of_memory_ = true;
    }
  }
  void leave() { left_.store(true, std::memory_order_relaxed); }
  bool left() const { return left_.load(std::memory_order_relaxed); }

  void append_faults(Array<SupportFault>& to) {
    if (out_of_memory_) throw std::bad_alloc();
    std::sort(faults_.begin(), faults_.end(), [](const Found& a, const Found& b) { return a.pair < b.pair; });
    for (const Found& found : faults_) to.push_back(found.fault);
  }

 private:
  struct Found {
    std::uint32_t pair;
    SupportFault fault;
  };
  std::mutex mutex_;
  NarrowReport& report_;
  Array<Found> faults_;
  std::atomic<bool> left_{false};
  bool out_of_memory_ = false;
};

}  // namespace

void collide(const Shape& a, const Frame& frame_a, const Shape& b, const Frame& frame_b, const NarrowSettings& settings,
             QueryMemory& memory, Certificate* certificate, Candidates& found, NarrowReport& report,
             SupportFault& fault) {
  found.count = 0;
  found.whole = found.on_rim = false;
  found.gap = -kInfinity;
  const Real reach = settings.manifold.contact_distance;
  const bool flat_a = a.form == Form::half_space, flat_b = b.form == Form::half_space;
  if ((flat_a && flat_b) || is_scenery(a) || is_scenery(b)) return;  // scenery: meet_scenery()
  const PairEntry& entry = pair_entry(a.form, b.form);
  if (settings.query.routines && entry.routine) {
    const Frame &first = entry.swapped ? frame_b : frame_a, &second = entry.swapped ? frame_a : frame_b;
    const Frame second_in_first = relative(first, second);
    if (!usable(second_in_first)) return;
    entry.routine(entry.swapped ? b : a, entry.swapped ? a : b, second_in_first, reach, found);
    to_world(first, entry.swapped, found);
  } else if (flat_a || flat_b) {
    const Frame &first = flat_b ? frame_b : frame_a, &second = flat_b ? frame_a : frame_b;
    const Frame second_in_first = relative(first, second);
    if (!usable(second_in_first)) return;
    half_space_by_support(flat_b ? b : a, flat_b ? a : b, second_in_first, reach,
                          settings.query.routines && !one_shot(settings.manifold.kind), 0, found, report.support_calls,
                          fault);
    to_world(first, flat_b, found);
  } else {
    collide_generic(a, frame_a, b, frame_b, settings, memory, certificate, found, report, fault);
  }
}

/// A pair's record brought up to date; without points if a support function misbehaved.
static void update(const PatchPair& pair, const NarrowSettings& settings, PairRecord& record, Certificate* certificate,
                   Candidates& found, NarrowReport& report, SupportFault& fault) {
  if (one_shot(settings.manifold.kind) && keep_patch(pair, settings.manifold, record.patch, record.manifold)) {
    ++report.kept_patches;
    return;
  }
  collide(pair.a, pair.frame_a, pair.b, pair.frame_b, settings, record.memory, certificate, found, report, fault);
  record.patch.firm = false;
  if (fault.kind == SupportFault::none) update_manifold(pair, found, settings.manifold, record, report, fault);
  if (fault.kind == SupportFault::none) return;
  record.manifold.count = 0;
  record.memory = QueryMemory{};
  if (certificate) *certificate = Certificate{};
}

void narrow_phase(const Colliders& table, const NarrowSettings& settings, PairTable& pairs, NarrowReport& report,
                  Array<SupportFault>& faults, Jobs* jobs) {
  if (settings.carry_over > 0) pairs.keep_certificates();
  Findings findings(report, *faults.get_allocator().resource());
  const auto part = [&](std::uint32_t begin, std::uint32_t end, Whose whose) {
    const FloatGuard guard;
    NarrowReport own_report;
    Candidates found;
    SupportFault fault;
    NarrowSettings own = settings;  // with the pair's own contact distance: fast colliders reach farther
    for (std::uint32_t i = begin; i < end; ++i) {
      PairTable::Place& place = pairs.place(i);
      if (i + kPairsAhead < end) pairs.fetch(i + kPairsAhead);  // beyond, another thread may be writing
      const std::uint32_t a = place.pair.a, b = place.pair.b;
      const Real reach = settings.manifold.contact_distance + table.reach[a] + table.reach[b];
      if (table.travel[a] + table.travel[b] + kFarthestPair * reach < place.horizon) continue;
      PairRecord& record = pairs[i];
      const PatchPair pair{*table.shape[a], *table.shape[b], table.frame[a], table.frame[b],
                           shells(settings.query) / 2};
      if (whose != Whose::everybodys && (pair.a.host_thread || pair.b.host_thread) != (whose == Whose::host_threads)) {
        findings.leave();
        continue;
      }
      own.manifold.contact_distance = reach;
      update(pair, own, record, pairs.certificate(i), found, own_report, fault);
      guard.put_back();
      place.points = static_cast<std::uint32_t>(record.manifold.count);
      place.horizon =
          place.points == 0 && fault.kind == SupportFault::none ? horizon_of(table, place.pair, found) : -kInfinity;
      if (fault.kind != SupportFault::none) findings.add(i, std::exchange(fault, {}));
    }
    findings.add(own_report);
  };
  const auto n = static_cast<std::uint32_t>(pairs.size());
  if (!jobs) {
    part(0, n, Whose::everybodys);
  } else {
    in_parts(jobs, n, kPairsAPart,
             [&](std::uint32_t begin, std::uint32_t end) { part(begin, end, Whose::any_threads); });
    if (findings.left()) part(0, n, Whose::host_threads);
  }
  findings.append_faults(faults);
}

}  // namespace carom::collision
