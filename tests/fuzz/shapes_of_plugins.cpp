// Shapes as the engine would make them of the plugins in plugins/, whose code is linked in; and a few that lie.
#include <carom/plugin.h>

#include "../pair_cases.h"
#include "pair_case.h"

// Every plugin exports the same name; the build gives each its own here.
extern "C" {
extern const carom_shape_plugin carom_plugin_sphere, carom_plugin_capsule, carom_plugin_box, carom_plugin_cylinder,
    carom_plugin_cone, carom_plugin_ellipsoid, carom_plugin_hull, carom_plugin_template;
}

namespace carom::fuzz {
namespace {

/// A box that misbehaves in a cone of directions about (1, 1, 1).
template <Lie lie>
std::int32_t lying_box(void*, const double* p, std::uint64_t count, const double* d, double* out) {
  const double norm = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  carom_plugin_box.support(nullptr, p, count, d, out);
  if (lie == Lie::single) {
    for (int i = 0; i < 3; ++i) out[i] = static_cast<double>(static_cast<float>(out[i]));
    return 0;
  }
  if (!(d[0] + d[1] + d[2] > 1.5 * norm)) return 0;
  if (lie == Lie::error) return 1;
  for (int i = 0; i < 3; ++i)
    out[i] = lie == Lie::not_a_number ? std::nan("") : lie == Lie::outside ? 1e3 * out[i] : -out[i];
  return 0;
}

SupportFn invalid_plugin(Lie lie) {
  switch (lie) {
    case Lie::error:
      return lying_box<Lie::error>;
    case Lie::not_a_number:
      return lying_box<Lie::not_a_number>;
    case Lie::outside:
      return lying_box<Lie::outside>;
    case Lie::inside:
      return lying_box<Lie::inside>;
    default:
      return lying_box<Lie::single>;
  }
}

std::vector<Vec3> points(const std::vector<double>& p) {
  std::vector<Vec3> v;
  v.reserve(p.size() / 3);
  for (std::size_t i = 0; i + 3 <= p.size(); i += 3) v.emplace_back(p[i], p[i + 1], p[i + 2]);
  return v;
}

/// The double cone of the template: no closed form.
Shape top(Real radius, Real half_height) {
  Shape s = test::make_shape(Form::none, nullptr, {radius, half_height}, Vec3(radius, half_height, radius),
                             std::max(radius, half_height));
  return s;
}

Shape plain(const ShapeSpec& spec, const carom_shape_plugin*& plugin) {
  const std::vector<double>& p = spec.params;
  switch (spec.kind) {
    case Kind::sphere:
      return plugin = &carom_plugin_sphere, test::sphere(p[0]);
    case Kind::capsule:
      return plugin = &carom_plugin_capsule, test::capsule(p[0], p[1]);
    case Kind::box:
      return plugin = &carom_plugin_box, test::box(Vec3(p[0], p[1], p[2]));
    case Kind::cylinder:
      return plugin = &carom_plugin_cylinder, test::cylinder(p[0], p[1]);
    case Kind::cone:
      return plugin = &carom_plugin_cone, test::cone(p[0], p[1]);
    case Kind::ellipsoid:
      return plugin = &carom_plugin_ellipsoid, test::ellipsoid(Vec3(p[0], p[1], p[2]));
    case Kind::hull:
      return plugin = &carom_plugin_hull, test::hull(points(p));
    case Kind::top:
      return plugin = &carom_plugin_template, top(p[0], p[1]);
    default:
      return plugin = nullptr, test::half_space(Vec3(p[0], p[1], p[2]), p[3]);
  }
}

}  // namespace

Shape make(const ShapeSpec& spec) {
  const carom_shape_plugin* plugin = nullptr;
  Shape s = plain(spec, plugin);
  if (!plugin) return s;
  s.support = spec.lie == Lie::none ? plugin->support : invalid_plugin(spec.lie);
  if (!spec.declared || spec.swell > 0 || spec.lie != Lie::none) {
    s.form = Form::none;
    s.vertices = {};
  }
  if (spec.swell > 0) {
    s.core_radius += spec.swell;
    s.bounding_radius += spec.swell;
    s.bounds.lo -= Vec3::constant(spec.swell);
    s.bounds.hi += Vec3::constant(spec.swell);
  }
  return s;
}

}  // namespace carom::fuzz
