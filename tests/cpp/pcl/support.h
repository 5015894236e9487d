#pragma once

#include <gtest/gtest.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/registration/emtr_ssc.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>

#include "bumpy_pair.h"

/// Gives a synthetic pair with a known pose as clouds of any point type.
class Pair {
 public:
  explicit Pair(std::uint64_t seed = 1, std::size_t count = 3000, double unit = 1.0) {
    if (bumpy_pair_make(&pair_, seed, count, unit) != 0) throw std::bad_alloc();
  }
  ~Pair() { bumpy_pair_free(&pair_); }
  Pair(const Pair&) = delete;
  Pair& operator=(const Pair&) = delete;

  template <typename PointT = pcl::PointXYZ>
  typename pcl::PointCloud<PointT>::Ptr source() const {
    return cloud<PointT>(pair_.source);
  }
  template <typename PointT = pcl::PointXYZ>
  typename pcl::PointCloud<PointT>::Ptr target() const {
    return cloud<PointT>(pair_.target);
  }

  Eigen::Matrix4d pose() const {
    return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(pair_.pose);
  }

  /// Returns how far `estimate` puts the source from its true place, in radii of the ball.
  template <typename Scalar>
  double error(const Eigen::Matrix<Scalar, 4, 4>& estimate) const {
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = estimate.template cast<double>();
    return bumpy_pair_error(&pair_, rows.data());
  }

 private:
  template <typename PointT>
  typename pcl::PointCloud<PointT>::Ptr cloud(const float* points) const {
    typename pcl::PointCloud<PointT>::Ptr made(new pcl::PointCloud<PointT>);
    for (std::size_t i = 0; i < pair_.count; ++i) {
      PointT point;
      point.x = points[3 * i];
      point.y = points[3 * i + 1];
      point.z = points[3 * i + 2];
      made->push_back(point);
    }
    return made;
  }

  bumpy_pair pair_;
};

/// The largest error of a right pose: 5 degrees of rotation alone are about 0.07.
constexpr double kRight = 0.05;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Returns one pair for all tests; each call makes new clouds of it.
inline const Pair& sharedPair() {
  static const Pair pair;
  return pair;
}

template <typename Matrix>
bool sameBits(const Matrix& a, const Matrix& b) {
  return (a.array() == b.array()).all();
}

template <typename Matrix>
bool allNaN(const Matrix& m) {
  return m.array().isNaN().all();
}

/// A registration of the shared pair, whose clouds each test has for its own.
class SharedPairTest : public testing::Test {
 protected:
  using Cloud = pcl::PointCloud<pcl::PointXYZ>;
  using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ>;

  void SetUp() override {
    reg.setNumberOfThreads(2);
    reg.setInputSource(source);
    reg.setInputTarget(target);
  }

  Cloud::Ptr source = sharedPair().source();
  Cloud::Ptr target = sharedPair().target();
  Cloud output;
  Registration reg;
};
