#include <gtest/gtest.h>
#include <signal.h>

#include <stdexcept>
#include <thread>
#include <vector>

#include "util/thread_team.h"

namespace {

using emtr::ThreadTeam;

TEST(ThreadTeam, DoesEachJobOnceAndAllBeforeItReturns) {
  for (const int threads : {1, 2, 3, 8})
    ThreadTeam::with(threads, [&](ThreadTeam& team) {
      for (std::size_t n = 0; n < 200; ++n) {
        std::vector<int> done(n, 0);
        team.parallel(n, [&](std::size_t i, std::size_t thread) {
          EXPECT_LT(thread, static_cast<std::size_t>(threads));
          ++done[i];
        });
        EXPECT_EQ(done, std::vector<int>(n, 1));
      }
    });
}

TEST(ThreadTeam, RunsItsBodyOnTheCallingThread) {
  const auto caller = std::this_thread::get_id();
  ThreadTeam::with(4, [&](ThreadTeam&) { EXPECT_EQ(std::this_thread::get_id(), caller); });
}

TEST(ThreadTeam, ThrowsWhatAJobThrowsAndCanGoOn) {
  ThreadTeam::with(4, [](ThreadTeam& team) {
    const auto failing = [](std::size_t i, std::size_t) {
      if (i == 37) throw std::runtime_error("job 37");
    };
    EXPECT_THROW(team.parallel(100, failing), std::runtime_error);
    std::atomic<int> count{0};
    team.parallel(100, [&](std::size_t, std::size_t) { ++count; });
    EXPECT_EQ(count, 100);
  });
}

TEST(ThreadTeam, ThrowsWhatItsBodyThrows) {
  EXPECT_THROW(ThreadTeam::with(3, [](ThreadTeam&) { throw std::runtime_error("body"); }), std::runtime_error);
}

TEST(ThreadTeam, WorksInsideAParallelRegionOfTheCallers) {
  std::atomic<int> count{0}, regions{0};
#pragma omp parallel num_threads(2)
  {
    ++regions;
    ThreadTeam::with(4,
               [&](ThreadTeam& team) { team.parallel(50, [&](std::size_t, std::size_t) { ++count; }); });
  }
  EXPECT_EQ(count, 50 * regions);
}

TEST(ThreadTeam, ItsHelpersTakeNoSignals) {
  ThreadTeam::with(3, [](ThreadTeam& team) {
    team.parallel(50, [](std::size_t, std::size_t thread) {
      sigset_t blocked;
      pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
      EXPECT_EQ(sigismember(&blocked, SIGINT), thread == 0 ? 0 : 1);
    });
  });
  sigset_t blocked;
  pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
  EXPECT_EQ(sigismember(&blocked, SIGINT), 0);
}

TEST(InParallel, RunsEachJobOnce) {
  for (const int threads : {1, 2, 7}) {
    std::vector<int> done(1000, 0);
    emtr::parallel_for(done.size(), threads, [&](std::size_t i) { ++done[i]; });
    EXPECT_EQ(done, std::vector<int>(1000, 1));
  }
  emtr::parallel_for(0, 3, [](std::size_t) { FAIL(); });
}

TEST(InParallel, ThrowsWhatAJobThrew) {
  for (const int threads : {1, 2, 5}) {
    const auto job = [](std::size_t i) {
      if (i % 10 == 3) throw std::out_of_range("job");
    };
    EXPECT_THROW(emtr::parallel_for(50, threads, job), std::out_of_range) << threads;
  }
}

}  // namespace
