// Numbers that tell the handles of one engine or world from those of another.
#pragma once

#include <cstdint>

namespace carom::abi {

/// Take a number that no living engine or world of this process has. @return 1..65535, or 0 when all are taken
/// Lock-free. The numbers tell handles apart and enter nothing else: no result of the physics depends on them.
std::uint32_t take_tag();
void release_tag(std::uint32_t tag);

}  // namespace carom::abi
