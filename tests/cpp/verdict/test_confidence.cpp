#include <gtest/gtest.h>

#include <cmath>

#include "geometry/pose_distance.h"
#include "refinement/shapes.h"
#include "verdict/confidence.h"

namespace {

using emtr::Candidate;
using emtr::Confidence;

constexpr std::size_t kPoints = 1000;  // of each surface

Confidence estimate_confidence(const std::vector<Candidate>& ranked) {
  return emtr::estimate_confidence(ranked, kPoints, kPoints);
}

/// A candidate that half of the points support, the worse its score the less precisely.
Candidate candidate(const emtr::Rigid& pose, double score) {
  Candidate c;
  c.pose = pose;
  c.score = c.fit.score = score;
  c.fit.near = 1;
  c.fit.inliers_source = c.fit.inliers_target = 0.5;
  return c;
}

/// Candidates about the z axis, 20 degrees apart, with these scores.
std::vector<Candidate> ranked(const std::vector<double>& scores) {
  std::vector<Candidate> out;
  for (std::size_t i = 0; i < scores.size(); ++i)
    out.push_back(
        candidate(emtr_test::motion({0, 0, 20.0 * static_cast<double>(i)}, {0, 0, 0}), scores[i]));
  return out;
}

Candidate at(double degrees, double score, double translation = 0) {
  return candidate(emtr_test::motion({degrees, 0, 0}, {translation, 0, 0}), score);
}

TEST(Confidence, TheGapIsToTheBestClearlyDifferentCandidate) {
  const Confidence s =
      estimate_confidence({at(0, 0.7), at(6, 0.65), at(0, 0.6, 0.1), at(40, 0.5), at(80, 0.4)});
  EXPECT_DOUBLE_EQ(s.score_gap, 0.7 - 0.5);
  ASSERT_EQ(s.alternatives.size(), 2u);
  EXPECT_EQ(s.alternatives[0].score, 0.5);
  EXPECT_EQ(s.alternatives[1].score, 0.4);
}

TEST(Confidence, AShiftAloneMakesAnotherAnswerToo) {
  EXPECT_DOUBLE_EQ(estimate_confidence({at(0, 0.7), at(0, 0.6, 0.2)}).score_gap, 0.7 - 0.6);
}

TEST(Confidence, WithoutAlternativesTheGapIsTheScore) {
  const Confidence s = estimate_confidence({at(0, 0.6), at(5, 0.5)});
  EXPECT_EQ(s.score_gap, 0.6);
  EXPECT_TRUE(s.alternatives.empty());
}

TEST(Confidence, AlternativesBelowNothingLeaveTheGapAtTheScore) {
  // A score below zero is as good as none: it must not make the best look better.
  EXPECT_EQ(estimate_confidence({at(0, 0.3), at(90, -0.8)}).score_gap, 0.3);
}

/// An answer with 0.6 of the best's score, which fits to this share of what lies near.
Confidence beside(double precision, double violation) {
  Candidate best = at(0, 0.5), other = at(120, 0.3);
  best.fit.near = 0.9;
  best.fit.score = 0.8 * best.fit.near;
  other.fit.near = 0.5;
  other.fit.score = precision * other.fit.near;
  other.violation = violation;
  return estimate_confidence({best, other});
}

TEST(Confidence, AnAnswerThatOverlapsLessButFitsAsWellIsARival) {
  const double without = beside(0.6, 0).probability;
  EXPECT_GT(without, 0.9);
  EXPECT_LT(beside(0.8, 0).probability, 0.45);
  EXPECT_EQ(beside(0.8, 0.05).probability, without);  // the sensors saw through it
}

TEST(Confidence, AnotherAnswerOfHalfTheScoreIsNearlyARival) {
  const auto nearly = [](const std::vector<Candidate>& some) {
    return emtr::is_nearly_rivaled(some.front(), estimate_confidence(some));
  };
  EXPECT_TRUE(nearly({at(0, 0.6), at(90, 0.35)}));
  EXPECT_FALSE(nearly({at(0, 0.6), at(90, 0.25)}));
  EXPECT_FALSE(nearly({at(0, 0.6), at(3, 0.5)}));  // the same answer
}

TEST(Confidence, AlternativesAreDistinctBestFirstAndTenAtMost) {
  std::vector<Candidate> all;
  for (int i = 0; i < 60; ++i) all.push_back(at(6.0 * i, 0.7 - 0.01 * i));
  const Confidence s = estimate_confidence(all);
  ASSERT_EQ(s.alternatives.size(), 10u);
  for (std::size_t i = 0; i < s.alternatives.size(); ++i) {
    EXPECT_FALSE(emtr::is_same_pose(s.alternatives[i].pose, all[0].pose, emtr::kDistinctPose));
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(
          emtr::is_same_pose(s.alternatives[i].pose, s.alternatives[j].pose, emtr::kDistinctPose));
      EXPECT_LE(s.alternatives[i].score, s.alternatives[j].score);
    }
  }
}

