#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "correspondences/user_correspondences.h"
#include "support/known_pair.h"
#include "util/error.h"

namespace {

using emtr_test::KnownPair;

emtr::UserCorrespondences read(const KnownPair& pair, const std::vector<std::int32_t>& rows,
                               std::size_t most = 1000) {
  return emtr::load_user_correspondences(
      emtr::normalize(pair.source_cloud(), pair.target_cloud(), 1), rows.data(), rows.size() / 2,
      most);
}

std::string refusal(const KnownPair& pair, const std::vector<std::int32_t>& rows) {
  try {
    read(pair, rows);
  } catch (const emtr::Error& error) {
    EXPECT_EQ(error.status(), EMTR_ERROR_ARGUMENT);
    return error.what();
  }
  return "";
}

TEST(UserCorrespondences, KeepTheirOrderAndTheirPlaces) {
  const KnownPair pair(500);
  const std::vector<std::int32_t> rows = {30, 7, 2, 9, 30, 1, 2, 9, 5, 7};  // one stands twice
  const emtr::UserCorrespondences m = read(pair, rows);
  ASSERT_EQ(m.correspondences.size(), 4u);
  EXPECT_EQ(m.keypoints.source.rows, (std::vector<std::int32_t>{2, 5, 30}));
  EXPECT_EQ(m.keypoints.target.rows, (std::vector<std::int32_t>{1, 7, 9}));
  const std::int32_t expected[4][2] = {{30, 7}, {2, 9}, {30, 1}, {5, 7}};
  const emtr::NormalizedPair normalized =
      emtr::normalize(pair.source_cloud(), pair.target_cloud(), 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto s = static_cast<std::size_t>(m.correspondences[i].source),
               t = static_cast<std::size_t>(m.correspondences[i].target);
    EXPECT_EQ(m.keypoints.source.rows[s], expected[i][0]);
    EXPECT_EQ(m.keypoints.target.rows[t], expected[i][1]);
    // All points are finite and few, so the base points are the caller's.
    EXPECT_EQ(m.keypoints.source.points.x[s],
              normalized.source.x[static_cast<std::size_t>(expected[i][0])]);
    EXPECT_EQ(m.keypoints.target.points.z[t],
              normalized.target.z[static_cast<std::size_t>(expected[i][1])]);
  }
  EXPECT_EQ(m.keypoints.source.dimension, 0u);
}

TEST(UserCorrespondences, OfTooManySomeFromAllOverTheListAreTaken) {
  const KnownPair pair(500);
  std::vector<std::int32_t> rows;
  for (std::int32_t i = 0; i < 100; ++i) rows.insert(rows.end(), {i, i});
  const emtr::UserCorrespondences m = read(pair, rows, 10);
  ASSERT_EQ(m.correspondences.size(), 10u);
  EXPECT_EQ(m.keypoints.source.rows,
            (std::vector<std::int32_t>{0, 10, 20, 30, 40, 50, 60, 70, 80, 90}));
  EXPECT_EQ(read(pair, rows, 100).correspondences.size(), 100u);
}

TEST(UserCorrespondences, WhatIsWrongWithThemIsSaid) {
  KnownPair pair(500);
  const std::string last = std::to_string(pair.target.size() / 3 - 1);
  const auto beyond = static_cast<std::int32_t>(pair.target.size() / 3);
  EXPECT_EQ(
      refusal(pair, {0, 0, 1, 1, 2, beyond}),
      "correspondences: row 2: target point " + std::to_string(beyond) + ", expected 0 to " + last);
  EXPECT_EQ(refusal(pair, {0, 0, -1, 1, 2, 2}).find("correspondences: row 1: source point -1"), 0u);
  EXPECT_EQ(refusal(pair, {0, 0, 1, 1, 0, 0}),
            "correspondences: 2 different ones, expected at least 3");
  EXPECT_EQ(refusal(pair, {}), "correspondences: 0 different ones, expected at least 3");
  pair.source[3 * 8 + 2] = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(refusal(pair, {0, 0, 1, 1, 8, 2}),
            "correspondences: row 2: source point 8 is not finite");
  EXPECT_EQ(refusal(pair, {0, 0, 1, 1, 9, 2}), "");
}

}  // namespace
