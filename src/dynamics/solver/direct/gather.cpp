// Groups from rows: who is in each, and in which order its bodies are eliminated.
#include <algorithm>

#include "dynamics/solver/direct.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/load.h"

namespace carom::dynamics {
namespace {

/// Capacity for some groups before there are any: a small world that settles goes on without allocating when one of its
/// bodies comes to rest late, and that group is the first to be solved here.
void reserve_groups(DirectGroups& d) {
  constexpr std::size_t kSome = 64;
  if (d.rows.capacity() >= kSome) return;
  const auto reserve = [](auto&... arrays) { (arrays.reserve(kSome), ...); };
  Elimination& e = d.elimination;
  reserve(d.rows, d.patches, d.places, d.row, d.begin, d.bodies, d.edges, d.edge_begin, d.ordered_edges, d.scratch,
          d.products, d.solution, d.rest, d.factor.diagonal, d.factor.below, e.place, e.column, e.rows);
  Elimination::Scratch& s = e.scratch();
  reserve(s.neighbour_begin, s.neighbour, s.degree, s.mark, s.first, s.member);
  s.link.reserve(2 * kSome), s.begin.reserve(2 * kSome);
}

/// Rows of a group's contacts and patches of its pairs.
void gather_contacts(const Contacts& c, DirectGroups& d, std::size_t group) {
  const DirectGroups::Begin begin = d.begin.back();
  std::uint32_t count = 0;  // of points of the pair
  for (std::uint32_t k = c.group_begin[group], next = k; k < c.group_begin[group + 1]; ++k) {
    const std::uint32_t i = c.group_rows[k];
    const Row& row = c.rows[i];
    ConeRow& contact = d.rows.emplace_back();
    contact.a = d.node(row.moves_a, row.a);
    contact.b = d.node(row.moves_b, row.b);
    const bool begins = k == next, alone = !row.one_normal;
    if (begins) next = k + (count = c.first_row[c.geometry[i].pair + 1] - i);
    if (begins || alone) {
      ConePatch& patch = d.patches.emplace_back();
      patch.a = contact.a, patch.b = contact.b;
      patch.first = static_cast<std::uint32_t>(d.row.size()) - begin.contact, patch.count = alone ? 1 : count;
    }
    d.places.emplace_back().patch = static_cast<std::uint32_t>(d.patches.size()) - 1 - begin.patch;
    const bool coupled = contact.a != kInvalid && contact.b != kInvalid;
    if (coupled && d.edges.back() != Edge{contact.a, contact.b}) d.edges.push_back({contact.a, contact.b});
    d.row.push_back(i);
  }
}

/// Bodies, contacts and edges of each group.
void gather(const World& world, DirectGroups& d) {
  const Contacts& c = *world.contacts;
  reserve_groups(d);
  for (const ConeBody& b : d.bodies)  // those of the last step, which may have ended for want of memory
    if (b.slot < d.body.size()) d.body[b.slot] = kInvalid;
  d.rows.clear(), d.patches.clear(), d.places.clear(), d.link_row.clear();
  d.rest.clear(), d.row.clear(), d.begin.clear();
  d.bodies.clear(), d.edges.clear(), d.edge_begin.clear();
  d.body.resize(world.scene.bodies.slots(), kInvalid);
  const auto make_room = [](auto& array, std::size_t n) {
    if (array.capacity() < n) array.reserve(n + n / 16);
  };
  constexpr std::size_t kRowsOfJoint = 12;
  const std::size_t points = c.rows.size();
  make_room(d.bodies, c.bodies.size()), make_room(d.rows, points + kRowsOfJoint * c.links.size());
  make_room(d.patches, points), make_room(d.places, points), make_room(d.row, points);
  const auto mark = [&] {
    d.begin.push_back({static_cast<std::uint32_t>(d.row.size()), static_cast<std::uint32_t>(d.bodies.size()),
                       static_cast<std::uint32_t>(d.link_row.size()), static_cast<std::uint32_t>(d.patches.size())});
    d.edges.push_back({kInvalid, kInvalid});
    d.edge_begin.push_back(static_cast<std::uint32_t>(d.edges.size()));
  };
  for (std::size_t g = 0; g < c.groups(); ++g) {
    if (!c.solved_directly(g)) continue;
    mark();
    d.rest.emplace_back().is_few = is_few(c, g);
    gather_contacts(c, d, g);
    gather_links(world, d, g);
  }
  mark();
}

/// Find an order of elimination, unless the bodies hang together as they did in the last step.
void order(DirectGroups& d, std::uint64_t most_factor) {
  if (d.edges == d.ordered_edges && d.bodies.size() == d.elimination.place.size()) return;
  d.elimination.clear();
  d.products.resize(d.groups());
  for (std::size_t g = 0; g < d.groups(); ++g)
    d.products[g] = eliminate(d.begin[g].body, d.begin[g + 1].body - d.begin[g].body,
                              {d.edges.data() + d.edge_begin[g], d.edge_begin[g + 1] - 1 - d.edge_begin[g]},
                              most_factor, d.elimination);
  d.scratch.resize(d.bodies.size());
  d.ordered_edges = d.edges;
}

/// Where in the factor each contact and each row of a joint couples its bodies. (Of a group that is too large to be
/// factored that is nowhere, and nothing reads it.)
void place_contacts(DirectGroups& d) {
  const auto place = [&](auto& c) {
    c.below = kInvalid;
    if (c.a == kInvalid || c.b == kInvalid) return;
    const std::uint32_t a = d.elimination.place[c.a], b = d.elimination.place[c.b];
    c.a_later = a > b;
    c.below = static_cast<std::uint32_t>(d.factor.at(d.elimination, std::max(a, b), std::min(a, b)));
  };
  std::ranges::for_each(d.rows, place);
  std::ranges::for_each(d.patches, place);
}

}  // namespace

void gather_groups(const World& world, SolverMemory& memory, std::uint64_t most_factor) {
  DirectGroups& d = *world.direct;
  gather(world, d);
  order(d, most_factor);
  const std::size_t matrices = d.link_row.empty() ? 1 : 2;
  remake(d.factor.diagonal, matrices * d.bodies.size()), remake(d.factor.below, matrices * d.elimination.rows.size());
  place_contacts(d);
  load_groups(world, memory, d);
  d.solution.resize(d.groups());
  for (std::size_t g = 0; g < d.groups(); ++g) d.rest[g].is_too_large = d.newton_work(g) > most_factor;
  d.elimination.scratch().member.reserve(d.groups());  // @see share_out()
  for (const Resistance& r : world.contacts->resisting)
    if (GroupRest* const rest = d.rest_of(world.contacts->rows[r.row])) rest->resists = true;
}

}  // namespace carom::dynamics
