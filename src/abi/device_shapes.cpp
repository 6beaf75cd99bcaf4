// Shapes for a device.
#include "abi/device_shapes.h"

#include <algorithm>

#include "collision/narrow/secant.h"

namespace carom::abi {

void DeviceShapes::add(const Shape& s, std::uint32_t plugin) {
  ShapeData d{};
  d.core_radius = s.core_radius, d.bounding_radius = s.bounding_radius;
  d.radius = s.radius, d.half_height = s.half_height, d.limit2 = Core::limit2(s);
  const Vec3 middle = 0.5 * (s.bounds.lo + s.bounds.hi);
  std::copy_n(s.half.data(), 3, d.extents);
  std::copy_n(middle.data(), 3, d.middle);
  const Form form = Core::own_form(s);
  d.form = static_cast<std::uint32_t>(form);
  d.plugin = plugin;
  d.smooth = GuessPolicy::smooth(s.form), d.faceted = GuessPolicy::faceted(s.form);
  d.numbers = numbers.size();
  if (form == Form::polytope) {
    const FarthestVertex::Parts parts = s.farthest.parts();
    d.points = parts.count;
    const bool climbs = s.farthest.climbs();
    const std::span<const double> coordinates = climbs ? s.vertices : parts.coordinates;
    numbers.insert(numbers.end(), coordinates.begin(), coordinates.end());
    d.number_count = coordinates.size() / 3;
    if (climbs) {
      d.cells = parts.cells;
      d.corners = corners.size() / kCornerWords, d.links = links.size();
      for (const FarthestVertex::Corner& c : parts.corners)
        corners.insert(corners.end(),
                       {c.x, c.y, c.z, static_cast<std::int64_t>(c.first), static_cast<std::int64_t>(c.point)});
      links.insert(links.end(), parts.guesses.begin(), parts.guesses.end());
      links.insert(links.end(), parts.neighbours.begin(), parts.neighbours.end());
    }
  } else if (form == Form::none) {
    numbers.insert(numbers.end(), s.params.begin(), s.params.end());
    d.number_count = s.params.size();
  }
  records.push_back(d);
}

}  // namespace carom::abi
