#pragma once

namespace emtr {

/// How many threads a parallel region started here may have: `threads`, or fewer when the system
/// gives this process no more (1 at least). OpenMP itself would end the process over it. Call it
/// before each region; new threads are tried only when the last region had fewer.
int available_threads(int threads);

}  // namespace emtr
