// Memory: every array of an engine draws from the host's allocator through one resource.
#pragma once

#include <memory_resource>
#include <vector>

namespace carom {

using Memory = std::pmr::memory_resource;

/// A growing array that draws from an engine's memory. Rooms that live in a world take a Memory* and build theirs on it.
template <class T>
using Array = std::pmr::vector<T>;

}  // namespace carom
