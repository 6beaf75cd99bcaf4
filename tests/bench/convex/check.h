// Holds every library to closed forms, so that a wrong number in a table is the library's and not its module's.
#pragma once

#include "peer.h"

namespace carom::bench {

/// Prints what each library says wrong of the stacks in closed_forms.h.
/// @return  wrong answers, but those of libraries that are known to give them
int check(const Peers& peers);

}  // namespace carom::bench
