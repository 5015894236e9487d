#include <gtest/gtest.h>

#include <algorithm>

#include "seeds/triangles.h"
#include "support/matches.h"

namespace {

using emtr_test::Matches;

emtr::Consistency consistency_of(const emtr::MatchPoints& points, double threshold) {
  std::vector<emtr::Correspondence> matches;
  for (std::size_t i = 0; i < points.size(); ++i)
    matches.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(i)});
  return {points.p, points.q, matches, threshold, emtr::select_kernels(), 1};
}

TEST(Triangles, TheLargestHoldsTheRightMatches) {
  const Matches matches(12, 300, 0.001);
  const auto c = consistency_of(matches.points, 0.02);
  const auto found = emtr::find_triangles(c, 0.03, 3, [](const emtr::Triangle&) { return false; });
  ASSERT_FALSE(found.empty());
  EXPECT_GE(found.front().matches.size(), 12u);
  EXPECT_LT(matches.error(found.front().pose), 2);
  for (std::size_t i = 1; i < found.size(); ++i)
    EXPECT_LE(found[i].matches.size(), found[i - 1].matches.size());
}

TEST(Triangles, EndWhenTheCallerHasEnough) {
  const Matches matches(100, 0, 0);
  const auto c = consistency_of(matches.points, 0.01);
  int asked = 0;
  const auto found =
      emtr::find_triangles(c, 0.01, 3, [&](const emtr::Triangle&) { return ++asked > 0; });
  EXPECT_EQ(asked, 1);
  EXPECT_EQ(found.size(), 1u);
}

TEST(Triangles, OfTooFewMatchesAreNone) {
  const Matches matches(10, 30, 0);
  const auto c = consistency_of(matches.points, 0.005);
  const auto never = [](const emtr::Triangle&) { return false; };
  EXPECT_FALSE(emtr::find_triangles(c, 0.005, 10, never).empty());
  EXPECT_TRUE(emtr::find_triangles(c, 0.005, 20, never).empty());
}

}  // namespace
