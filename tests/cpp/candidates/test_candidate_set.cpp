#include "candidates/candidate_set.h"
#include "candidates/one_scene.h"

namespace {

using emtr::is_same_pose;
using emtr::kDuplicatePose;
using emtr::Rigid;
using emtr::ThreadTeam;
using emtr_test::anywhere;
using emtr_test::same_bits;

class CandidateSet : public emtr_test::OneScene {
 protected:
  /// Good ones, duplicates of them, and many that are wrong.
  static std::vector<Rigid> poses() {
    std::vector<Rigid> out = anywhere(30, 7);
    for (const double degrees : {0.0, 1.0, 2.0, 5.0, 9.0, 20.0})
      out.push_back(scene().off({0, degrees, 0}, {0.002 * degrees, 0, 0}));
    out.push_back(out[3]);
    return out;
  }

  static std::vector<Rigid> shortlist(std::size_t most, int threads = 1) {
    std::vector<Rigid> out;
    ThreadTeam::with(threads, [&](ThreadTeam& team) {
      out = emtr::CandidateSet(surfaces(), nullptr).shortlist(poses(), most, team);
    });
    return out;
  }

  static void add(emtr::CandidateSet& candidate_set, const std::vector<Rigid>& some,
                  int threads = 1) {
    ThreadTeam::with(threads, [&](ThreadTeam& team) { candidate_set.add(some, team); });
  }
};

TEST_F(CandidateSet, AShortlistIsOrderedByTheQuickFitAndHasNoDuplicates) {
  const auto all = poses(), out = shortlist(all.size());
  ASSERT_GT(out.size(), 25u);
  EXPECT_TRUE(scene().solved(out.front()));
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (i > 0) {
      EXPECT_GE(quick(out[i - 1]), quick(out[i]));
    }
    for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(is_same_pose(out[i], out[j], kDuplicatePose));
    EXPECT_TRUE(std::any_of(all.begin(), all.end(),
                            [&](const Rigid& pose) { return same_bits(pose, out[i]); }));
  }
}

TEST_F(CandidateSet, AShortlistKnowsFreeSpace) {
  // Moved toward the target's sensor the source stands where that looked through.
  const emtr_test::Vector at = scene().sensor_target();
  const emtr::Normalization& normalization = scene().normalized.normalization;
  emtr::Viewpoint sensor;
  double length = 0;
  for (std::size_t a = 0; a < 3; ++a) {
    sensor.at[a] = (at[a] - normalization.center_target[a]) / normalization.scale;
    length += sensor.at[a] * sensor.at[a];
  }
  Eigen::Vector3d toward(sensor.at[0], sensor.at[1], sensor.at[2]);
  toward *= 0.4 / std::sqrt(length);
  const std::vector<Rigid> both{scene().off({0, 0, 0}, toward), scene().off({0, 0, 0}, -toward)};
  const emtr::SurfacePair seen(scene().source, scene().target, {}, sensor, emtr::select_kernels());
  emtr::Ranking::Scratch scratch;
  const auto front = seen.ranking().evaluate(both[0], scratch, emtr::SurfacePair::kQuickStep);
  EXPECT_GT(front.violation, 0.1);
  std::vector<Rigid> out;
  ThreadTeam::with(1, [&](ThreadTeam& team) {
    out = emtr::CandidateSet(seen, nullptr).shortlist(both, 1, team);
  });
  ASSERT_EQ(out.size(), 1u);
  EXPECT_TRUE(same_bits(out.front(), both[1]));
}

TEST_F(CandidateSet, OnlyDuplicatesOfBetterOnesAreLeftOut) {
  const auto out = shortlist(poses().size());
  std::size_t left_out = 0;
  for (const Rigid& pose : poses()) {
    const auto is = [&](const Rigid& other) { return same_bits(pose, other); };
    if (std::any_of(out.begin(), out.end(), is)) continue;
    ++left_out;
    EXPECT_TRUE(std::any_of(out.begin(), out.end(), [&](const Rigid& other) {
      return is_same_pose(pose, other, kDuplicatePose) && quick(other) >= quick(pose);
    }));
  }
  EXPECT_GE(left_out, 2u);  // the truth's duplicates, less than 3 degrees from it
}

TEST_F(CandidateSet, AShorterListIsTheBeginningOfALongerOne) {
  const auto five = shortlist(5), ten = shortlist(10);
  ASSERT_EQ(five.size(), 5u);
  ASSERT_EQ(ten.size(), 10u);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_TRUE(same_bits(five[i], ten[i]));
  EXPECT_TRUE(shortlist(0).empty());
}

