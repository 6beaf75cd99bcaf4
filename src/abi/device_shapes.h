// Shapes as a device has them: records, and the numbers that they point to, side by side.
#pragma once

#include "collision/core.h"
#include "core/memory.h"

namespace carom::abi {

/// As carom_shape_data of device/pairs.c, whose comments say what is what.
struct ShapeData {
  double core_radius, bounding_radius, radius, half_height, extents[3], middle[3], limit2;
  std::uint64_t numbers, number_count, corners, links;
  std::uint32_t form, plugin, smooth, faceted, points, cells;
};
static_assert(sizeof(ShapeData) == 144, "no gaps, on no compiler");

struct DeviceShapes {
  static constexpr std::uint32_t kLeft = 0xFFFFFFFFu;  // in place of a shape: the host does its pairs
  static constexpr std::size_t kCornerWords = 5;

  explicit DeviceShapes(Memory* memory) : records(memory), numbers(memory), corners(memory), links(memory) {}

  /// @param plugin  number of its plugin's text, where it has no form
  void add(const Shape& shape, std::uint32_t plugin);

  Array<ShapeData> records;
  Array<double> numbers;
  Array<std::int64_t> corners;
  Array<std::uint32_t> links;
};

}  // namespace carom::abi
