#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <functional>

#include "priors/make_prior.h"
#include "refinement/hessian_spectrum.h"
#include "refinement/refiner.h"
#include "refinement/shapes.h"

namespace {

using emtr::HessianSpectrum;
using Vector6 = Eigen::Matrix<double, 6, 1>;

HessianSpectrum spectrum_of(
    const std::function<emtr::Cloud(std::uint64_t, std::size_t, double)>& shape) {
  const emtr_test::Refiner refiner(emtr::downsample_surface(shape(1, 30000, 0.001), 0.03),
                                   emtr::downsample_surface(shape(2, 30000, 0.001), 0.03),
                                   emtr::LocalRefinementSettings());
  return emtr::hessian_spectrum(refiner(emtr::Rigid()).sums);
}

/// How much of a motion (rotation vector about the center, then translation) lies in the
/// unconstrained directions, of [0, 1].
double unconstrained_part(const HessianSpectrum& s, Vector6 motion) {
  motion.head<3>() *= s.radius;
  motion.normalize();
  double squares = 0;
  for (int k = 0; k < s.unconstrained; ++k) {
    const double part = Eigen::Map<const Vector6>(s.eigenvectors[k]).dot(motion);
    squares += part * part;
  }
  return std::sqrt(squares);
}

TEST(HessianSpectrum, OfAPlaneLeavesTwoTranslationsAndARotation) {
  const HessianSpectrum s = spectrum_of(emtr_test::plane);
  ASSERT_EQ(s.unconstrained, 3);
  EXPECT_LT(s.condition(), 0.01);
  EXPECT_GT(unconstrained_part(s, {0, 0, 0, 1, 0, 0}), 0.99);
  EXPECT_GT(unconstrained_part(s, {0, 0, 0, 0, 1, 0}), 0.99);
  EXPECT_GT(unconstrained_part(s, {0, 0, 1, 0, 0, 0}), 0.99);
  EXPECT_LT(unconstrained_part(s, {0, 0, 0, 0, 0, 1}), 0.1);
}

TEST(HessianSpectrum, OfASphereLeavesThreeRotations) {
  const HessianSpectrum s = spectrum_of(emtr_test::sphere);
  ASSERT_EQ(s.unconstrained, 3);
  for (int k = 0; k < 3; ++k) {
    EXPECT_GT(unconstrained_part(s, Vector6::Unit(k)), 0.99);
    EXPECT_LT(unconstrained_part(s, Vector6::Unit(3 + k)), 0.1);
    EXPECT_NEAR(s.eigenvalues[3 + k], 1.0 / 3, 0.05);
  }
  EXPECT_NEAR(s.radius, 0.8, 0.02);
}

TEST(HessianSpectrum, OfACylinderLeavesATranslationAndARotation) {
  const HessianSpectrum s = spectrum_of(emtr_test::cylinder);
  ASSERT_EQ(s.unconstrained, 2);
  EXPECT_GT(unconstrained_part(s, {0, 0, 1, 0, 0, 0}), 0.99);
  EXPECT_GT(unconstrained_part(s, {0, 0, 0, 0, 0, 1}), 0.99);
}

TEST(HessianSpectrum, OfACubeLeavesNone) {
  const HessianSpectrum s = spectrum_of(emtr_test::cube);
  EXPECT_EQ(s.unconstrained, 0);
  EXPECT_GT(s.condition(), 0.1);
  EXPECT_GT(s.eigenvalues[0], 0.03);
}

TEST(HessianSpectrum, DoesNotDependOnWhereAndHowLargeTheOverlapIs) {
  // A corner of the cube, small and far from the origin, is as firm as a corner anywhere.
  const auto corner = [](std::uint64_t seed, std::size_t n, double noise) {
    return emtr_test::Draw(seed).cloud(n, noise, [](emtr_test::Draw& d) {
      Eigen::Vector3d p(d.uniform(0, 0.3), d.uniform(0, 0.3), d.uniform(0, 0.3));
      p[static_cast<int>(d.uniform(0, 3))] = 0;
      return Eigen::Vector3d(p + Eigen::Vector3d(0.5, 0.45, -0.4));
    });
  };
  const HessianSpectrum s = spectrum_of(corner);
  EXPECT_EQ(s.unconstrained, 0);
  EXPECT_GT(s.eigenvalues[0], 0.02);
  EXPECT_LT(s.radius, 0.3);
  EXPECT_NEAR(s.center[0], 0.6, 0.03);
  EXPECT_NEAR(s.center[2], -0.3, 0.03);
}

TEST(HessianSpectrum, OfNothingIsAllUnconstrained) {
  const HessianSpectrum s = emtr::hessian_spectrum(emtr::NormalEquations());
  EXPECT_EQ(s.unconstrained, 6);
  EXPECT_EQ(s.condition(), 0);
}

/// Counts among the directions that a prior leaves.
TEST(HessianSpectrum, WhatAPriorFixesIsNotUnconstrained) {
  const auto unconstrained = [](const HessianSpectrum& s, const Eigen::Vector3d& axis,
                                double largest) {
    emtr::Settings settings = emtr::preset("default");
    settings.has_axis = 1;
    Eigen::Vector3d::Map(settings.axis) = axis;
    settings.maximum_rotation = largest;
    const auto prior = emtr::make_prior(settings, emtr::Normalization());
    return emtr::unconstrained_within(s, prior->limits(emtr::Rigid()));
  };
  const Eigen::Vector3d x(1, 0, 0), z(0, 0, 1);
  const HessianSpectrum plane = spectrum_of(emtr_test::plane),
                        sphere = spectrum_of(emtr_test::sphere);
  EXPECT_EQ(emtr::unconstrained_within(plane, {}), 3);
  EXPECT_EQ(unconstrained(plane, z, 180), 3);
  EXPECT_EQ(unconstrained(plane, x, 180), 2);
  EXPECT_EQ(unconstrained(plane, z, 0), 2);
  EXPECT_EQ(unconstrained(sphere, z, 180), 1);
  EXPECT_EQ(unconstrained(sphere, z, 0), 0);
}

}  // namespace
