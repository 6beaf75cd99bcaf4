// The hard pairs, where libraries hang and crash: every question in a process of its own, under a time limit.
#pragma once

#include "peer.h"

namespace carom::bench {

/// Ask every peer about every pair of the file and print how many it got wrong, and how.
void print_hard(const Peers& peers, const char* path);

}  // namespace carom::bench
