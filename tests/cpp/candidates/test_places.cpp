#include <gtest/gtest.h>

#include "candidates/places.h"
#include "candidates/scene.h"

namespace {

using emtr::Cloud;
using emtr::Rigid;

constexpr double kSize = 0.08;  // the object's radius by that of the scene

/// The source of a pair about its own centroid, at the object's size.
Cloud object(const emtr_test::Scene& scene) {
  return emtr::scale_cloud(scene.normalized.source, kSize);
}

/// A floor and a wall with clutter, and the pair's target on it.
Cloud room(const emtr_test::Scene& scene, bool with_object) {
  emtr_test::Draw draw(5);
  Cloud out;
  const auto push = [&](double x, double y, double z) {
    out.append(static_cast<float>(x), static_cast<float>(y), static_cast<float>(z));
  };
  for (int i = 0; i < 40000; ++i) push(draw.uniform(-0.7, 0.7), draw.uniform(-0.7, 0.7), 0);
  for (int i = 0; i < 20000; ++i) push(draw.uniform(-0.7, 0.7), 0.7, draw.uniform(0, 0.6));
  for (int ball = 0; ball < 12; ++ball) {
    const Eigen::Vector3d at(draw.uniform(-0.6, 0.6), draw.uniform(-0.6, 0.6), 0.05);
    for (int i = 0; i < 700; ++i) {
      const Eigen::Vector3d p = at + 0.05 * draw.direction();
      push(p.x(), p.y(), p.z());
    }
  }
  if (with_object) {
    Cloud placed = emtr::scale_cloud(scene.normalized.target, kSize);
    for (std::size_t i = 0; i < placed.size(); ++i)
      out.append(placed.x[i] + 0.3f, placed.y[i] - 0.2f, placed.z[i] + 0.1f);
  }
  return out;
}

TEST(Places, TheFirstIsWhereTheObjectLies) {
  const emtr_test::Scene scene(61, 4000);
  const std::vector<Rigid> found =
      emtr::find_places(object(scene), room(scene, true), scene.settings, emtr::select_kernels());
  ASSERT_FALSE(found.empty());
  Rigid truth = scene.truth;
  truth.t = kSize * truth.t + Eigen::Vector3d(0.3, -0.2, 0.1);
  EXPECT_TRUE(is_same_pose(found.front(), truth, {10 * M_PI / 180, 0.2 * kSize}));
}

TEST(Places, ThereIsNoneInWhatIsTooCoarseToShowTheObject) {
  const emtr_test::Scene scene(61, 4000);
  const Cloud coarse =
      room(scene, true)
          .select(std::vector<int>{0, 1000, 2000, 3000, 4000, 40000, 41000, 42000, 61000, 64000});
  EXPECT_TRUE(
      emtr::find_places(object(scene), coarse, scene.settings, emtr::select_kernels()).empty());
}

TEST(Places, AreTheSameForAnyNumberOfThreads) {
  const emtr_test::Scene scene(61, 4000);
  emtr::Settings two = scene.settings;
  two.threads = 2;
  const Cloud small = object(scene), large = room(scene, true);
  const auto a = emtr::find_places(small, large, scene.settings, emtr::select_kernels()),
             b = emtr::find_places(small, large, two, emtr::select_kernels());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(emtr_test::same_bits(a[i], b[i]));
}

}  // namespace
