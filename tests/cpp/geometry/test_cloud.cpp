#include <gtest/gtest.h>

#include "geometry/cloud.h"
#include "support/clouds.h"

namespace {

using emtr::Cloud;

TEST(Cloud, SelectTakesRowsInTheirOrder) {
  const Cloud cloud = emtr_test::uniform_cloud(50, 1);
  const std::vector<std::int32_t> rows = {7, 0, 49, 7};
  const Cloud selected = cloud.select(rows);
  ASSERT_EQ(selected.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto row = static_cast<std::size_t>(rows[i]);
    EXPECT_EQ(selected.x[i], cloud.x[row]);
    EXPECT_EQ(selected.y[i], cloud.y[row]);
    EXPECT_EQ(selected.z[i], cloud.z[row]);
  }
}

TEST(Cloud, SelectReplacesWhatTheOtherCloudHeld) {
  const Cloud cloud = emtr_test::uniform_cloud(10, 2);
  Cloud out = emtr_test::uniform_cloud(30, 3);
  cloud.select(std::vector<std::size_t>{4}, out);
  ASSERT_EQ(out.size(), 1u);
  EXPECT_EQ(out.z[0], cloud.z[4]);
  EXPECT_EQ(cloud.select(std::vector<std::size_t>{}).size(), 0u);
}

TEST(Cloud, AppendsPointsAndClouds) {
  Cloud cloud;
  cloud.append(1, 2, 3);
  const Cloud other = emtr_test::uniform_cloud(4, 4);
  cloud.append(other);
  ASSERT_EQ(cloud.size(), 5u);
  EXPECT_EQ(cloud.y[0], 2);
  EXPECT_EQ(cloud.y[4], other.y[3]);
}

}  // namespace
