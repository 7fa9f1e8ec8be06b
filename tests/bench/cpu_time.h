// The clock of the benchmarks that have one thread.
#pragma once

#include <ctime>

namespace touchstone::bench {

/// CPU time of the calling thread: with RLIMIT_CPU set, the clock of the process has the resolution of a tick.
inline double cpu_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace touchstone::bench
