#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "preprocessing/preprocessed_cloud.h"
#include "preprocessing/strays.h"
#include "support/clouds.h"

namespace {

using Packed = std::vector<double>;

emtr_cloud view(const Packed& packed) {
  return {packed.data(), packed.size() / 3, 0, EMTR_FLOAT64};
}

emtr::PreprocessedCloud preprocess(const Packed& packed, int threads = 2) {
  emtr_cloud cloud = view(packed);
  cloud.keep_points = 1;
  return {cloud, "", threads};
}

/// A box of size 2 about a place.
Packed box(std::size_t points, double x = 0, double y = 0, double z = 0) {
  const emtr::Cloud cloud = emtr_test::uniform_cloud(points, 3);
  Packed packed;
  for (std::size_t i = 0; i < points; ++i)
    packed.insert(packed.end(),
                  {x + double{cloud.x[i]}, y + double{cloud.y[i]}, z + double{cloud.z[i]}});
  return packed;
}

/// Appends points in all directions, at distances from `near` to `far`.
void scatter(Packed& packed, std::size_t points, double near, double far) {
  std::mt19937 random(5);
  for (std::size_t i = 0; i < points; ++i) {
    const auto draw = [&] { return static_cast<double>(random()) / 4294967296.0; };
    const double z = 2 * draw() - 1, angle = 6.283185 * draw(), r = std::sqrt(1 - z * z),
                 distance = near + (far - near) * draw();
    packed.insert(packed.end(),
                  {distance * r * std::cos(angle), distance * r * std::sin(angle), distance * z});
  }
}

void expect_same_extent(const emtr::PreprocessedCloud& one, const emtr::PreprocessedCloud& other) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(one.center[k], other.center[k], 1e-12) << k;
  EXPECT_NEAR(one.radius, other.radius, 1e-12);
  ASSERT_EQ(one.base.size(), other.base.size());
  for (std::size_t i = 0; i < one.base.size(); ++i) {
    ASSERT_NEAR(one.base.x[i], other.base.x[i], 1e-6);
    ASSERT_NEAR(one.base.z[i], other.base.z[i], 1e-6);
  }
}

TEST(Strays, AreLeftOutAndCounted) {
  for (const std::size_t points : {200u, 20000u, 250000u}) {
    const Packed clean = box(points);
    for (const double distance : {8.0, 20.0, 50.0, 1e6, 1e38, 1e160}) {
      Packed packed = clean;
      const std::size_t strays = points / 1000 + 1;
      scatter(packed, strays, distance, 2 * distance);
      const emtr::PreprocessedCloud found = preprocess(packed);
      EXPECT_EQ(found.strays, strays) << points << " points, strays at " << distance;
      EXPECT_EQ(found.count, points + strays);
      EXPECT_EQ(found.dropped, 0u);
      expect_same_extent(found, preprocess(clean));
    }
  }
}

TEST(Strays, HideNoNearerOnes) {
  const Packed clean = box(5000);
  Packed packed = {3e38, 3e38, -3e38};  // the first point is one
  packed.insert(packed.end(), clean.begin(), clean.end());
  for (const double distance : {1e12, 1e4, 20.0}) scatter(packed, 3, distance, distance);
  const emtr::PreprocessedCloud found = preprocess(packed);
  EXPECT_EQ(found.strays, 10u);
  expect_same_extent(found, preprocess(clean));
}

TEST(Strays, LieAtTheOriginOfACloudFarFromIt) {
  const Packed clean = box(3000, 5e5, 4e6, 100);
  Packed packed = clean;
  for (int i = 0; i < 20; ++i) packed.insert(packed.end(), {0, 0, 0});
  const emtr::PreprocessedCloud found = preprocess(packed);
  EXPECT_EQ(found.strays, 20u);
  EXPECT_NEAR(found.radius, preprocess(clean).radius, 1e-8);
}

TEST(Strays, AreFoundAtAnyDistanceFarEnoughAway) {
  Packed packed = box(20000);
  scatter(packed, 100, 2, 200);  // no gap anywhere
  const emtr::PreprocessedCloud found = preprocess(packed);
  EXPECT_GT(found.strays, 85u);
  EXPECT_LT(found.radius, 25);
}

