// The signed distance of any two shapes: a specific routine where both are declared, the generic path elsewhere.
#include <algorithm>

#include "collision/narrow/pair.h"
#include "collision/narrow/query.h"
#include "collision/narrow/rounding.h"

namespace carom::collision {
namespace {

/// A contact point as the result of a query.
/// @param swapped  it was found with B first, in B's frame
/// @param slack    m: half the bracket
/// @param asked    m: width of the bracket that is narrow enough
void write_result(const ContactPoint& p, bool swapped, const Frame& b_in_a, Real slack, Real asked,
                  QueryResult& result) {
  result.separation = p.separation;
  result.lower = p.separation - slack;
  result.upper = p.separation + slack;
  result.status = result.upper - result.lower <= asked ? QueryStatus::exact_enough : QueryStatus::rounding;
  result.normal = swapped ? Vec3(-(b_in_a.r * p.normal)) : p.normal;
  result.point_a = swapped ? p.on_b : p.on_a;
  result.point_b = swapped ? p.on_a : p.on_b;
}

void unknown(QueryStatus status, QueryResult& result) {
  result.status = status;
  result.lower = -kInfinity;
  result.upper = kInfinity;
}

}  // namespace

void distance(const Shape& a, const Shape& b, const Frame& b_in_a, const QuerySettings& settings, QueryMemory* memory,
              QueryResult& result, SupportFault& fault) {
  const bool flat_a = a.form == Form::half_space, flat_b = b.form == Form::half_space;
  const PairEntry& entry = pair_entry(a.form, b.form);
  const bool specific = settings.routines && entry.routine;
  if (!specific && !flat_a && !flat_b) return generic_distance(a, b, b_in_a, settings, memory, result, fault);
  result = QueryResult{};
  if (!usable(b_in_a)) return unknown(QueryStatus::rounding, result);
  if (flat_a && flat_b) return unknown(QueryStatus::capped, result);  // two half-spaces: no contract, no claim
  // GJK, without the shells of the hybrid, which a routine does not know either.
  const auto ask_gjk = [&] {
    QuerySettings exact = settings;
    exact.method = Method::gjk_epa;
    generic_distance(a, b, b_in_a, exact, memory, result, fault);
  };
  const bool swapped = specific ? entry.swapped : flat_b;
  const Shape &first = swapped ? b : a, &second = swapped ? a : b;
  const Frame turned_over = swapped ? Frame(b_in_a.r.transpose(), -(b_in_a.r.transpose() * b_in_a.p)) : Frame();
  const Frame& frame = swapped ? turned_over : b_in_a;
  Candidates found;
  std::uint64_t calls = 0;
  if (specific) {
    entry.routine(first, second, frame, kInfinity, found);
  } else if (!half_space_by_support(first, second, frame, kInfinity, false, 0, found, calls, fault)) {
    return unknown(QueryStatus::fault, result);
  }
  const ContactPoint* const nearest = deepest(found);
  // The routine is no judge of shapes apart.
  if (specific && !entry.exact_apart && !nearest) return ask_gjk();
  const Real size = b_in_a.p.abs().sum() + extent(a) + extent(b);
  const Real slack = (kBracketRounding * kUnitRoundoff + (specific ? entry.accuracy : 0)) * size;
  const Real asked = settings.tolerance * size_of_pair(a, b, b_in_a);
  if (specific && entry.accuracy > 0 && 2 * slack > asked && !flat_a && !flat_b) return ask_gjk();  // not exact enough
  result.support_calls = static_cast<int>(calls);
  if (!nearest) return unknown(QueryStatus::rounding, result);  // poses that are no numbers
  write_result(*nearest, swapped, b_in_a, slack, asked, result);
}

}  // namespace carom::collision
