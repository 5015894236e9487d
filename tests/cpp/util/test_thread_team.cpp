#include <gtest/gtest.h>
#include <omp.h>
#include <signal.h>

#include <atomic>
#include <cfenv>
#include <chrono>
#include <stdexcept>
#include <thread>
#include <vector>

#include "util/cancellation.h"
#include "util/thread_team.h"

namespace {

using emtr::ThreadTeam;

/// Whether each of n jobs is done once on a team of its own.
bool does_each_job_once(std::size_t n, int threads) {
  std::vector<int> done(n, 0);
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    team.parallel(n, [&](std::size_t i, std::size_t) { ++done[i]; });
  });
  return done == std::vector<int>(n, 1);
}

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
  EXPECT_THROW(ThreadTeam::with(3, [](ThreadTeam&) { throw std::runtime_error("body"); }),
               std::runtime_error);
}

/// The calling thread has no job left while a helper works on; it asks its caller nevertheless.
TEST(ThreadTeam, AsksItsCallerWhileHelpersWork) {
  std::atomic<int> asked{0};
  emtr::CancellationToken token([&](const emtr_progress&) { return ++asked >= 3; }, 0, {});
  const emtr::CancellationScope scope(&token);
  std::atomic<bool> helped{false};
  const auto run = [&] {
    ThreadTeam::with(2, [&](ThreadTeam& team) {
      team.parallel(2, [&](std::size_t, std::size_t thread) {
        if (thread == 0) {  // until the helper has the other job
          while (!helped && team.size() > 1) std::this_thread::yield();
          return;
        }
        helped = true;
        for (;;) {  // until it is stopped
          emtr::check_cancelled();
          std::this_thread::yield();
        }
      });
    });
  };
  EXPECT_THROW(run(), emtr::Cancelled);
  EXPECT_TRUE(helped);
  EXPECT_GE(asked, 3);
}

TEST(ThreadTeam, ThrowsWhatTheCallerThrowsWhenAsked) {
  emtr::CancellationToken token(
      [](const emtr_progress&) -> bool { throw std::domain_error("caller"); }, 0, {});
  const emtr::CancellationScope scope(&token);
  const auto until_stopped = [](std::size_t, std::size_t) {
    for (;;) {
      emtr::check_cancelled();
      std::this_thread::yield();
    }
  };
  EXPECT_THROW(ThreadTeam::with(3, [&](ThreadTeam& team) { team.parallel(100, until_stopped); }),
               std::domain_error);
}

TEST(ThreadTeam, HasOneThreadInsideAParallelRegionOfTheCallers) {
  std::atomic<int> count{0}, regions{0};
#pragma omp parallel num_threads(2)
  {
    ++regions;
    ThreadTeam::with(4, [&](ThreadTeam& team) {
      EXPECT_EQ(team.size(), 1u);
      team.parallel(50, [&](std::size_t, std::size_t) { ++count; });
    });
  }
  EXPECT_EQ(count, 50 * regions);
}

TEST(ThreadTeam, HasThreadsInsideAParallelRegionOfACallerThatNests) {
  const int levels = omp_get_max_active_levels();
  omp_set_max_active_levels(2);
  std::atomic<int> right{0}, regions{0};
#pragma omp parallel num_threads(2)
  {
    ++regions;
    right += does_each_job_once(50, 3) ? 1 : 0;
    ThreadTeam::with(3, [](ThreadTeam& team) { EXPECT_GT(team.size(), 1u); });
  }
  omp_set_max_active_levels(levels);
  EXPECT_EQ(right, regions);
}

TEST(ThreadTeam, IsTheTeamOfABodyInsideItsBody) {
  ThreadTeam::with(3, [](ThreadTeam& team) {
    ThreadTeam::with(4, [&](ThreadTeam& inner) { EXPECT_EQ(&inner, &team); });
    ThreadTeam::with(2, [&](ThreadTeam& inner) { EXPECT_EQ(inner.size(), 1u); });
    ThreadTeam::with(1, [&](ThreadTeam& inner) { EXPECT_EQ(inner.size(), 1u); });
    for (const int threads : {1, 2, 3, 4}) EXPECT_TRUE(does_each_job_once(20, threads));
    EXPECT_THROW(ThreadTeam::with(3, [](ThreadTeam&) { throw std::runtime_error("body"); }),
                 std::runtime_error);
    EXPECT_TRUE(does_each_job_once(20, 3));
  });
  EXPECT_TRUE(does_each_job_once(20, 3));
}

TEST(ThreadTeam, IsNotTheTeamOfAnotherRunInsideItsBody) {
  ThreadTeam::with(3, [](ThreadTeam& team) {
    emtr::CancellationToken token(nullptr);
    const emtr::CancellationScope scope(&token);
    ThreadTeam::with(3, [&](ThreadTeam& inner) { EXPECT_NE(&inner, &team); });
  });
}

TEST(ThreadTeam, JobsHaveTeamsOfOneThread) {
  std::atomic<int> right{0};
  ThreadTeam::with(3, [&](ThreadTeam& team) {
    team.parallel(10, [&](std::size_t, std::size_t) {
      ThreadTeam::with(3, [](ThreadTeam& inner) { EXPECT_EQ(inner.size(), 1u); });
      right += does_each_job_once(20, 3) ? 1 : 0;
    });
  });
  EXPECT_EQ(right, 10);
}

TEST(ThreadTeam, ManyCallersAtOnceHaveTeamsOfTheirOwn) {
  std::atomic<int> right{0};
  std::vector<std::thread> callers;
  for (int caller = 0; caller < 16; ++caller)
    callers.emplace_back([&right, caller] {
      for (int i = 0; i < 20; ++i) right += does_each_job_once(100, 1 + (caller + i) % 4) ? 1 : 0;
    });
  for (std::thread& caller : callers) caller.join();
  EXPECT_EQ(right, 16 * 20);
}

TEST(ThreadTeam, LeavesOpenMPsDefaultsAlone) {
  const int before = omp_get_max_threads();
  for (const int dynamic : {0, 1}) {
    omp_set_num_threads(3);
    omp_set_dynamic(dynamic);
    const int levels = omp_get_max_active_levels();
    EXPECT_TRUE(does_each_job_once(100, 5));
    EXPECT_EQ(omp_get_max_threads(), 3);
    EXPECT_EQ(omp_get_dynamic(), dynamic);
    EXPECT_EQ(omp_get_max_active_levels(), levels);
  }
  omp_set_dynamic(0);
  omp_set_num_threads(before);
}

int upward_threads() {
  int upward = 0;
#pragma omp parallel num_threads(3) reduction(+ : upward)
  upward += std::fegetround() == FE_UPWARD ? 1 : 0;
  return upward;
}

/// OpenMP's threads may have been made by the caller, with another floating-point environment.
TEST(ThreadTeam, ItsHelpersHaveTheDefaultArithmeticAndGiveTheirOwnBack) {
#pragma omp parallel num_threads(3)
  std::fesetround(FE_UPWARD);
  std::fesetround(FE_TONEAREST);        // as each call into the library sets it
  const int before = upward_threads();  // 2 with GCC's runtime; LLVM's hands on that of the caller
  ThreadTeam::with(3, [](ThreadTeam& team) {
    team.parallel(200,
                  [](std::size_t, std::size_t) { EXPECT_EQ(std::fegetround(), FE_TONEAREST); });
  });
  EXPECT_EQ(upward_threads(), before);
#pragma omp parallel num_threads(3)
  std::fesetround(FE_TONEAREST);
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