TEST(Strays, AreNoThinTailAndNoSeparateObject) {
  Packed scan;  // a scanner in the middle of a plane: ever fewer points farther away
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    const double u = (static_cast<double>(random()) + 1) / 4294967297.0;
    const double distance = std::min(2 / std::sqrt(u), 80.0), angle = 0.01 * i;
    scan.insert(scan.end(), {distance * std::cos(angle), distance * std::sin(angle), -1.8});
  }
  EXPECT_EQ(preprocess(scan).strays, 0u);

  Packed pair = box(9800);
  const Packed object = box(200, 15, 0, 0);  // 2 % of the points
  pair.insert(pair.end(), object.begin(), object.end());
  EXPECT_EQ(preprocess(pair).strays, 0u);
}

TEST(Strays, AreNotSoughtAmongFewPoints) {
  EXPECT_EQ(emtr::most_strays(24), 0u);
  EXPECT_EQ(emtr::most_strays(25), 1u);
  EXPECT_EQ(emtr::most_strays(20000), 200u);
  Packed packed = box(23);
  packed.insert(packed.end(), {100, 0, 0});
  EXPECT_EQ(preprocess(packed).strays, 0u);
}

TEST(Strays, HaveRowsBetweenTheOthers) {
  Packed packed = box(1000);
  packed[3 * 17] = 1000;
  packed[3 * 40] = std::numeric_limits<double>::quiet_NaN();
  const emtr::PreprocessedCloud found = preprocess(packed);
  EXPECT_EQ(found.count, 999u);
  EXPECT_EQ(found.strays, 1u);
  EXPECT_EQ(found.rows(), 1000u);
  float p[3];
  EXPECT_FALSE(found.find(17, p));
  EXPECT_TRUE(found.is_stray(17));
  EXPECT_FALSE(found.find(40, p));
  EXPECT_FALSE(found.is_stray(40));
  ASSERT_TRUE(found.find(999, p));
  EXPECT_NEAR(found.center[1] + found.radius * double{p[1]}, packed[3 * 999 + 1], 1e-6);
}

TEST(Strays, HaveTheSameBitsForAnyNumberOfThreads) {
  Packed packed = box(300000);
  scatter(packed, 200, 30, 90);
  const emtr::PreprocessedCloud one = preprocess(packed, 1), three = preprocess(packed, 3);
  EXPECT_EQ(one.strays, three.strays);
  EXPECT_EQ(one.radius, three.radius);
  EXPECT_EQ(one.base.x, three.base.x);
}

/// A sphere of 1500 points, a NaN before them, and 600 points all over its box.
Packed sphere_in_outliers() {
  Packed packed = {NAN, 0, 0};
  scatter(packed, 1500, 1, 1);
  const Packed outliers = box(600);
  packed.insert(packed.end(), outliers.begin(), outliers.end());
  return packed;
}

TEST(Strays, PointsScatteredOffASmallSurfaceAreAmongThem) {
  const auto cloud = preprocess(sphere_in_outliers());
  EXPECT_EQ(cloud.count, 2100u);
  EXPECT_EQ(cloud.dropped, 1u);
  EXPECT_GT(cloud.strays, 250u);
  EXPECT_EQ(cloud.base.size(), cloud.count - cloud.strays);
  std::size_t strays = 0;
  for (std::size_t row = 0; row < cloud.rows(); ++row) {
    float p[3];
    const bool found = cloud.find(row, p);
    EXPECT_EQ(found, row != 0 && !cloud.is_stray(row));
    if (found && row <= 1500) {
      EXPECT_NEAR(std::hypot(p[0], p[1], p[2]) * cloud.radius, 1, 0.2);
    }
    strays += cloud.is_stray(row);
  }
  EXPECT_EQ(strays, cloud.strays);
}

TEST(Strays, NormalsOfScatteredPointsAreLeftOutToo) {
  const Packed points = sphere_in_outliers();
  emtr_cloud cloud = view(points);
  cloud.normals = points.data();  // the sphere's are its points
  const emtr::PreprocessedCloud preprocessed(cloud, "", 1);
  ASSERT_EQ(preprocessed.normals.size(), preprocessed.base.size());
  std::size_t of_sphere = 0;
  for (std::size_t i = 0; i < preprocessed.base.size(); ++i) {
    const double radius = preprocessed.radius;
    const double x = preprocessed.base.x[i] * radius + preprocessed.center[0];
    of_sphere += std::abs(x - double{preprocessed.normals.x[i]}) < 1e-5;
  }
  EXPECT_GT(of_sphere, 1450u);
  EXPECT_LT(preprocessed.base.size(), 1850u);
}

}  // namespace
