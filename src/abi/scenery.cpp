// Scenery: meshes and height fields, checked, copied, made ready.
#include <carom/scenery.h>

#include <algorithm>
#include <cmath>

#include "abi/engine.h"
#include "core/float_scope.h"
#include "abi/shape_draft.h"
#include "collision/scenery/triangle_shape.h"

namespace carom::abi {
namespace {

constexpr double kFarthest = 1e8;                     // m: a tenth of what shapes may reach
constexpr std::uint64_t kMostTriangles = 1ull << 28;  // the tree counts in 31 bits, sides take three numbers each
constexpr std::uint32_t kMostAcross = 1u << 14;       // triangles of a height field are counted alike
constexpr std::uint64_t kMostVertices = 0xFFFFFFFEull;

/// A height or a coordinate; a hole's height is no number.
bool within(Call& call, const char* name, std::uint64_t i, double x) {
  if (std::fabs(x) <= kFarthest) return true;
  return call.fail(std::isfinite(x) ? CAROM_E_OUT_OF_RANGE : CAROM_E_NOT_FINITE, 2,
                   "%s[%llu] is %g; at most %g is taken", name, static_cast<unsigned long long>(i), x, kFarthest);
}

bool count_in(Call& call, const char* name, std::uint64_t n, std::uint64_t least, std::uint64_t most) {
  return (n >= least && n <= most) ||
         call.fail(CAROM_E_OUT_OF_RANGE, 2, "%s is %llu, outside [%llu, %llu]", name,
                   static_cast<unsigned long long>(n), static_cast<unsigned long long>(least),
                   static_cast<unsigned long long>(most));
}

bool check(Call& call, const carom_mesh_desc& d) {
  if (!only_bits(call, 2, "desc->flags", d.flags, CAROM_SCENERY_TWO_SIDED) ||
      !count_in(call, "desc->vertex_count", d.vertex_count, 3, kMostVertices) ||
      !count_in(call, "desc->triangle_count", d.triangle_count, 1, kMostTriangles) ||
      !present(call, 2, "desc->vertices", d.vertices) || !present(call, 2, "desc->triangles", d.triangles))
    return false;
  for (std::uint64_t i = 0; i < 3 * d.vertex_count; ++i)
    if (!within(call, "desc->vertices", i, d.vertices[i])) return false;
  for (std::uint64_t i = 0; i < 3 * d.triangle_count; ++i)
    if (d.triangles[i] >= d.vertex_count)
      return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->triangles[%llu] is %u, of %llu vertices",
                       static_cast<unsigned long long>(i), d.triangles[i],
                       static_cast<unsigned long long>(d.vertex_count));
  return true;
}

bool check(Call& call, const carom_height_field_desc& d) {
  if (!only_bits(call, 2, "desc->flags", d.flags, 0) || !count_in(call, "desc->columns", d.columns, 2, kMostAcross) ||
      !count_in(call, "desc->rows", d.rows, 2, kMostAcross) || !present(call, 2, "desc->heights", d.heights) ||
      !in_range(call, 2, "desc->spacing[0]", d.spacing[0], 1e-9, kFarthest / d.columns) ||
      !in_range(call, 2, "desc->spacing[1]", d.spacing[1], 1e-9, kFarthest / d.rows))
    return false;
  const std::uint64_t n = std::uint64_t(d.columns) * d.rows;
  for (std::uint64_t i = 0; i < n; ++i)
    if (!std::isnan(d.heights[i]) && !within(call, "desc->heights", i, d.heights[i])) return false;
  return true;
}

template <class Make>
bool draft_scenery(Call& call, ShapeDraft& draft, const Make& make) {
  const FloatScope scope;
  Memory* const memory = draft.memory;
  auto scenery = std::allocate_shared<Scenery>(std::pmr::polymorphic_allocator<Scenery>(memory), memory);
  make(*scenery);
  if (!(scenery->bounds.lo.x() <= scenery->bounds.hi.x()))
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "nothing is left: no triangle has an area");
  make_scenery(std::move(scenery), *draft.shape);
  return true;
}

template <class Desc, class Draft>
void create(Call& call, carom_engine* engine, const Desc* given, Desc d, carom_shape* shape, const Draft& make) {
  if (!present(call, 1, "engine", engine) || !read_struct(call, 2, "desc", given, d) ||
      !present(call, 3, "shape", shape))
    return;
  ShapeDraft draft(&engine->memory);
  if (make(call, d, draft)) add_shape(call, *engine, draft, shape);
}

