#include <algorithm>
#include <limits>

#include "candidates/one_scene.h"
#include "candidates/quick_scores.h"

namespace {

using emtr::Rigid;
using emtr::SurfacePair;
using emtr::ThreadTeam;
using emtr_test::anywhere;

class QuickScores : public emtr_test::OneScene {
 protected:
  static double quickest(const Rigid& pose) { return score(pose, SurfacePair::kQuickestStep); }

  /// Ninety wrong ones, and ten from the truth on to twenty degrees off.
  static std::vector<Rigid> poses() {
    std::vector<Rigid> out = anywhere(90, 7);
    for (int i = 0; i < 10; ++i) out.push_back(scene().off({0, 2.0 * i, 0}, {0, 0, 0}));
    return out;
  }

  static std::vector<std::size_t> order(std::size_t most, int threads = 1) {
    std::vector<std::size_t> out;
    ThreadTeam::with(threads, [&](ThreadTeam& team) {
      out = emtr::order_by_quick_scores(surfaces(), poses(), most, team);
    });
    return out;
  }
};

TEST_F(QuickScores, OrdersAllPosesOnceAndTheDeservingByTheirQuickScore) {
  const auto all = poses();
  const auto rows = order(20);
  ASSERT_EQ(rows.size(), all.size());
  std::vector<std::size_t> sorted = rows;
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 0; i < sorted.size(); ++i) EXPECT_EQ(sorted[i], i);
  EXPECT_EQ(rows.front(), 90u);  // the truth
  for (std::size_t i = 1; i < 40; ++i) EXPECT_GE(quick(all[rows[i - 1]]), quick(all[rows[i]]));
  for (std::size_t i = 41; i < rows.size(); ++i)
    EXPECT_GE(quickest(all[rows[i - 1]]), quickest(all[rows[i]]));
  for (std::size_t i = 0; i < 40; ++i)
    EXPECT_GE(quickest(all[rows[i]]), quickest(all[rows[40]])) << i;
}

TEST_F(QuickScores, WhereAllDeserveOneTheOrderIsThatOfTheQuickScores) {
  const auto all = poses();
  const auto rows = order(all.size());
  for (std::size_t i = 1; i < rows.size(); ++i)
    EXPECT_GE(quick(all[rows[i - 1]]), quick(all[rows[i]]));
  EXPECT_EQ(order(std::numeric_limits<std::size_t>::max()), rows);
}

TEST_F(QuickScores, APromisingPoseHasItsQuickScoreAndTheOthersNone) {
  constexpr double kPromising = 0.4;
  const auto all = poses();
  const std::size_t best = 90;
  std::vector<double> scores;
  ThreadTeam::with(1, [&](ThreadTeam& team) {
    scores = emtr::promising_quick_scores(surfaces(), all, best, kPromising, team);
  });
  ASSERT_EQ(scores.size(), all.size());
  std::size_t promising = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool is = i == best || quickest(all[i]) > kPromising / 2 * quickest(all[best]);
    EXPECT_EQ(scores[i], is ? quick(all[i]) : -std::numeric_limits<double>::infinity()) << i;
    promising += is;
  }
  EXPECT_GT(promising, 2u);
  EXPECT_LT(promising, 50u);
}

TEST_F(QuickScores, ThreadsDoNotChangeTheOrderAndNoPoseHasNone) {
  EXPECT_EQ(order(12, 1), order(12, 3));
  ThreadTeam::with(2, [&](ThreadTeam& team) {
    EXPECT_TRUE(emtr::order_by_quick_scores(surfaces(), {}, 12, team).empty());
    EXPECT_TRUE(emtr::promising_quick_scores(surfaces(), {}, 0, 0.4, team).empty());
  });
}

}  // namespace
