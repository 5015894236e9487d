#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "preprocessing/base_points.h"
#include "preprocessing/keypoints.h"
#include "preprocessing/preprocessed_cloud.h"
#include "support/clouds.h"
#include "util/error.h"

namespace {

using emtr::PreprocessedCloud;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

/// Points in a box and a descriptor for each: its row and the negative of it.
struct Input {
  std::vector<float> points, features;
  emtr_cloud cloud;

  explicit Input(std::size_t count) : cloud() {
    const emtr::Cloud box = emtr_test::uniform_cloud(count, 1);
    for (std::size_t i = 0; i < count; ++i) {
      points.insert(points.end(), {box.x[i], box.y[i], box.z[i]});
      features.insert(features.end(), {static_cast<float>(i), -static_cast<float>(i)});
    }
    cloud = {points.data(), count, 0, EMTR_FLOAT32};
    cloud.features = features.data();
    cloud.feature_dimension = 2;
  }
};

std::string refusal(const emtr_cloud& cloud) {
  try {
    const PreprocessedCloud preprocessed(cloud, "source", 1);
  } catch (const emtr::Error& error) {
    EXPECT_EQ(error.status(), EMTR_ERROR_ARGUMENT);
    return error.what();
  }
  return "";
}

TEST(Keypoints, AreThoseWithCoordinatesAndAWholeDescriptor) {
  Input in(100);
  in.points[3 * 7] = kNone;
  in.features[2 * 11 + 1] = kNone;
  in.features[2 * 12] = std::numeric_limits<float>::infinity();
  const PreprocessedCloud preprocessed(in.cloud, "", 1);
  const emtr::Keypoints& d = preprocessed.keypoints;
  ASSERT_EQ(d.rows.size(), 97u);
  ASSERT_EQ(d.points.size(), 97u);
  ASSERT_EQ(d.descriptors.size(), 2 * 97u);
  for (std::size_t k = 0; k < d.rows.size(); ++k) {
    const auto row = static_cast<std::size_t>(d.rows[k]);
    EXPECT_TRUE(row != 7 && row != 11 && row != 12);
    EXPECT_EQ(d.descriptors[2 * k], static_cast<float>(row));
    EXPECT_EQ(d.descriptors[2 * k + 1], -static_cast<float>(row));
    float p[3];
    ASSERT_TRUE(preprocessed.find(row, p));
    EXPECT_EQ(d.points.x[k], p[0]);
    EXPECT_NEAR(d.points.y[k] * preprocessed.radius + preprocessed.center[1],
                in.points[3 * row + 1], 1e-6);
    EXPECT_EQ(d.points.z[k], p[2]);
  }
}

TEST(Keypoints, AreReadInAnyStride) {
  Input in(50);
  constexpr std::size_t stride = 13;  // of no float's alignment
  std::vector<char> bytes(stride * 50);
  for (std::size_t i = 0; i < 50; ++i) std::memcpy(&bytes[stride * i], &in.features[2 * i], 8);
  const PreprocessedCloud packed(in.cloud, "", 1);
  in.cloud.features = reinterpret_cast<const float*>(bytes.data());
  in.cloud.feature_stride = stride;
  const PreprocessedCloud strided(in.cloud, "", 1);
  EXPECT_EQ(strided.keypoints.descriptors, packed.keypoints.descriptors);
}

TEST(Keypoints, OfALargeCloudAreThinned) {
  Input in(emtr::kDownsampledAbove + 50000);
  for (std::size_t i = 0; i < in.points.size() / 3; ++i)
    in.points[3 * i] *= 0.01f;  // many in a voxel
  const PreprocessedCloud preprocessed(in.cloud, "", 2);
  const emtr::Keypoints& d = preprocessed.keypoints;
  EXPECT_LT(d.rows.size(), in.cloud.count - 10000);
  EXPECT_GT(d.rows.size(), 100000u);
  EXPECT_TRUE(std::is_sorted(d.rows.begin(), d.rows.end()));
  for (std::size_t k = 0; k < d.rows.size(); ++k)
    ASSERT_EQ(d.descriptors[2 * k], static_cast<float>(d.rows[k]));

  const emtr::Keypoints fewer = emtr::downsample(d, 0.1f);
  EXPECT_LT(fewer.rows.size(), 1000u);
  ASSERT_EQ(fewer.descriptors.size(), 2 * fewer.rows.size());
  for (std::size_t k = 0; k < fewer.rows.size(); ++k)
    ASSERT_EQ(fewer.descriptors[2 * k], static_cast<float>(fewer.rows[k]));
}

TEST(Keypoints, WhatCannotBeReadIsNamed) {
  const auto with = [](const auto& change) {
    Input in(100);
    change(in);
    return refusal(in.cloud);
  };
  EXPECT_EQ(with([](Input& in) { in.cloud.features = nullptr; }),
            "source cloud: feature_dimension is given, but features is null");
  EXPECT_EQ(with([](Input& in) { in.cloud.feature_dimension = 0; }),
            "source cloud: feature_dimension is 0, expected 1 to 65536");
  EXPECT_EQ(with([](Input& in) { in.cloud.feature_stride = 7; }),
            "source cloud: feature_stride is 7 bytes, expected 0 or at least 8");
  EXPECT_EQ(with([](Input& in) { in.features.assign(200, kNone); }),
            "source cloud: features are given, but no finite point has one that is finite");
  EXPECT_EQ(with([](Input&) {}), "");
}

TEST(PreprocessedCloud, NormalsAreMadeOfUnitLengthAndKeptBesideThePoints) {
  Input in(100);
  std::vector<float> normals;
  for (std::size_t i = 0; i < 100; ++i)
    normals.insert(normals.end(), {3.0f * static_cast<float>(i + 1), 0, 0});
  in.points[3 * 2] = kNone;
  std::fill_n(&normals[3 * 5], 3, 0.0f);
  normals[3 * 6 + 1] = kNone;
  in.cloud.normals = normals.data();
  const PreprocessedCloud preprocessed(in.cloud, "", 1);
  ASSERT_EQ(preprocessed.normals.size(), 99u);
  for (std::size_t k = 0; k < 99; ++k) {
    const std::size_t row = k < 2 ? k : k + 1;
    if (row == 5 || row == 6)
      EXPECT_TRUE(std::isnan(preprocessed.normals.x[k]));
    else
      EXPECT_EQ(preprocessed.normals.x[k], 1);
  }
  std::fill(normals.begin(), normals.end(), 0.0f);
  EXPECT_EQ(refusal(in.cloud),
            "source cloud: normals are given, but no finite point has one that is finite and has "
            "a length");
  in.cloud.normal_stride = 4;
  EXPECT_EQ(refusal(in.cloud),
            "source cloud's normals: stride is 4 bytes, expected 0 or at least 12");
}

TEST(PreprocessedCloud, NormalsOfALargeCloudAreMeansInItsVoxels) {
  Input in(emtr::kDownsampledAbove + 50000);
  std::vector<float> normals;
  for (std::size_t i = 0; i < in.cloud.count; ++i) {
    in.points[3 * i] *= 0.01f;
    const float s = i % 2 ? 0.6f : -0.6f;  // they differ, and their mean is along z
    normals.insert(normals.end(), {s, 0, 0.8f});
  }
  in.cloud.normals = normals.data();
  in.cloud.features = nullptr;
  in.cloud.feature_dimension = 0;
  const PreprocessedCloud one(in.cloud, "", 1), two(in.cloud, "", 2);
  ASSERT_EQ(one.normals.size(), one.base.size());
  EXPECT_LT(one.base.size(), in.cloud.count - 10000);
  EXPECT_EQ(one.normals.x, two.normals.x);
  for (std::size_t i = 0; i < one.normals.size(); ++i) {
    const float length = std::hypot(one.normals.x[i], one.normals.y[i], one.normals.z[i]);
    ASSERT_NEAR(length, 1, 1e-5);
    ASSERT_GE(one.normals.z[i], 0.79f);
  }
}

TEST(PreprocessedCloud, FindsTheRowsOfTheCallersArray) {
  Input in(emtr::kDownsampledAbove + 1000);
  in.points[3 * 4 + 1] = in.points[3 * 90000] = kNone;
  const auto check = [&](const PreprocessedCloud& preprocessed) {
    EXPECT_EQ(preprocessed.rows(), in.cloud.count);
    for (const std::size_t row : {0u, 3u, 4u, 5u, 89999u, 90000u, 90001u}) {
      if (row >= in.cloud.count) continue;
      float p[3];
      ASSERT_EQ(preprocessed.find(row, p), row != 4 && row != 90000);
      for (int k = 0; k < 3 && row != 4 && row != 90000; ++k)
        EXPECT_NEAR(p[k] * preprocessed.radius + preprocessed.center[k],
                    in.points[3 * row + static_cast<std::size_t>(k)], 1e-6);
    }
  };
  in.cloud.keep_points = 1;
  check(PreprocessedCloud(in.cloud, "source", 2));
  in.cloud.count = 90000;  // small enough to keep them without being told
  in.cloud.keep_points = 0;
  check(PreprocessedCloud(in.cloud, "source", 1));
  in.cloud.count = emtr::kDownsampledAbove + 1000;
  const PreprocessedCloud downsampled(in.cloud, "source", 1);
  float p[3];
  EXPECT_THROW(downsampled.find(0, p), emtr::Error);
}

}  // namespace
