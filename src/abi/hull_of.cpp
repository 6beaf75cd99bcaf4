// A hull of shapes that the engine has: handles and placements checked, parts kept while it is made.
#include "collision/hull_of.h"

#include <carom/shape.h>

#include <algorithm>

#include "abi/engine.h"
#include "abi/shape_draft.h"

namespace carom::abi {
namespace {

constexpr double kFarthest = 1e8;                   // m: as a hull's points
constexpr double kSmallest = 1e-6, kLargest = 1e6;  // scale

/// HeldParts that stay while this lives.
class HeldParts {
 public:
  explicit HeldParts(carom_engine& engine) : engine_(engine), held_(&engine.memory) {}
  ~HeldParts() {
    const std::lock_guard lock(engine_.mutex);
    for (const Shape* part : held_) engine_.shapes[handle_slot(part->handle)].uses -= 1;
  }
  HeldParts(const HeldParts&) = delete;
  HeldParts& operator=(const HeldParts&) = delete;

  bool take(Call& call, std::span<const carom_shape> handles) {
    held_.reserve(handles.size());
    const std::lock_guard lock(engine_.mutex);
    for (const carom_shape handle : handles) {
      if (!resolve(call, 2, "parts", engine_.shape_slots, handle)) return false;
      ShapeRecord& record = engine_.shapes[handle_slot(handle)];
      record.uses += 1;
      held_.push_back(record.shape);
    }
    return true;
  }
  std::span<const Shape* const> get() const { return held_; }

 private:
  carom_engine& engine_;
  Array<const Shape*> held_;
};

/// As HullOf::numbers.
void gather(std::uint64_t count, const double* positions, const double* orientations, const double* scales,
            double radius, Array<double>& numbers) {
  numbers.assign(1 + HullOf::kNumbers * count, 0);
  numbers[0] = radius;
  for (std::uint64_t i = 0; i < count; ++i) {
    double* const to = &numbers[1 + HullOf::kNumbers * i];
    to[6] = to[7] = to[8] = to[9] = 1;
    if (positions) std::copy_n(positions + 3 * i, 3, to);
    if (orientations) std::copy_n(orientations + 4 * i, 4, to + 3);
    if (scales) std::copy_n(scales + 3 * i, 3, to + 7);
  }
}

bool check_part(Call& call, const Shape& s, std::size_t i) {
  if (s.form == Form::half_space || is_scenery(s))
    return call.fail(CAROM_E_UNSUPPORTED, 2, "parts[%zu] is %s, which has no support points", i,
                     is_scenery(s) ? "a mesh or a height field" : "a half-space");
  return !s.hull_of || s.hull_of->depth < HullOf::kMostDepth ||
         call.fail(CAROM_E_LIMIT, 2, "parts[%zu] is a hull of hulls, %d deep", i, s.hull_of->depth) ||
         call.advise("give the parts of the inner hulls instead");
}

bool check_scale(Call& call, const double scale[3], std::size_t i) {
  if (!finite(call, 6, "scales", scale, 3)) return false;
  const Vec3 s = to_vec3(scale).abs();
  return (s.min_entry() >= kSmallest && s.max_entry() <= kLargest) ||
         call.fail(CAROM_E_OUT_OF_RANGE, 6, "the scale of part %zu is %g, %g, %g: sizes are %g to %g", i, scale[0],
                   scale[1], scale[2], kSmallest, kLargest);
}

}  // namespace

bool check_hull_of(Call& call, std::span<const Shape* const> parts, std::span<const double> numbers) {
  if (!in_range(call, 7, "radius", numbers[0], 0, kFarthest)) return false;
  std::size_t calls = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const double* const x = &numbers[1 + HullOf::kNumbers * i];
    if (!check_part(call, *parts[i], i) || !vector_in_range(call, 4, "positions", x, kFarthest) ||
        !unit(call, 5, "orientations", x + 3, 4) || !check_scale(call, x + 7, i))
      return false;
    calls += parts[i]->hull_of ? parts[i]->hull_of->calls : 1;
  }
  return calls <= HullOf::kMostParts ||
         call.fail(CAROM_E_LIMIT, 2, "%zu parts with those of inner hulls, more than %zu", calls, HullOf::kMostParts) ||
         call.advise("make one hull of fewer parts: those that lie inside others add nothing");
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_shape_create_hull_of(carom_engine* engine, const carom_shape* parts, uint64_t count,
                                   const double* positions, const double* orientations, const double* scales,
                                   double radius, carom_shape* shape, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 2, "parts", parts)) return;
    if (count < 1 || count > HullOf::kMostParts) {
      call.fail(CAROM_E_OUT_OF_RANGE, 3, "count is %llu, not 1 to %llu", static_cast<unsigned long long>(count),
                static_cast<unsigned long long>(HullOf::kMostParts));
      return;
    }
    if (!present(call, 8, "shape", shape)) return;
    Array<double> numbers(&engine->memory);
    gather(count, positions, orientations, scales, radius, numbers);
    HeldParts held(*engine);
    ShapeDraft draft(&engine->memory);
    if (held.take(call, {parts, static_cast<std::size_t>(count)}) && check_hull_of(call, held.get(), numbers) &&
        draft_hull_of(call, held.get(), numbers, draft))
      add_shape(call, *engine, draft, shape);
  });
}

int32_t carom_shape_get_parts(carom_engine* engine, carom_shape shape, carom_shape* parts, double* positions,
                              double* orientations, double* scales, uint64_t* count, double* radius,
                              carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine) || !present(call, 7, "count", count)) return;
    const std::lock_guard lock(engine->mutex);
    if (!resolve(call, 2, "shape", engine->shape_slots, shape)) return;
    const HullOf* const hull = engine->shapes[handle_slot(shape)].shape->hull_of.get();
    const std::uint64_t n = hull ? hull->parts.size() : 0, capacity = *count;
    *count = n;
    if (parts && capacity < n) {
      call.fail(CAROM_E_BUFFER_TOO_SMALL, 7, "capacity for %llu parts, the shape has %llu",
                static_cast<unsigned long long>(capacity), static_cast<unsigned long long>(n));
      return;
    }
    if (radius) *radius = hull ? hull->numbers[0] : 0;
    for (std::uint64_t i = 0; parts && i < n; ++i) {
      const double* const from = &hull->numbers[1 + HullOf::kNumbers * i];
      parts[i] = hull->parts[i].shape->handle;
      if (positions) std::copy_n(from, 3, positions + 3 * i);
      if (orientations) std::copy_n(from + 3, 4, orientations + 4 * i);
      if (scales) std::copy_n(from + 7, 3, scales + 3 * i);
    }
  });
}

}  // extern "C"
