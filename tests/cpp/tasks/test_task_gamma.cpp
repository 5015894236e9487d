#include <gtest/gtest.h>

#include <cmath>

#include "refinement/shapes.h"
#include "support/clouds.h"
#include "tasks/task_gamma.h"

namespace {

using emtr::MatchPoints;
using emtr::TaskGamma;

constexpr float kLeaf = 0.03f;

/// n matches of which a share follows a similarity of this scale, up to noise of half a leaf.
MatchPoints matches(std::size_t n, double right, double scale, unsigned seed = 1) {
  MatchPoints out{emtr_test::uniform_cloud(n, seed), emtr_test::uniform_cloud(n, seed + 1)};
  const emtr::Rigid pose = emtr_test::motion({30, 70, -20}, {0.2, 0.1, -0.3});
  const emtr::Cloud noise = emtr_test::uniform_cloud(n, seed + 2, 0.5f * kLeaf);
  for (std::size_t i = 0; i < static_cast<std::size_t>(right * static_cast<double>(n)); ++i) {
    const Eigen::Vector3d q = scale * (pose.R * emtr::point_of(out.p, i)) + pose.t;
    const float moved[3] = {static_cast<float>(q.x()) + noise.x[i],
                            static_cast<float>(q.y()) + noise.y[i],
                            static_cast<float>(q.z()) + noise.z[i]};
    out.q.set(i, moved);
  }
  return out;
}

TEST(TaskGamma, FindsTheScaleThatASmallShareOfTheMatchesHas) {
  for (const double scale : {0.87, 1.0, 1.15}) {
    TaskGamma gamma(-2, 2);
    gamma.add(matches(600, 0.12, scale), kLeaf, 0, 0.5, 1);
    const auto peaks = gamma.peaks(3);
    ASSERT_FALSE(peaks.empty());
    EXPECT_NEAR(peaks.front().octaves, std::log2(scale), 0.02) << scale;
    EXPECT_EQ(gamma.evaluate(peaks.front().octaves), peaks.front().score);
  }
}

TEST(TaskGamma, KnowsThatTheSourceWasScaledBefore) {
  TaskGamma gamma(-2, 2);
  gamma.add(matches(600, 0.1, 1.1), kLeaf, 1.5, 0.5, 1);
  EXPECT_NEAR(gamma.peaks(1).front().octaves, 1.5 + std::log2(1.1), 0.02);
}

TEST(TaskGamma, HearsNoVotesFarFromTheScaleOfTheMatches) {
  TaskGamma gamma(-2, 2);
  gamma.add(matches(400, 0.5, 1.9), kLeaf, 0, 0.5, 1);  // 0.93 octaves away
  for (double x = -2; x < 2; x += 0.01)
    if (std::abs(x) > 0.5) {
      EXPECT_EQ(gamma.evaluate(x), 0) << x;
    }
}

TEST(TaskGamma, SuppressesWhatLiesBesideAPeak) {
  TaskGamma gamma(-1, 1);
  gamma.add(matches(500, 0.3, 1), kLeaf, 0, 0.5, 1);
  const auto peaks = gamma.peaks(8);
  ASSERT_GT(peaks.size(), 2u);
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    if (i > 0) {
      EXPECT_LE(peaks[i].score, peaks[i - 1].score);
    }
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(std::abs(peaks[i].octaves - peaks[j].octaves), 0.1);
  }
}

TEST(TaskGamma, HasTheSameBitsForAnyNumberOfThreads) {
  TaskGamma one(-1, 1), four(-1, 1);
  const MatchPoints made = matches(700, 0.1, 1.05);
  one.add(made, kLeaf, 0.1, 0.5, 1);
  four.add(made, kLeaf, 0.1, 0.5, 4);
  for (double x = -1; x < 1; x += 1.0 / 128) EXPECT_EQ(one.evaluate(x), four.evaluate(x));
}

TEST(TaskGamma, HasNoPeaksWithoutMatches) {
  EXPECT_TRUE(TaskGamma(-1, 1).peaks(5).empty());
  EXPECT_EQ(TaskGamma(-1, 1).evaluate(7), 0);
}

}  // namespace
