// Colors in a whole registration: what they decide, and that they do no harm.
#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "colors/painted.h"
#include "settings/settings.h"
#include "support/registered.h"
#include "util/error.h"

namespace {

using emtr::Rigid;
using emtr_test::Painted;

const Rigid kAway = emtr_test::motion({40, -70, 110}, {0.5, -0.3, 0.4});

/// A cloud as a user has it: red, green and blue of the channels that Patches makes.
struct User {
  std::vector<float> points, colors;

  explicit User(const Painted& painted) {
    for (std::size_t i = 0; i < painted.points.size(); ++i) {
      points.insert(points.end(), {painted.points.x[i], painted.points.y[i], painted.points.z[i]});
      const float mean = painted.colors.x[i], a = painted.colors.y[i] / 6,
                  b = painted.colors.z[i] / 6;
      for (const float v : {mean + a + b, mean - a + b, mean - 2 * b}) colors.push_back(v);
    }
  }
  emtr_cloud view(bool colored = true) const {
    emtr_cloud out{points.data(), points.size() / 3, 0, EMTR_FLOAT32};
    if (colored) out.colors = colors.data();
    return out;
  }
};

struct Walls {
  User source, target;

  explicit Walls(std::uint64_t seed = 1)
      : source(moved_away(emtr_test::painted_plane(emtr_test::Patches(seed), 2, 0, 0.7, 0.1))),
        target(emtr_test::painted_plane(emtr_test::Patches(seed), 3, 0.4)) {}

  static Painted moved_away(Painted painted) {
    painted.points = emtr_test::moved_by(kAway.inverse(), painted.points);
    return painted;
  }
};

std::unique_ptr<emtr::Result> registered(const emtr_cloud& source, const emtr_cloud& target,
                                         double use_colors = EMTR_AUTO, int threads = 2) {
  emtr::Settings settings = emtr::preset("fast");
  settings.threads = threads;
  emtr::set(settings, "use_colors", use_colors);
  return emtr_test::registered(source, target, settings);
}

bool same_pose(const emtr_result& a, const emtr_result& b) {
  return std::memcmp(a.transformation, b.transformation, sizeof a.transformation) == 0 &&
         a.confidence == b.confidence && a.reason == b.reason;
}

TEST(ColorStage, AFlatWallIsRegisteredByItsColors) {
  const Walls walls;
  const auto result = registered(walls.source.view(), walls.target.view());
  EXPECT_EQ(result->reason, EMTR_REASON_REGISTERED);
  EXPECT_TRUE(result->used_colors);
  EXPECT_EQ(result->unconstrained_directions, 0);
  EXPECT_GT(result->color_correlation, 0.7);
  EXPECT_GT(result->color_evidence, 20);
  const Rigid pose = emtr::from_matrix(result->transformation);
  EXPECT_LT(emtr_test::degrees_between(pose, kAway), 0.3);
  EXPECT_LT(emtr_test::translation_between(pose, kAway), 0.01);
}

TEST(ColorStage, WithoutColorsTheWallIsDegenerate) {
  const Walls walls;
  const auto bare = registered(walls.source.view(false), walls.target.view(false)),
             off = registered(walls.source.view(), walls.target.view(), EMTR_OFF);
  EXPECT_FALSE(bare->registered);
  EXPECT_FALSE(bare->used_colors);
  EXPECT_TRUE(std::isnan(bare->color_evidence));
  EXPECT_TRUE(same_pose(*bare, *off));
}

TEST(ColorStage, TheResultDoesNotDependOnTheThreads) {
  const Walls walls;
  const auto one = registered(walls.source.view(), walls.target.view(), EMTR_AUTO, 1),
             three = registered(walls.source.view(), walls.target.view(), EMTR_AUTO, 3);
  EXPECT_TRUE(same_pose(*one, *three));
  EXPECT_EQ(one->color_evidence, three->color_evidence);
}

TEST(ColorStage, ColorsOfAnotherWallRegisterNothing) {
  for (const std::uint64_t seed : {5, 6, 7}) {
    const Walls one(1), other(seed);
    const auto result = registered(one.source.view(), other.target.view());
    EXPECT_FALSE(result->registered) << seed;
    EXPECT_FALSE(result->used_colors) << seed;
  }
}

TEST(ColorStage, RandomOrConstantColorsChangeNothing) {
  const Walls walls;
  const auto bare = registered(walls.source.view(false), walls.target.view(false));
  User random_source = walls.source, random_target = walls.target, gray_source = walls.source;
  std::mt19937 random(1);
  for (auto* colors : {&random_source.colors, &random_target.colors})
    for (float& v : *colors) v = static_cast<float>(random() % 256) / 255;
  for (float& v : gray_source.colors) v = 0.5f;
  EXPECT_TRUE(same_pose(*bare, *registered(random_source.view(), random_target.view())));
  EXPECT_TRUE(same_pose(*bare, *registered(gray_source.view(), walls.target.view())));
}

TEST(ColorStage, AskedForColorsMustBeThere) {
  const Walls walls;
  EXPECT_THROW(registered(walls.source.view(false), walls.target.view(), EMTR_ALWAYS), emtr::Error);
  EXPECT_THROW(registered(walls.source.view(), walls.target.view(false), EMTR_ALWAYS), emtr::Error);
}

}  // namespace
