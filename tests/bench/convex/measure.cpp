// Passes over a set go round the libraries; a block of queries counts with the least time of all of them.
#include "measure.h"

#include <time.h>

#include <algorithm>
#include <numeric>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name) static_cast<void>(name)
#endif

namespace carom::bench {

namespace {

/// Long beside a look at the clock (0.3 microseconds), short beside the time slices of a busy machine.
constexpr std::size_t kBlock = 250;

double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

std::vector<double> measure(const std::vector<Peer*>& peers, const Set& set, int passes) {
  const std::size_t count = set.queries.size(), blocks = (count + kBlock - 1) / kBlock;
  std::vector<std::vector<double>> least(peers.size(), std::vector<double>(blocks, HUGE_VAL));
  volatile double sink = 0;
  for (int pass = 0; pass < passes; ++pass)
    for (std::size_t p = 0; p < peers.size(); ++p)
      for (std::size_t block = 0; block < blocks; ++block) {
        const std::size_t end = std::min(count, (block + 1) * kBlock);
        double sum = 0;
        const double start = cpu_seconds();
        for (std::size_t i = block * kBlock; i < end; ++i) {
          Answer answer;
          peers[p]->ask(i, answer);
          sum += answer.separation + answer.overlap;
        }
        least[p][block] = std::min(least[p][block], cpu_seconds() - start);
        sink = sum;
      }
  static_cast<void>(sink);
  std::vector<double> ns;
  for (const std::vector<double>& blocks_of : least)
    ns.push_back(1e9 * std::accumulate(blocks_of.begin(), blocks_of.end(), 0.0) / static_cast<double>(count));
  return ns;
}

void count_instructions(const std::vector<Peer*>& peers, const Set& set) {
  for (Peer* const peer : peers) {
    const std::string name = set.family + "," + set.kind + "," + peer->name();
    const auto pass = [&] {
      for (std::size_t i = 0; i < set.queries.size(); ++i) {
        Answer answer;
        peer->ask(i, answer);
      }
    };
    pass();  // what a library does but once is not counted
    CALLGRIND_ZERO_STATS;
    pass();
    CALLGRIND_DUMP_STATS_AT(name.c_str());
  }
}

}  // namespace carom::bench
