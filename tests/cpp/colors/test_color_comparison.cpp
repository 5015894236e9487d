#include <gtest/gtest.h>

#include <memory>
#include <vector>

#include "colors/color_comparison.h"
#include "colors/painted.h"

namespace {

using emtr_test::Painted;

constexpr double kLeaf = 0.02;

emtr::PreprocessedCloudPtr preprocessed(const Painted& painted, bool intensities = false) {
  std::vector<float> points, colors, first;
  for (std::size_t i = 0; i < painted.points.size(); ++i) {
    points.insert(points.end(), {painted.points.x[i], painted.points.y[i], painted.points.z[i]});
    const float shade = painted.colors.x[i];
    colors.insert(colors.end(), {shade, shade, shade});
    first.push_back(shade);
  }
  emtr_cloud view{points.data(), painted.points.size(), 0, EMTR_FLOAT32};
  (intensities ? view.intensities : view.colors) = (intensities ? first : colors).data();
  return std::make_shared<const emtr::PreprocessedCloud>(view, "", 1);
}

bool tells_something(const emtr::PreprocessedCloudPtr& source,
                     const emtr::PreprocessedCloudPtr& target) {
  const emtr::NormalizedPair pair = emtr::normalize(source, target);
  const emtr::FineSurfaces fine = emtr::fine_surfaces(pair, kLeaf, 1, emtr::select_kernels());
  return emtr::compare_colors(pair, fine, emtr::select_kernels()) != nullptr;
}

TEST(ColorComparison, OfPatchesTellsSomething) {
  const Painted a = emtr_test::painted_plane(emtr_test::Patches(1), 2);
  EXPECT_TRUE(tells_something(preprocessed(a), preprocessed(a)));
  EXPECT_TRUE(tells_something(preprocessed(a, true), preprocessed(a, true)));
}

TEST(ColorComparison, OfOneColorTellsNothing) {
  const Painted a = emtr_test::painted_plane(emtr_test::Patches(1), 2);
  Painted gray = a;
  for (float& v : gray.colors.x) v = 0.5f;
  EXPECT_FALSE(tells_something(preprocessed(a), preprocessed(gray)));
  EXPECT_FALSE(tells_something(preprocessed(gray, true), preprocessed(gray, true)));
}

TEST(ColorComparison, OfNoiseTellsNothing) {
  const Painted a = emtr_test::painted_plane(emtr_test::Patches(1), 2);
  Painted noise = a;
  emtr_test::Draw draw(4);
  for (float& v : noise.colors.x) v = static_cast<float>(draw.uniform(0, 1));
  EXPECT_FALSE(tells_something(preprocessed(a), preprocessed(noise)));
  EXPECT_FALSE(tells_something(preprocessed(noise), preprocessed(noise)));
}

TEST(ColorComparison, NeedsOneKindOfBoth) {
  const Painted a = emtr_test::painted_plane(emtr_test::Patches(1), 2);
  EXPECT_FALSE(tells_something(preprocessed(a), preprocessed(a, true)));
  emtr_cloud bare{};
  std::vector<float> points;
  for (std::size_t i = 0; i < a.points.size(); ++i)
    points.insert(points.end(), {a.points.x[i], a.points.y[i], a.points.z[i]});
  bare.points = points.data();
  bare.count = a.points.size();
  bare.scalar = EMTR_FLOAT32;
  const auto without = std::make_shared<const emtr::PreprocessedCloud>(bare, "", 1);
  EXPECT_FALSE(tells_something(preprocessed(a), without));
}

}  // namespace
