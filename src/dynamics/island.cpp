// Contact groups by union-find.
#include "dynamics/island.h"

#include "dynamics/contact_views.h"

#include <algorithm>

namespace carom::dynamics {
namespace {

/// Counting sort: groups begin as their ends, and members are put in from the last to the first.
void sort_by_label(const Array<std::uint32_t>& label, std::uint32_t groups, Array<std::uint32_t>& begin,
                   Array<std::uint32_t>& members) {
  begin.assign(groups + 1, 0);
  for (const std::uint32_t g : label) ++begin[g];
  for (std::uint32_t g = 0; g < groups; ++g) begin[g + 1] += begin[g];
  for (std::size_t i = label.size(); i-- > 0;) members[--begin[label[i]]] = static_cast<std::uint32_t>(i);
}

}  // namespace

std::uint32_t root_of(Array<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

std::uint32_t group_of(Contacts& c, std::uint32_t body) { return c.is_grouped ? c.cursor[root_of(c.parent, body)] : 0; }

std::uint32_t island_of(Contacts& c, std::uint32_t body) { return root_of(c.parent, body); }

void partition_rows(Contacts& c, std::size_t body_slots, bool grouped) {
  const std::size_t n = c.rows.size();
  c.group_begin.clear();
  grow_to(c.group_rows, n), grow_to(c.label, n);
  c.link_label.resize(c.links.size());
  c.is_grouped = grouped;
  std::size_t met = 0;
  for (const ContactPair& m : c.contact_pairs) met += m.count;
  const bool some_are_out = met < n;  // of this pass, @see accuracy/passes.h: they are a last group, which is taken off
  if (some_are_out) std::ranges::fill(c.label, kInvalid);
  std::uint32_t groups = 0;
  if (grouped) {
    c.parent.resize(body_slots), c.cursor.resize(body_slots);
    for (const ContactPair& m : c.contact_pairs) {  // bodies without rows stay out of it, sleepers among them
      c.parent[m.a] = m.a, c.parent[m.b] = m.b;
      c.cursor[m.a] = c.cursor[m.b] = kInvalid;  // scratch: group of a root
    }
    for (const Link& l : c.links) {
      if (l.moves_a) c.parent[l.a] = l.a, c.cursor[l.a] = kInvalid;
      if (l.moves_b) c.parent[l.b] = l.b, c.cursor[l.b] = kInvalid;
    }
    const auto join = [&](const auto& both) {
      if (!both.moves_a || !both.moves_b) return;
      const std::uint32_t a = root_of(c.parent, both.a), b = root_of(c.parent, both.b);
      // The lower slot is the root whatever the order of unions: labels depend on the contacts alone.
      if (a < b) c.parent[b] = a;
      if (b < a) c.parent[a] = b;
    };
    for (const ContactPair& m : c.contact_pairs) join(m);
    for (const Link& l : c.links) join(l);
    const auto label = [&](const auto& both) {
      const std::uint32_t r = root_of(c.parent, both.moves_a ? both.a : both.b);
      if (c.cursor[r] == kInvalid) c.cursor[r] = groups++;
      return c.cursor[r];
    };
    for (const ContactPair& m : c.contact_pairs) {
      const std::uint32_t group = label(m);
      std::fill_n(c.label.begin() + m.row, m.count, group);
    }
    for (std::size_t i = 0; i < c.links.size(); ++i) c.link_label[i] = label(c.links[i]);
    c.group_bodies.assign(groups, 0);
    for (const std::uint32_t body : c.bodies) ++c.group_bodies[c.cursor[root_of(c.parent, body)]];
  } else {
    if (!some_are_out) c.label.assign(n, 0);
    for (const ContactPair& m : c.contact_pairs) std::fill_n(c.label.begin() + m.row, m.count, 0u);
    c.link_label.assign(c.links.size(), 0);
    groups = met || !c.links.empty() ? 1 : 0;
    c.group_bodies.assign(groups, static_cast<std::uint32_t>(c.bodies.size()));
  }
  if (some_are_out) std::ranges::replace(c.label, kInvalid, groups);
  sort_by_label(c.label, groups + some_are_out, c.group_begin, c.group_rows);
  if (some_are_out) c.group_begin.pop_back(), c.group_rows.resize(c.group_begin.back());
  c.group_link_begin.clear();
  c.group_links.resize(c.links.size());
  if (!c.links.empty()) sort_by_label(c.link_label, groups, c.group_link_begin, c.group_links);
}

void find_groups(const World& world, StepReport& report, const StepTime&) {
  Contacts& c = *world.contacts;
  world.views->reserve(c.rows.size());
  c.direct.clear();
  partition_rows(c, world.scene.bodies.slots(), world.scene.dials.choice(Dial::groups) != 0);
  report.groups = c.groups();
  for (std::size_t g = 0; g < c.groups(); ++g)
    report.largest_group = std::max<std::uint64_t>(report.largest_group, c.group_begin[g + 1] - c.group_begin[g]);
}

}  // namespace carom::dynamics
