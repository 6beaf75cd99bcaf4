// The clock by which costs are told.
#pragma once

#include <ctime>

namespace carom::tools {

/// s of CPU time of this thread: what else the machine does makes none slower.
inline double cpu_time() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// s of the wall's clock: for work that several threads share.
inline double wall_time() {
  timespec t{};
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace carom::tools
