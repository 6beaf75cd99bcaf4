// The dispatch table of pair routines, filled once at compile time from the list below, both orders.
#include "collision/narrow/pair.h"

#include <array>

namespace carom::collision {
namespace {

constexpr std::size_t kForms = static_cast<std::size_t>(Form::count);
using Table = std::array<std::array<PairEntry, kForms>, kForms>;

constexpr void enter(Table& table, Form a, Form b, PairRoutine routine, Real accuracy = 0, bool exact_apart = true) {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  table[j][i] = {routine, true, exact_apart, accuracy};
  table[i][j] = {routine, false, exact_apart, accuracy};  // last, so that a pair of equal forms is not swapped
}

constexpr Table make_table() {
  // Edges that enclose less than 1e-8 rad count as parallel, cores nearer than 1e-8 of the size as touching,
  // rims tilted by less than 1e-9 rad as level; each routine says why beside its constant.
  constexpr Real kEdges = 2e-8, kNoAxes = 2e-8, kRim = 1e-9;
  Table t{};
  enter(t, Form::sphere, Form::sphere, contact_sphere_sphere);
  enter(t, Form::box, Form::sphere, contact_box_sphere);
  enter(t, Form::capsule, Form::sphere, contact_capsule_sphere);
  enter(t, Form::capsule, Form::capsule, contact_capsule_capsule, kNoAxes);
  enter(t, Form::box, Form::capsule, contact_box_capsule, kEdges);
  enter(t, Form::box, Form::box, contact_box_box, kEdges, false);
  enter(t, Form::half_space, Form::sphere, contact_half_space_sphere);
  enter(t, Form::half_space, Form::capsule, contact_half_space_capsule);
  enter(t, Form::half_space, Form::box, contact_half_space_box);
  enter(t, Form::half_space, Form::cylinder, contact_half_space_cylinder, kRim);
  enter(t, Form::half_space, Form::cone, contact_half_space_cone, kRim);
  enter(t, Form::half_space, Form::ellipsoid, contact_half_space_ellipsoid);
  enter(t, Form::half_space, Form::polytope, contact_half_space_polytope);
  return t;
}

constexpr Table kTable = make_table();

}  // namespace

const PairEntry& pair_entry(Form a, Form b) { return kTable[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)]; }

}  // namespace carom::collision
