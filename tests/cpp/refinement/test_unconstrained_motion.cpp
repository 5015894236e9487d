#include <gtest/gtest.h>

#include "refinement/refiner.h"
#include "refinement/shapes.h"
#include "refinement/unconstrained_motion.h"

namespace {

using emtr::HessianSpectrum;
using emtr::Rigid;
using emtr_test::motion;

HessianSpectrum spectrum_of(emtr::Cloud (*shape)(std::uint64_t, std::size_t, double)) {
  const emtr_test::Refiner refiner(emtr::downsample_surface(shape(1, 30000, 0.001), 0.03),
                                   emtr::downsample_surface(shape(2, 30000, 0.001), 0.03),
                                   emtr::LocalRefinementSettings());
  return emtr::hessian_spectrum(refiner(Rigid()).sums);
}

TEST(UnconstrainedMotion, OfACylinderIsAnyAboutAndAlongItsAxis) {
  const HessianSpectrum s = spectrum_of(emtr_test::cylinder);  // about z
  const Rigid pose = motion({20, 30, 40}, {0.1, 0.2, 0.3});
  for (const double angle : {1.0, 40.0, 170.0, 180.0})
    for (const double along : {0.0, 0.6})
      EXPECT_TRUE(
          emtr::is_same_but_unconstrained(motion({0, 0, angle}, {0, 0, along}) * pose, pose, s))
          << angle << ", " << along;
  EXPECT_FALSE(emtr::is_same_but_unconstrained(motion({180, 0, 0}, {0, 0, 0}) * pose, pose, s));
  EXPECT_FALSE(emtr::is_same_but_unconstrained(motion({0, 20, 0}, {0, 0, 0}) * pose, pose, s));
  EXPECT_FALSE(emtr::is_same_but_unconstrained(motion({0, 0, 90}, {0.3, 0, 0}) * pose, pose, s));
}

TEST(UnconstrainedMotion, OfASphereIsAnyRotationAboutItsCenter) {
  const HessianSpectrum s = spectrum_of(emtr_test::sphere);
  for (const double angle : {5.0, 90.0, 179.0})
    EXPECT_TRUE(emtr::is_same_but_unconstrained(motion({angle, angle / 3, -angle / 2}, {0, 0, 0}),
                                                Rigid(), s));
  EXPECT_FALSE(emtr::is_same_but_unconstrained(motion({40, 0, 0}, {0.2, 0, 0}), Rigid(), s));
}

TEST(UnconstrainedMotion, LeadsFromOnePoseToTheOther) {
  const HessianSpectrum s = spectrum_of(emtr_test::cylinder);
  const Rigid b = motion({20, 30, 40}, {0.1, 0.2, 0.3});
  const Rigid a = motion({0, 0, 120}, {0, 0, 0.6}) * b;
  const auto distance = [](const Rigid& x, const Rigid& y) {
    return (x.R - y.R).norm() + (x.t - y.t).norm();
  };
  EXPECT_LT(distance(emtr::between(a, b, s, 0), b), 1e-9);
  EXPECT_LT(distance(emtr::between(a, b, s, 1), a), 1e-9);
  const Rigid half = emtr::between(a, b, s, 0.5);
  EXPECT_LT((half.R - motion({0, 0, 60}, {0, 0, 0}).R * b.R).norm(), 1e-9);
  EXPECT_TRUE(emtr::is_same_but_unconstrained(half, b, s));
  const Rigid slid = motion({0, 0, 0}, {0, 0, 0.5}) * b;
  EXPECT_LT(distance(emtr::between(slid, b, s, 0.5), motion({0, 0, 0}, {0, 0, 0.25}) * b), 1e-9);
}

TEST(UnconstrainedMotion, OfACubeIsNone) {
  const HessianSpectrum s = spectrum_of(emtr_test::cube);
  EXPECT_TRUE(emtr::is_same_but_unconstrained(motion({4, 0, 0}, {0.1, 0, 0}), Rigid(), s));
  EXPECT_FALSE(emtr::is_same_but_unconstrained(motion({0, 0, 90}, {0, 0, 0}), Rigid(), s));
  EXPECT_FALSE(emtr::is_same_but_unconstrained(motion({0, 0, 0}, {0, 0.2, 0}), Rigid(), s));
}

}  // namespace
