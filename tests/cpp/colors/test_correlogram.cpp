#include <gtest/gtest.h>

#include "colors/correlogram.h"
#include "colors/painted.h"
#include "voxels/voxel_order.h"

namespace {

using emtr::Correlogram;
using emtr::SampledValues;
using emtr_test::Painted;

const emtr_test::Patches kPatches(1);

Painted noise() {
  Painted out = emtr_test::painted_plane(kPatches, 2);
  emtr_test::Draw draw(9);
  for (float& v : out.colors.x) v = static_cast<float>(draw.gaussian());
  return out;
}

TEST(Correlogram, OfPatchesFallsFromOneToZero) {
  const Painted a = emtr_test::painted_plane(kPatches, 2);
  const Correlogram found = emtr::correlogram(emtr::sample_values(a.points, a.colors.x));
  ASSERT_EQ(found.size(), emtr::kCorrelogramBins);
  EXPECT_GT(found[0], 0.8);
  EXPECT_GT(found[1], found[5]);
  EXPECT_LT(found[40], 0.3);
}

TEST(Correlogram, OfNoiseIsZero) {
  const Painted a = noise();
  const Correlogram found = emtr::correlogram(emtr::sample_values(a.points, a.colors.x));
  for (std::size_t bin = 3; bin < found.size(); ++bin) EXPECT_NEAR(found[bin], 0, 0.1) << bin;
}

TEST(Correlogram, OfOneValueIsZero) {
  Painted a = emtr_test::painted_plane(kPatches, 2);
  for (float& v : a.colors.x) v = 0.5f;
  for (const double v : emtr::correlogram(emtr::sample_values(a.points, a.colors.x)))
    EXPECT_EQ(v, 0);
}

TEST(EffectiveSamples, OfNoiseAreAllAndOfPatchesFew) {
  const Painted patches = emtr_test::painted_plane(kPatches, 2), random = noise();
  const auto samples = [](const Painted& a) {
    const SampledValues values = emtr::sample_values(a.points, a.colors.x);
    const Correlogram found = emtr::correlogram(values);
    return emtr::effective_samples(values, found, found);
  };
  EXPECT_GT(samples(random), 0.8 * emtr::kCorrelogramPoints);
  EXPECT_LT(samples(patches), 0.2 * emtr::kCorrelogramPoints);
  EXPECT_GT(samples(patches), 10);
}

// The test that the number is for: among many wrong poses the evidence is that of chance.
TEST(EffectiveSamples, MakeTheCorrelationOfUnrelatedPatchesOneOfChance) {
  double squares = 0;
  constexpr int kTrials = 60;
  for (int trial = 0; trial < kTrials; ++trial) {
    const auto seed = static_cast<std::uint64_t>(trial);
    const Painted a = emtr_test::painted_plane(emtr_test::Patches(100 + seed), 1),
                  b = emtr_test::painted_plane(emtr_test::Patches(900 + seed), 1);
    const SampledValues from = emtr::sample_values(a.points, a.colors.x),
                        to = emtr::sample_values(b.points, b.colors.x);
    const double n = emtr::effective_samples(from, emtr::correlogram(from), emtr::correlogram(to));
    double sums[5] = {};
    for (std::size_t i = 0; i < from.size(); ++i) {
      const double u = from.value[i], v = to.value[i];  // the places are the same: one seed
      const double terms[5] = {u, v, u * u, v * v, u * v};
      for (int k = 0; k < 5; ++k) sums[k] += terms[k] / static_cast<double>(from.size());
    }
    const double covariance = sums[4] - sums[0] * sums[1];
    squares += n * covariance * covariance /
               ((sums[2] - sums[0] * sums[0]) * (sums[3] - sums[1] * sums[1]));
  }
  EXPECT_GT(squares / kTrials, 0.4);  // 1 is expected
  EXPECT_LT(squares / kTrials, 1.8);
}

TEST(Coherence, IsHighForPatchesAndZeroForNoise) {
  const Painted patches = emtr_test::painted_plane(kPatches, 2), random = noise();
  const emtr::Surface surface = emtr::downsample_surface(patches.points, 0.02);
  const auto of = [&](const Painted& a) {
    return emtr::coherence(surface.points, emtr::mean_colors(a.points, a.colors, 0.02f).x, 0.042);
  };
  EXPECT_GT(of(patches), 0.7);
  EXPECT_LT(of(random), 0.1);
}

}  // namespace
