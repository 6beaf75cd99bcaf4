// Who stands where in lanes: numbers of bodies, regions, colours, places of pairs.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "dynamics/joint/wide_joints.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

using Manifold = WideContacts::Manifold;
using Member = Placing::Member;

/// Pairs of the whole by colour and kind; beyond the colours each stands alone.
constexpr std::uint32_t kBuckets = (kColours + 1) * kPairKinds, kAlone = kColours * kPairKinds;

/// Whether those solved in lanes are who they were a step ago, and meet as they met.
bool meet_as_before(const World& world, const WideContacts& wide) {
  const Contacts& c = *world.contacts;
  const Placing& p = *wide.placing;
  if (!p.stands || !c.links.empty() || wide.body.size() != world.scene.bodies.slots()) return false;
  const auto is_kinematic = [&](std::uint32_t body) { return world.scene.type[body] == BodyType::kinematic; };
  const auto has_its_number = [&](bool moves, std::uint32_t body) {
    return moves || is_kinematic(body) == (wide.body[body] != 0);
  };
  auto old = p.met.begin();
  for (const ContactPair& m : c.contact_pairs) {
    if (!c.solved_in_lanes(m.row)) continue;
    if (old == p.met.end() || !old->is_like(m)) return false;
    if (!has_its_number(m.moves_a, m.a) || !has_its_number(m.moves_b, m.b)) return false;
    ++old;
  }
  return old == p.met.end();
}

/// Pairs that met before have other rows, since pairs come and go that are solved elsewhere.
void take_rows(const Contacts& c, WideContacts& wide) {
  std::size_t i = 0;
  for (const ContactPair& m : c.contact_pairs)
    if (c.solved_in_lanes(m.row)) wide.manifolds[i].row = wide.placing->met[i].row = m.row, ++i;
}

/// What is solved in lanes, and their bodies.
void list_bodies(const World& world, WideContacts& wide) {
  const Contacts& c = *world.contacts;
  const Scene& scene = world.scene;
  Placing& p = *wide.placing;
  constexpr std::uint32_t kMoves = 0xFFFFFFFFu;
  for (const std::uint32_t body : wide.slot) wide.body[body] = 0;  // of the last step: all others are 0
  wide.body.resize(scene.bodies.slots(), 0);
  wide.slot.assign(1, 0);
  // Capacity first: no body may be left marked.
  p.met.clear(), p.met.reserve(c.contact_pairs.size());
  p.movers.clear(), p.movers.reserve(c.bodies.size());
  p.kinematic.clear(), p.kinematic.reserve(world.plan->kinematic.count);
  const auto mark = [&](bool moves, std::uint32_t body) {
    if (moves || wide.body[body]) return void(wide.body[body] = kMoves);
    if (scene.type[body] == BodyType::kinematic) wide.body[body] = kMoves, p.kinematic.push_back(body);
  };
  for (const ContactPair& m : c.contact_pairs)
    if (c.solved_in_lanes(m.row)) p.met.push_back(m), mark(m.moves_a, m.a), mark(m.moves_b, m.b);
  for (const Link& l : c.links)
    for (const auto& [moves, body] : {std::pair(l.moves_a, l.a), std::pair(l.moves_b, l.b)})
      if (body != kInvalid) mark(moves, body);
  for (const std::uint32_t i : p.kinematic) wide.body[i] = 0;
  for (const std::uint32_t i : c.bodies)
    if (std::exchange(wide.body[i], 0)) p.movers.push_back(i);
}

/// m, of the grid by which bodies are halved: about what they measure. A power of two, so as to be the same in the next
/// step.
Real size_of_cell(const World& world, const Placing& p) {
  if (levels_for(p.movers.size()) == 1 || p.met.empty()) return 1;  // none is halved, or by joints alone
  constexpr std::size_t kAsked = 256;
  const std::size_t stride = p.met.size() / kAsked + 1;
  Real sum = 0, count = 0;
  for (std::size_t i = 0; i < p.met.size(); i += stride) {
    const RowGeometry& g = world.contacts->geometry[p.met[i].row];
    sum += (p.met[i].moves_a ? g.l_a : g.l_b).norm(), count += 1;
  }
  const Real mean = sum / count;
  return mean >= std::numeric_limits<Real>::min() && finite(mean) ? std::ldexp(Real(1), std::ilogb(mean) + 1) : 1;
}

