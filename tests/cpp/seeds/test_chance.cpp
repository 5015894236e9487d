#include <gtest/gtest.h>

#include "seeds/chance.h"
#include "support/matches.h"

namespace {

using emtr_test::Matches;

TEST(Chance, OfMoreMatchesAndOfNearerOnesIsLess) {
  const Matches matches(20, 80, 0);
  emtr::Chance chance(matches.points);
  chance.measure(matches.pose);
  EXPECT_LT(chance.log_expected(11, 0.01), chance.log_expected(10, 0.01));
  EXPECT_LT(chance.log_expected(10, 0.001), chance.log_expected(10, 0.01));
  EXPECT_LT(chance.log_expected(20, 1e-6), -100);
}

TEST(Chance, ThreeMatchesThatKeepTheirLengthsSaySomethingOnlyIfTheyDoSoClosely) {
  const Matches matches(3, 0, 0);
  emtr::Chance chance(matches.points);
  chance.measure(matches.pose);
  EXPECT_LT(chance.log_expected(3, 1e-6), -8);
  EXPECT_GT(chance.log_expected(3, 0.3), -1);
}

TEST(Chance, DoesNotDependOnTheUnit) {
  const Matches matches(10, 90, 0.01);
  Matches tenth = matches;
  for (auto* cloud : {&tenth.points.p, &tenth.points.q})
    for (auto* axis : {&cloud->x, &cloud->y, &cloud->z})
      for (float& v : *axis) v /= 16;
  tenth.pose.t /= 16;
  emtr::Chance chance(matches.points), of_tenth(tenth.points);
  chance.measure(matches.pose);
  of_tenth.measure(tenth.pose);
  EXPECT_NEAR(chance.log_expected(10, 0.032), of_tenth.log_expected(10, 0.002), 1e-6);
  EXPECT_NEAR(chance.usual_length(), 16 * of_tenth.usual_length(), 1e-6);
}

}  // namespace
