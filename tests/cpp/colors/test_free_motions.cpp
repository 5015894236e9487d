#include <gtest/gtest.h>

#include "colors/free_motions.h"
#include "refinement/refiner.h"
#include "refinement/shapes.h"

namespace {

using emtr::Cloud;
using emtr::FreeMotions;
using emtr::HessianSpectrum;
using emtr::Rigid;

constexpr double kLeaf = 0.03;

HessianSpectrum spectrum_of(const Cloud& source, const Cloud& target, const Rigid& pose) {
  const emtr_test::Refiner refiner(emtr::downsample_surface(source, kLeaf),
                                   emtr::downsample_surface(target, kLeaf),
                                   emtr::LocalRefinementSettings());
  return hessian_spectrum(refiner(pose).sums);
}

template <class Shape>
FreeMotions motions_of(const Shape& shape) {
  const Rigid pose;
  return {spectrum_of(shape(1, 20000, 0.001), shape(2, 20000, 0.001), pose), pose};
}

/// How far the pose moves points off the shape, given how far a point is from it.
template <class Distance>
double off(const Cloud& cloud, const Rigid& pose, const Distance& distance) {
  double most = 0;
  for (std::size_t i = 0; i < cloud.size(); i += 50)
    most = std::max(most,
                    std::abs(distance(pose * Eigen::Vector3d(cloud.x[i], cloud.y[i], cloud.z[i]))));
  return most;
}

TEST(FreeMotions, OfAPlaneAreTwoTranslationsAndARotation) {
  const FreeMotions motions = motions_of(emtr_test::plane);
  EXPECT_EQ(motions.translations(), 2u);
  EXPECT_EQ(motions.rotations(), 1u);
  const Rigid pose = motions.at(Eigen::Vector3d(1.0, 0.4, -0.3));
  EXPECT_NEAR(emtr_test::degrees_between(pose, {}), 180 / M_PI, 0.5);
  EXPECT_LT(
      off(emtr_test::plane(3, 5000, 0), pose, [](const Eigen::Vector3d& p) { return p.z() - 0.1; }),
      0.02);
}

TEST(FreeMotions, OfACylinderAreOneOfEach) {
  const FreeMotions motions = motions_of(emtr_test::cylinder);
  EXPECT_EQ(motions.translations(), 1u);
  EXPECT_EQ(motions.rotations(), 1u);
  const Rigid pose = motions.at(Eigen::Vector2d(2.0, 0.3));
  EXPECT_LT(off(emtr_test::cylinder(3, 5000, 0), pose,
                [](const Eigen::Vector3d& p) { return p.head<2>().norm() - 0.4; }),
            0.02);
}

TEST(FreeMotions, OfASphereAreThreeRotations) {
  const FreeMotions motions = motions_of(emtr_test::sphere);
  EXPECT_EQ(motions.translations(), 0u);
  EXPECT_EQ(motions.rotations(), 3u);
  EXPECT_LT(off(emtr_test::sphere(3, 5000, 0), motions.at(Eigen::Vector3d(1, -0.5, 2)),
                [](const Eigen::Vector3d& p) { return p.norm() - 0.8; }),
            0.02);
}

TEST(FreeMotions, OfACubeAreNone) { EXPECT_EQ(motions_of(emtr_test::cube).size(), 0u); }

TEST(FreeMotions, TheOriginIsThePose) {
  const Rigid pose = emtr_test::motion({0, 0, 20}, {0.1, -0.2, 0});
  const Cloud a = emtr_test::plane(1, 20000, 0.001), b = emtr_test::plane(2, 20000, 0.001);
  const FreeMotions motions(spectrum_of(a, b, pose), pose);
  const Rigid same = motions.at(motions.origin());
  EXPECT_LT(emtr_test::degrees_between(same, pose), 1e-6);
  EXPECT_LT(emtr_test::translation_between(same, pose), 1e-9);
}

}  // namespace