/// Solver bodies: 0 for what no impulse and no host moves, then kinematic bodies as rows name them (they keep their
/// velocity and lend it to those that touch them), then the rest, region by region: a thread that has a region finds
/// its bodies beside each other.
void number_bodies(WideContacts& wide) {
  const Placing& p = *wide.placing;
  for (const std::uint32_t body : wide.slot) wide.body[body] = 0;
  wide.slot.assign(1, 0);
  wide.slot.reserve(1 + p.kinematic.size() + p.movers.size());  // now: no number may be left that slot lacks
  const auto number = [&](std::uint32_t i) {
    wide.body[i] = static_cast<std::uint32_t>(wide.slot.size());
    wide.slot.push_back(i);
  };
  for (const std::uint32_t i : p.kinematic) number(i);
  wide.first_moved = static_cast<std::uint32_t>(wide.slot.size());
  for (const std::uint32_t i : p.regions.order) number(i);
}

/// Where bodies are as the step begins, and capacity for what lanes know of them.
void save_poses(const World& world, WideContacts& wide) {
  const std::size_t n = wide.slot.size();
  wide.velocity.assign(n, {});
  wide.swept_again.assign(n, 0);
  wide.shift.assign(n, {});
  wide.placing->turn.resize(n);
  wide.start_x.resize(n), wide.start_q.resize(n);
  in_parallel(world.jobs, n, kBodiesAPart, [&](std::uint32_t i) {
    if (i == 0) return;
    wide.start_x[i] = world.state.x[wide.slot[i]];
    wide.start_q[i] = world.state.q[wide.slot[i]];
  });
}

/// Manifolds from contact pairs, and who is of which region.
void list_manifolds(const World& world, WideContacts& wide) {
  Placing& p = *wide.placing;
  const std::uint32_t regions = p.regions.end();
  const std::size_t n = p.met.size();
  wide.rows = 0;
  for (const ContactPair& m : p.met) wide.rows += m.count;
  wide.manifolds.resize(n), p.in_region.resize(n), p.at.resize(n), p.members.resize(n), p.by_colour.resize(n);
  wide.parts.assign(regions + 1, {});
  const std::uint32_t* const leaf = p.regions.leaf.data();
  const auto solver_body = [&](bool moves, std::uint32_t body) { return moves ? wide.body[body] : 0; };
  in_parallel(world.jobs, n, kPairsAPart, [&](std::uint32_t i) {
    const ContactPair& m = p.met[i];
    const std::uint32_t a = solver_body(m.moves_a, m.a), b = solver_body(m.moves_b, m.b);
    p.in_region[i] = Regions::of(leaf[(a ? a : b) - wide.first_moved], leaf[(b ? b : a) - wide.first_moved]);
    wide.manifolds[i] = {m.row, m.count, 0, 0, 0};
  });
  for (const std::uint32_t region : p.in_region) ++wide.parts[region].member;
  // How many become where they end; where they end, filled from the last, where they begin.
  for (std::uint32_t r = 1; r <= regions; ++r) wide.parts[r].member += wide.parts[r - 1].member;
  for (std::size_t i = n; i-- > 0;) p.at[i] = --wide.parts[p.in_region[i]].member;
  in_parallel(world.jobs, n, kPairsAPart, [&](std::uint32_t i) {
    const ContactPair& m = p.met[i];
    p.members[p.at[i]] = {i, solver_body(m.moves_a, m.a), solver_body(m.moves_b, m.b),
                          (m.one_normal ? 0u : static_cast<std::uint32_t>(kPairPoints)) + m.count - 1};
  });
}

/// f(member) for all of a region.
template <class F>
void each_of(const WideContacts& wide, std::uint32_t region, const F& f) {
  for (std::uint32_t k = wide.parts[region].member; k < wide.parts[region + 1].member; ++k) f(wide.placing->members[k]);
}

/// Which colours bodies have in a region: those of one level share none.
std::uint64_t* taken_in(WideContacts& wide, std::uint32_t region) {
  return wide.placing->taken.data() + Regions::level_of(region) * wide.slot.size();
}

/// Each pair takes the highest colour that none of its movable bodies has yet in its region: who came first, and what
/// was built from the ground up, is swept last.
void colour(WideContacts& wide, std::uint32_t region, bool both_move) {
  std::uint64_t* const taken = taken_in(wide, region);
  for (std::uint32_t k = wide.parts[region].member; k < wide.parts[region + 1].member; ++k) {
    Member& m = wide.placing->members[k];
    if ((m.a && m.b) == both_move)
      m.bucket += BothColours(taken, m.a > 0, m.a, m.b > 0, m.b).take_highest() * kPairKinds;
  }
}

