#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "candidates/translation_votes.h"
#include "refinement/shapes.h"

namespace {

using emtr::UprightPoint;
using emtr::YawPairs;

const emtr::Kernels& kKernels = emtr::select_kernels();

std::vector<UprightPoint> random_points(std::uint64_t seed, std::size_t n) {
  emtr_test::Draw draw(seed);
  std::vector<UprightPoint> out;
  for (std::size_t i = 0; i < n; ++i)
    out.push_back({draw.uniform(-0.9, 0.9), draw.uniform(-0.9, 0.9), draw.uniform(0, 0.3),
                   draw.uniform(0, emtr::kPi)});
  return out;
}

std::vector<UprightPoint> moved(std::vector<UprightPoint> points, int yaw, double x, double y) {
  const double angle = yaw * emtr::kYawStep, c = std::cos(angle), s = std::sin(angle);
  for (UprightPoint& p : points) {
    p = {c * p.x - s * p.y + x, s * p.x + c * p.y + y, p.height,
         std::fmod(p.azimuth + angle, emtr::kPi)};
  }
  return points;
}

TEST(TranslationVotes, PeakAtTheMotionAndNowhereElse) {
  const auto source = random_points(1, 300);
  const auto target = moved(source, 40, 0.31, -0.17);
  const YawPairs pairs(source, target);
  int best = 0, best_elsewhere = 0;
  emtr::TranslationPeak at{};
  for (int yaw = 0; yaw < emtr::kYaws; ++yaw)
    for (const auto& peak : emtr::vote_for_translations(source, target, pairs, yaw, kKernels)) {
      if (std::abs(yaw - 40) > 10) {
        best_elsewhere = std::max(best_elsewhere, peak.votes);
      } else if (peak.votes > best) {
        best = peak.votes;
        at = peak;
      }
    }
  EXPECT_GE(best, 290);
  EXPECT_LT(best_elsewhere, best / 3);
  EXPECT_LE(std::abs(at.yaw - 40), 2);
  EXPECT_NEAR(at.x, 0.31, 0.02);
  EXPECT_NEAR(at.y, -0.17, 0.02);
}

TEST(TranslationVotes, EachPairIsOfOneHeightAndHasOneRotation) {
  const auto source = random_points(2, 80), target = random_points(3, 90);
  const YawPairs pairs(source, target);
  std::size_t count = 0, expected = 0;
  for (int step = 0; step < emtr::kYaws / 2; ++step) {
    count += pairs.of(step).size();
    EXPECT_EQ(&pairs.of(step), &pairs.of(step + emtr::kYaws / 2));
    for (const YawPairs::Pair& pair : pairs.of(step))
      EXPECT_LE(std::abs(source[pair.source].height - target[pair.target].height), 0.03);
  }
  for (const UprightPoint& p : source)
    for (const UprightPoint& q : target) expected += std::abs(p.height - q.height) <= 0.03;
  EXPECT_EQ(count, expected);
}

TEST(TranslationVotes, ReachTheCornersOfTheirCells) {
  const std::vector<UprightPoint> source = {{0, 0, 0.1, 1}};
  for (const double x : {-1.59, 1.63})
    for (const double y : {-1.59, 1.63}) {
      const std::vector<UprightPoint> target = {{x, y, 0.1, 1}};
      const auto peaks =
          emtr::vote_for_translations(source, target, YawPairs(source, target), 0, kKernels);
      ASSERT_EQ(peaks.size(), 1u);
      EXPECT_EQ(peaks[0].votes, 1);
      EXPECT_NEAR(peaks[0].x, x, 0.03);
      EXPECT_NEAR(peaks[0].y, y, 0.03);
    }
}

TEST(TranslationVotes, ThereAreNoneWithoutPoints) {
  const auto some = random_points(2, 80);
  const std::vector<UprightPoint> none;
  EXPECT_TRUE(emtr::vote_for_translations(some, none, YawPairs(some, none), 0, kKernels).empty());
  EXPECT_TRUE(emtr::vote_for_translations(none, some, YawPairs(none, some), 0, kKernels).empty());
}

}  // namespace
