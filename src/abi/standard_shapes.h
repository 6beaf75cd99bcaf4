// Plugins that are linked into the library, for hosts that load no files.
#pragma once

#include <carom/plugin.h>

#include <span>

namespace carom::abi {

/// Those of plugins/, in the order of their names; none where the library was built without.
std::span<const carom_shape_plugin* const> standard_shapes();

}  // namespace carom::abi
