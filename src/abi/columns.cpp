// Rays of a batch, and the settings of a question.
#include "abi/columns.h"

#include "dynamics/dials.h"

namespace carom::abi {

bool RayColumns::read(Call& call, int argument, const carom_rays* given) {
  carom_rays r{};
  if (!read_struct(call, argument, "rays", given, r) ||
      !known(call, argument, "rays->scalar", r.scalar, CAROM_SCALAR_F64 + 1))
    return false;
  count = r.count;
  scalar = r.scalar;
  const std::uint64_t one = bytes(scalar);
  return (!count || (present(call, argument, "rays->origins", r.origins) &&
                     present(call, argument, "rays->directions", r.directions))) &&
         make_column(call, argument, "rays->origins", r.origins, r.origin_stride, 3 * one, count, origins) &&
         make_column(call, argument, "rays->directions", r.directions, r.direction_stride, 3 * one, count,
                     directions) &&
         make_column(call, argument, "rays->max", r.max, r.max_stride, one, count, max);
}

bool RayColumns::get(std::uint64_t i, Ray& ray) const {
  double o[3], d[3], m = 1;
  load<3>(origins, scalar, i, o);
  load<3>(directions, scalar, i, d);
  if (max.at) load<1>(max, scalar, i, &m);
  ray = {to_vec3(o), to_vec3(d), m};
  return carom::finite(ray.origin) && carom::finite(ray.direction) && m >= 0;
}

bool take_settings(Call& call, int argument, std::uint32_t iterations, double tolerance, double target,
                   CastSettings& settings) {
  const DialRow& bounds = dial_table()[static_cast<std::size_t>(Dial::gjk_tolerance)];
  if (!in_range(call, argument, "desc->iterations", iterations, 1, kMostIterations) ||
      !in_range(call, argument, "desc->tolerance", tolerance, bounds.min, bounds.max) ||
      !in_range(call, argument, "desc->target", target, 0, kLongest))
    return false;
  settings.tolerance = tolerance;
  settings.target = target;
  settings.cap = static_cast<int>(iterations);
  return true;
}

}  // namespace carom::abi
