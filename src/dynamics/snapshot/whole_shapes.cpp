#include "dynamics/snapshot/whole_shapes.h"

#include <algorithm>

#include "collision/hull_of.h"
#include "collision/scenery/scenery.h"

namespace carom::dynamics::snapshot {
namespace {

/// Longest id of a plugin.
constexpr std::size_t kLongestId = 200;

ShapeImage::Kind kind_of(const Shape& s) {
  if (s.form == Form::half_space) return ShapeImage::half_space;
  if (s.hull_of) return ShapeImage::hull_of;
  if (!is_scenery(s)) return ShapeImage::of_plugin;
  return s.scenery->is_field() ? ShapeImage::height_field : ShapeImage::mesh;
}

/// Numbers that are of a shape's own, without a copy.
std::span<const double> numbers_of(const Shape& s, std::array<double, 4>& plane) {
  switch (kind_of(s)) {
    case ShapeImage::half_space:
      plane = {s.normal.x(), s.normal.y(), s.normal.z(), s.offset};
      return plane;
    case ShapeImage::mesh:
      return {reinterpret_cast<const double*>(s.scenery->vertex.data()), 3 * s.scenery->vertex.size()};
    case ShapeImage::height_field:
      return s.scenery->heights;
    case ShapeImage::hull_of:
      return s.hull_of->numbers;
    default:
      return s.params;
  }
}
static_assert(sizeof(Vec3) == 3 * sizeof(double));

}  // namespace

void save_shape(Saver& io, const Shape& shape, std::span<const Shape* const> before, const ShapeNames& names) {
  std::string_view plugin;
  std::uint32_t version = 0;
  const bool named = names.name(shape, plugin, version);
  const ShapeImage::Kind kind = named ? kind_of(shape) : ShapeImage::known;
  io.value(static_cast<std::uint8_t>(kind));
  if (!named) return;
  if (kind == ShapeImage::of_plugin) io.value(version), list(io, plugin);
  std::array<double, 4> plane;
  const std::span<const double> numbers = numbers_of(shape, plane);
  list(io, numbers);
  if (kind == ShapeImage::hull_of)
    for (const HullOf::Part& part : shape.hull_of->parts)
      io.value(static_cast<std::uint32_t>(std::ranges::find(before, part.shape) - before.begin()));
  if (!is_scenery(shape)) return;
  const Scenery& s = *shape.scenery;
  if (kind == ShapeImage::mesh)
    io.value(static_cast<std::uint8_t>(s.two_sided)), io.value(s.dropped), list(io, s.corner);
  if (kind == ShapeImage::height_field)
    io.value(s.columns), io.value(s.rows), io.value(s.spacing_x), io.value(s.spacing_z);
}

void build_shape(Checker& io, Builder& b) {
  Memory* const memory = b.world.memory;
  ShapeImage image;
  const auto kind = io.value(std::uint8_t(0));
  io.demand(kind < ShapeImage::count);
  image.kind = static_cast<ShapeImage::Kind>(kind);
  Array<char> id(memory);
  Array<double> numbers(memory);
  Array<std::uint32_t> corners(memory);
  if (image.kind == ShapeImage::of_plugin) {
    image.version = io.value(0u);
    list(io, id);
    io.demand(!id.empty() && id.size() <= kLongestId && std::ranges::count(id, '\0') == 0);
  }
  if (image.kind != ShapeImage::known) list(io, numbers);
  if (image.kind == ShapeImage::mesh) {
    image.two_sided = yes_or_no(io, false), image.dropped = io.value(0u);
    list(io, corners);
  }
  if (image.kind == ShapeImage::height_field) {
    image.columns = io.value(0u), image.rows = io.value(0u);
    image.spacing_x = io.value(0.0), image.spacing_z = io.value(0.0);
    io.demand(std::uint64_t(image.columns) * image.rows == numbers.size());
  }
  Array<const Shape*> parts(memory);
  if (image.kind == ShapeImage::hull_of) {
    io.demand(numbers.size() % HullOf::kNumbers == 1 && numbers.size() > 1);
    for (std::size_t n = numbers.size() / HullOf::kNumbers; n > 0 && !io.bad(); --n) {
      const std::uint32_t part = io.value(0u);
      io.demand(part < b.shape.size());
      if (!io.bad()) parts.push_back(b.shape[part]);
    }
    image.parts = parts;
  }
  io.demand(image.kind != ShapeImage::half_space || numbers.size() == 4);
  if (io.bad()) return;
  image.plugin = {id.data(), id.size()}, image.numbers = numbers, image.corners = corners;
  const Shape* const made = b.shapes.make(b.shape.size(), image, b.fault);
  io.demand(made && (image.kind == ShapeImage::known || kind_of(*made) == image.kind));
  b.shape.push_back(made);
}

}  // namespace carom::dynamics::snapshot
