#include <gtest/gtest.h>

#include <set>

#include "ranking/cube_map.h"

namespace {

using emtr::CubeMap;

TEST(CubeMap, NumbersTheBinsOfTheWindowsAndNoOthers) {
  CubeMap map(1000);
  for (const emtr::DirectionBins::Bin& bin :
       {emtr::DirectionBins::Bin{0, 500, 400}, {0, 502, 401}, {0, 501, 403}, {4, 0, 999}})
    map.include(bin);
  EXPECT_EQ(map.number_bins(), 3u * 4u + 1u);
  std::set<std::size_t> numbers;
  for (std::int32_t row = 400; row <= 403; ++row)
    for (std::int32_t column = 500; column <= 502; ++column)
      numbers.insert(map.index({0, column, row}));
  numbers.insert(map.index({4, 0, 999}));
  EXPECT_EQ(numbers.size(), 13u);  // each its own
  EXPECT_EQ(*numbers.begin(), 0u);
  EXPECT_EQ(*numbers.rbegin(), 12u);
}

TEST(CubeMap, AWindowContainsWhatLiesInItsRectangle) {
  CubeMap map(10);
  map.include({2, 3, 4});
  map.include({2, 5, 6});
  map.number_bins();
  EXPECT_TRUE(map.window(2).contains({2, 3, 6}));
  EXPECT_FALSE(map.window(2).contains({2, 2, 4}));
  EXPECT_FALSE(map.window(2).contains({2, 6, 4}));
  EXPECT_FALSE(map.window(2).contains({2, 3, 3}));
  EXPECT_FALSE(map.window(2).contains({2, 3, 7}));
  EXPECT_FALSE(map.window(1).contains({1, 3, 4}));  // nothing was seen through that face
}

TEST(CubeMap, WithoutAnyBinHasNone) { EXPECT_EQ(CubeMap(10).number_bins(), 0u); }

}  // namespace
