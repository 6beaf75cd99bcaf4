// How each call that changes a world is written down, see recorder.h: functions that bindings/gen writes from the headers.
#pragma once

#include <carom/carom.h>

#include "abi/columns.h"
#include "abi/recorder.h"

namespace carom::abi {
/// Numbers in a record of CAROM_JOINT_BULK_*; 0: there is no such field.
std::uint32_t joint_bulk_width(std::uint32_t field);
}  // namespace carom::abi

#include "abi/record_calls.inc"