TEST(Confidence, ConfidenceIsAShareThatGrowsWithTheScore) {
  for (const double other : {-0.5, 0.05, 0.3, 0.6}) {
    double before = -1;
    for (const double step : {0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.39}) {
      const double c = estimate_confidence(ranked({other + step, other})).probability;
      EXPECT_GE(c, 0);
      EXPECT_LE(c, 1);
      EXPECT_EQ(c, std::round(c * 1e6) / 1e6);  // what no C library's last digits can change
      EXPECT_GE(c, before) << other << ' ' << step;
      before = c;
    }
  }
  EXPECT_GT(estimate_confidence(ranked({0.4})).probability,
            estimate_confidence(ranked({0.1})).probability);
}

TEST(Confidence, ConfidenceGrowsWithTheGap) {
  for (const double score : {0.05, 0.12, 0.3, 0.7, 1.0}) {
    double before = -1;
    for (const double share : {0.0, 0.01, 0.05, 0.1, 0.19, 0.21, 0.4, 0.8, 1.0}) {
      const double c = estimate_confidence(ranked({score, score - share * score})).probability;
      EXPECT_GE(c, before) << score << ' ' << share;
      before = c;
    }
    EXPECT_GT(before, estimate_confidence(ranked({score, score})).probability);
  }
}

TEST(Confidence, ConfidenceFallsWithTheViolationAtEqualScore) {
  double before = 1;
  for (const double violation : {0.0, 0.001, 0.01, 0.05}) {
    std::vector<Candidate> some = ranked({0.15, 0.1});
    some[0].violation = violation;
    some[0].fit.score = 0.15 + 2 * violation;
    const double c = estimate_confidence(some).probability;
    EXPECT_LT(c, before) << violation;
    before = c;
  }
}

TEST(Confidence, MismatchedSurfacesLowerItAndFlushOnesDoNot) {
  for (const double surface_mismatch : {-0.2, 0.0, 0.3, 0.7, std::nan("")})
    EXPECT_EQ(emtr::lower_confidence(0.9, surface_mismatch), 0.9) << surface_mismatch;
  double before = 0.9;
  for (const double surface_mismatch : {0.75, 0.85, 1.0, 1.4}) {
    const double c = emtr::lower_confidence(0.9, surface_mismatch);
    EXPECT_LT(c, before) << surface_mismatch;
    before = c;
  }
  EXPECT_LT(before, 0.001);
  EXPECT_EQ(emtr::lower_confidence(0, 1.0), 0);
}

TEST(Confidence, ConfidenceTellsGoodFromBad) {
  EXPECT_GT(estimate_confidence(ranked({0.7, 0.1})).probability, 0.95);
  EXPECT_LT(estimate_confidence(ranked({0.1, 0.09})).probability, 0.5);
  EXPECT_LT(estimate_confidence(ranked({0.03, 0.029})).probability, 0.05);
  EXPECT_LT(estimate_confidence(ranked({-2})).probability, 0.05);
}

TEST(Confidence, OfTwoAnswersThatAreAsGoodNoneIsBelievedByHalf) {
  for (const double score : {0.2, 0.5, 1.0}) {
    EXPECT_LT(estimate_confidence(ranked({score, score})).probability, 0.5);
    EXPECT_LT(estimate_confidence(ranked({score, 0.85 * score})).probability, 0.5);
  }
  EXPECT_GT(estimate_confidence(ranked({0.7, 0.5})).probability, 0.5);
}

TEST(Confidence, ScansFromOnePlaceNeedToBeClearlyTheBest) {
  std::vector<Candidate> some = ranked({0.6, 0.3});
  const double elsewhere = estimate_confidence(some).probability;
  some[0].shares_pattern = true;
  EXPECT_LT(estimate_confidence(some).probability, 0.5 * elsewhere);
  some = ranked({0.6, 0.1});
  const double clear = estimate_confidence(some).probability;
  some[0].shares_pattern = true;
  EXPECT_EQ(estimate_confidence(some).probability, clear);
}

TEST(Confidence, AChangedSourceThatFitsBetterTakesTheConfidence) {
  const std::vector<Candidate> one = ranked({0.5, 0.05});
  const auto weighed = [&](double mirrored, const emtr::Rescaled& rescaled) {
    Confidence out = estimate_confidence(one);
    emtr::weigh_changed_source(one[0], mirrored, rescaled, out);
    return out;
  };
  const double before = estimate_confidence(one).probability;
  EXPECT_EQ(weighed(-INFINITY, {}).probability, before);
  EXPECT_EQ(weighed(0.5, {1.1, 0.5}).probability, before);  // as well, and no better
  EXPECT_FALSE(weighed(0.5, {}).mirrored);
  EXPECT_TRUE(weighed(0.7, {}).mirrored);
  EXPECT_LT(weighed(0.7, {}).probability, 0.5);
  EXPECT_EQ(weighed(0.1, {1.1, 0.7}).scale_factor, 1.1);
  EXPECT_LT(weighed(0.1, {1.1, 0.7}).probability, 0.5);
  EXPECT_EQ(weighed(0.1, {1.1, 0.5}).scale_factor, 1);
}

