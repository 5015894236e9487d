#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "support/bumpy_pair.h"
#include "support/clouds.h"
#include "support/problems.h"
#include "util/cancellation.h"
#include "util/thread_team.h"

namespace {

using emtr::CancellationScope;
using emtr::CancellationToken;
using emtr::Cancelled;
using emtr::OnProgress;
using emtr::ThreadTeam;
using emtr_test::Pair;
using ResultPtr = std::unique_ptr<emtr::Result>;

constexpr CancellationToken::Clock::duration kAlways{
    0};  // asks at every poll, so that counts are of work

emtr::Settings through_all_stages(int threads) {
  emtr::Settings settings = emtr::preset("thorough");
  settings.threads = threads;
  settings.dense_points = 3000;
  settings.iterations = 5;
  settings.stall_iterations = 0;
  settings.fallback_points = 4000;
  settings.fallback_candidates = 20;
  return settings;
}

ResultPtr run(const emtr_cloud& source, const emtr_cloud& target, const emtr::Settings& settings,
              CancellationToken& token) {
  emtr::InputCloud from{&source, nullptr}, to{&target, nullptr};
  const auto problem = emtr::make_problem(from, to, settings, token);
  return emtr::solve(*problem, token);
}

ResultPtr run(const Pair& pair, const emtr::Settings& settings, const OnProgress& on_progress,
              CancellationToken::Clock::duration every = kAlways) {
  CancellationToken token(on_progress, 0, every);
  return run(pair.source(), pair.target(), settings, token);
}

bool same_pose(const emtr::Result& a, const emtr::Result& b) {
  return std::equal(a.transformation, a.transformation + 16, b.transformation);
}

const emtr::Result& undisturbed(const Pair& pair) {
  static const ResultPtr result = run(pair, through_all_stages(1), nullptr);
  return *result;
}

const Pair& shared_pair() {
  static const Pair pair(80, 3000);
  return pair;
}

TEST(CancellationToken, AHeldStageStandsForAllThatAreReported) {
  std::vector<std::string> stages;
  CancellationToken token([&](const emtr_progress& p) {
    stages.emplace_back(p.stage);
    return false;
  });
  token.hold_stage("fallback_search");
  token.report_progress({"features", 1, 2, 3, 4});
  token.hold_stage(nullptr);
  token.report_progress({"features", 0, 0, 0, 0});
  EXPECT_EQ(stages, (std::vector<std::string>{"fallback_search", "features"}));
}

// ---- how often ------------------------------------------------------------------------

/// A stage's polls, each a chance to stop, against what it has to work on. The clock has no say.
TEST(CancellationToken, IsAskedEveryFewMillisecondsOfWorkInEachStage) {
  const std::size_t points = 300000;
  const Pair pair(81, points);
  emtr::Settings settings = emtr::preset("thorough");
  settings.threads = 1;
  settings.stall_iterations = 0;
  std::map<std::string, std::size_t> polls;
  const auto count = [&](const emtr_progress& p) {
    ++polls[p.stage];
    return false;
  };
  run(pair, settings, count);
  const auto matches = static_cast<std::size_t>(settings.max_correspondences),
             particles = 2 * static_cast<std::size_t>(settings.population),
             described = static_cast<std::size_t>(settings.dense_points);
  EXPECT_GE(polls["normalization"],
            2 * 4 * points / 65536);     // four passes over each cloud, by blocks
  EXPECT_GE(polls["downsampling"], 5u);  // counts of one leaf each
  EXPECT_GE(polls["features"], described / 100);
  EXPECT_GE(polls["matching"], described / 64);  // and the points of the grids
  EXPECT_GE(polls["seeds"], matches / 10);       // by match and by seed
  EXPECT_GE(polls["evolution"], particles * static_cast<std::size_t>(settings.iterations));
  EXPECT_GE(polls["candidates"], 12u * 5u);  // by step of each refinement
  EXPECT_GE(polls["fallback_search"], static_cast<std::size_t>(settings.fallback_points) / 10);
  EXPECT_GE(polls["refinement"], points / 1024);
}

TEST(CancellationToken, IsAskedWhileUserInputIsRead) {
  const std::size_t points = 300000, dimension = 3;
  const Pair pair(83, points);
  std::vector<float> rows(points * dimension);
  std::mt19937 random(83);
  for (float& value : rows) value = static_cast<float>(random() % 1000);
  std::vector<std::int32_t> matches(2 * points);
  for (std::size_t i = 0; i < matches.size(); ++i) matches[i] = static_cast<std::int32_t>(i / 2);
  emtr_cloud source = pair.source(), target = pair.target();
  source.normals = target.normals = source.features = target.features = rows.data();
  source.feature_dimension = target.feature_dimension = dimension;
  emtr::Settings settings = emtr::preset("fast");
  settings.threads = 1;
  settings.correspondences = matches.data();
  settings.correspondence_count = points;
  std::map<std::string, std::size_t> polls;
  const auto stop_after_features = [&](const emtr_progress& p) {
    ++polls[p.stage];
    return p.stage == std::string("matching");
  };
  CancellationToken token(stop_after_features, 0, kAlways);
  emtr::InputCloud from{&source, nullptr}, to{&target, nullptr};
  const auto problem = emtr::make_problem(from, to, settings, token);
  EXPECT_TRUE(problem->stopped);
  EXPECT_GE(polls["normalization"], 2 * points / 256 + points / 1024);
}

TEST(CancellationToken, AsksTheCallerWhileItsHelpersWork) {
  int asked = 0;
  CancellationToken token([&](const emtr_progress&) { return ++asked == 5; }, 0, kAlways);
  const CancellationScope scope(&token);
  std::atomic<int> here{0};
  const auto job = [&](std::size_t, std::size_t thread) {
    for (++here; here < 2;) std::this_thread::yield();  // until each thread has one of the two
    while (thread == 1) emtr::check_cancelled();
  };
  EXPECT_THROW(ThreadTeam::with(2, [&](ThreadTeam& team) { team.parallel(2, job); }), Cancelled);
  EXPECT_EQ(asked, 5);
  EXPECT_TRUE(token.cancelled());
  EXPECT_FALSE(token.timed_out());
}

TEST(CancellationToken, NobodyIsAskedOutsideOfARun) { EXPECT_NO_THROW(emtr::check_cancelled()); }

// ---- what a stop leaves ---------------------------------------------------------------

void expect_whole(const emtr::Result& r, const emtr::Result& whole, const std::string& stage) {
  EXPECT_EQ(r.reason, EMTR_REASON_INTERRUPTED);
  EXPECT_EQ(r.registered, 0);
  const bool known = std::isfinite(r.transformation[0]);
  if (stage == "candidates" || stage == "fallback_search" || stage == "refinement") {
    EXPECT_TRUE(known);
  }
  if (known) {
    EXPECT_TRUE(emtr::is_rigid(r.transformation));
    EXPECT_GE(r.fitness, 0);
    EXPECT_LE(r.fitness, 1);
  }
  EXPECT_LE(r.iterations, whole.iterations);
  for (std::size_t i = 0; i < r.iterations; ++i)
    EXPECT_EQ(r.history_alpha[i], whole.history_alpha[i]);
  EXPECT_FALSE(r.refined);
  EXPECT_EQ(r.used_fallback_search, stage == "refinement");
  EXPECT_EQ(std::isfinite(r.confidence), stage == "fallback_search" || stage == "refinement");
  if (std::isfinite(r.confidence)) {
    EXPECT_GT(r.candidates, 0u);
  }
}

TEST(CancellationToken, AStopAnywhereLeavesTheBestPoseSoFar) {
  const Pair& pair = shared_pair();
  std::size_t polls = 0;
  const auto all = run(pair, through_all_stages(1), [&](const emtr_progress&) {
    ++polls;
    return false;
  });
  EXPECT_TRUE(same_pose(*all, undisturbed(pair)));
  for (const int threads : {1, 3})
    for (std::size_t at = 1; at < polls; at += 1 + polls / 20) {
      SCOPED_TRACE("poll " + std::to_string(at) + ", threads " + std::to_string(threads));
      std::size_t asked = 0;
      std::string stage;
      const auto stop = [&](const emtr_progress& p) {
        stage = p.stage;
        return ++asked >= at;
      };
      const ResultPtr r = run(pair, through_all_stages(threads), stop);
      if (stage == "verdict") continue;  // with helpers at work there are fewer polls
      EXPECT_EQ(asked, at);              // nobody was asked again
      expect_whole(*r, undisturbed(pair), stage);
    }
}

TEST(CancellationToken, AStopAnywhereKeepsToThePrior) {
  const Pair& pair = shared_pair();
  emtr::Settings settings = through_all_stages(1);
  settings.maximum_rotation = 10;  // none of the seeds
  std::size_t polls = 0, known = 0;
  const auto count = [&](const emtr_progress&) { return ++polls, false; };
  EXPECT_GT(run(pair, settings, count)->seeds, 0u);
  std::set<std::string> stages;
  for (std::size_t at = 1; at < polls; at += 1 + polls / 40) {
    std::size_t asked = 0;
    std::string stage;
    const auto stop = [&](const emtr_progress& p) {
      const bool next = stages.insert(stage = p.stage).second;  // each stage as it begins, too
      return ++asked >= at || next;
    };
    const ResultPtr r = run(pair, settings, stop);
    if (std::isnan(r->transformation[0])) continue;
    ++known;
    const emtr::Rigid pose = emtr::from_matrix(r->transformation);
    EXPECT_LE(emtr::rotation_distance(pose.R, emtr::Rigid().R), 10 * M_PI / 180 + 1e-9)
        << "poll " << at << ", stage " << stage;
  }
  EXPECT_GT(known, 20u);
}

TEST(CancellationToken, TheTimeLimitHasAReasonOfItsOwn) {
  const Pair& pair = shared_pair();
  CancellationToken at_once(nullptr, 1e-9), never(nullptr, 1e9);
  const ResultPtr none = run(pair.source(), pair.target(), through_all_stages(2), at_once);
  EXPECT_EQ(none->reason, EMTR_REASON_TIME_LIMIT);
  EXPECT_EQ(none->registered, 0);
  EXPECT_TRUE(std::isnan(none->transformation[0]));
  EXPECT_STREQ(emtr_reason_text(none->reason), "the time limit was reached");
  const ResultPtr whole = run(pair.source(), pair.target(), through_all_stages(2), never);
  EXPECT_TRUE(same_pose(*whole, undisturbed(pair)));
  EXPECT_EQ(whole->reason, undisturbed(pair).reason);

  emtr::Settings settings = through_all_stages(1);
  settings.time_limit = 1e-9;  // of a problem at hand it counts from solve() on
  const auto problem = emtr_test::problem_of(pair.source(), pair.target(), settings);
  EXPECT_FALSE(problem->stopped);
  const ResultPtr seed = emtr_test::solve(*problem);
  EXPECT_EQ(seed->reason, EMTR_REASON_TIME_LIMIT);
  EXPECT_TRUE(emtr::is_rigid(seed->transformation));  // the best of the seeds
}

// ---- callbacks that do as they please -------------------------------------------------

TEST(CancellationToken, WhatTheCallbackThrowsComesOutOfAnyPoll) {
  const Pair& pair = shared_pair();
  for (const std::size_t at : {3u, 30u, 100u, 300u, 1000u}) {
    std::size_t asked = 0;
    const auto throwing = [&](const emtr_progress&) -> bool {
      if (++asked == at) throw std::out_of_range("mine");
      return false;
    };
    EXPECT_THROW(run(pair, through_all_stages(3), throwing), std::out_of_range) << at;
    EXPECT_EQ(asked, at);
  }
}

TEST(CancellationToken, ACallbackMayRegisterCloudsItself) {
  const Pair& pair = shared_pair();
  const Pair other(82, 2000);
  const ResultPtr alone = run(other, through_all_stages(1), nullptr);
  std::size_t asked = 0, inner = 0;
  const auto nested = [&](const emtr_progress&) {
    if (++asked % 400 != 0) return false;
    const auto count = [&](const emtr_progress&) { return ++inner, false; };
    EXPECT_TRUE(same_pose(*run(other, through_all_stages(2), count), *alone));
    // Without an eye of its own it is nobody's: the outer run is not asked for it.
    const std::size_t before = asked;
    emtr_test::problem_of(other.source(), other.target(), through_all_stages(1));
    EXPECT_EQ(asked, before);
    return false;
  };
  const ResultPtr outer = run(pair, through_all_stages(2), nested);
  EXPECT_GT(inner, 0u);
  EXPECT_TRUE(same_pose(*outer, undisturbed(pair)));
}

TEST(CancellationToken, ACallbackMayRegisterTheCloudsOfTheRun) {
  const Pair& pair = shared_pair();
  const auto preprocessed = [](const emtr_cloud& cloud) {
    return std::make_shared<const emtr::PreprocessedCloud>(cloud, "", 1);
  };
  const auto source = preprocessed(pair.source()), target = preprocessed(pair.target());
  const emtr::Settings settings = through_all_stages(1);
  std::size_t asked = 0;
  const auto nested = [&](const emtr_progress& p) {
    if (p.stage != std::string("downsampling") || ++asked % 20 != 10) return false;
    EXPECT_TRUE(same_pose(*emtr_test::solve(*emtr_test::problem_of(source, target, settings)),
                          undisturbed(pair)));
    return false;
  };
  CancellationToken token(nested, 0, kAlways);
  emtr::InputCloud from{nullptr, source}, to{nullptr, target};
  const auto problem = emtr::make_problem(from, to, settings, token);
  EXPECT_TRUE(same_pose(*emtr::solve(*problem, token), undisturbed(pair)));
  EXPECT_GE(asked, 40u);
}

}  // namespace
