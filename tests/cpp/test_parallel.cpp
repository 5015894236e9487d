#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "parallel.h"

namespace {

TEST(InParallel, RunsEachJobOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> done(1000, 0);
    emtr::in_parallel(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(1000, 1));
  }
  emtr::in_parallel(0, 3, [](std::size_t) { FAIL(); });
}

TEST(InParallel, ThrowsWhatAJobThrew) {
  for (const int threads : {1, 2, 5}) {
    const auto job = [](std::size_t i) {
      if (i % 10 == 3) throw std::out_of_range("job");
    };
    EXPECT_THROW(emtr::in_parallel(50, threads, job), std::out_of_range) << threads;
  }
}

}  // namespace
