#include <gtest/gtest.h>

#include <utility>

#include "candidates/fallback_search.h"
#include "candidates/scene.h"

namespace {

using emtr::Rigid;
using emtr::Viewpoint;
using emtr_test::same_bits;

class FallbackSearch : public testing::Test {
 protected:
  FallbackSearch() {
    scene.settings.fallback_points = 4000;
    scene.settings.fallback_correspondences = 800;
    scene.settings.fallback_seeds = 40;
  }

  Viewpoint source(double sign = 1) const {
    return at(scene.sensor_source(), scene.normalized.normalization.center_source, sign);
  }
  Viewpoint target(double sign = 1) const {
    return at(scene.sensor_target(), scene.normalized.normalization.center_target, sign);
  }

  /// The same place first, but only held to be likely.
  static Viewpoint guessed(Viewpoint one) {
    one.given = false;
    one.trust = 0.5;
    return one;
  }

  std::vector<Rigid> seeds(const std::optional<Viewpoint>& of_source,
                           const std::optional<Viewpoint>& of_target, int threads = 1,
                           const emtr::Kernels& kernels = emtr::select_kernels()) const {
    return emtr::find_fallback_seeds(scene.normalized, of_source, of_target, scene.settings,
                                     kernels, threads);
  }

  /// The first that is right, as many as there are when none is.
  std::size_t first_right(const std::vector<Rigid>& poses) const {
    std::size_t i = 0;
    while (i < poses.size() && !scene.solved(poses[i])) ++i;
    return i;
  }

  emtr_test::Scene scene{38, 5000, 20};

 private:
  Viewpoint at(const emtr_test::Vector& sensor, const double* center, double sign) const {
    Viewpoint v;
    for (std::size_t a = 0; a < 3; ++a)
      v.at[a] = sign * (sensor[a] - center[a]) / scene.normalized.normalization.scale;
    return v;
  }
};

TEST_F(FallbackSearch, FindsTheTruthFromGivenSensors) {
  const auto found = seeds(source(), target());
  EXPECT_LT(first_right(found), found.size());
  EXPECT_LE(found.size(), 40u);  // one sign
}

TEST_F(FallbackSearch, FindsTheTruthWithNothingKnown) {
  const auto found = seeds({}, {});
  EXPECT_LT(first_right(found), found.size());
  EXPECT_LE(found.size(), 80u);  // two signs
}

TEST_F(FallbackSearch, TriesTheOtherSignUnlessBothSensorsAreGiven) {
  const auto given = seeds(source(), target());
  for (const auto& [a, b] :
       {std::pair(guessed(source()), target()), std::pair(source(), guessed(target())),
        std::pair(guessed(source()), guessed(target()))}) {
    const auto both_signs = seeds(a, b);
    ASSERT_GT(both_signs.size(), given.size());
    for (std::size_t i = 0; i < given.size(); ++i)
      EXPECT_TRUE(same_bits(both_signs[i], given[i])) << i;
  }
}

TEST_F(FallbackSearch, TheOtherSignMendsAWrongGuess) {
  const auto wrong = seeds(source(), target(-1));  // its normals point inwards
  EXPECT_EQ(first_right(wrong), wrong.size());
  const auto found = seeds(source(), guessed(target(-1)));
  ASSERT_GT(found.size(), wrong.size());
  EXPECT_LT(first_right(found), wrong.size() + 3);  // among the first of the other sign
  const auto both_wrong = seeds(source(-1), target(-1));
  EXPECT_LT(first_right(both_wrong), 3u);  // one rule for both clouds, whichever
}

TEST_F(FallbackSearch, GivesAtMostSoManySeeds) {
  scene.settings.fallback_seeds = 5;
  EXPECT_LE(seeds(source(), target()).size(), 5u);
  EXPECT_LE(seeds({}, {}).size(), 10u);
}

TEST_F(FallbackSearch, IsTheSameBitsForAnyThreadsAndKernels) {
  const auto one = seeds({}, {}, 1);
  const auto expect_same = [&](const std::vector<Rigid>& other, const char* what) {
    ASSERT_EQ(one.size(), other.size()) << what;
    for (std::size_t i = 0; i < one.size(); ++i) EXPECT_TRUE(same_bits(one[i], other[i])) << what;
  };
  for (const int threads : {2, 4}) expect_same(seeds({}, {}, threads), "threads");
  for (const emtr::Kernels* k : emtr_test::kernels_here())
    expect_same(seeds({}, {}, 1, *k), k->name);
}

}  // namespace
