#include <gtest/gtest.h>

#include "verdict/color_verdict.h"

namespace {

using emtr::ColoredCandidate;
using emtr::ColorVerdict;
using emtr::judge_by_colors;

ColoredCandidate candidate(double score, double evidence, double correlation = 0.8) {
  ColoredCandidate out;
  out.candidate.score = score;
  out.colors.evidence = evidence;
  out.colors.correlation = correlation;
  return out;
}

TEST(ColorVerdict, TheColorsDecideBetweenPosesThatFitAlike) {
  const ColorVerdict verdict =
      judge_by_colors({candidate(0.8, 2), candidate(0.78, 40), candidate(0.79, -3)}, 100);
  EXPECT_TRUE(verdict.decided);
  EXPECT_EQ(verdict.best, 1u);
  EXPECT_GT(verdict.probability, 0.99);
}

TEST(ColorVerdict, TwoOfTheSameEvidenceAreNotDecided) {
  EXPECT_FALSE(judge_by_colors({candidate(0.8, 40), candidate(0.8, 39)}, 100).decided);
}

TEST(ColorVerdict, ChanceDecidesNothing) {
  EXPECT_FALSE(judge_by_colors({candidate(0.8, 12), candidate(0.8, 0)}, 100000).decided);
  EXPECT_TRUE(judge_by_colors({candidate(0.8, 12), candidate(0.8, 0)}, 100).decided);
  EXPECT_TRUE(emtr::is_more_than_chance(12, 100));
  EXPECT_FALSE(emtr::is_more_than_chance(12, 100000));
}

TEST(ColorVerdict, TheLargestOfManyThatAreChanceIsNoProof) {
  EXPECT_FALSE(judge_by_colors({candidate(0.8, 32), candidate(0.8, 25)}, 100000).decided);
  EXPECT_TRUE(judge_by_colors({candidate(0.8, 32), candidate(0.8, 20)}, 100000).decided);
}

TEST(ColorVerdict, ColorsOfALittleOverlapMustSayMore) {
  EXPECT_FALSE(judge_by_colors({candidate(0.1, 24), candidate(0.8, 2)}, 100000).decided);
  EXPECT_TRUE(judge_by_colors({candidate(0.5, 24), candidate(0.8, 2)}, 100000).decided);
}

TEST(ColorVerdict, PlacesThatAreAlikeInPartAreNoProof) {
  EXPECT_FALSE(judge_by_colors({candidate(0.8, 40, 0.35), candidate(0.8, 12, 0.2)}, 100).decided);
  EXPECT_TRUE(judge_by_colors({candidate(0.8, 40, 0.55), candidate(0.8, 12, 0.2)}, 100).decided);
}

TEST(ColorVerdict, AFarBetterFitOutweighsSomewhatBetterColors) {
  const ColorVerdict verdict = judge_by_colors({candidate(0.8, 30), candidate(0.2, 34)}, 100);
  EXPECT_EQ(verdict.best, 0u);
}

TEST(ColorVerdict, OfNoCandidatesIsNone) { EXPECT_FALSE(judge_by_colors({}, 0).decided); }

}  // namespace
