// Matches that decide, from the problem to the result.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "settings/settings.h"
#include "support/matches.h"
#include "support/problems.h"

namespace {

using emtr_test::Matches;

struct Input {
  std::vector<float> source, target;
  std::vector<std::int32_t> rows;
  emtr::Settings settings = emtr::preset("default");

  explicit Input(const Matches& matches) {
    settings.threads = 2;
    const emtr::MatchPoints& points = matches.points;
    for (std::size_t i = 0; i < points.size(); ++i) {
      source.insert(source.end(), {points.p.x[i], points.p.y[i], points.p.z[i]});
      target.insert(target.end(), {points.q.x[i], points.q.y[i], points.q.z[i]});
      rows.insert(rows.end(), 2, static_cast<std::int32_t>(i));
    }
    settings.correspondences = rows.data();
    settings.correspondence_count = points.size();
  }

  static emtr_cloud view(const std::vector<float>& points) {
    emtr_cloud out{};
    out.points = points.data();
    out.count = points.size() / 3;
    out.scalar = EMTR_FLOAT32;
    return out;
  }

  emtr_test::ResultPtr solve(emtr::Stages stages = emtr::Stages::Needed) const {
    const emtr_cloud from = view(source), to = view(target);
    emtr::InputCloud a{&from, nullptr}, b{&to, nullptr};
    emtr::CancellationToken token(nullptr);
    return emtr_test::solve(*emtr::make_problem(a, b, settings, token, stages));
  }
};

emtr::Rigid pose_of(const emtr_result& result) { return emtr::from_matrix(result.transformation); }

TEST(UserMatches, GiveThePoseWhereThereIsNoSurface) {
  const Matches matches(25, 25, 0);
  const auto result = Input(matches).solve();
  EXPECT_EQ(result->reason, EMTR_REASON_REGISTERED);
  EXPECT_TRUE(result->registered);
  EXPECT_LT(matches.error(pose_of(*result)), 1e-4);
  EXPECT_EQ(result->correspondences, 50u);
  EXPECT_EQ(result->score, 0.5);
  EXPECT_EQ(result->unconstrained_directions, 0);
}

TEST(UserMatches, ThreeOfThreePointsAreEnough) {
  const Matches matches(3, 0, 0);
  const auto result = Input(matches).solve();
  EXPECT_TRUE(result->registered);
  EXPECT_LT(matches.error(pose_of(*result)), 1e-3);
}

TEST(UserMatches, ThatLeadAnywhereAreNotRegistered) {
  const auto result = Input(Matches(0, 60, 0)).solve();
  EXPECT_EQ(result->reason, EMTR_REASON_FEW_MATCHES);
  EXPECT_FALSE(result->registered);
  EXPECT_LT(result->confidence, 0.5);
}

TEST(UserMatches, GiveTheSameWhetherOrNotTheTasksAreMade) {
  const Input input(Matches(150, 150, 0.01));
  const auto needed = input.solve(), all = input.solve(emtr::Stages::All);
  EXPECT_EQ(std::memcmp(needed->transformation, all->transformation, sizeof all->transformation),
            0);
  EXPECT_EQ(needed->confidence, all->confidence);
  EXPECT_EQ(needed->dense_source, all->dense_source);
}

TEST(UserMatches, KeepToThePrior) {
  const Matches matches(40, 0, 0);
  Input input(matches);
  input.settings.maximum_rotation = 1;
  const auto result = input.solve();
  EXPECT_FALSE(result->registered);
  EXPECT_LT(emtr::rotation_distance(pose_of(*result).R, Eigen::Matrix3d::Identity()), 0.02);
}

}  // namespace
