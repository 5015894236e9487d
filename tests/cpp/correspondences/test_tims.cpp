#include <gtest/gtest.h>

#include <cmath>

#include "correspondences/tims.h"
#include "support/clouds.h"

namespace {

std::vector<emtr::Correspondence> diagonal(std::int32_t n) {
  std::vector<emtr::Correspondence> out;
  for (std::int32_t i = 0; i < n; ++i) out.push_back({i, i});
  return out;
}

TEST(Tims, AreAllPairsInOrder) {
  const emtr::Cloud p = emtr_test::uniform_cloud(6, 1), q = emtr_test::uniform_cloud(6, 2);
  const emtr::Tims tims = emtr::form_tims(p, q, diagonal(6), 100);
  ASSERT_EQ(tims.size(), 15u);
  EXPECT_EQ(tims.pruned, 0u);
  EXPECT_EQ(tims.source.x[0], p.x[1] - p.x[0]);
  EXPECT_EQ(tims.target.z[5], q.z[2] - q.z[1]);
}

TEST(Tims, PruneOnlyWhatNoRotationCanMatch) {
  const emtr::Cloud p = emtr_test::uniform_cloud(60, 3), q = emtr_test::uniform_cloud(60, 4);
  const double threshold = 0.2;
  const emtr::Tims tims = emtr::form_tims(p, q, diagonal(60), threshold);
  EXPECT_EQ(tims.formed(), 60u * 59 / 2);
  EXPECT_GT(tims.pruned, 100u);
  std::size_t hopeless = 0;
  for (std::size_t j = 0; j < 60; ++j)
    for (std::size_t k = j + 1; k < 60; ++k) {
      const auto length = [&](const emtr::Cloud& c) {
        return std::hypot(double{c.x[k]} - double{c.x[j]}, double{c.y[k]} - double{c.y[j]},
                          double{c.z[k]} - double{c.z[j]});
      };
      hopeless += std::abs(length(p) - length(q)) > threshold * 1.0001;
    }
  EXPECT_NEAR(static_cast<double>(tims.pruned), static_cast<double>(hopeless), 2);
}

TEST(Tims, CapCountsPairs) {
  EXPECT_EQ(emtr::correspondence_cap(3), 3u);
  EXPECT_EQ(emtr::correspondence_cap(5), 3u);
  EXPECT_EQ(emtr::correspondence_cap(6), 4u);
  EXPECT_EQ(emtr::correspondence_cap(100000), 447u);
}

}  // namespace
