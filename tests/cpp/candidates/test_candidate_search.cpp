#include <gtest/gtest.h>

#include "candidates/candidate_search.h"
#include "candidates/scene.h"

namespace {

using emtr::CandidateSearch;
using emtr::Rigid;
using emtr_test::anywhere;
using emtr_test::same_bits;

constexpr std::size_t kMostRivals = 24;

class Search : public testing::Test {
 protected:
  Search() {
    scene.settings.candidates = 6;
    scene.settings.fallback_points = 4000;
    scene.settings.fallback_correspondences = 800;
    scene.settings.fallback_seeds = 40;
    scene.settings.fallback_candidates = 8;
  }

  CandidateSearch search() const {
    return {scene.normalized, surfaces, scene.settings, emtr::select_kernels(), nullptr};
  }

  /// A search that was given nothing of use.
  CandidateSearch used_fallback_search() const {
    CandidateSearch out = search();
    out.add(anywhere(3, 2), {});
    EXPECT_FALSE(out.used_fallback_search());
    EXPECT_FALSE(scene.solved(out.ranked().front().pose));
    out.run_fallback_search();
    EXPECT_TRUE(out.used_fallback_search());
    return out;
  }

  emtr_test::Scene scene{34, 5000, 20};
  emtr::SurfacePair surfaces{scene.source, scene.target, {}, {}, emtr::select_kernels()};
};

TEST_F(Search, TheShortlistIsOfTheSeedsThatFitBest) {
  std::vector<emtr::Seed> seeds;
  for (const Rigid& pose : anywhere(20, 3)) seeds.push_back({pose, 50});
  seeds.push_back({scene.off({2, 0, 0}, {0, 0.01, 0}), 3});  // however few support it
  const auto out = search().shortlist(seeds);
  ASSERT_EQ(out.size(), 6u);
  EXPECT_TRUE(same_bits(out.front(), seeds.back().pose));
  EXPECT_TRUE(search().shortlist({}).empty());
}

TEST_F(Search, AddsAllOfTheFewAndTheBestOfTheMany) {
  CandidateSearch few = search();
  few.add(anywhere(15, 4), {});
  EXPECT_GE(few.ranked().size(), 15u);  // more than `candidates`, and rivals
  CandidateSearch both = search();
  auto many = anywhere(40, 5);
  many.push_back(scene.off({1, 2, 0}, {0, 0, 0.01}));
  both.add(anywhere(15, 4), many);
  EXPECT_GT(both.ranked().size(), 15u);
  EXPECT_LE(both.ranked().size(), 15u + 6u + kMostRivals);
  EXPECT_TRUE(scene.solved(both.ranked().front().pose));
}

TEST_F(Search, FallbackFindsWhatNoSeedGave) {
  const CandidateSearch found = used_fallback_search();
  EXPECT_TRUE(scene.solved(found.ranked().front().pose));
  EXPECT_GT(found.ranked().front().score, 0.3);
  EXPECT_LE(found.ranked().size(), 8u + 3u + 2 * kMostRivals);
}

TEST_F(Search, ScoresAreThoseOfTheSurfaces) {
  const CandidateSearch found = used_fallback_search();
  emtr::Ranking::Scratch scratch;
  for (const emtr::Candidate& c : found.ranked()) {
    EXPECT_EQ(c.score, surfaces.ranking().evaluate(c.pose, scratch).score);
    EXPECT_EQ(c.violation, surfaces.ranking().evaluate(c.pose, scratch).violation);
  }
}

TEST_F(Search, RivalsJoinTheOthers) {
  CandidateSearch found = search();
  found.add({scene.truth}, {});
  EXPECT_TRUE(scene.solved(found.ranked().front().pose));
  EXPECT_GT(found.ranked().size(), 6u);
  EXPECT_FALSE(found.used_fallback_search());
}

TEST_F(Search, WithoutFreeSpaceNothingIsViolated) {
  scene.settings.free_space = 0;
  const CandidateSearch found = used_fallback_search();
  EXPECT_TRUE(scene.solved(found.ranked().front().pose));
  for (const emtr::Candidate& c : found.ranked()) EXPECT_EQ(c.violation, 0);
}

TEST_F(Search, FallbackKeepsTheCandidatesOfBefore) {
  scene.settings.fallback_points = 100;  // too few to find anything
  scene.settings.fallback_seeds = 1;
  CandidateSearch kept = search();
  kept.add({scene.off({1, 0, 0}, {0, 0, 0})}, anywhere(5, 6));
  const auto before = kept.ranked();
  kept.run_fallback_search();
  EXPECT_TRUE(scene.solved(kept.ranked().front().pose));
  EXPECT_GE(kept.ranked().size() + 1, before.size());  // refinement may bring two together
}

TEST_F(Search, IsTheSameBitsForAnyThreads) {
  const auto run = [&](int threads) {
    scene.settings.threads = threads;
    return used_fallback_search().ranked();
  };
  const auto one = run(1);
  for (const int threads : {2, 4}) {
    const auto other = run(threads);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_TRUE(same_bits(one[i].pose, other[i].pose));
      EXPECT_EQ(one[i].score, other[i].score);
      EXPECT_EQ(one[i].violation, other[i].violation);
    }
  }
}

}  // namespace
