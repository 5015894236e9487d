#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "geometry/similarity.h"
#include "pipeline/result.h"
#include "pipeline/scale_range.h"
#include "refinement/shapes.h"
#include "settings/settings.h"
#include "support/clouds.h"
#include "support/registered.h"
#include "verdict/confidence.h"

namespace {

using emtr::Result;
using emtr::Settings;
using emtr_test::registered;

Settings settings(emtr_scale scale, double low = 1, double high = 1) {
  Settings out = emtr::preset("fast");
  out.scale = scale;
  out.scale_minimum = low;
  out.scale_maximum = high;
  return out;
}

/// A cloud in memory of its own, its points times a factor.
struct Scaled {
  std::vector<float> points;

  Scaled(const emtr_cloud& cloud, double factor) {
    const auto* p = static_cast<const float*>(cloud.points);
    for (std::size_t i = 0; i < 3 * cloud.count; ++i)
      points.push_back(static_cast<float>(factor * double{p[i]}));
  }
  emtr_cloud view() const { return {points.data(), points.size() / 3, 0, EMTR_FLOAT32}; }
};

/// The pose error of the source before it was scaled, as Pair::error() tells it.
double pose_error(const emtr_test::Pair& pair, const Result& result, double factor) {
  const auto similarity = emtr::similarity_from_matrix(result.transformation);
  if (!similarity) return HUGE_VAL;
  double T[16];
  emtr::to_matrix(similarity->pose, T);
  EXPECT_NEAR(similarity->scale, result.scale, 1e-3 * result.scale);
  EXPECT_NEAR(result.scale * factor, 1, 0.01);
  return pair.error(T);
}

TEST(UnknownScale, FindsAnyScaleWithThePose) {
  const emtr_test::Pair pair(5);
  for (const double factor : {0.03, 1.0, 700.0}) {
    const Scaled source(pair.source(), factor);
    const auto result = registered(source.view(), pair.target(), settings(EMTR_SCALE_FREE));
    EXPECT_TRUE(result->registered) << factor;
    EXPECT_LT(pose_error(pair, *result, factor), 0.03) << factor;
    EXPECT_GT(result->scale_constraint, 0.01);
    EXPECT_GT(result->information_similarity[48], 0);
    EXPECT_GT(result->seconds_scale_search, 0);
  }
}

TEST(UnknownScale, FindsAScaleWithinBounds) {
  const emtr_test::Pair pair(6);
  const Scaled source(pair.source(), 1 / 1.15);
  const auto found =
      registered(source.view(), pair.target(), settings(EMTR_SCALE_BOUNDED, 0.8, 1.25));
  EXPECT_TRUE(found->registered);
  EXPECT_LT(pose_error(pair, *found, 1 / 1.15), 0.03);
  const auto known =
      registered(source.view(), pair.target(), settings(EMTR_SCALE_BOUNDED, 1.15, 1.15));
  EXPECT_TRUE(known->registered);
  EXPECT_LT(pose_error(pair, *known, 1 / 1.15), 0.03);
}

TEST(UnknownScale, TellsAUnitExactly) {
  const emtr_test::Pair pair(7);
  for (const double unit : {12.0, 1 / 25.4}) {
    const Scaled source(pair.source(), 1 / unit);
    const auto result = registered(source.view(), pair.target(), settings(EMTR_SCALE_UNITS));
    EXPECT_TRUE(result->registered) << unit;
    EXPECT_EQ(result->scale, unit);
  }
}

TEST(UnknownScale, OfAFactorThatIsNoUnitIsNotRegisteredAsOne) {
  const emtr_test::Pair pair(7);
  const Scaled source(pair.source(), 1.3);
  EXPECT_FALSE(registered(source.view(), pair.target(), settings(EMTR_SCALE_UNITS))->registered);
}

TEST(UnknownScale, IsSaidToBeFreeWhereTheSurfacesLeaveItOpen) {
  const auto corner =
      [](std::uint64_t seed) {  // three planes: the rigid pose is held, not the scale
        return emtr_test::Draw(seed).cloud(4000, 1e-3, [](emtr_test::Draw& d) {
          const double u = 1.3 * d.uniform(0, 1), v = d.uniform(0, 1);
          const auto side = static_cast<int>(d.uniform(0, 3));
          return side == 0   ? Eigen::Vector3d(u, 0.8 * v, 0)
                 : side == 1 ? Eigen::Vector3d(u, 0, v)
                             : Eigen::Vector3d(0, 0.8 * u, v);
        });
      };
  const auto interleaved = [](const emtr::Cloud& cloud) {
    std::vector<float> out;
    for (std::size_t i = 0; i < cloud.size(); ++i)
      out.insert(out.end(), {cloud.x[i], cloud.y[i], cloud.z[i]});
    return out;
  };
  const std::vector<float> a = interleaved(corner(1)), b = interleaved(corner(2));
  const auto result =
      registered({a.data(), a.size() / 3, 0, EMTR_FLOAT32},
                 {b.data(), b.size() / 3, 0, EMTR_FLOAT32}, settings(EMTR_SCALE_FREE));
  EXPECT_FALSE(result->registered);
  if (result->confidence >= 0.5) {
    EXPECT_EQ(result->reason, EMTR_REASON_FREE_SCALE);
    EXPECT_LT(result->scale_constraint, 3e-3);
  }
}

TEST(UnknownScale, HasTheSameBitsForAnyThreads) {
  const emtr_test::Pair pair(8, 3000);
  const Scaled source(pair.source(), 3);
  Settings chosen = settings(EMTR_SCALE_FREE);
  chosen.threads = 1;
  const auto one = registered(source.view(), pair.target(), chosen);
  chosen.threads = 3;
  const auto three = registered(source.view(), pair.target(), chosen);
  for (int i = 0; i < 16; ++i) EXPECT_EQ(one->transformation[i], three->transformation[i]);
  for (int i = 0; i < 49; ++i)
    EXPECT_EQ(one->information_similarity[i], three->information_similarity[i]);
  EXPECT_EQ(one->confidence, three->confidence);
}

TEST(UnknownScale, StopsWhenAsked) {
  const emtr_test::Pair pair(9);
  for (const char* stage : {"normalization", "scale_search", "refinement"}) {
    const auto result = registered(
        pair.source(), pair.target(), settings(EMTR_SCALE_FREE),
        [&](const emtr_progress& progress) { return std::string(progress.stage) == stage; });
    EXPECT_FALSE(result->registered);
    EXPECT_EQ(result->reason, EMTR_REASON_INTERRUPTED) << stage;
  }
}

TEST(UnknownScale, ASearchOfAllScalesHalvesTheOdds) {
  EXPECT_NEAR(emtr::lower_for_many_scales(0.5), 1.0 / 3, 1e-6);
  EXPECT_NEAR(emtr::lower_for_many_scales(0.628), 0.4577, 1e-3);
  EXPECT_GT(emtr::lower_for_many_scales(0.999), 0.997);
}

TEST(ScaleRange, KeepsToTheUsersBounds) {
  const emtr_test::Pair pair(10, 2000);
  const emtr::PreprocessedCloud source(pair.source(), "", 1), target(pair.target(), "", 1);
  const auto free = emtr::scale_range(source, target, settings(EMTR_SCALE_FREE));
  EXPECT_NEAR(free.guess, 1, 0.3);
  EXPECT_EQ(free.lowest, -2);
  EXPECT_EQ(free.highest, 2);
  const auto bounded = emtr::scale_range(source, target, settings(EMTR_SCALE_BOUNDED, 0.8, 1.25));
  EXPECT_NEAR(bounded.scale(bounded.lowest), 0.8, 1e-12);
  EXPECT_NEAR(bounded.scale(bounded.highest), 1.25, 1e-12);
  const auto far = emtr::scale_range(source, target, settings(EMTR_SCALE_BOUNDED, 100, 1e6));
  EXPECT_NEAR(far.scale(far.lowest), 100, 1e-9);
  EXPECT_NEAR(far.highest - far.lowest, 4, 1e-12);
}

TEST(ScaleRange, HasTheUnitsThatAreNearFirst) {
  const auto units = emtr::unit_factors({11, -2, 2});
  ASSERT_GE(units.size(), 3u);
  EXPECT_EQ(units[0], 12);
  EXPECT_EQ(units[1], 10);
  EXPECT_EQ(units[2], 25.4);
  EXPECT_EQ(emtr::unit_factors({1e5, -2, 2}), std::vector<double>{1000});
}

}  // namespace
