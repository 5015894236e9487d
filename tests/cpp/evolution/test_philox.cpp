#include <gtest/gtest.h>

#include "evolution/philox.h"

namespace {

using Key = std::array<std::uint64_t, 2>;
using Block = std::array<std::uint64_t, 4>;

struct Vector {
  Key key;
  Block counter, result;
};

// Made by numpy.random.Philox: see philox_vectors.py.
const Vector kVectors[] = {
#include "evolution/philox_vectors.inc"
};

TEST(Philox, GivesTheKnownAnswers) {
  for (const Vector& v : kVectors) EXPECT_EQ(emtr::philox(v.key, v.counter), v.result);
}

TEST(Philox, DrawIsKeyedBySeedAndPlace) {
  EXPECT_EQ(emtr::draw(42, 7, emtr::Stream::Beta, 3, 2), emtr::philox({42, 0}, {7, 1, 3, 2}));
}

TEST(Philox, UniformIsInTheHalfOpenUnitInterval) {
  EXPECT_EQ(emtr::uniform(0), 0);
  EXPECT_EQ(emtr::uniform(2047), 0);
  EXPECT_LT(emtr::uniform(~std::uint64_t{0}), 1);
  double sum = 0;
  for (std::uint64_t i = 0; i < 10000; ++i)
    sum += emtr::uniform(emtr::draw(1, i, emtr::Stream::Alpha, 0, 0)[0]);
  EXPECT_NEAR(sum / 10000, 0.5, 0.01);
}

}  // namespace
