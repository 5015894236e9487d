#pragma once

#include <algorithm>
#include <cstddef>

#include "team.h"
#include "watch.h"

namespace emtr {

/// Runs job(i) once for each i < n, on up to `threads` threads, and throws on what a job threw.
/// Jobs that keep their results by i make a whole that does not depend on the threads.
template <class Job>
void in_parallel(std::size_t n, int threads, const Job& job) {
  const int most = static_cast<int>(std::min(n, static_cast<std::size_t>(threads)));
  Team::with(std::max(most, 1),
             [&](Team& team) { team.parallel(n, [&](std::size_t i, std::size_t) { job(i); }); });
}

}  // namespace emtr
