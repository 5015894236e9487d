#include <gtest/gtest.h>

#include <cmath>

#include "geometry/similarity.h"
#include "pipeline/registration_at_scale.h"
#include "support/clouds.h"

namespace {

using emtr::ScaleHypothesis;
using emtr::Settings;

/// A pair whose source has its true scale at 1, to be registered at any other.
class RegistrationAtScale : public testing::Test {
 protected:
  explicit RegistrationAtScale(double low = 0, double high = 0) : settings_(emtr::preset("fast")) {
    settings_.scale = high > 0 ? EMTR_SCALE_BOUNDED : EMTR_SCALE_FREE;
    if (high > 0) settings_.scale_minimum = low, settings_.scale_maximum = high;
    emtr::preprocess(source_, target_, settings_);
  }

  std::unique_ptr<emtr::Result> run(const ScaleHypothesis& start) {
    emtr::CancellationToken token({});
    return emtr::RegistrationAtScale(source_, target_, settings_, token, {})(start, false);
  }

  /// The true pose, at a scale that is wrong by a factor.
  ScaleHypothesis true_pose(double scale) const {
    const auto similarity = emtr::similarity_from_matrix(pair_.pose());
    return {{scale, similarity->pose}, 1};
  }

  const emtr_test::Pair pair_{11};
  const emtr_cloud from_ = pair_.source(), to_ = pair_.target();
  emtr::InputCloud source_{&from_, nullptr}, target_{&to_, nullptr};
  Settings settings_;
};

class RegistrationWithinBounds : public RegistrationAtScale {
 protected:
  RegistrationWithinBounds() : RegistrationAtScale(1.02, 1.2) {}
};

TEST_F(RegistrationAtScale, FollowsTheRefinedScaleToTheTruth) {
  for (const double start : {0.86, 0.97, 1.03, 1.18}) {
    const auto result = run(true_pose(start));
    EXPECT_NEAR(result->scale, 1, 2e-3) << start;
    EXPECT_TRUE(result->registered) << start;
  }
}

TEST_F(RegistrationAtScale, FindsThePoseWhereNoneIsKnown) {
  const auto result = run(emtr::scale_without_pose(1.05));
  EXPECT_NEAR(result->scale, 1, 2e-3);
  EXPECT_TRUE(result->registered);
}

TEST_F(RegistrationWithinBounds, StaysThere) {
  const auto result = run(true_pose(1.1));
  EXPECT_GE(result->scale, 1.02);
  EXPECT_LE(result->scale, 1.2);
}

TEST_F(RegistrationAtScale, TheSourceStaysWhereItIsWhenItIsRescaled) {
  emtr::CancellationToken token({});
  const emtr::RegistrationAtScale at(source_, target_, settings_, token, {});
  const ScaleHypothesis before = true_pose(1), after = at.rescaled(before, 3);
  const auto center = Eigen::Vector3d::Map(source_.preprocessed->center);
  EXPECT_EQ(after.similarity.scale, 3);
  EXPECT_LT((before.similarity * center - after.similarity * center).norm(), 1e-12);
}

}  // namespace
