// Attributes of bodies in scene files: all that the library has, by name, so that a new one needs nothing here.
#pragma once

#include "scenefile/document.h"
#include "scenes/scene.h"

namespace carom::tools::scenefile {

/// {name: numbers} of those that are not as usual; numbers are one, or a list.   @throws Error
json attributes_of(carom_world* world, carom_body body);

/// Set what stands in a node's "attributes", and the names that files had for some of them before: drag, locks, fieldMask.
/// @throws Error that names the place in the file
void read_attributes(const Value& own, carom_world* world, carom_body body);

}  // namespace carom::tools::scenefile
