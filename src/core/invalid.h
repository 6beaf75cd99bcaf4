// What an index says that names nothing.
#pragma once

#include <cstdint>

namespace carom::core {

/// No slot and no index. As the body of a joint, a spring or a line: the world.
inline constexpr std::uint32_t kInvalid = 0xFFFFFFFFu;

}  // namespace carom::core
