// How each call that changes a world is written down, see recorder.h: functions that bindings/gen writes from the headers.
#pragma once

#include <carom/carom.h>

#include "abi/columns.h"
#include "abi/recorder.h"

#include "abi/record_calls.inc"
