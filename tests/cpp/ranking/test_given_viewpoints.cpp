#include <gtest/gtest.h>

#include "ranking/given_viewpoints.h"
#include "util/error.h"

namespace {

using emtr::GivenViewpoints;

emtr::Normalization normalization() {
  emtr::Normalization out;
  out.scale = 2;
  out.center_source[0] = 10;
  out.center_target[2] = -4;
  return out;
}

emtr::Settings settings() {
  emtr::Settings out = emtr::preset("default");
  out.has_viewpoint_source = 1;
  out.viewpoint_source[0] = 16;
  return out;
}

TEST(GivenViewpoints, AreInTheNormalizedFrameOfTheirOwnCloud) {
  emtr::Settings s = settings();
  const GivenViewpoints one(s, normalization());
  ASSERT_TRUE(one.source);
  EXPECT_EQ(one.source->at[0], 3);
  EXPECT_FALSE(one.target);
  EXPECT_FALSE(one.both());
  s.has_viewpoint_target = 1;
  const GivenViewpoints two(s, normalization());
  ASSERT_TRUE(two.both());
  EXPECT_EQ(two.target->at[2], 2);
}

TEST(GivenViewpoints, AreNotAskedForWhereFreeSpaceIsOff) {
  emtr::Settings s = settings();
  s.free_space = 0;
  EXPECT_FALSE(GivenViewpoints(s, normalization()).source);
}

TEST(GivenViewpoints, OneTooFarAwayIsRefused) {
  emtr::Settings s = settings();
  s.viewpoint_source[1] = 1e9;
  EXPECT_THROW(GivenViewpoints(s, normalization()), emtr::Error);
}

}  // namespace
