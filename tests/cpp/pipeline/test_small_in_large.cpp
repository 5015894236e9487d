#include <gtest/gtest.h>

#include "pipeline/small_in_large.h"
#include "settings/settings.h"
#include "support/clouds.h"

namespace {

using emtr::PreprocessedCloud;
using emtr::Settings;
using emtr::Sizes;

PreprocessedCloud cloud(double unit) {
  const emtr_test::Pair pair(62, 500, unit);
  return PreprocessedCloud(pair.source(), "", 1);
}

TEST(CompareSizes, GoesByTheRadiiWhicheverIsTheLarger) {
  const Settings settings = emtr::preset("default");
  const PreprocessedCloud one = cloud(1), two = cloud(2), ten = cloud(10);
  EXPECT_EQ(emtr::compare_sizes(one, one, settings), Sizes::Alike);
  EXPECT_EQ(emtr::compare_sizes(one, two, settings), Sizes::Different);
  EXPECT_EQ(emtr::compare_sizes(ten, one, settings), Sizes::VeryDifferent);
  EXPECT_EQ(emtr::compare_sizes(two, ten, settings), Sizes::VeryDifferent);
}

TEST(CompareSizes, NoneMatterWhereTheSettingsSearchNoParts) {
  const PreprocessedCloud one = cloud(1), ten = cloud(10);
  EXPECT_EQ(emtr::compare_sizes(one, ten, emtr::preset("paper")), Sizes::Alike);
  Settings settings = emtr::preset("default");
  settings.fallback_search = EMTR_OFF;
  EXPECT_EQ(emtr::compare_sizes(one, ten, settings), Sizes::Alike);
  settings = emtr::preset("default");
  const std::int32_t row[2] = {0, 0};
  settings.correspondences = row;
  settings.correspondence_count = 1;
  EXPECT_EQ(emtr::compare_sizes(one, ten, settings), Sizes::Alike);
}

}  // namespace
