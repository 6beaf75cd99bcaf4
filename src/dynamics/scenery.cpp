// Pairs with scenery: asked before the narrow phase, which passes them over.
#include "dynamics/scenery.h"

#include <algorithm>
#include <utility>

#include "collision/manifold/adopt.h"
#include "dynamics/contact/seams.h"

namespace carom::dynamics {
namespace {

// Cosine of 0.35 rad: a patch goes on from a record whose points looked the same way within this.
constexpr Real kSceneryPatch = 0.94;

/// A pair with scenery as collision/scenery sees it; none where both are without a volume to be pushed.
struct Parties {
  std::uint32_t scenery, convex;  // collider slots
  bool swapped;                   // the scenery is B

  Parties(const Colliders& c, const Pair& p)
      : scenery(is_scenery(*c.shape[p.a]) ? p.a : p.b), convex(scenery == p.a ? p.b : p.a), swapped(scenery == p.b) {}

  bool can_meet(const Colliders& c) const {
    const Shape& s = *c.shape[convex];
    return s.form != Form::half_space && !is_scenery(s);
  }
  SceneryPair pair(const Colliders& c) const {
    return pair(c, c.frame[swapped ? convex : scenery], c.frame[swapped ? scenery : convex]);
  }
  SceneryPair pair(const Colliders& c, const Frame& a, const Frame& b) const {
    return {*c.shape[scenery], *c.shape[convex], swapped ? b : a, swapped ? a : b};
  }
  Real reach(const Colliders& c, const NarrowSettings& settings) const {
    return settings.manifold.contact_distance + c.reach[scenery] + c.reach[convex];
  }
};

/// Whether all patches of a pair hold still, @see keep_patch().
bool keep(const Colliders& c, const NarrowSettings& settings, PairTable& pairs, const SceneryContacts::OfPair& of) {
  for (std::uint32_t i = of.place; i < of.place + of.places; ++i) {
    PairRecord& record = pairs[i];
    const Pair& slots = pairs.place(i).pair;
    const PatchPair pair{*c.shape[slots.a], *c.shape[slots.b], c.frame[slots.a], c.frame[slots.b], 0};
    if (!keep_patch(pair, settings.manifold, record.patch, record.manifold)) return false;
  }
  return true;
}

/// Patches beside the records of the last step: a record goes on with the patch that looks its way and lies nearest.
/// Records that go on come first in their run, and patches in the same order.
/// @return  how many go on
std::uint32_t match(PairTable& pairs, SceneryContacts& s, const SceneryContacts::OfPair& of, bool swapped) {
  const auto side = [&](const ContactPoint& p) -> const Vec3& { return swapped ? p.on_a : p.on_b; };
  const auto taken = [&](std::uint32_t k) {
    return std::find(s.order.begin() + of.first, s.order.end(), of.first + k) != s.order.end();
  };
  std::uint32_t matched = 0;
  for (std::uint32_t i = of.place; i < of.place + of.places; ++i) {
    const Manifold& old = pairs[i].manifold;
    if (old.count == 0) continue;
    std::uint32_t best = of.count;
    Real nearest = kInfinity;
    for (std::uint32_t k = 0; k < of.count; ++k) {
      const SceneryPatch& patch = s.patches[of.first + k];
      const Vec3 normal = swapped ? Vec3(-patch.normal) : patch.normal;
      if (old.point[0].normal.dot(normal) < kSceneryPatch || taken(k)) continue;
      for (int p = 0; p < patch.count; ++p)
        for (int q = 0; q < old.count; ++q) {
          const Real d = (patch.point[p].on_b - side(old.point[q])).squared_norm();
          if (d < nearest) nearest = d, best = k;
        }
    }
    if (best == of.count) continue;
    s.order.push_back(of.first + best);
    std::swap(pairs.place(of.place + matched), pairs.place(i));
    ++matched;
  }
  for (std::uint32_t k = 0; k < of.count; ++k)
    if (!taken(k)) s.order.push_back(of.first + k);
  return matched;
}

/// Put a pair's patches in the order of its records; records that none goes on with begin afresh.
void arrange(PairTable& pairs, SceneryContacts& s, const SceneryContacts::OfPair& of, bool swapped) {
  const std::uint32_t matched = match(pairs, s, of, swapped);
  for (std::uint32_t i = of.place + matched; i < of.place + of.places; ++i) {
    PairRecord& record = pairs[i];
    record.manifold.count = 0, record.patch = PatchMemory{};
  }
}

/// Of a patch, the points that stand for it.
void choose(const NarrowSettings& settings, const SceneryPatch& patch, bool swapped, Real reach, const Frame& a,
            Manifold& manifold) {
  ContactPoint point[PatchPoints::kMax];
  for (int i = 0; i < patch.count; ++i) point[i] = swapped ? exchanged(patch.point[i]) : patch.point[i];
  ManifoldSettings own = settings.manifold;
  own.contact_distance = reach, own.sunk_alike = true;
  adopt(a, point, patch.count, own, manifold);
}

void fill(const Colliders& c, const NarrowSettings& settings, const SceneryPatch& patch, bool swapped, Real reach,
          const Pair& pair, PairRecord& record) {
  const Frame &a = c.frame[pair.a], &b = c.frame[pair.b];
  choose(settings, patch, swapped, reach, a, record.manifold);
  record.patch.firm = patch.firm && record.manifold.count > 0;
  record.patch.of_b = swapped;
  record.patch.normal = swapped ? b.rotate_inverse(-patch.normal) : a.rotate_inverse(patch.normal);
  record.patch.b_in_a = relative(a, b);
}

void ask(const World& world, PairTable& pairs, NarrowReport& report, const NarrowSettings& settings, SceneryContacts& s,
         SceneryContacts::OfPair& of) {
  const Colliders& c = world.scene.colliders;
  const Pair pair = world.pairs.place(of.place).pair;
  const Parties parties(c, pair);
  of.first = static_cast<std::uint32_t>(s.patches.size()), of.count = 0;
  of.kept = keep(c, settings, pairs, of);
  if (of.kept) {
    report.kept_patches += of.places;
    return;
  }
  SupportFault fault;
  if (parties.can_meet(c) && s.pair_finder.find(parties.pair(c), settings, parties.reach(c, settings), report, fault)) {
    s.patches.insert(s.patches.end(), s.pair_finder.patches().begin(), s.pair_finder.patches().end());
    of.count = static_cast<std::uint32_t>(s.pair_finder.patches().size());
  }
  if (fault.kind != SupportFault::none) world.plan->faults.push_back(fault);
  arrange(pairs, s, of, parties.swapped);
}

}  // namespace

void scenery::find(const Scene& scene, const State&, Participants& participants) {
  const Colliders& c = scene.colliders;
  for (const std::uint32_t slot : c.active)
    if (is_scenery(*c.shape[slot]) && !(c.disabled[slot] & Colliders::kFaulty)) participants.add(slot);
}

void meet_scenery(const World& world, PairTable& pairs, NarrowReport& report, const NarrowSettings& settings) {
  if (world.plan->effects[+EffectId::scenery].participants.count == 0) return;
  if (!world.plan->scenery) world.plan->scenery = make_owned<SceneryContacts>(world.memory, world.memory);
  SceneryContacts& s = *world.plan->scenery;
  const Colliders& c = world.scene.colliders;
  s.of_pair.clear(), s.patches.clear(), s.order.clear(), s.runs.clear();
  for (std::uint32_t i = 0, j; i < pairs.size(); i = j) {
    const Pair pair = pairs.place(i).pair;
    for (j = i + 1; j < pairs.size() && pairs.place(j).pair == pair;) ++j;
    if (is_scenery(*c.shape[pair.a]) || is_scenery(*c.shape[pair.b])) s.of_pair.push_back({i, j - i, 0, 0, false});
  }
  std::uint32_t shift = 0;  // what runs before have grown by
  for (SceneryContacts::OfPair& of : s.of_pair) {
    ask(world, pairs, report, settings, s, of);
    const std::uint32_t wanted = of.kept ? of.places : std::max(of.count, 1u);
    if (wanted != of.places) s.runs.push_back({of.place, of.places, wanted});
    of.place += shift;
    shift += wanted - of.places;  // may wrap, and comes back
    of.places = wanted;
  }
  if (!s.runs.empty()) pairs.resize_runs(s.runs);
  for (const SceneryContacts::OfPair& of : s.of_pair) {
    const Parties parties(c, pairs.place(of.place).pair);
    for (std::uint32_t k = 0; k < of.places; ++k) {
      PairTable::Place& place = pairs.place(of.place + k);
      PairRecord& record = pairs[of.place + k];
      if (k < of.count)
        fill(c, settings, s.patches[s.order[of.first + k]], parties.swapped, parties.reach(c, settings), place.pair,
             record);
      place.points = static_cast<std::uint32_t>(record.manifold.count);
      place.horizon = kInfinity;  // not the narrow phase's
    }
  }
}

void meet_patch(const World& world, NarrowReport& report, const NarrowSettings& settings, const SceneryFrames& at,
                const Vec3& normal, Manifold& manifold) {
  const Colliders& c = world.scene.colliders;
  const Parties parties(c, at.pair);
  manifold.count = 0;
  SupportFault fault;
  if (!parties.can_meet(c)) return;
  SceneryPairFinder& finder = world.plan->scenery->pair_finder;
  const Real reach = parties.reach(c, settings);
  if (!finder.find(parties.pair(c, at.a, at.b), settings, reach, report, fault)) return;
  for (const SceneryPatch& patch : finder.patches())
    if ((patch.normal - (parties.swapped ? Vec3(-normal) : normal)).squared_norm() <= kSameWay2)
      return choose(settings, patch, parties.swapped, reach, at.a, manifold);
}

bool touches_scenery(const World& world, NarrowReport& report, const NarrowSettings& settings, const Pair& pair) {
  const Colliders& c = world.scene.colliders;
  const Parties parties(c, pair);
  if (!parties.can_meet(c)) return false;
  SceneryPairFinder pair_finder(world.memory);
  SupportFault fault;
  pair_finder.find(parties.pair(c), settings, parties.reach(c, settings), report, fault);
  return !pair_finder.patches().empty() || fault.kind != SupportFault::none;
}

}  // namespace carom::dynamics