/// Places of the whole's, contacts with what does not move last: four of a bucket share one, but beyond the colours
/// each has one for itself. Leaves in its part how many pairs and points it has.
void place_whole(WideContacts& wide) {
  colour(wide, 1, false), colour(wide, 1, true);
  std::array<std::uint32_t, kBuckets> next{};
  std::uint32_t first = kBuckets;  // the highest colours are taken first: a small world has few, and none is before it
  each_of(wide, 1, [&](const Member& m) { ++next[m.bucket], first = std::min(first, m.bucket); });
  for (auto& colour : wide.colours) colour = {};
  std::uint32_t lanes = 0, points = 0;
  for (std::uint32_t i = first; i < kBuckets; ++i) {
    const std::uint32_t begin = lanes, count = next[i];
    lanes += i < kAlone ? (count + kLanes - 1) / kLanes * kLanes : count * kLanes;
    points += (lanes - begin) / kLanes * (i % kPairPoints + 1);
    next[i] = begin;
    if (i < kAlone) wide.colours[i / kPairKinds][i % kPairKinds] = lanes / kLanes;
  }
  each_of(wide, 1, [&](const Member& member) {
    Manifold& m = wide.manifolds[member.manifold];
    std::uint32_t& at = next[member.bucket];
    m.kind = member.bucket % kPairKinds, m.pair = at / kLanes, m.lane = at % kLanes;
    at += member.bucket < kAlone ? 1 : kLanes;
  });
  wide.parts[1].pair = lanes / kLanes, wide.parts[1].point = points;
}

/// Places in a smaller region, whose rows one thread has to itself, so that colours may mix: pairs come colour by
/// colour, and each goes into the first of a few lanes that are open and have its kind and neither of its bodies. So
/// fewer lanes stay empty, and those one after the other seldom share a body, for which the later would have to wait.
class AsTheyCome {
 public:
  /// @param taken  by solver body, bit i: who is in open lanes i moves it
  explicit AsTheyCome(std::uint64_t* taken) : taken_(taken) {}

  void add(const Member& of, Manifold& m) {
    const std::uint32_t kind = of.bucket % kPairKinds;
    const std::uint64_t of_kind = kAll << kind * kOpen, met = taken(of.a) | taken(of.b);
    std::uint32_t i = first(is_open_ & of_kind & ~met);
    if (i == kNone) i = open(of_kind, kind % kPairPoints + 1);
    Four& four = four_[i];
    m.kind = kind, m.pair = four.pair, m.lane = four.count;
    four.a[four.count] = of.a, four.b[four.count] = of.b, ++four.count;
    const std::uint64_t bit = std::uint64_t{1} << i;
    if (of.a) taken_[of.a] |= bit;
    if (of.b) taken_[of.b] |= bit;
    if (four.count == kLanes) close(i);
  }
  void close_all() {
    while (is_open_) close(static_cast<std::uint32_t>(std::countr_zero(is_open_)));
  }

  std::uint32_t pairs = 0, points = 0;

 private:
  static constexpr std::uint32_t kOpen = 64 / kPairKinds, kNone = 64;
  static constexpr std::uint64_t kAll = (std::uint64_t{1} << kOpen) - 1;

  struct Four {
    std::uint32_t pair, count;
    std::uint32_t a[kLanes], b[kLanes];
  };

  /// Body 0, which is none, is never taken.
  std::uint64_t taken(std::uint32_t body) const { return body ? taken_[body] : 0; }
  /// Of some that are open, the one opened first.
  std::uint32_t first(std::uint64_t of) const {
    std::uint32_t least = kNone;
    for (; of; of &= of - 1) {
      const auto i = static_cast<std::uint32_t>(std::countr_zero(of));
      if (least == kNone || four_[i].pair < four_[least].pair) least = i;
    }
    return least;
  }
  std::uint32_t open(std::uint64_t of_kind, std::uint32_t count_of_points) {
    if ((is_open_ & of_kind) == of_kind) close(first(of_kind));
    const auto i = static_cast<std::uint32_t>(std::countr_zero(~is_open_ & of_kind));
    is_open_ |= std::uint64_t{1} << i;
    four_[i].pair = pairs++, four_[i].count = 0;
    points += count_of_points;
    return i;
  }
  void close(std::uint32_t i) {
    const std::uint64_t bit = std::uint64_t{1} << i;
    is_open_ &= ~bit;
    for (std::uint32_t k = 0; k < four_[i].count; ++k) {
      if (four_[i].a[k]) taken_[four_[i].a[k]] &= ~bit;
      if (four_[i].b[k]) taken_[four_[i].b[k]] &= ~bit;
    }
  }

