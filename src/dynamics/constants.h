// Numbers that are no dials, as a host reads them: one table, put together of what each file says of its own.
#pragma once

#include <span>

#include "core/constant.h"

namespace carom::dynamics {

/// All of them, of the layers below too. Static storage.
std::span<const ConstantRow> constant_table();

}  // namespace carom::dynamics
