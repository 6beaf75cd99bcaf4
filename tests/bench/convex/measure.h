// The clock: every library asked about every query, in turn, as often as it takes for noise to go.
#pragma once

#include "sets.h"

namespace carom::bench {

/// CPU time a query, ns: passes over the set go round the libraries, each block of queries counts with the least time
/// of all passes, so that a busy machine makes no library slower than it is.
/// @return  [peers]
std::vector<double> measure(const std::vector<Peer*>& peers, const Set& set, int passes);

/// Under valgrind --tool=callgrind: one pass a library, each dumped with its name; see tests/bench/count_instructions.
/// Nothing otherwise.
void count_instructions(const std::vector<Peer*>& peers, const Set& set);

}  // namespace carom::bench
