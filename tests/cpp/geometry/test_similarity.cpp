#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "geometry/similarity.h"
#include "refinement/shapes.h"
#include "support/clouds.h"

namespace {

using Eigen::Vector3d;
using emtr::Similarity;

const Similarity kExample{2.5, emtr_test::motion({20, -50, 70}, {0.3, -0.2, 1.1})};

TEST(Similarity, MovesAPointByScaleRotationAndTranslation) {
  const Vector3d p(0.4, -0.7, 0.2);
  const Vector3d q = kExample * p;
  const Vector3d expected = 2.5 * (kExample.pose.R * p) + kExample.pose.t;
  EXPECT_LT((q - expected).norm(), 1e-15);
  EXPECT_LT((kExample.inverse() * q - p).norm(), 1e-15);
}

TEST(Similarity, OfScaleOneHasTheBitsOfItsPose) {
  const Similarity rigid{1, kExample.pose};
  const Vector3d p(0.4, -0.7, 0.2);
  EXPECT_EQ(rigid * p, rigid.pose * p);
  EXPECT_EQ(rigid.inverse().pose.t, rigid.pose.inverse().t);
  double a[16], b[16];
  emtr::to_matrix(rigid, a);
  emtr::to_matrix(rigid.pose, b);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(a[i], b[i]);
  const emtr::Cloud cloud = emtr_test::uniform_cloud(50, 3);
  emtr::Cloud x, y;
  x.resize(50);
  y.resize(50);
  const emtr::Kernels& kernels = emtr::select_kernels();
  emtr::transform(kernels, cloud.view(), rigid, x.x.data(), x.y.data(), x.z.data());
  emtr::transform(kernels, cloud.view(), rigid.pose, y.x.data(), y.y.data(), y.z.data());
  EXPECT_EQ(x.x, y.x);
  EXPECT_EQ(x.z, y.z);
}

TEST(Similarity, IsReadFromItsMatrix) {
  double T[16];
  emtr::to_matrix(kExample, T);
  const auto read = emtr::similarity_from_matrix(T);
  ASSERT_TRUE(read);
  EXPECT_NEAR(read->scale, 2.5, 1e-14);
  EXPECT_LT((read->pose.R - kExample.pose.R).norm(), 1e-14);
  EXPECT_EQ(read->pose.t, kExample.pose.t);
}

TEST(Similarity, IsNotReadFromAnyOtherMatrix) {
  double T[16];
  emtr::to_matrix(kExample, T);
  const auto changed = [&](int i, double value) {
    double other[16];
    std::copy_n(T, 16, other);
    other[i] = value;
    return emtr::similarity_from_matrix(other).has_value();
  };
  EXPECT_FALSE(changed(0, T[0] + 0.1));  // sheared
  EXPECT_FALSE(changed(12, 0.1));
  EXPECT_FALSE(changed(3, NAN));
  double mirrored[16];
  std::copy_n(T, 16, mirrored);
  for (int i = 0; i < 3; ++i) mirrored[4 * i] *= -1;
  EXPECT_FALSE(emtr::similarity_from_matrix(mirrored));
}

TEST(Similarity, ChangesItsScaleAboutWhereTheSourcesOriginEnds) {
  const double x[7] = {0, 0, 0, 0, 0, 0, std::log(1.1)};
  const Similarity moved = emtr::moved(kExample, x);
  EXPECT_NEAR(moved.scale, 2.75, 1e-14);
  EXPECT_LT((moved * Vector3d::Zero() - kExample * Vector3d::Zero()).norm(), 1e-15);
}

}  // namespace