/// Scenery of a shape, which is kept alive by the pin.
const Scenery* scenery_of(Call& call, ShapePin& pin, carom_shape shape) {
  if (!pin.take(call, 2, "shape", shape)) return nullptr;
  if (!is_scenery(*pin)) call.fail(CAROM_E_UNSUPPORTED, 2, "the shape is convex: it has no triangles");
  return pin->scenery.get();
}

std::uint64_t boundary_edges_of(const Scenery& s) {
  if (!s.is_field()) return static_cast<std::uint64_t>(std::count(s.beyond.begin(), s.beyond.end(), kInvalid));
  std::uint64_t edges = 0;
  Triangle triangle;
  for (std::uint32_t i = 0; i < s.triangles(); ++i)
    if (s.triangle(i, triangle))
      edges += static_cast<std::uint64_t>(triangle.boundary[0]) + triangle.boundary[1] + triangle.boundary[2];
  return edges;
}

}  // namespace

bool draft_mesh(Call& call, const carom_mesh_desc& d, ShapeDraft& draft, std::uint32_t dropped) {
  return check(call, d) && draft_scenery(call, draft, [&](Scenery& s) {
           make_mesh({d.vertices, 3 * std::size_t(d.vertex_count)}, {d.triangles, 3 * std::size_t(d.triangle_count)},
                     (d.flags & CAROM_SCENERY_TWO_SIDED) != 0, s);
           s.dropped += dropped;
         });
}

bool draft_height_field(Call& call, const carom_height_field_desc& d, ShapeDraft& draft) {
  return check(call, d) && draft_scenery(call, draft, [&](Scenery& s) {
           make_height_field({d.heights, std::size_t(d.columns) * d.rows}, d.columns, d.rows, d.spacing[0],
                             d.spacing[1], s);
         });
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_mesh_desc_init(carom_mesh_desc* desc, uint32_t struct_size) { return init_struct(desc, struct_size); }

int32_t carom_height_field_desc_init(carom_height_field_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_height_field_desc& d) { d.spacing[0] = d.spacing[1] = 1; });
}

int32_t carom_shape_create_mesh(carom_engine* engine, const carom_mesh_desc* desc, carom_shape* shape,
                                carom_error* error) {
  return guarded(error, [&](Call& call) {
    carom_mesh_desc defaults;
    carom_mesh_desc_init(&defaults, sizeof defaults);
    create(call, engine, desc, defaults, shape,
           [](Call& c, const carom_mesh_desc& d, ShapeDraft& draft) { return draft_mesh(c, d, draft); });
  });
}

int32_t carom_shape_create_height_field(carom_engine* engine, const carom_height_field_desc* desc, carom_shape* shape,
                                        carom_error* error) {
  return guarded(error, [&](Call& call) {
    carom_height_field_desc defaults;
    carom_height_field_desc_init(&defaults, sizeof defaults);
    create(call, engine, desc, defaults, shape, draft_height_field);
  });
}

int32_t carom_shape_get_scenery_info(carom_engine* engine, carom_shape shape, carom_scenery_info* info,
                                     carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !fillable(call, 3, "info", info)) return;
    ShapePin pin(*engine);
    const Scenery* const s = scenery_of(call, pin, shape);
    if (!s) return;
    carom_scenery_info full{};
    full.flags = s->two_sided ? CAROM_SCENERY_TWO_SIDED : 0;
    full.triangles = s->triangles();
    full.vertices = s->is_field() ? s->heights.size() : s->vertex.size();
    full.dropped = s->dropped;
    full.boundary_edges = boundary_edges_of(*s);
    full.bytes = s->bytes();
    write_struct(full, info);
  });
}

int32_t carom_shape_get_triangles(carom_engine* engine, carom_shape shape, uint64_t first, double* corners,
                                  uint64_t* count, uint64_t* next, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 5, "count", count) || !present(call, 6, "next", next))
      return;
    ShapePin pin(*engine);
    const Scenery* const s = scenery_of(call, pin, shape);
    if (!s) return;
    if (first > s->triangles()) {
      call.fail(CAROM_E_OUT_OF_RANGE, 3, "first is %llu, of %u triangles", static_cast<unsigned long long>(first),
                s->triangles());
      return;
    }
    const std::uint64_t space = corners ? *count : s->triangles();
    std::uint64_t written = 0;
    auto at = static_cast<std::uint32_t>(first);
    Triangle triangle;
    for (; at < s->triangles() && written < space; ++at) {
      if (!s->triangle(at, triangle)) continue;
      for (int k = 0; corners && k < 3; ++k)
        from_vec3(triangle.corner[static_cast<std::size_t>(k)], corners + 9 * written + 3 * k);
      ++written;
    }
    *count = written, *next = at;
  });
}

}  // extern "C"
