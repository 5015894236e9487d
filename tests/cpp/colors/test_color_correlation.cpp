#include <gtest/gtest.h>

#include "colors/color_correlation.h"
#include "colors/painted.h"
#include "voxels/voxel_grid.h"
#include "voxels/voxel_order.h"

namespace {

using emtr::ColorCorrelation;
using emtr::Rigid;
using emtr_test::Painted;

constexpr float kLeaf = 0.02f;

ColorCorrelation compared(const Painted& a, const Painted& b) {
  const emtr::Cloud source = emtr::voxel_grid(a.points, kLeaf),
                    target = emtr::voxel_grid(b.points, kLeaf);
  return {source,
          target,
          emtr::make_channels(emtr::mean_colors(a.points, a.colors, kLeaf),
                              emtr::mean_colors(b.points, b.colors, kLeaf)),
          kLeaf,
          2000,
          emtr::select_kernels()};
}

Rigid along_x(double x) { return emtr_test::motion({0, 0, 0}, {x, 0, 0}); }

TEST(ColorCorrelation, IsHighWhereTheColorsLieOnEachOther) {
  const emtr_test::Patches patches(1);
  const ColorCorrelation colors = compared(emtr_test::painted_plane(patches, 2),
                                           emtr_test::painted_plane(patches, 3, 0.3, 0.6, 0.2));
  ColorCorrelation::Scratch scratch;
  const emtr::ColorEvidence right = colors.evaluate_locally(along_x(0), scratch);
  EXPECT_GT(right.correlation, 0.75);
  EXPECT_GT(right.evidence, 20);
  EXPECT_NEAR(right.overlap, 1.1 / 1.4, 0.05);
  for (const double x : {-0.5, -0.2, 0.2, 0.5}) {
    const emtr::ColorEvidence wrong = colors.evaluate_locally(along_x(x), scratch);
    EXPECT_LT(wrong.evidence, right.evidence / 3) << x;
  }
}

TEST(ColorCorrelation, OfUnrelatedColorsIsLow) {
  const ColorCorrelation colors = compared(emtr_test::painted_plane(emtr_test::Patches(1), 2),
                                           emtr_test::painted_plane(emtr_test::Patches(5), 3));
  ColorCorrelation::Scratch scratch;
  for (const double x : {-0.5, -0.2, 0.0, 0.2, 0.5})
    EXPECT_LT(colors.evaluate_locally(along_x(x), scratch).evidence, 8) << x;
}

TEST(ColorCorrelation, OfNegativesIsBelowZero) {
  const emtr_test::Patches patches(1);
  const ColorCorrelation colors = compared(emtr_test::painted_plane(patches, 2),
                                           emtr_test::painted_plane(patches, 3, 0, -1, 1));
  ColorCorrelation::Scratch scratch;
  const emtr::ColorEvidence found = colors.evaluate(along_x(0), scratch);
  EXPECT_LT(found.correlation, -0.6);
  EXPECT_LT(found.evidence, -10);
}

TEST(ColorCorrelation, WithoutOverlapSaysNothing) {
  const emtr_test::Patches patches(1);
  const ColorCorrelation colors =
      compared(emtr_test::painted_plane(patches, 2), emtr_test::painted_plane(patches, 3));
  ColorCorrelation::Scratch scratch;
  const emtr::ColorEvidence found = colors.evaluate_locally(along_x(5), scratch);
  EXPECT_EQ(found.evidence, 0);
  EXPECT_EQ(found.correlation, 0);
  EXPECT_EQ(found.overlap, 0);
}

}  // namespace
