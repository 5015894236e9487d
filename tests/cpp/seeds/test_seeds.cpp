#include <gtest/gtest.h>

#include <cmath>

#include "geometry/euler.h"
#include "geometry/transform.h"
#include "seeds/seeds.h"
#include "support/clouds.h"

namespace {

/// `right` correspondences that a pose explains among wrong ones.
struct Scene {
  emtr::Cloud source, target;
  std::vector<emtr::Correspondence> matches;
  emtr::Rigid pose;

  Scene(std::size_t right, std::size_t wrong) {
    const double particle[6] = {1.2, 0.5, -2.0, 0.2, -0.3, 0.1};
    pose = emtr::decode(particle);
    const std::size_t n = right + wrong;
    source = emtr_test::uniform_cloud(n, 7);
    target = emtr_test::uniform_cloud(n, 8);
    emtr::Cloud moved;
    moved.resize(n);
    emtr::transform(emtr::select_kernels(), source, pose, moved.x.data(), moved.y.data(),
                    moved.z.data());
    for (std::size_t i = 0; i < n; ++i) {
      const auto k = static_cast<std::int32_t>(i);
      if (i < right) {
        target.x[i] = moved.x[i];
        target.y[i] = moved.y[i];
        target.z[i] = moved.z[i];
      }
      matches.push_back({k, k});
    }
  }

  std::vector<emtr::Seed> seeds(std::size_t most, int threads) const {
    const double threshold = 0.02;
    const emtr::Consistency c(source, target, matches, threshold, emtr::select_kernels(), threads);
    return emtr::find_seeds(c, threshold, most, threads);
  }
};

TEST(Seeds, FindThePoseOfAFewInMany) {
  const Scene scene(20, 400);  // under five in a hundred are right
  const auto seeds = scene.seeds(50, 2);
  ASSERT_FALSE(seeds.empty());
  EXPECT_LE(seeds.size(), 50u);
  EXPECT_GE(seeds[0].inliers, 20u);
  EXPECT_LT(emtr::rotation_distance(seeds[0].pose.R, scene.pose.R), 1e-3);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(seeds[0].pose.t[a], scene.pose.t[a], 1e-3);
}

TEST(Seeds, TheBestSupportedComesFirst) {
  const auto seeds = Scene(30, 300).seeds(100, 1);
  for (std::size_t i = 1; i < seeds.size(); ++i) EXPECT_GE(seeds[i - 1].inliers, seeds[i].inliers);
}

TEST(Seeds, AreTheSameForAnyThreads) {
  const Scene scene(20, 200);
  const auto one = scene.seeds(40, 1), four = scene.seeds(40, 4);
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].inliers, four[i].inliers);
    EXPECT_EQ(one[i].pose.R, four[i].pose.R);
    EXPECT_EQ(one[i].pose.t, four[i].pose.t);
  }
}

TEST(Seeds, NoneWithoutMatches) {
  const Scene scene(0, 1);
  EXPECT_TRUE(scene.seeds(10, 1).empty());  // one match alone says nothing
}

}  // namespace
