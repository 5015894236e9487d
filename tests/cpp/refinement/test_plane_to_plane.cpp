#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <cstring>

#include "geometry/small_motion.h"
#include "refinement/matched_pairs.h"
#include "refinement/plane_to_plane.h"
#include "refinement/shapes.h"
#include "support/clouds.h"

namespace {

using emtr::NormalEquations;
using emtr::PlaneToPlane;
using emtr::Rigid;
using emtr::SurfacePoint;
using emtr_test::motion;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::RowMajor>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

SurfacePoint oriented(const Eigen::Vector3d& p, const Eigen::Vector3d& n) {
  SurfacePoint out;
  Eigen::Vector3f::Map(out.p) = p.cast<float>();
  Eigen::Vector3f::Map(out.n) = n.normalized().cast<float>();
  return out;
}

constexpr double kEps = 5e-3, kScale = 0.08;

struct Match {
  Rigid pose = motion({20, -30, 50}, {0.1, -0.2, 0.05});
  Eigen::Vector3d p{0.3, -0.4, 0.5}, n{0.1, 0.8, -0.5}, d{0.01, 0.012, -0.006}, tilt{3, -4, 2};

  Eigen::Matrix3d R() const { return pose.R; }
  Eigen::Vector3d y() const { return R() * p + pose.t; }
  SurfacePoint source() const { return oriented(p, n); }
  SurfacePoint target() const {
    const Rigid rotation = motion(tilt, {0, 0, 0});
    return oriented(y() - d, rotation.R * R() * n);
  }
  NormalEquations sums(double scale = kScale, double gate = 0.7) const {
    NormalEquations out;
    PlaneToPlane(pose, scale, kEps, gate).add(source(), target(), out);
    return out;
  }

