// Two sensors receive less from afar: what is left must be what is painted.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "colors/channels.h"
#include "colors/fall_off.h"
#include "colors/painted.h"

namespace {

using emtr::Cloud;
using emtr_test::Painted;

constexpr double kLeaf = 0.02;

/// A wall that two sensors see from a distance, each in front of another place of it.
struct Walls {
  Painted painted = emtr_test::painted_plane(emtr_test::Patches(1), 2);
  emtr::FineSurfaces fine = emtr_test::fine_surfaces_of(painted.points, painted.points, kLeaf);

  Cloud received(double x, double distance, bool marks = true) const {
    Cloud out = fine.source->points;
    for (std::size_t i = 0; i < out.size(); ++i) {
      const double dx = out.x[i] - x, dy = out.y[i],
                   squared = dx * dx + dy * dy + distance * distance;
      const double shade = marks ? emtr_test::Patches(1).at(out.x[i], out.y[i])[0] : 0.8;
      out.x[i] = static_cast<float>(100 * (0.1 + shade) * distance / std::pow(squared, 1.5));
      out.y[i] = out.z[i] = 0;
    }
    return out;
  }
};

double correlation(const Cloud& a, const Cloud& b) {
  const emtr::Channels channels = emtr::make_channels(a, b);
  double best = 0;
  for (int k = 0; k < emtr::kChannels; ++k) {
    const std::vector<float>&from = channel(channels.source, k), &to = channel(channels.target, k);
    double sum = 0;
    for (std::size_t i = 0; i < from.size(); ++i) sum += from[i] * to[i];
    best = std::max(best, std::abs(sum) / static_cast<double>(from.size()));
  }
  return best;
}

TEST(FallOff, OfNearSensorsLeavesWhatIsPainted) {
  const Walls walls;
  const Cloud left = walls.received(-0.4, 0.6), right = walls.received(0.4, 0.6);
  EXPECT_LT(correlation(left, right), 0.7);
  EXPECT_GT(correlation(emtr::without_fall_off(*walls.fine.source, left),
                        emtr::without_fall_off(*walls.fine.source, right)),
            0.85);
}

TEST(FallOff, OfABlankWallLeavesNextToNothing) {
  const Walls walls;
  const Cloud flat = emtr::without_fall_off(*walls.fine.source, walls.received(0.3, 0.6, false)),
              marked = emtr::without_fall_off(*walls.fine.source, walls.received(0.3, 0.6));
  const auto largest = [](const Cloud& cloud) {
    float out = 0;
    for (const float v : cloud.x) out = std::max(out, std::abs(v));
    return out;
  };
  EXPECT_LT(largest(flat), 0.1f * largest(marked));
}

TEST(FallOff, NoLightAtAllIsNoMark) {
  const Walls walls;
  Cloud dark;
  dark.resize(walls.fine.source->points.size());
  const Cloud out = emtr::without_fall_off(*walls.fine.source, dark);
  EXPECT_FALSE(emtr::make_channels(out, out).any());
}

}  // namespace