  std::uint64_t* taken_;
  std::uint64_t is_open_ = 0;
  Four four_[64];
};

/// Those of whom both, or one, moves: colour by colour into by_colour; who has which is forgotten.
/// @return one past the last
std::uint32_t sort_by_colour(WideContacts& wide, std::uint32_t region, bool both_move) {
  const std::uint32_t begin = wide.parts[region].member;
  std::uint64_t* const taken = taken_in(wide, region);
  std::array<std::uint32_t, kColours + 2> next{};
  const auto each = [&](const auto& f) {
    each_of(wide, region, [&](const Member& m) {
      if ((m.a && m.b) == both_move) f(m, m.bucket / kPairKinds);
    });
  };
  each([&](const Member& m, std::uint32_t colour) {
    ++next[colour + 1];
    if (m.a) taken[m.a] = 0;
    if (m.b) taken[m.b] = 0;
  });
  next[0] = begin;
  for (std::uint32_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  each([&](const Member& m, std::uint32_t colour) { wide.placing->by_colour[next[colour]++] = m; });
  return next[kColours];
}

/// Contacts with what does not move last.
void place(WideContacts& wide, std::uint32_t region) {
  WideContacts::Part& part = wide.parts[region];
  AsTheyCome lanes(taken_in(wide, region));
  for (const bool both_move : {true, false}) {
    colour(wide, region, both_move);
    const std::uint32_t end = sort_by_colour(wide, region, both_move);
    for (std::uint32_t k = part.member; k < end; ++k)
      lanes.add(wide.placing->by_colour[k], wide.manifolds[wide.placing->by_colour[k].manifold]);
    lanes.close_all();
  }
  part.pair = lanes.pairs, part.point = lanes.points;
}

/// Places among all, once it is known where the region's begin.
void settle(WideContacts& wide, std::uint32_t region) {
  const WideContacts::Part& part = wide.parts[region];
  each_of(wide, region, [&](const Member& member) {
    Manifold& m = wide.manifolds[member.manifold];
    m.pair += part.pair;
    wide.occupant[m.pair * kLanes + m.lane] = member.manifold;
  });
  std::uint32_t point = part.point;
  for (std::uint32_t k = part.pair; k < wide.parts[region + 1].pair; ++k) {
    wide.first_point[k] = point;
    point += wide.manifolds[wide.occupant[k * kLanes]].points;
  }
}

/// Colours, lanes and places of all.
void place_all(const World& world, WideContacts& wide) {
  Placing& p = *wide.placing;
  p.taken.assign(p.regions.levels * wide.slot.size(), 0);
  wide.colours.resize(kColours);
  colour_joints(world);
  const std::size_t regions = p.regions.end() - 1;
  in_parallel(world.jobs, regions, 1, [&](std::uint32_t i) {
    if (i > 0) return place(wide, 1 + i);
    place_whole(wide);
  });
  WideContacts::Part next{0, 0, 0};
  for (std::uint32_t r = 1; r <= p.regions.end(); ++r) {
    WideContacts::Part& part = wide.parts[r];
    std::swap(part.pair, next.pair), std::swap(part.point, next.point);
    next.pair += part.pair, next.point += part.point;
  }
  wide.occupant.assign(std::size_t{wide.parts.back().pair} * kLanes, kEmptyLane);
  wide.first_point.resize(wide.parts.back().pair);
  in_parallel(world.jobs, regions, 1, [&](std::uint32_t i) { settle(wide, 1 + i); });
}

}  // namespace

void place_pairs(const World& world, WideContacts& wide) {
  if (!wide.placing) wide.placing = make_owned<Placing>(world.memory, world.memory);
  Placing& p = *wide.placing;
  bool same = meet_as_before(world, wide);
  p.stands = false;
  if (same)
    take_rows(*world.contacts, wide);
  else
    list_bodies(world, wide);
  same &= halve(world.state.x, size_of_cell(world, p), world.jobs, p.movers, p.regions);
  if (!same) {
    number_bodies(wide);
    list_manifolds(world, wide);
    place_all(world, wide);
  }
  save_poses(world, wide);
  p.stands = world.contacts->links.empty();
}

}  // namespace carom::dynamics