  /// 2 eps C^-1 by the definition.
  Eigen::Matrix3d metric() const {
    const Eigen::Vector3d m = R() * Eigen::Vector3f::Map(source().n).cast<double>();
    const Eigen::Vector3d q = Eigen::Vector3f::Map(target().n).cast<double>();
    const Eigen::Matrix3d C =
        2 * Eigen::Matrix3d::Identity() - (1 - kEps) * (m * m.transpose() + q * q.transpose());
    return 2 * kEps * C.inverse();
  }
};

TEST(PlaneToPlane, StepAndMatrixAreThoseOfTheDefinition) {
  const Match match;
  const NormalEquations sums = match.sums();
  const Eigen::Matrix3d M = match.metric();
  const Eigen::Vector3d y = match.y(), d = match.d;
  Eigen::Matrix<double, 3, 6> J;
  J << 0, y.z(), -y.y(), 1, 0, 0, -y.z(), 0, y.x(), 0, 1, 0, y.y(), -y.x(), 0, 0, 0, 1;
  const double tukey = std::pow(1 - d.dot(M * d) / (kScale * kScale), 2);
  Matrix6 full;
  sums.full_matrix(full.data());
  EXPECT_LT((full - tukey * J.transpose() * M * J).norm(), 0.01 * full.norm());
  const Vector6 g = tukey * J.transpose() * M * d;
  EXPECT_LT((Vector6::Map(sums.g) - g).norm(), 0.01 * g.norm());
}

TEST(PlaneToPlane, TakesAMotionAsMovedDoes) {
  // The derivative of half the cost with the metric held, by finite differences of moved().
  const Match match;
  const Eigen::Matrix3d M = match.metric();
  const double wide = 1e6;  // no bend
  const NormalEquations sums = match.sums(wide);
  for (int k = 0; k < 6; ++k) {
    const auto cost = [&](double h) {
      double x[6] = {};
      x[k] = h;
      Match other = match;
      other.pose = emtr::moved(match.pose, x);
      const Eigen::Vector3d d = other.y() - match.y() + match.d;
      return d.dot(M * d) / 2;
    };
    const double slope = (cost(1e-5) - cost(-1e-5)) / 2e-5;
    EXPECT_NEAR(sums.g[k], slope, 1e-2 * Vector6::Map(sums.g).norm()) << k;
  }
}

TEST(PlaneToPlane, SlopesAreTheDerivativeOfTheForce) {
  Match match;
  match.tilt.setZero();
  const Eigen::Vector3d u = (match.R() * match.n).normalized();
  const auto force = [&](double e) {
    Match at = match;
    at.d = e * u;
    const NormalEquations s = at.sums();
    return s.g[3] * u[0] + s.g[4] * u[1] + s.g[5] * u[2];
  };
  for (const double e : {0.0, 0.01, 0.03, 0.06}) {
    Match at = match;
    at.d = e * u;
    EXPECT_NEAR(at.sums().slopes, (force(e + 1e-4) - force(e - 1e-4)) / 2e-4, 0.02) << e;
  }
}

TEST(PlaneToPlane, LeavesOutFarPairsOtherNormalsAndNone) {
  Match match;
  EXPECT_EQ(match.sums().inliers, 1);
  EXPECT_EQ(match.sums(0.005).inliers, 0);
  NormalEquations none;
  Match tilted = match;
  tilted.tilt = 35 * (match.R() * match.n).unitOrthogonal();  // cosine 0.82
  EXPECT_EQ(tilted.sums(kScale, 0.8).inliers, 1);
  EXPECT_EQ(tilted.sums(kScale, 0.84).inliers, 0);
  SurfacePoint bare = match.source();
  bare.n[0] = bare.n[1] = bare.n[2] = std::nanf("");
  PlaneToPlane(match.pose, kScale, kEps, 0).add(bare, match.target(), none);
  PlaneToPlane(match.pose, kScale, kEps, 0).add(match.source(), bare, none);
  EXPECT_EQ(none.inliers, 0);
  EXPECT_EQ(none.weights, 0);
}

TEST(PlaneToPlane, ManyPairsHaveTheSumsOfEachByEveryInstructionSet) {
  const Match match;
  const emtr::Cloud off = emtr_test::uniform_cloud(203, 5);
  const PlaneToPlane estimator(match.pose, kScale, kEps, 0.7);
  emtr::MatchedPairs<256> pairs;
  NormalEquations one_by_one;
  for (std::size_t i = 0; i < off.size(); ++i) {
    Match other = match;
    const Eigen::Vector3d here(off.x[i], off.y[i], off.z[i]);
    other.p += here;
    other.d = 0.03 * here;   // some are beyond the cut-off
    other.tilt = 50 * here;  // and some beyond the gate
    SurfacePoint source = other.source();
    if (i % 20 == 0) source.n[0] = source.n[1] = source.n[2] = std::nanf("");
    if (i % 3 == 0)
      for (float& n : source.n) n = -n;
    pairs.add(source, other.target());
    estimator.add(source, other.target(), one_by_one);
  }
  ASSERT_GT(one_by_one.inliers, 40);
  ASSERT_LT(one_by_one.inliers, 190);
  double expected[36], found[36];
  one_by_one.full_matrix(expected);
  const NormalEquations first = estimator.sums(pairs.view(), *emtr::kernels_at(0));
  first.full_matrix(found);
  for (int k = 0; k < 36; ++k) EXPECT_NEAR(found[k], expected[k], 1e-11) << k;
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(first.g[k], one_by_one.g[k], 1e-11) << k;
  EXPECT_EQ(first.inliers, one_by_one.inliers);
  EXPECT_NEAR(first.weights, one_by_one.weights, 1e-11);
  EXPECT_NEAR(first.squares, one_by_one.squares, 1e-11);
  EXPECT_NEAR(first.squared_influence, one_by_one.squared_influence, 1e-11);
  EXPECT_NEAR(first.slopes, one_by_one.slopes, 1e-11);
  for (const emtr::Kernels* k : emtr_test::kernels_here()) {
    const NormalEquations sums = estimator.sums(pairs.view(), *k);
    EXPECT_EQ(std::memcmp(&sums, &first, sizeof sums), 0) << k->name;
  }
}

TEST(PlaneToPlane, GradientIsWhatAPairAdds) {
  const Match match;
  double gradient[6];
  const PlaneToPlane estimator(match.pose, kScale, kEps, 0.7);
  ASSERT_TRUE(estimator.gradient(match.source(), match.target(), gradient));
  const NormalEquations sums = match.sums();
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(gradient[k], sums.g[k], 1e-15) << k;
  EXPECT_FALSE(PlaneToPlane(match.pose, 0.005, kEps, 0.7)
                   .gradient(match.source(), match.target(), gradient));
}

TEST(Moved, IsTheExponentialOnTheLeftAndStaysARotation) {
  const Rigid pose = motion({20, -30, 50}, {0.1, -0.2, 0.05});
  const double x[6] = {0.3, -0.1, 0.2, 0.01, 0.02, -0.03};
  const Rigid out = emtr::moved(pose, x);
  const Rigid rotation = motion(Eigen::Vector3d(x[0], x[1], x[2]) * 180 / M_PI, {x[3], x[4], x[5]});
  const Eigen::Matrix3d wanted = rotation.R * pose.R;
  EXPECT_LT((out.R - wanted).norm(), 1e-14);
  Rigid many = pose;
  for (int i = 0; i < 2000; ++i) many = emtr::moved(many, x);
  const Eigen::Matrix3d& R = many.R;
  EXPECT_LT((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
  const double nothing[6] = {};
  EXPECT_LT(emtr_test::degrees_between(emtr::moved(pose, nothing), pose), 1e-12);
}

}  // namespace
