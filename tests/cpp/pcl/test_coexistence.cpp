// Tests coexistence in one process: many registrations at once, a forked child, and a process whose
// state no registration changes.
#include <fcntl.h>
#include <omp.h>
#include <pcl/console/print.h>
#include <pcl/registration/emtr_ssc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cfenv>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "arithmetic_control.h"
#include "support.h"
#include "thread_sanitizer.h"

namespace {

using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ, double>;
using Pose = std::array<double, 16>;

Pose by_class(const Pair& pair, std::uint64_t seed, unsigned threads) {
  Registration registration;
  registration.setPreset("paper");  // whose pose depends on the seed
  registration.setInputSource(pair.source());
  registration.setInputTarget(pair.target());
  registration.setSeed(seed);
  registration.setNumberOfThreads(threads);
  pcl::PointCloud<pcl::PointXYZ> aligned;
  registration.align(aligned);
  Pose out;
  std::copy_n(registration.getResult()->transformation, 16, out.begin());
  return out;
}

Pose by_c(const Pair& pair, std::uint64_t seed, int threads) {
  const auto source = pair.source(), target = pair.target();
  const emtr_cloud from{&(*source)[0].x, source->size(), sizeof(pcl::PointXYZ), EMTR_FLOAT32};
  const emtr_cloud to{&(*target)[0].x, target->size(), sizeof(pcl::PointXYZ), EMTR_FLOAT32};
  emtr_settings settings;
  emtr_settings_init(&settings, sizeof settings, "paper");
  settings.seed = seed;
  settings.threads = threads;
  emtr_result* result = nullptr;
  Pose out{};
  if (emtr_register(&from, &to, &settings, nullptr, nullptr, &result) == EMTR_OK)
    std::copy_n(result->transformation, 16, out.begin());
  emtr_result_free(result);
  return out;
}

TEST(Coexistence, SixteenAtOnceAreEachAsIfAlone) {
  constexpr std::size_t n = 16;
  std::vector<Pose> alone(n), together(n);
  for (std::size_t i = 0; i < n; i += 2) alone[i] = alone[i + 1] = by_c(sharedPair(), i, 1);
  EXPECT_NE(alone[0], alone[2]);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < n; ++i)
    threads.emplace_back([&, i] {
      const std::size_t seed = i / 2 * 2;
      together[i] = i % 2 ? by_class(sharedPair(), seed, static_cast<unsigned>(1 + i % 3))
                          : by_c(sharedPair(), seed, static_cast<int>(1 + i % 3));
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(together, alone);
}

TEST(Coexistence, EachThreadOfAnOpenMPRegionMayRegister) {
  const Pose alone = by_c(sharedPair(), 1, 1);
  std::array<Pose, 3> found;
#pragma omp parallel for num_threads(3)
  for (int i = 0; i < 3; ++i) found[static_cast<std::size_t>(i)] = by_c(sharedPair(), 1, 0);
  for (const Pose& pose : found) EXPECT_EQ(pose, alone);
}

TEST(Coexistence, AForkedChildRegistersAndEnds) {
  if (emtr_test::kThreadSanitizer) GTEST_SKIP();
  const Pose before = by_c(sharedPair(), 1, 3);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    alarm(120);  // ends a child that hangs, so that the test fails
    _exit(by_c(sharedPair(), 1, 3) == before ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_TRUE(WIFEXITED(status)) << "ended by signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

/// Captures all that is written to a file descriptor during its lifetime.
class Captured {
 public:
  explicit Captured(int fd) : fd_(fd), before_(dup(fd)), file_(std::tmpfile()) {
    std::fflush(nullptr);
    dup2(fileno(file_), fd_);
  }
  ~Captured() {
    close(before_);
    std::fclose(file_);
  }
  long end() {
    std::fflush(nullptr);
    const long written = lseek(fileno(file_), 0, SEEK_END);
    dup2(before_, fd_);
    return written;
  }

 private:
  int fd_, before_;
  std::FILE* file_;
};

TEST(Coexistence, NothingIsWrittenAndPCLStaysAsTalkativeAsItWas) {
  const auto verbosity = pcl::console::getVerbosityLevel();
  // The most verbose level without PCL's own messages: its kd-trees write at L_DEBUG.
  pcl::console::setVerbosityLevel(pcl::console::L_INFO);
  Captured out(STDOUT_FILENO), err(STDERR_FILENO);
  by_c(sharedPair(), 1, 2);
  const float nothing[9] = {};
  const emtr_cloud small{nothing, 3, 0, EMTR_FLOAT32};
  emtr_result* result = nullptr;
  const emtr_status failed = emtr_register(&small, &small, nullptr, nullptr, nullptr, &result);
  by_class(sharedPair(), 1, 2);
  const long written = out.end() + err.end();
  EXPECT_EQ(failed, EMTR_ERROR_CLOUD);
  EXPECT_EQ(written, 0);
  EXPECT_EQ(pcl::console::getVerbosityLevel(), pcl::console::L_INFO);
  pcl::console::setVerbosityLevel(verbosity);
}

TEST(Coexistence, TheProcessIsAsItWas) {
  std::setlocale(LC_ALL, "C");
  std::signal(SIGINT, SIG_IGN);
  omp_set_num_threads(3);
  const int levels = omp_get_max_active_levels(), dynamic = omp_get_dynamic();
  const std::uint64_t control = arithmetic_control();
  char before[4096], after[4096];
  ASSERT_NE(getcwd(before, sizeof before), nullptr);
  std::srand(5);
  const int first = std::rand(), second = std::rand();
  std::srand(5);
  EXPECT_EQ(std::rand(), first);

  by_class(sharedPair(), 1, 2);

  EXPECT_EQ(std::rand(), second);
  EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C");
  EXPECT_EQ(std::signal(SIGINT, SIG_DFL), SIG_IGN);
  EXPECT_EQ(omp_get_max_threads(), 3);
  EXPECT_EQ(omp_get_max_active_levels(), levels);
  EXPECT_EQ(omp_get_dynamic(), dynamic);
  EXPECT_EQ(arithmetic_control(), control);
  ASSERT_NE(getcwd(after, sizeof after), nullptr);
  EXPECT_STREQ(before, after);
}

/// Sets the flags that a library built with -ffast-math leaves set.
TEST(Coexistence, DenormalsTakenForZeroChangeNoBit) {
  const Pose usual = by_c(sharedPair(), 3, 2);
  const std::uint64_t before = arithmetic_control();
  const std::uint64_t flush = before | kFlushDenormals;
  set_arithmetic_control(flush);
  const Pose flushed = by_c(sharedPair(), 3, 2);
  const std::uint64_t left = arithmetic_control();
  set_arithmetic_control(before);
  EXPECT_EQ(flushed, usual);
  EXPECT_EQ(left, flush);
}

}  // namespace
