#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "pipeline/progress.h"

namespace {

using emtr::CancellationToken;
using emtr::Progress;
using emtr::Stage;
using emtr::StageSeconds;

void wait() { std::this_thread::sleep_for(std::chrono::milliseconds(20)); }

TEST(Progress, TellsEachStageAndMeasuresItAlone) {
  std::vector<std::string> told;
  CancellationToken token([&](const emtr_progress& p) {
    told.emplace_back(p.stage);
    EXPECT_EQ(p.iterations, 7);
    wait();  // the caller's time, and no stage's
    return false;
  });
  StageSeconds seconds;
  {
    Progress progress(token, 7, seconds);
    progress.enter(Stage::Features);
    wait();
    progress.enter(Stage::Matching);
  }
  EXPECT_EQ(told, (std::vector<std::string>{"features", "matching"}));
  EXPECT_GE(seconds[Stage::Features], 0.02);
  EXPECT_GT(seconds[Stage::Matching], 0);
  EXPECT_LT(seconds[Stage::Matching], 0.01);
  EXPECT_EQ(seconds[Stage::Seeds], 0);
}

TEST(Progress, AStageThatTheCallerStopsDoesNotBegin) {
  CancellationToken token(
      [](const emtr_progress& p) { return p.stage == std::string("matching"); });
  StageSeconds seconds;
  {
    Progress progress(token, 0, seconds);
    progress.enter(Stage::Features);
    EXPECT_THROW(progress.enter(Stage::Matching), emtr::Cancelled);
  }
  EXPECT_GT(seconds[Stage::Features], 0);
  EXPECT_EQ(seconds[Stage::Matching], 0);
  EXPECT_TRUE(token.cancelled());
}

TEST(Progress, AnIterationMayEndTheRun) {
  CancellationToken token([](const emtr_progress& p) {
    EXPECT_STREQ(p.stage, "evolution");
    EXPECT_EQ(p.best_alpha, 0.5);
    EXPECT_EQ(p.best_beta, 0.25);
    return p.iteration == 3;
  });
  StageSeconds seconds;
  Progress progress(token, 7, seconds);
  EXPECT_FALSE(progress.iterated(2, 0.5, 0.25));
  EXPECT_TRUE(progress.iterated(3, 0.5, 0.25));
}

}  // namespace
