// Contact groups by union-find.
#include "dynamics/island.h"

#include <algorithm>
#include <atomic>

#include "dynamics/contact_views.h"

namespace carom::dynamics {
namespace {

constexpr std::size_t kContactPairsAPart = 512;

/// Counting sort: groups begin as their ends, and members are put in from the last to the first.
void sort_by_label(const Array<std::uint32_t>& label, std::uint32_t groups, Array<std::uint32_t>& begin,
                   Array<std::uint32_t>& members) {
  begin.assign(groups + 1, 0);
  for (const std::uint32_t g : label) ++begin[g];
  for (std::uint32_t g = 0; g < groups; ++g) begin[g + 1] += begin[g];
  for (std::size_t i = label.size(); i-- > 0;) members[--begin[label[i]]] = static_cast<std::uint32_t>(i);
}

/// Trees of bodies that hang together, grown by any number of threads at a time. A parent is a lower slot, and is only
/// ever replaced by a lower one above it. So roots are the lowest slots of all, whoever joins what first.
class SharedTrees {
 public:
  explicit SharedTrees(Array<std::uint32_t>& parent) : parent_(parent) {}

  void plant(std::uint32_t body) { at(body).store(body, std::memory_order_relaxed); }
  std::uint32_t root(std::uint32_t i) {
    while (true) {
      const std::uint32_t above = at(i).load(std::memory_order_relaxed);
      if (above == i) return i;
      const std::uint32_t next = at(above).load(std::memory_order_relaxed);
      if (next != above) at(i).store(next, std::memory_order_relaxed);
      i = next;
    }
  }
  void join(std::uint32_t a, std::uint32_t b) {
    while ((a = root(a)) != (b = root(b))) {
      std::uint32_t &higher = a > b ? a : b, lower = std::min(a, b), was = higher;
      if (at(higher).compare_exchange_weak(was, lower, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::atomic_ref<std::uint32_t> at(std::uint32_t i) { return std::atomic_ref<std::uint32_t>(parent_[i]); }
  Array<std::uint32_t>& parent_;
};

/// Contacts::pair_group and link_label by bodies that hang together; GroupSize::bodies.   @return how many groups
std::uint32_t find_islands(Contacts& c, std::size_t body_slots, Jobs* jobs) {
  const std::size_t pairs = c.contact_pairs.size();
  c.parent.resize(body_slots), c.cursor.resize(body_slots);
  SharedTrees trees(c.parent);
  in_parallel(jobs, pairs, kContactPairsAPart,
              [&](std::uint32_t i) {  // bodies without rows stay out of it, sleepers among them
                trees.plant(c.contact_pairs[i].a), trees.plant(c.contact_pairs[i].b);
              });
  for (const Link& l : c.links) {
    if (l.moves_a) trees.plant(l.a);
    if (l.moves_b) trees.plant(l.b);
  }
  const auto join = [&](const auto& both) {
    if (both.moves_a && both.moves_b) trees.join(both.a, both.b);
  };
  const auto root = [&](const auto& both) { return trees.root(both.moves_a ? both.a : both.b); };
  in_parallel(jobs, pairs, kContactPairsAPart, [&](std::uint32_t i) { join(c.contact_pairs[i]); });
  for (const Link& l : c.links) join(l);
  in_parallel(jobs, pairs, kContactPairsAPart, [&](std::uint32_t i) { c.pair_group[i] = root(c.contact_pairs[i]); });

  // Numbers by the first pair, in the cursor of a root.
  for (const std::uint32_t r : c.pair_group) c.cursor[r] = kInvalid;
  for (const Link& l : c.links) c.cursor[root(l)] = kInvalid;
  std::uint32_t groups = 0;
  const auto number = [&](std::uint32_t r) {
    if (c.cursor[r] == kInvalid) c.cursor[r] = groups++;
    return c.cursor[r];
  };
  for (std::uint32_t& of : c.pair_group) of = number(of);
  for (std::size_t i = 0; i < c.links.size(); ++i) c.link_label[i] = number(root(c.links[i]));
  c.group_size.assign(groups, {});
  for (const std::uint32_t body : c.bodies) ++c.group_size[c.cursor[trees.root(body)]].bodies;
  return groups;
}

/// Rows of groups, ascending, and the group of each row.
void list_rows(Contacts& c, std::uint32_t groups, Jobs* jobs) {
  const std::size_t pairs = c.contact_pairs.size();
  c.group_begin.assign(groups + 1, 0);
  for (std::size_t i = 0; i < pairs; ++i) {
    c.group_begin[c.pair_group[i]] += c.contact_pairs[i].count;
    ++c.group_size[c.pair_group[i]].pairs;
  }
  for (std::uint32_t g = 0; g < groups; ++g) c.group_begin[g + 1] += c.group_begin[g];
  c.pair_begin.resize(pairs);
  for (std::size_t i = pairs; i-- > 0;) c.pair_begin[i] = c.group_begin[c.pair_group[i]] -= c.contact_pairs[i].count;
  remake(c.group_rows, c.group_begin.back());
  if (c.group_rows.size() < c.rows.size()) std::ranges::fill(c.label, groups);  // of those that are out of this pass
  in_parallel(jobs, pairs, kContactPairsAPart, [&](std::uint32_t i) {
    const ContactPair& m = c.contact_pairs[i];
    for (std::uint32_t k = 0; k < m.count; ++k) {
      c.label[m.row + k] = c.pair_group[i];
      c.group_rows[c.pair_begin[i] + k] = m.row + k;
    }
  });
}

}  // namespace

std::uint32_t root_of(Array<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

std::uint32_t group_of(Contacts& c, std::uint32_t body) { return c.is_grouped ? c.cursor[root_of(c.parent, body)] : 0; }

std::uint32_t island_of(Contacts& c, std::uint32_t body) { return root_of(c.parent, body); }

void partition_rows(Contacts& c, std::size_t body_slots, bool grouped, Jobs* jobs) {
  remake(c.label, c.rows.size()), c.link_label.resize(c.links.size()), c.pair_group.resize(c.contact_pairs.size());
  c.is_grouped = grouped;
  std::uint32_t groups;
  if (grouped) {
    groups = find_islands(c, body_slots, jobs);
  } else {
    std::ranges::fill(c.pair_group, 0), std::ranges::fill(c.link_label, 0);
    groups = c.contact_pairs.empty() && c.links.empty() ? 0 : 1;
    c.group_size.assign(groups, {.bodies = static_cast<std::uint32_t>(c.bodies.size())});
  }
  list_rows(c, groups, jobs);
  c.group_link_begin.clear();
  c.group_links.resize(c.links.size());
  if (!c.links.empty()) sort_by_label(c.link_label, groups, c.group_link_begin, c.group_links);
}

void find_groups(const World& world, StepReport& report, const StepTime&) {
  Contacts& c = *world.contacts;
  world.views->reserve(c.rows.size());
  c.direct.clear();
  partition_rows(c, world.scene.bodies.slots(), world.scene.dials.choice(Dial::groups) != 0, world.jobs);
  report.groups = c.groups();
  for (std::size_t g = 0; g < c.groups(); ++g)
    report.largest_group = std::max<std::uint64_t>(report.largest_group, c.group_begin[g + 1] - c.group_begin[g]);
}

}  // namespace carom::dynamics
