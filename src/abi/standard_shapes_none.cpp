// A library without linked plugins: its hosts load files, or register functions of their own.
#include "abi/standard_shapes.h"

namespace carom::abi {

std::span<const carom_shape_plugin* const> standard_shapes() { return {}; }

}  // namespace carom::abi