TEST(Confidence, AFewPointsAreNoEvidence) {
  const auto confidence = [](std::size_t source, std::size_t target) {
    return emtr::estimate_confidence(ranked({0.8, 0.1}), source, target)
        .probability;  // half are inliers
  };
  EXPECT_EQ(confidence(200, 200), confidence(5000, 200));
  EXPECT_GT(confidence(200, 200), 0.95);
  EXPECT_LT(confidence(100, 200), 0.5);
  EXPECT_LT(confidence(5000, 100), 0.5);  // the poorer side decides
  EXPECT_LT(confidence(20, 20), confidence(100, 100));
}

class Reason : public testing::Test {
 protected:
  emtr_reason reason(const std::vector<double>& scores, bool unconstrained = false,
                     std::size_t correspondences = 100, std::size_t points = kPoints) const {
    const auto all = ranked(scores);
    const Confidence confidence = emtr::estimate_confidence(all, points, points);
    return emtr::reason(all.front(), confidence, unconstrained, correspondences, settings);
  }
  emtr::Settings settings = emtr::preset("default");
};

TEST_F(Reason, Registered) {
  EXPECT_EQ(reason({0.7, 0.1}), EMTR_REASON_REGISTERED);
  EXPECT_EQ(reason({0.7, 0.1}, false, 0), EMTR_REASON_REGISTERED);  // however it was found
}

TEST_F(Reason, Degenerate) { EXPECT_EQ(reason({0.7, 0.1}, true), EMTR_REASON_DEGENERATE); }

TEST_F(Reason, Ambiguous) {
  EXPECT_EQ(reason({0.7, 0.695}), EMTR_REASON_AMBIGUOUS);
  EXPECT_EQ(reason({0.3, 0.3}), EMTR_REASON_AMBIGUOUS);
  EXPECT_EQ(reason({0.7, 0.695}, true), EMTR_REASON_AMBIGUOUS);
  EXPECT_EQ(reason({0.7, 0.695}, false, 3), EMTR_REASON_AMBIGUOUS);
}

TEST_F(Reason, LowOverlap) {
  EXPECT_EQ(reason({0.02, 0.019}), EMTR_REASON_LOW_OVERLAP);  // two that mean nothing: no rivals
  EXPECT_EQ(reason({0.01}), EMTR_REASON_LOW_OVERLAP);
  EXPECT_EQ(reason({-0.1, -0.11}), EMTR_REASON_LOW_OVERLAP);
  EXPECT_EQ(reason({0.7, 0.1}, false, 100, 60), EMTR_REASON_LOW_OVERLAP);  // of next to no points
}

TEST_F(Reason, FewMatches) {
  EXPECT_EQ(reason({0.02, 0.018}, false, 9), EMTR_REASON_FEW_MATCHES);
  EXPECT_EQ(reason({0.02, 0.018}, false, 10), EMTR_REASON_LOW_OVERLAP);
}

TEST_F(Reason, MirroredOrAnotherScale) {
  const auto one = ranked({0.5, 0.05});
  Confidence confidence = estimate_confidence(one);
  emtr::weigh_changed_source(one[0], 0.7, {}, confidence);
  EXPECT_EQ(emtr::reason(one[0], confidence, false, 100, settings), EMTR_REASON_MIRRORED);
  confidence = estimate_confidence(one);
  emtr::weigh_changed_source(one[0], 0, {0.9, 0.7}, confidence);
  EXPECT_EQ(emtr::reason(one[0], confidence, false, 100, settings), EMTR_REASON_SCALE);
}

TEST_F(Reason, FollowsTheConfidenceAskedFor) {
  const double confidence = estimate_confidence(ranked({0.4, 0.3})).probability;
  settings.minimum_confidence = confidence;
  EXPECT_EQ(reason({0.4, 0.3}), EMTR_REASON_REGISTERED);
  settings.minimum_confidence = std::nextafter(confidence, 1.0);
  EXPECT_EQ(reason({0.4, 0.3}), EMTR_REASON_LOW_OVERLAP);
  settings.minimum_confidence = 0.01;  // who asks for less takes one of two that are as good
  EXPECT_EQ(reason({0.7, 0.695}), EMTR_REASON_REGISTERED);
}

TEST(Confidence, OutlinesAreBelievedByTheirScore) {
  EXPECT_LT(emtr::lower_outline_confidence(0.999, 0.3), 0.1);
  EXPECT_GT(emtr::lower_outline_confidence(0.999, 0.6), 0.9);
  EXPECT_NEAR(emtr::lower_outline_confidence(0.999, 1), 0.999, 1e-6);  // never surer than before
}

}  // namespace
