#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "support/clouds.h"

namespace {

using emtr::Cloud;
using emtr::Kernels;
using emtr_test::kernels_here;

using Double3 = std::array<double, 3>;
double dot(const Double3& a, const Double3& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Double3 cross(const Double3& a, const Double3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Double3 at(const Cloud& cloud, std::size_t i) {
  return {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}};
}

Cloud unit_vectors(std::size_t n, unsigned seed) {
  Cloud out = emtr_test::uniform_cloud(n, seed);
  for (std::size_t i = 0; i < n; ++i) {
    const auto length = static_cast<float>(std::sqrt(dot(at(out, i), at(out, i))));
    out.x[i] /= length;
    out.y[i] /= length;
    out.z[i] /= length;
  }
  return out;
}

float squared(const Cloud& cloud, std::size_t i, std::size_t j) {
  const float x = cloud.x[j] - cloud.x[i], y = cloud.y[j] - cloud.y[i], z = cloud.z[j] - cloud.z[i];
  return (x * x + y * y) + z * z;
}

/// The three angles of a pair in the words of the definition, in double.
Double3 pair_angles(const Double3& p, Double3 n, const Double3& q, Double3 m) {
  Double3 d = {q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  const double length = std::sqrt(dot(d, d));
  for (double& c : d) c /= length;
  if (std::acos(std::abs(dot(n, d))) > std::acos(std::abs(dot(m, d)))) {
    std::swap(n, m);
    for (double& c : d) c = -c;
  }
  Double3 v = cross(d, n);
  const double norm = std::sqrt(dot(v, v));
  for (double& c : v) c /= norm;
  return {std::atan2(dot(cross(n, v), m), dot(n, m)), dot(v, m), dot(n, d)};
}

std::size_t bin(double fraction) {
  return static_cast<std::size_t>(std::min(10.0, std::max(0.0, std::floor(11 * fraction))));
}

TEST(DescriptorKernels, CountEachPairInTheBinsOfItsAngles) {
  const float radius = 0.9f * 0.9f;
  std::size_t wrong = 0, all = 0;
  for (const std::size_t n : {16u, 512u, 1600u}) {
    const Cloud cloud = emtr_test::uniform_cloud(n, 11), normals = unit_vectors(n, 12);
    const emtr::SurfaceView list = {cloud.view(), normals.x.data(), normals.y.data(),
                                    normals.z.data()};
    for (std::size_t i = 0; i < n; i += n / 16) {
      std::vector<float> expected(emtr::kDescriptorRow, 0), found(emtr::kDescriptorRow, -1);
      float neighbors = 0;
      for (std::size_t j = 0; j < n; ++j) neighbors += squared(cloud, i, j) < radius;
      for (std::size_t j = 0; j < n; ++j) {
        if (j == i || !(squared(cloud, i, j) < radius)) continue;
        const Double3 a = pair_angles(at(cloud, i), at(normals, i), at(cloud, j), at(normals, j));
        const float share = 100 / (neighbors - 1);
        expected[bin((a[0] + M_PI) / (2 * M_PI))] += share;
        expected[11 + bin((a[1] + 1) / 2)] += share;
        expected[22 + bin((a[2] + 1) / 2)] += share;
      }
      const emtr::SurfacePoint query = {{cloud.x[i], cloud.y[i], cloud.z[i]},
                                        {normals.x[i], normals.y[i], normals.z[i]}};
      std::vector<float> first(emtr::kDescriptorRow);
      emtr::kernels_at(0)->pair_histograms(list, query, radius, first.data());
      for (const Kernels* k : kernels_here()) {
        k->pair_histograms(list, query, radius, found.data());
        EXPECT_EQ(found, first) << k->name;
      }
      for (std::size_t b = 0; b < found.size(); ++b, ++all)
        wrong += std::abs(found[b] - expected[b]) > 1e-3f;
    }
  }
  EXPECT_LE(wrong, all / 200);  // a pair on an edge between two bins
}

TEST(DescriptorKernels, LeastDirectionsAreThoseOfTheCovariance) {
  // Discs of known direction, thinner and thinner, off the origin.
  std::mt19937 random(5);
  const auto draw = [&] { return static_cast<double>(random()) / 2147483648.0 - 1; };
  constexpr std::size_t discs = 37;  // not a multiple of any register
  const Cloud axes = unit_vectors(discs, 21), helpers = unit_vectors(discs, 22);
  std::vector<float> moments(emtr::kMoments * discs);
  Cloud centers;
  for (std::size_t k = 0; k < discs; ++k) {
    const Double3 n = at(axes, k);
    Double3 u = cross(n, at(helpers, k));
    const double length = std::sqrt(dot(u, u));
    for (double& c : u) c /= length;
    const Double3 v = cross(n, u);
    Cloud list;
    for (int i = 0; i < 48; ++i) {
      const double a = draw(), b = 0.7 * draw(), c = draw() * std::pow(0.5, 1 + int(k) / 4);
      emtr_test::push(list, static_cast<float>(5 + 0.1 * (a * u[0] + b * v[0] + c * n[0])),
                      static_cast<float>(-3 + 0.1 * (a * u[1] + b * v[1] + c * n[1])),
                      static_cast<float>(1 + 0.1 * (a * u[2] + b * v[2] + c * n[2])));
    }
    emtr_test::push(centers, list.x[0], list.y[0], list.z[0]);
    const float query[3] = {list.x[0], list.y[0], list.z[0]};
    std::vector<float> first(emtr::kMoments), found(emtr::kMoments);
    emtr::kernels_at(0)->moments(list.view(), query, 1, first.data(), 1);
    for (const Kernels* kernel : kernels_here()) {
      kernel->moments(list.view(), query, 1, found.data(), 1);
      EXPECT_EQ(found, first) << kernel->name;
    }
    EXPECT_EQ(first[0], 48);
    for (std::size_t m = 0; m < emtr::kMoments; ++m) moments[m * discs + k] = first[m];
  }
  const float viewpoint[3] = {0, 0, 0};
  Cloud first;
  first.resize(discs);
  emtr::kernels_at(0)->plane_normals(moments.data(), discs, centers.view(), viewpoint,
                                     first.x.data(), first.y.data(), first.z.data());
  for (std::size_t k = 0; k < discs; ++k) {
    const Double3 n = at(first, k);
    EXPECT_NEAR(dot(n, n), 1, 1e-6);
    EXPECT_LE(dot(n, at(centers, k)), 1e-6);
    if (k >= 16) {  // from where on the disc is thin enough for its axis to be the direction
      EXPECT_GT(std::abs(dot(n, at(axes, k))), 0.995) << k;
    }
    // A x = lambda x, with the covariance in double
    const auto mean = [&](std::size_t m) { return double{moments[m * discs + k]} / 48; };
    const double s[3] = {mean(1), mean(2), mean(3)};
    const double A[3][3] = {{mean(4) - s[0] * s[0], mean(5) - s[0] * s[1], mean(6) - s[0] * s[2]},
                            {mean(5) - s[0] * s[1], mean(7) - s[1] * s[1], mean(8) - s[1] * s[2]},
                            {mean(6) - s[0] * s[2], mean(8) - s[1] * s[2], mean(9) - s[2] * s[2]}};
    Double3 image = {};
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c) image[r] += A[r][c] * n[c];
    const double lambda = dot(n, image), trace = A[0][0] + A[1][1] + A[2][2];
    for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(image[r], lambda * n[r], 1e-6 * trace) << k;
    EXPECT_LT(lambda, trace / 3);
  }
  for (const Kernels* kernel : kernels_here()) {
    Cloud found;
    found.resize(discs);
    kernel->plane_normals(moments.data(), discs, centers.view(), viewpoint, found.x.data(),
                          found.y.data(), found.z.data());
    EXPECT_EQ(found.x, first.x) << kernel->name;
    EXPECT_EQ(found.y, first.y) << kernel->name;
    EXPECT_EQ(found.z, first.z) << kernel->name;
  }
}

TEST(DescriptorKernels, WeightedHistogramsAreSumsOverSquaredDistance) {
  const std::size_t n = 1600;
  const Cloud cloud = emtr_test::uniform_cloud(n, 31);
  std::mt19937 random(32);
  std::vector<float> histograms(emtr::kDescriptorRow * n);
  for (std::size_t i = 0; i < histograms.size(); ++i)
    histograms[i] = i % emtr::kDescriptorRow < 33 ? static_cast<float>(random() % 1000) : 0;
  std::vector<std::uint32_t> rows(n);
  for (std::size_t i = 0; i < n; ++i) rows[i] = static_cast<std::uint32_t>(n - 1 - i);
  for (const std::size_t i : {0u, 700u, 1599u}) {
    const float query[3] = {cloud.x[i], cloud.y[i], cloud.z[i]};
    std::vector<double> expected(33, 0.0);
    for (std::size_t j = 0; j < n; ++j)
      if (j != i && squared(cloud, i, j) < 0.5f)
        for (std::size_t b = 0; b < 33; ++b)
          expected[b] +=
              double{histograms[emtr::kDescriptorRow * rows[j] + b]} / double{squared(cloud, i, j)};
    std::vector<float> first(33), found(33);
    emtr::kernels_at(0)->weighted_histograms(cloud.view(), rows.data(), query, 0.5f,
                                             histograms.data(), first.data());
    for (std::size_t b = 0; b < 33; ++b) {
      double whole = 0;
      for (std::size_t k = b / 11 * 11; k < b / 11 * 11 + 11; ++k) whole += expected[k];
      EXPECT_NEAR(first[b], 100 * expected[b] / whole, 1e-4);
    }
    for (const Kernels* k : kernels_here()) {
      k->weighted_histograms(cloud.view(), rows.data(), query, 0.5f, histograms.data(),
                             found.data());
      EXPECT_EQ(found, first) << k->name;
    }
  }
}

TEST(DescriptorKernels, LeastSquaredIsTheNearestOfTheList) {
  const Cloud cloud = emtr_test::uniform_cloud(320, 41);
  const Cloud queries = emtr_test::uniform_cloud(20, 42);
  for (std::size_t i = 0; i < queries.size(); ++i) {
    float expected = 1e30f;
    for (std::size_t j = 0; j < cloud.size(); ++j) {
      const float x = cloud.x[j] - queries.x[i], y = cloud.y[j] - queries.y[i],
                  z = cloud.z[j] - queries.z[i];
      expected = std::min(expected, (x * x + y * y) + z * z);
    }
    const float query[3] = {queries.x[i], queries.y[i], queries.z[i]};
    for (const Kernels* k : kernels_here())
      EXPECT_EQ(k->minimum_squared_distance(cloud.view(), query), expected) << k->name;
  }
}

}  // namespace
