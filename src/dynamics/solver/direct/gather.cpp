// Groups from rows: who is in each, and in which order its bodies are eliminated.
#include <algorithm>

#include "dynamics/solver/direct.h"
#include "dynamics/solver/direct/cone_group_constants.h"
#include "dynamics/solver/direct/forest.h"
#include "dynamics/solver/direct/group_links.h"
#include "dynamics/solver/direct/load.h"
#include "dynamics/solver/direct/yielding_constants.h"
#include "dynamics/solver/wide_contacts.h"

namespace carom::dynamics {
namespace {

/// Capacity for some groups before there are any: a small world that settles goes on without allocating when one of its
/// bodies comes to rest late, and that group is the first to be solved here.
void reserve_groups(DirectGroups& d) {
  constexpr std::size_t kSome = 64;
  if (d.contacts.capacity() >= kSome) return;
  const auto reserve = [](auto&... arrays) { (arrays.reserve(kSome), ...); };
  Elimination& e = d.elimination;
  reserve(d.contacts, d.row, d.begin, d.bodies, d.scratch, d.rest, d.factor.diagonal, d.factor.beside,
          d.factor.is_filled, e.place, e.column, e.rows);
  Elimination::Scratch& s = e.scratch();
  reserve(s.neighbour_begin, s.neighbour, s.degree, s.mark, s.first, s.member, s.joints, s.joint, s.node_at, s.joint_at,
          s.ordered_edges, s.ordered_begin, s.edges, s.products);
  s.link.reserve(2 * kSome), s.begin.reserve(2 * kSome);
}

/// Bodies, contacts and edges of each group.
void gather(const World& world, DirectGroups& d) {
  const Contacts& c = *world.contacts;
  reserve_groups(d);
  d.forget();  // those of another pass of the step, or of a begin that ended for want of memory
  d.body.resize(world.scene.bodies.slots(), kInvalid);
  // Contacts of the last step are written over: to make 400 bytes of zeros of each first costs more than to fill it.
  std::size_t points = 0;
  for (std::size_t g = 0; g < c.groups(); ++g)
    if (c.solved_directly(g)) points += c.group_begin[g + 1] - c.group_begin[g];
  if (points > d.contacts.capacity()) d.contacts.clear(), d.contacts.reserve(points + points / 16);
  d.contacts.resize(points);
  if (d.bodies.capacity() < c.bodies.size()) d.bodies.reserve(c.bodies.size() + c.bodies.size() / 16);
  const auto mark = [&] {
    const auto size = [](const auto& of) { return static_cast<std::uint32_t>(of.size()); };
    d.begin.push_back({.contact = size(d.row),
                       .body = size(d.bodies),
                       .link = size(d.links),
                       .edge = size(d.elimination.scratch().edges),
                       .forest = d.has_forest() ? size(d.forest().joints) : 0,
                       .tree = 0,
                       .lock = size(d.links)});
  };
  for (std::size_t g = 0; g < c.groups(); ++g) {
    const bool in_lanes = !c.solved_directly(g);
    if (in_lanes && !c.has_joints(g)) continue;
    mark();
    GroupRest& rest = d.rest.emplace_back();
    rest.is_few = is_few(c, g), rest.in_lanes = in_lanes;
    rest.points = in_lanes ? c.group_begin[g + 1] - c.group_begin[g] : 0;
    for (std::uint32_t k = c.group_begin[g]; !in_lanes && k < c.group_begin[g + 1]; ++k) {
      const std::uint32_t i = c.group_rows[k];
      const Row& row = c.rows[i];
      ConeContact& contact = d.contacts[d.row.size()];
      contact.a = d.node(row.moves_a, row.a);
      contact.b = d.node(row.moves_b, row.b);
      const bool coupled = contact.a != kInvalid && contact.b != kInvalid;
      if (coupled && (d.elimination.scratch().edges.size() == d.begin.back().edge ||
                      d.elimination.scratch().edges.back() != Edge{contact.a, contact.b}))
        d.elimination.scratch().edges.push_back({contact.a, contact.b});
      d.row.push_back(i);
    }
    gather_links(world, d, g);
  }
  mark();
}

/// Find an order of elimination, unless the bodies hang together as they did in the last step.
void order(DirectGroups& d, std::uint64_t most_factor) {
  Elimination::Scratch& last = d.elimination.scratch();
  if (last.edges == last.ordered_edges &&
      std::ranges::equal(d.begin, last.ordered_begin, {}, &DirectGroups::Begin::edge) &&
      (!d.has_forest() || d.forest().joints == d.forest().ordered) && d.bodies.size() == d.elimination.place.size())
    return;
  d.elimination.clear();
  last.products.resize(d.groups());
  for (std::size_t g = 0; g < d.groups(); ++g)
    last.products[g] = eliminate(d.begin[g].body, d.begin[g + 1].body - d.begin[g].body,
                                 {last.edges.data() + d.begin[g].edge, d.begin[g + 1].edge - d.begin[g].edge},
                                 d.forest_of(g), most_factor, d.elimination);
  d.scratch.resize(d.bodies.size());
  last.ordered_edges = last.edges, last.ordered_begin.resize(d.begin.size());
  std::ranges::transform(d.begin, last.ordered_begin.begin(), &DirectGroups::Begin::edge);
  if (d.has_forest()) d.forest().ordered = d.forest().joints;
}

/// Nodes of the forests, in the order of elimination. What is too large to be factored has none, and all rows.
void plant_forests(DirectGroups& d, std::uint64_t most_factor) {
  if (!d.has_forest()) return;
  Array<TreeNode>& nodes = d.forest().nodes;
  for (std::size_t g = 0; g < d.groups(); ++g) {
    DirectGroups::Begin &from = d.begin[g], &to = d.begin[g + 1];
    const std::span<const TreeJoint> forest = d.forest_of(g);
    from.tree = static_cast<std::uint32_t>(nodes.size());
    to.tree = from.tree;
    if (forest.empty()) continue;
    if (d.newton_work(g) > most_factor) {
      from.lock = to.link;
      continue;
    }
    nodes.resize(from.tree + to.body - from.body);
    to.tree = static_cast<std::uint32_t>(nodes.size());
    plant({nodes.data() + from.tree, to.tree - from.tree}, forest, d.elimination, from.body);
  }
}

/// Where in the factor each contact and each row of a joint couples its bodies. (Of a group that is too large to be
/// factored that is nowhere, and nothing reads it.)
void place_contacts(DirectGroups& d) {
  const auto place = [&](auto& c) {
    c.beside = kInvalid;
    if (c.a == kInvalid || c.b == kInvalid) return;
    const std::uint32_t a = d.elimination.place[c.a], b = d.elimination.place[c.b];
    c.a_later = a > b;
    if (d.elimination.is_bare(std::min(a, b))) return;  // a joint's own limit or drive
    c.beside = static_cast<std::uint32_t>(d.factor.at(d.elimination, std::max(a, b), std::min(a, b)));
  };
  std::ranges::for_each(d.contacts, place);
  std::ranges::for_each(d.links, place);
}

}  // namespace

void DirectGroups::forget() {
  for (const ConeBody& b : bodies)
    if (b.slot < body.size()) body[b.slot] = kInvalid;
  links.clear(), link_row.clear();
  rest.clear(), row.clear(), begin.clear();
  bodies.clear(), elimination.forget_edges();
  if (has_forest()) forest().joints.clear(), forest().nodes.clear(), forest().more.clear();
}

bool yields_for_half(std::uint64_t work_of_step, int substeps) {
  return 2 * static_cast<std::uint64_t>(substeps) * kStepsOfYielding * work_of_step <= kWorkOfFew;
}

bool DirectGroups::may_yield(std::size_t group, int substeps) const {
  return yields_for_half(rest[group].work_of_step, substeps);
}

void gather_groups(const World& world, SolverMemory& memory, Real h, std::uint64_t most_factor) {
  DirectGroups& d = *world.direct;
  gather(world, d);
  order(d, most_factor);
  plant_forests(d, most_factor);
  const std::size_t matrices = d.links.empty() ? 1 : 2;
  remake(d.factor.diagonal, matrices * d.bodies.size()), remake(d.factor.beside, matrices * d.elimination.rows.size());
  d.factor.is_filled.resize(matrices * d.elimination.rows.size());
  place_contacts(d);
  load_groups(world, memory, h);
  const auto work = static_cast<std::uint64_t>(world.scene.dials[Dial::direct_work]);
  const std::uint64_t of_loops = std::min(most_factor, work * static_cast<std::uint64_t>(world.plan->substeps));
  for (std::size_t g = 0; g < d.groups(); ++g) {
    const bool has_loops = d.begin[g].link < d.begin[g].lock, is_bounded = most_factor != ~std::uint64_t{0};
    d.rest[g].is_dear = has_loops && d.newton_work(g) > work;
    d.rest[g].is_too_large = d.newton_work(g) > (has_loops && is_bounded ? of_loops : most_factor);
  }
  d.elimination.scratch().member.reserve(d.groups());  // @see share_out()
  if (world.plan->rotation_method && world.wide->one_turner.runs.empty()) world.wide->one_turner.add(0);
  for (const Resistance& r : world.contacts->resisting)
    if (GroupRest* const rest = d.rest_of(world.contacts->rows[r.row])) rest->resists = true;
}

}  // namespace carom::dynamics
