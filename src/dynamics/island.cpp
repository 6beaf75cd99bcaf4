// Contact groups by union-find.
#include "dynamics/island.h"

#include <algorithm>

namespace carom {
namespace {

/// Root of a body's tree; halves the path, so that later searches are short.
std::uint32_t root(Array<std::uint32_t>& parent, std::uint32_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

std::uint32_t island_of(Contacts& c, std::uint32_t body) { return root(c.parent, body); }

void partition_rows(Contacts& c, std::size_t body_slots, bool grouped) {
  constexpr std::uint32_t kNone = 0xFFFFFFFFu;
  const std::size_t n = c.rows.size();
  c.group_begin.clear();
  c.group_rows.resize(n);
  c.label.resize(n);
  std::uint32_t groups = 0;
  if (grouped) {
    c.parent.resize(body_slots), c.cursor.resize(body_slots);
    for (const Meeting& m : c.meetings) {  // bodies without rows stay out of it, sleepers among them
      c.parent[m.a] = m.a, c.parent[m.b] = m.b;
      c.cursor[m.a] = c.cursor[m.b] = kNone;  // scratch: group of a root
    }
    for (const Meeting& m : c.meetings) {
      if (!m.moves_a || !m.moves_b) continue;
      const std::uint32_t a = root(c.parent, m.a), b = root(c.parent, m.b);
      // The lower slot is the root whatever the order of unions: labels depend on the contacts alone.
      if (a < b) c.parent[b] = a;
      if (b < a) c.parent[a] = b;
    }
    for (const Meeting& m : c.meetings) {
      const std::uint32_t r = root(c.parent, m.moves_a ? m.a : m.b);
      if (c.cursor[r] == kNone) c.cursor[r] = groups++;
      std::fill_n(c.label.begin() + m.row, m.count, c.cursor[r]);
    }
    c.group_bodies.assign(groups, 0);
    for (const std::uint32_t body : c.bodies) ++c.group_bodies[c.cursor[root(c.parent, body)]];
  } else {
    c.label.assign(n, 0);
    groups = n ? 1 : 0;
    c.group_bodies.assign(groups, static_cast<std::uint32_t>(c.bodies.size()));
  }
  // Counting sort by label: groups begin as their ends, and rows are put in from the last to the first.
  c.group_begin.assign(groups + 1, 0);
  for (std::size_t i = 0; i < n; ++i) ++c.group_begin[c.label[i]];
  for (std::uint32_t g = 0; g < groups; ++g) c.group_begin[g + 1] += c.group_begin[g];
  for (std::size_t i = n; i-- > 0;) c.group_rows[--c.group_begin[c.label[i]]] = static_cast<std::uint32_t>(i);
}

void find_groups(World& world, const StepTime& time) {
  Contacts& c = *world.contacts;
  build_rows(world, time.h);
  c.direct.clear();
  partition_rows(c, world.scene.bodies.slots(), world.scene.dials.choice(Dial::groups) != 0);
  world.report.groups = c.groups();
  for (std::size_t g = 0; g < c.groups(); ++g)
    world.report.largest_group =
        std::max<std::uint64_t>(world.report.largest_group, c.group_begin[g + 1] - c.group_begin[g]);
}

}  // namespace carom