TEST_F(CandidateSet, RefinesWhatIsAdded) {
  const Rigid start = scene().off({2, -2, 1}, {0.02, 0.01, -0.02});
  emtr::Ranking::Scratch scratch;
  const double before = surfaces().ranking().evaluate(start, scratch).score;
  emtr::CandidateSet candidate_set(surfaces(), nullptr);
  add(candidate_set, {start});
  ASSERT_EQ(candidate_set.ranked().size(), 1u);
  const emtr::Candidate& c = candidate_set.ranked().front();
  EXPECT_GT(c.score, before + 0.2);
  EXPECT_LT(emtr_test::degrees_between(c.pose, scene().truth), 0.7);
  EXPECT_LT(emtr_test::translation_between(c.pose, scene().truth), 0.01);
}

TEST_F(CandidateSet, NoPoseIsMadeWorse) {
  // Next to the truth there is little to gain, and now and then refinement loses.
  std::vector<Rigid> starts = anywhere(20, 11);
  emtr_test::Draw draw(5);
  for (int i = 0; i < 300; ++i)
    starts.push_back(scene().off(0.05 * draw.direction(), 0.0005 * draw.direction()));
  std::size_t lost = 0;
  emtr::LocalRefinement::Scratch scratch;
  for (const Rigid& start : starts) {
    emtr::CandidateSet candidate_set(surfaces(), nullptr);
    add(candidate_set, {start});
    const Rigid refined = surfaces().local_refinement()(start, nullptr, scratch).pose;
    const bool worse = quick(refined) < quick(start);
    EXPECT_TRUE(same_bits(candidate_set.ranked().front().pose, worse ? start : refined));
    lost += worse;
  }
  EXPECT_GT(lost, 0u);
  EXPECT_LT(lost, starts.size() / 2);
}

TEST_F(CandidateSet, IsRankedByTheFineScoreAndDistinct) {
  emtr::CandidateSet candidate_set(surfaces(), nullptr);
  add(candidate_set, poses());
  const auto& ranked = candidate_set.ranked();
  ASSERT_GT(ranked.size(), 15u);
  EXPECT_LT(ranked.size(), poses().size());
  EXPECT_TRUE(scene().solved(ranked.front().pose));
  emtr::Ranking::Scratch scratch;
  for (std::size_t i = 0; i < ranked.size(); ++i) {
    const auto value = surfaces().ranking().evaluate(ranked[i].pose, scratch);
    EXPECT_EQ(ranked[i].score, value.score);
    EXPECT_EQ(ranked[i].fit.score, value.fit.score);
    EXPECT_EQ(ranked[i].violation, value.violation);
    if (i > 0) {
      EXPECT_GE(ranked[i - 1].score, ranked[i].score);
    }
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(is_same_pose(ranked[i].pose, ranked[j].pose, kDuplicatePose));
  }
}

TEST_F(CandidateSet, WhatComesLaterIsRankedAmongWhatIsThere) {
  emtr::CandidateSet candidate_set(surfaces(), nullptr);
  add(candidate_set, anywhere(10, 3));
  const double wrong = candidate_set.ranked().front().score;
  const std::size_t before = candidate_set.ranked().size();
  add(candidate_set, {scene().off({1, 1, 1}, {0, 0, 0})});
  EXPECT_EQ(candidate_set.ranked().size(), before + 1);
  EXPECT_TRUE(scene().solved(candidate_set.ranked().front().pose));
  EXPECT_GT(candidate_set.ranked().front().score, wrong + 0.2);
  EXPECT_EQ(candidate_set.ranked()[1].score, wrong);
  add(candidate_set, {scene().off({-1, 1, 0}, {0.01, 0, 0})});  // it is there already
  EXPECT_EQ(candidate_set.ranked().size(), before + 1);
  add(candidate_set, {});
  EXPECT_EQ(candidate_set.ranked().size(), before + 1);
}

TEST_F(CandidateSet, AddsTheBestAlone) {
  emtr::CandidateSet all(surfaces(), nullptr), three(surfaces(), nullptr);
  add(all, poses());
  ThreadTeam::with(1, [&](ThreadTeam& team) { three.add(poses(), team, 3); });
  ASSERT_EQ(three.ranked().size(), 3u);
  EXPECT_TRUE(same_bits(three.ranked().front().pose, all.ranked().front().pose));
  EXPECT_GT(all.ranked().size(), 15u);
}

TEST_F(CandidateSet, IsTheSameForAnyThreads) {
  emtr::CandidateSet one(surfaces(), nullptr);
  add(one, poses(), 1);
  const auto list = shortlist(12, 1);
  for (const int threads : {2, 4}) {
    const auto other_list = shortlist(12, threads);
    ASSERT_EQ(list.size(), other_list.size());
    for (std::size_t i = 0; i < list.size(); ++i) EXPECT_TRUE(same_bits(list[i], other_list[i]));
    emtr::CandidateSet other(surfaces(), nullptr);
    add(other, poses(), threads);
    ASSERT_EQ(one.ranked().size(), other.ranked().size());
    for (std::size_t i = 0; i < one.ranked().size(); ++i) {
      EXPECT_TRUE(same_bits(one.ranked()[i].pose, other.ranked()[i].pose));
      EXPECT_EQ(one.ranked()[i].score, other.ranked()[i].score);
    }
  }
}

}  // namespace
