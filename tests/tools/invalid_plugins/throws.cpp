// A unit ball whose support function throws for directions in a cap: `carom check` has to say so.
#include <carom/plugin.h>

#include <cmath>
#include <stdexcept>

namespace {

std::int32_t support(void*, const double*, std::uint64_t, const double dir[3], double out[3]) {
  const double length = std::hypot(dir[0], dir[1], dir[2]);
  for (int k = 0; k < 3; ++k) out[k] = dir[k] / length;
  if (out[1] < -0.95) throw std::runtime_error("not down there");
  return 0;
}

}  // namespace

extern "C" {
extern CAROM_PLUGIN_EXPORT const carom_shape_plugin carom_shape_plugin_v1;
const carom_shape_plugin carom_shape_plugin_v1 = {sizeof(carom_shape_plugin),
                                                  CAROM_PLUGIN_ABI_MAJOR,
                                                  CAROM_PLUGIN_ABI_MINOR,
                                                  0,
                                                  "test.throws",
                                                  1,
                                                  0,
                                                  nullptr,
                                                  nullptr,
                                                  support,
                                                  0,
                                                  0,
                                                  nullptr,
                                                  0,
                                                  0,
                                                  nullptr,
                                                  nullptr};
}
