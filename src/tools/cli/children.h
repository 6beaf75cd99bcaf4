// What commands have done by a process of its own.
#pragma once

#include "host/system.h"

namespace carom::tools {

extern const ChildWork print_shape_work;  // `carom shapes`, of one plugin
extern const ChildWork probe_work;        // `carom check`

}  // namespace carom::tools
