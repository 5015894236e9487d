#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

#include "preprocessing/normalization.h"
#include "util/error.h"

namespace {

using Points = std::vector<Eigen::Vector3d>;

emtr_cloud view(const Points& points) {
  return {points.data(), points.size(), sizeof(Eigen::Vector3d), EMTR_FLOAT64};
}

Points ellipsoid(double unit, const Eigen::Vector3d& offset) {
  Points points;
  for (int i = 0; i < 200; ++i) {
    const double a = i * 2.39996, z = 2 * (i + 0.5) / 200 - 1, r = std::sqrt(1 - z * z);
    points.push_back(offset +
                     unit * Eigen::Vector3d(r * std::cos(a), 0.6 * r * std::sin(a), 0.4 * z));
  }
  return points;
}

emtr::Error error_of(const Points& source, const Points& target) {
  try {
    emtr::normalize(view(source), view(target), 1);
  } catch (const emtr::Error& error) {
    return error;
  }
  return {EMTR_OK, "no error"};
}

TEST(Normalization, CentresBothAndScalesByTheLargerRadius) {
  const auto pair =
      emtr::normalize(view(ellipsoid(3, {1, 2, 3})), view(ellipsoid(5, {0, 0, 9})), 1);
  double largest = 0, mean = 0;
  for (std::size_t i = 0; i < pair.target.size(); ++i) {
    largest = std::max(largest, std::hypot(double{pair.target.x[i]}, double{pair.target.y[i]},
                                           double{pair.target.z[i]}));
    mean += double{pair.source.x[i]};
  }
  EXPECT_NEAR(largest, 1, 1e-6);
  EXPECT_NEAR(mean, 0, 1e-4);
  EXPECT_NEAR(pair.normalization.scale, 5, 0.05);
}

TEST(Normalization, KeepsItsDigitsFarFromTheOriginAndInEveryUnit) {
  const auto near =
      emtr::normalize(view(ellipsoid(1, {0, 0, 0})), view(ellipsoid(1, {0, 0, 0})), 1);
  for (const double unit : {1e-3, 1.0, 1e3}) {
    const Points far = ellipsoid(unit, Eigen::Vector3d(5e5, 4e6, 100) * unit);
    const auto moved = emtr::normalize(view(far), view(far), 1);
    for (std::size_t i = 0; i < near.source.size(); ++i)
      EXPECT_NEAR(moved.source.x[i], near.source.x[i], 1e-6);
  }
}

TEST(Normalization, ConvertsPosesThereAndBack) {
  emtr::Normalization normalization;
  normalization.scale = 7;
  normalization.center_source[0] = 100;
  normalization.center_target[2] = -30;
  emtr::Rigid pose;
  pose.R(0, 0) = pose.R(1, 1) = 0;
  pose.R(0, 1) = -1;
  pose.R(1, 0) = 1;
  pose.t[1] = 0.25;
  const emtr::Rigid user = normalization.to_user(pose);
  // A rotation by 90 degrees takes the source's centroid (100, 0, 0) to (0, 100, 0).
  EXPECT_DOUBLE_EQ(user.t[0], 0);
  EXPECT_DOUBLE_EQ(user.t[1], 7 * 0.25 - 100);
  EXPECT_DOUBLE_EQ(user.t[2], -30);
  const emtr::Rigid back = normalization.to_normalized(user);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(back.t[i], pose.t[i], 1e-14);
}

TEST(Normalization, DropsAndCountsWhatIsNotFinite) {
  Points source = ellipsoid(1, {0, 0, 0});
  const Points target = source;
  source[3].x() = std::numeric_limits<double>::quiet_NaN();
  source[9].z() = std::numeric_limits<double>::infinity();
  const auto pair = emtr::normalize(view(source), view(target), 1);
  EXPECT_EQ(pair.preprocessed_source->dropped, 2u);
  EXPECT_EQ(pair.preprocessed_target->dropped, 0u);
  EXPECT_EQ(pair.source.size(), 198u);
}

TEST(Normalization, ReadsFloatsAtAnyStrideAndAlignment) {
  const Points points = ellipsoid(1, {0, 0, 0});
  std::vector<char> bytes(points.size() * 29 + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector3f p = points[i].cast<float>();
    std::memcpy(&bytes[29 * i + 1], p.data(), 12);
  }
  const emtr_cloud odd{&bytes[1], points.size(), 29, EMTR_FLOAT32};
  const auto pair = emtr::normalize(odd, view(points), 1);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR(pair.source.y[i], pair.target.y[i], 1e-6);
}

TEST(Normalization, NamesTheCloudThatCannotBeRegistered) {
  const Points good = ellipsoid(1, {0, 0, 0});
  const Points few(good.begin(), good.begin() + 9);
  const Points equal(50, Eigen::Vector3d(3, 4, 5));
  Points line, huge = good;
  for (int i = 0; i < 50; ++i) line.emplace_back(i, 2 * i + 1, -i);
  for (auto& p : huge) p *= 1e300;

  const auto expect = [](const emtr::Error& error, const char* cloud, const char* what) {
    EXPECT_EQ(error.status(), EMTR_ERROR_CLOUD);
    EXPECT_EQ(std::string(error.what()).rfind(cloud, 0), 0u) << error.what();
    EXPECT_NE(std::string(error.what()).find(what), std::string::npos) << error.what();
  };
  expect(error_of(few, good), "source cloud", "9 finite points");
  expect(error_of(good, few), "target cloud", "at least 10");
  expect(error_of(good, {}), "target cloud", "0 finite points");
  expect(error_of(equal, good), "source cloud", "equal");
  expect(error_of(good, line), "target cloud", "line");
  expect(error_of(huge, good), "source cloud", "too large");
}

TEST(Normalization, RefusesViewsThatCannotBeRead) {
  const Points good = ellipsoid(1, {0, 0, 0});
  const auto status = [&](emtr_cloud bad) {
    try {
      emtr::normalize(view(good), bad, 1);
    } catch (const emtr::Error& error) {
      return error.status();
    }
    return EMTR_OK;
  };
  EXPECT_EQ(status({nullptr, 100, 0, EMTR_FLOAT32}), EMTR_ERROR_ARGUMENT);
  EXPECT_EQ(status({good.data(), 200, 8, EMTR_FLOAT32}), EMTR_ERROR_ARGUMENT);
  emtr_cloud unknown = view(good);
  const int scalar = 3;  // what a caller in C may well pass
  std::memcpy(&unknown.scalar, &scalar, sizeof unknown.scalar);
  EXPECT_EQ(status(unknown), EMTR_ERROR_ARGUMENT);
}

}  // namespace
