#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/spread_rows.h"

namespace {

TEST(SpreadRows, AreAllWhereThereAreFew) {
  EXPECT_EQ(emtr::spread_rows(3, 5), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(emtr::spread_rows(0, 5).empty());
}

TEST(SpreadRows, LieAllOverACloudAndNotAtOneStep) {
  const auto rows = emtr::spread_rows(100000, 1000);
  ASSERT_EQ(rows.size(), 1000u);
  auto sorted = rows;
  std::sort(sorted.begin(), sorted.end());
  std::size_t widest = sorted.front() + 100000 - sorted.back(), narrowest = widest;
  for (std::size_t i = 1; i < sorted.size(); ++i) {
    widest = std::max(widest, sorted[i] - sorted[i - 1]);
    narrowest = std::min(narrowest, sorted[i] - sorted[i - 1]);
  }
  EXPECT_LT(widest, 300u);
  EXPECT_LT(narrowest, widest);
}

}  // namespace
