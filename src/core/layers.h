// The layers, a namespace each: core <- collision <- dynamics <- abi. A file names what stands below it without a prefix;
// what stands above it, it cannot include (tests/abi/check_arrows.cmake).
#pragma once

namespace carom {
namespace core {}
namespace collision {}
namespace dynamics {}
using namespace core;
using namespace collision;
using namespace dynamics;
}  // namespace carom
