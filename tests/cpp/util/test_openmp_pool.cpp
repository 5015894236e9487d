// OpenMP's pool of threads: given up before a fork, and no larger than the system allows.
#include <gtest/gtest.h>
#include <omp.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <functional>
#include <thread>
#include <vector>

#include "support/thread_sanitizer.h"
#include "util/thread_team.h"

namespace {

using emtr::ThreadTeam;

/// Does 100 jobs and returns the size of the team, or 0 when not each was done once.
std::size_t team_size(int threads) {
  std::vector<int> done(100, 0);
  std::size_t size = 0;
  ThreadTeam::with(threads, [&](ThreadTeam& team) {
    size = team.size();
    team.parallel(done.size(), [&](std::size_t i, std::size_t) { ++done[i]; });
  });
  return done == std::vector<int>(100, 1) ? size : 0;
}

/// Returns how a forked child ends: 0 when the body is true in it.
int in_child(const std::function<bool()>& body) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(60);  // a child that hangs is ended by the system, and the test fails
    _exit(body() ? 0 : 1);
  }
  int status = -1;
  return child > 0 && waitpid(child, &status, 0) == child ? status : -1;
}

bool works() { return team_size(3) == 3; }

class Fork : public testing::Test {
 protected:
  void SetUp() override {
    if (emtr_test::kThreadSanitizer) GTEST_SKIP();
  }
};

using FewerThreads = Fork;

TEST_F(Fork, AChildHasTeamsOfItsOwn) {
  for (int i = 0; i < 5; ++i) {
    EXPECT_TRUE(works());
    EXPECT_EQ(in_child(works), 0);
  }
}

TEST_F(Fork, AChildsChildHasTeamsOfItsOwn) {
  EXPECT_TRUE(works());
  EXPECT_EQ(in_child([] { return works() && in_child(works) == 0 && works(); }), 0);
}

TEST_F(Fork, AChildHasTeamsAfterARegionOfTheCallers) {
  EXPECT_TRUE(works());
  std::atomic<int> count{0};
#pragma omp parallel num_threads(4)
  ++count;
  EXPECT_EQ(count, 4);
  EXPECT_EQ(in_child(works), 0);
}

TEST_F(Fork, AChildMayBeForkedWhileOtherThreadsWork) {
  std::atomic<bool> end{false}, right{true};
  std::vector<std::thread> others;
  for (int i = 0; i < 3; ++i)
    others.emplace_back([&] {
      while (!end) right = right && works();
    });
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(works());
    EXPECT_EQ(in_child(works), 0) << i;
  }
  end = true;
  for (std::thread& other : others) other.join();
  EXPECT_TRUE(right);
}

/// GCC's runtime cannot give up the pool inside a region: the child has the one thread of a nested
/// region. LLVM's begins anew.
TEST_F(Fork, AChildForkedByAJobHasTeams) {
  std::atomic<int> status{-1};
  ThreadTeam::with(2, [&](ThreadTeam& team) {
    team.parallel(
        1, [&](std::size_t, std::size_t) { status = in_child([] { return team_size(3) > 0; }); });
  });
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(works());
}

TEST_F(Fork, OpenMPsDefaultsAreKept) {
  const int before = omp_get_max_threads();
  omp_set_num_threads(5);
  omp_set_dynamic(1);
  const auto kept = [levels = omp_get_max_active_levels()] {
    return omp_get_max_threads() == 5 && omp_get_dynamic() == 1 &&
           omp_get_max_active_levels() == levels;
  };
  EXPECT_TRUE(team_size(2) > 0);
  EXPECT_EQ(in_child(works), 0);
  EXPECT_TRUE(kept());
  omp_set_dynamic(0);
  omp_set_num_threads(before);
}

// ---- fewer threads than asked for

/// LLVM's runtime ends the process when it gets no memory; GCC's takes little.
#ifdef __clang__
constexpr bool kFrugalRuntime = false;
#else
constexpr bool kFrugalRuntime = true;
#endif

rlim_t used_address_space() {
  unsigned long pages = 0;
  std::FILE* file = std::fopen("/proc/self/statm", "r");
  if (!file || std::fscanf(file, "%lu", &pages) != 1) return 0;
  std::fclose(file);
  return static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

bool limit(int resource, rlim_t most) {
  const rlimit value{most, most};
  return setrlimit(static_cast<__rlimit_resource_t>(resource), &value) == 0;
}

/// The threads that the system does not give are not asked of OpenMP, which would end the process.
TEST_F(FewerThreads, WhereAddressSpaceIsLimited) {
  if (!kFrugalRuntime || used_address_space() == 0) GTEST_SKIP();
  for (const rlim_t megabytes : {2, 9, 20, 60, 150})
    EXPECT_EQ(in_child([&] {
                limit(RLIMIT_AS, used_address_space() + (megabytes << 20));
                for (const int threads : {2, 40, 3, 40}) {
                  const std::size_t size = team_size(threads);
                  if (size == 0 || size >= 40) return false;
                }
                return true;
              }),
              0)
        << megabytes;
}

/// Root is not limited; its child becomes another user.
bool limit_threads(rlim_t most) {
  return limit(RLIMIT_NPROC, most) && (geteuid() != 0 || setuid(65534) == 0);
}

TEST_F(FewerThreads, WhereTheUserMayHaveFew) {
  if (in_child([] { return limit_threads(4); }) != 0) GTEST_SKIP() << "cannot limit processes";
  EXPECT_EQ(in_child([] {
              limit_threads(4);
              const std::size_t size = team_size(8);
              return size > 0 && size < 8 && team_size(8) > 0;
            }),
            0);
}

TEST_F(FewerThreads, ForManyCallersAtOnce) {
  if (in_child([] { return limit_threads(4); }) != 0) GTEST_SKIP() << "cannot limit processes";
  EXPECT_EQ(in_child([] {
              std::atomic<int> ready{0};
              std::atomic<bool> right{true};
              std::vector<std::thread> callers;
              for (int i = 0; i < 4; ++i)
                callers.emplace_back([&] {
                  for (++ready; ready < 5;) std::this_thread::yield();
                  for (int k = 0; k < 20; ++k) right = right && team_size(4) > 0;
                });
              const bool limited = limit_threads(9);
              ++ready;
              for (std::thread& caller : callers) caller.join();
              return limited && right;
            }),
            0);
}

}  // namespace
