#include <gtest/gtest.h>

#include "colors/painted.h"
#include "colors/photometric_refinement.h"
#include "refinement/hessian_spectrum.h"
#include "voxels/voxel_order.h"

namespace {

using emtr::Rigid;
using emtr_test::Painted;

constexpr double kLeaf = 0.02;

emtr::PhotometricResult refined(const Painted& source, const Painted& target, const Rigid& start) {
  const emtr::FineSurfaces fine = emtr_test::fine_surfaces_of(source.points, target.points, kLeaf);
  const auto leaf = static_cast<float>(fine.leaf());
  const emtr::Channels channels =
      emtr::make_channels(emtr::mean_colors(source.points, source.colors, leaf),
                          emtr::mean_colors(target.points, target.colors, leaf));
  return emtr::PhotometricRefinement(fine, channels, emtr::select_kernels())(start, nullptr);
}

TEST(PhotometricRefinement, MovesAPlaneWithinItselfToWhereTheColorsAgree) {
  const emtr_test::Patches patches(1);
  const Painted source = emtr_test::painted_plane(patches, 2),
                target = emtr_test::painted_plane(patches, 3, 0.2, 0.6, 0.2);
  for (const Rigid& start : {emtr_test::motion({0, 0, 2}, {0.02, -0.01, 0}),
                             emtr_test::motion({1, -1, -2}, {-0.02, 0.02, 0.01})}) {
    const emtr::PhotometricResult result = refined(source, target, start);
    ASSERT_TRUE(result.succeeded);
    EXPECT_LT(emtr_test::degrees_between(result.pose, {}), 0.2);
    EXPECT_LT(emtr_test::translation_between(result.pose, {}), 0.003);
  }
}

TEST(PhotometricRefinement, ConstrainsWhatThePlaneDoesNot) {
  const emtr_test::Patches patches(1);
  const emtr::PhotometricResult result =
      refined(emtr_test::painted_plane(patches, 2), emtr_test::painted_plane(patches, 3), {});
  EXPECT_EQ(emtr::hessian_spectrum(result.geometric).unconstrained, 3);
  emtr::NormalEquations both = result.geometric;
  for (int k = 0; k < 21; ++k) both.H[k] += kLeaf * kLeaf * result.photometric.H[k];
  EXPECT_EQ(emtr::hessian_spectrum(both).unconstrained, 0);
}

TEST(PhotometricRefinement, DoesNotMindSomethingThatWasPutThereLater) {
  const emtr_test::Patches patches(1);
  const Painted source = emtr_test::painted_plane(patches, 2);
  Painted target = emtr_test::painted_plane(patches, 3);
  for (std::size_t i = 0; i < target.points.size(); ++i)
    if (target.points.x[i] > 0.3f && target.points.y[i] > 0) {
      const float black[3] = {0, 0, 0};
      target.colors.set(i, black);
    }
  const emtr::PhotometricResult result =
      refined(source, target, emtr_test::motion({0, 0, 1}, {0.015, 0.01, 0}));
  ASSERT_TRUE(result.succeeded);
  EXPECT_LT(emtr_test::degrees_between(result.pose, {}), 0.2);
  EXPECT_LT(emtr_test::translation_between(result.pose, {}), 0.003);
}

TEST(PhotometricRefinement, StaysWhereTheCloudsAreApart) {
  const emtr_test::Patches patches(1);
  const Rigid start = emtr_test::motion({0, 0, 0}, {0, 0, 3});
  const emtr::PhotometricResult result =
      refined(emtr_test::painted_plane(patches, 2), emtr_test::painted_plane(patches, 3), start);
  EXPECT_FALSE(result.succeeded);
  EXPECT_EQ(result.pose.t, start.t);
}

}  // namespace
