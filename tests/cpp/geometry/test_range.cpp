#include <gtest/gtest.h>

#include <cstddef>
#include <vector>

#include "geometry/range.h"

namespace {

TEST(RangeOf, IsTheLeastAndTheLargestWhereverTheyAre) {
  for (const std::size_t size : {1u, 2u, 15u, 16u, 17u, 33u, 100u})
    for (std::size_t at = 0; at < size; ++at) {
      std::vector<float> numbers(size, 2.5f);
      numbers[at] = -3;
      EXPECT_EQ(emtr::range_of(numbers).low, -3) << size << ", " << at;
      EXPECT_EQ(emtr::range_of(numbers).high, size == 1 ? -3 : 2.5f) << size << ", " << at;
      numbers[at] = 7;
      EXPECT_EQ(emtr::range_of(numbers).low, size == 1 ? 7 : 2.5f) << size << ", " << at;
      EXPECT_EQ(emtr::range_of(numbers).high, 7) << size << ", " << at;
    }
}

}  // namespace
