// Questions about two shapes at given poses, without a world.
#include "collision/narrow/query.h"

#include <carom/dial.h>
#include <carom/query.h>

#include "abi/distance.h"
#include "abi/engine.h"
#include "collision/narrow/rounding.h"
#include "collision/scenery/ask.h"
#include "core/float_scope.h"
#include "dynamics/dials.h"

namespace carom::abi {
namespace {

static_assert(static_cast<std::uint32_t>(QueryStatus::exact_enough) == CAROM_QUERY_EXACT_ENOUGH &&
              static_cast<std::uint32_t>(QueryStatus::capped) == CAROM_QUERY_CAPPED &&
              static_cast<std::uint32_t>(QueryStatus::rounding) == CAROM_QUERY_ROUNDING &&
              static_cast<std::uint32_t>(QueryStatus::fault) == CAROM_QUERY_FAULT);
static_assert(static_cast<std::uint32_t>(Simplex::johnson) == CAROM_SIMPLEX_JOHNSON &&
              static_cast<std::uint32_t>(Simplex::voronoi) == CAROM_SIMPLEX_VORONOI &&
              static_cast<std::uint32_t>(Simplex::voronoi_last) == CAROM_SIMPLEX_VORONOI_LAST);
static_assert(static_cast<std::uint32_t>(Method::hybrid) == CAROM_NARROW_HYBRID &&
              static_cast<std::uint32_t>(Method::gjk_epa) == CAROM_NARROW_GJK_EPA);

const DialRow& row(Dial dial) { return dial_table()[static_cast<std::size_t>(dial)]; }

/// Same bounds as the dial of the same name.
bool like_dial(Call& call, int argument, const char* name, double value, Dial dial) {
  return in_range(call, argument, name, value, row(dial).min, row(dial).max);
}

bool check_desc(Call& call, int at, const carom_distance_desc& d) {
  return known(call, at, "desc->simplex", d.simplex, row(Dial::simplex).choice_count) &&
         known(call, at, "desc->narrow_phase", d.narrow_phase, row(Dial::narrow_phase).choice_count) &&
         known(call, at, "desc->pair_routines", d.pair_routines, 2) &&
         like_dial(call, at, "desc->tolerance", d.tolerance, Dial::gjk_tolerance) &&
         like_dial(call, at, "desc->hybrid_margin", d.hybrid_margin, Dial::hybrid_margin) &&
         like_dial(call, at, "desc->gjk_iterations", d.gjk_iterations, Dial::gjk_iterations) &&
         like_dial(call, at, "desc->epa_iterations", d.epa_iterations, Dial::epa_iterations);
}

/// The bracket is of the shapes at the relative pose as it was rounded: widened, it is of the poses that were given.
void widen_by_pose(const Shape& a, const Shape& b, const Frame& b_in_a, Real tolerance, QueryResult& r) {
  const Real slack = kPoseRounding * kUnitRoundoff * (b_in_a.p.norm() + extent(a) + extent(b));
  r.lower -= slack;
  r.upper += slack;
  const bool wide = !(r.upper - r.lower <= tolerance * size_of_pair(a, b, b_in_a));
  if (wide && r.status == QueryStatus::exact_enough) r.status = QueryStatus::rounding;
}

/// From the frames of the two shapes to the world's.
carom_distance distance_of(const QueryResult& r, const Frame& a, const Frame& b) {
  carom_distance out{};
  out.status = static_cast<std::uint32_t>(r.status);
  out.separation = r.separation;
  out.lower = r.lower;
  out.upper = r.upper;
  from_vec3(a.rotate(r.normal), out.normal);
  from_vec3(a.apply(r.point_a), out.point_a);
  from_vec3(b.apply(r.point_b), out.point_b);
  out.gjk_iterations = static_cast<std::uint32_t>(r.gjk_iterations);
  out.epa_iterations = static_cast<std::uint32_t>(r.epa_iterations);
  out.support_calls = static_cast<std::uint32_t>(r.support_calls);
  return out;
}

}  // namespace

bool read_distance_desc(Call& call, int argument, const carom_distance_desc* given, carom_distance_desc& known) {
  carom_distance_desc_init(&known, sizeof known);
  return (!given || read_struct(call, argument, "desc", given, known)) && check_desc(call, argument, known);
}

QuerySettings query_settings(const carom_distance_desc& d) {
  QuerySettings s;
  s.simplex = static_cast<Simplex>(d.simplex);
  s.method = static_cast<Method>(d.narrow_phase);
  s.routines = d.pair_routines;
  s.tolerance = d.tolerance;
  s.margin = d.hybrid_margin;
  s.gjk_cap = static_cast<int>(d.gjk_iterations);
  s.epa_cap = static_cast<int>(d.epa_iterations);
  return s;
}

bool has_distance(Call& call, int argument, const char* what, const Shape& a, const Shape& b) {
  if (a.form == Form::half_space && b.form == Form::half_space)
    return call.fail(CAROM_E_UNSUPPORTED, argument,
                     "two half-spaces%s have no distance: unless parallel they overlap without end", what);
  return !is_scenery(a) || !is_scenery(b) ||
         call.fail(CAROM_E_UNSUPPORTED, argument, "both shapes%s are scenery: one of them has to be convex", what);
}

carom_distance measure_distance(const Shape& a, const Frame& frame_a, const Shape& b, const Frame& frame_b,
                                const QuerySettings& settings) {
  QueryResult found;
  SupportFault fault;
  const Frame b_in_a = relative(frame_a, frame_b);
  any_shape::distance(a, b, b_in_a, settings, nullptr, found, fault);
  widen_by_pose(a, b, b_in_a, settings.tolerance, found);
  return distance_of(found, frame_a, frame_b);
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_distance_desc_init(carom_distance_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_distance_desc& d) {
    d.simplex = CAROM_SIMPLEX_VORONOI_LAST;
    d.narrow_phase = CAROM_NARROW_GJK_EPA;
    d.tolerance = 1e-6;
    d.hybrid_margin = row(Dial::hybrid_margin).initial;
    d.gjk_iterations = 128;
    d.epa_iterations = 256;
  });
}

int32_t carom_shape_distance(carom_engine* engine, carom_shape shape_a, const double position_a[3],
                             const double orientation_a[4], carom_shape shape_b, const double position_b[3],
                             const double orientation_b[4], const carom_distance_desc* desc, carom_distance* result,
                             carom_error* error) {
  return guarded(error, [&](Call& call) {
    carom_distance_desc known_desc;
    if (!present(call, 1, "engine", engine)) return;
    ShapePin a(*engine), b(*engine);
    if (!a.take(call, 2, "shape_a", shape_a) || !carom::abi::finite(call, 3, "position_a", position_a, 3) ||
        !unit(call, 4, "orientation_a", orientation_a, 4) || !b.take(call, 5, "shape_b", shape_b) ||
        !carom::abi::finite(call, 6, "position_b", position_b, 3) ||
        !unit(call, 7, "orientation_b", orientation_b, 4) || !read_distance_desc(call, 8, desc, known_desc) ||
        !fillable(call, 9, "result", result) || !has_distance(call, 5, "", *a, *b))
      return;
    const FloatScope scope;
    const Frame frame_a(Pose{to_quat(orientation_a), to_vec3(position_a)});
    const Frame frame_b(Pose{to_quat(orientation_b), to_vec3(position_b)});
    write_struct(measure_distance(*a, frame_a, *b, frame_b, query_settings(known_desc)), result);
  });
}

}  // extern "C"
