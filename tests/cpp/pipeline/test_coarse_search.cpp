#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "settings/settings.h"
#include "support/clouds.h"
#include "support/registered.h"

namespace {

using emtr::Settings;
using emtr_test::Pair;
using emtr_test::registered;
using ResultPtr = std::unique_ptr<emtr::Result>;

Settings settings_with(std::int32_t coarse_points) {
  Settings settings = emtr::preset("default");
  settings.threads = 1;
  settings.coarse_points = coarse_points;
  return settings;
}

/// How often a registration matches the clouds: once a search.
int searches(const emtr_cloud& source, const emtr_cloud& target, const Settings& settings) {
  int found = 0;
  std::string last;
  registered(source, target, settings, [&](const emtr_progress& p) {
    found += p.stage == std::string("matching") && last != p.stage;
    last = p.stage;
    return false;
  });
  return found;
}

void expect_same_bits(const emtr::Result& a, const emtr::Result& b) {
  EXPECT_TRUE(std::equal(a.transformation, a.transformation + 16, b.transformation));
  EXPECT_EQ(a.confidence, b.confidence);
  EXPECT_EQ(a.score, b.score);
  EXPECT_EQ(a.fitness, b.fitness);
  EXPECT_EQ(a.reason, b.reason);
  EXPECT_EQ(a.dense_source, b.dense_source);
}

class CoarseSearch : public testing::Test {
 protected:
  static const Pair& sure() {
    static const Pair pair(61, 8000);
    return pair;
  }

  /// Two clouds that do not belong together.
  static emtr_cloud doubtful_source() { return sure().source(); }
  static emtr_cloud doubtful_target() {
    static const Pair other(62, 8000);
    return other.target();
  }
};

TEST_F(CoarseSearch, IsTheAnswerWhereItLeavesNoDoubt) {
  const Pair& pair = sure();
  const ResultPtr r = registered(pair.source(), pair.target(), settings_with(2500));
  EXPECT_EQ(r->registered, 1);
  EXPECT_LT(pair.error(r->transformation), 0.01);
  EXPECT_LT(r->dense_source + r->dense_target, 2500 * 1.2);
  EXPECT_EQ(searches(pair.source(), pair.target(), settings_with(2500)), 1);

  Settings same = settings_with(0);  // but by its own effort
  same.dense_points = 2500;
  same.population = 20;
  same.candidates = same.injected_seeds = 6;
  expect_same_bits(*r, *registered(pair.source(), pair.target(), same));
}

TEST_F(CoarseSearch, LeavesNothingBehindWhereThereIsDoubt) {
  const emtr_cloud source = doubtful_source(), target = doubtful_target();
  const ResultPtr both = registered(source, target, settings_with(2500)),
                  alone = registered(source, target, settings_with(0));
  EXPECT_EQ(both->registered, 0);
  expect_same_bits(*both, *alone);
  EXPECT_EQ(searches(source, target, settings_with(2500)), 2);
  EXPECT_EQ(searches(source, target, settings_with(0)), 1);
}

TEST_F(CoarseSearch, IsLeftOutWhereItCouldNotDecide) {
  const auto searches_with = [](auto change) {
    Settings settings = settings_with(2500);
    change(settings);
    return searches(doubtful_source(), doubtful_target(), settings);
  };
  EXPECT_EQ(searches_with([](Settings& s) { s.dense_points = 2500; }), 1);
  EXPECT_EQ(searches_with([](Settings& s) { s.sparse_points = 2500; }), 1);
  EXPECT_EQ(searches_with([](Settings& s) { s.candidates = 0; }), 1);
  EXPECT_EQ(searches_with([](Settings& s) { s.seeds = s.injected_seeds = 0; }), 1);
  EXPECT_EQ(searches_with([](Settings& s) { s.fallback_search = EMTR_ALWAYS; }), 1);
  EXPECT_EQ(searches_with([](Settings& s) { s.fallback_search = EMTR_OFF; }), 2);
}

TEST_F(CoarseSearch, FailsQuietlyWhereTooFewPointsAreLeft) {
  Settings few = settings_with(100), none = settings_with(0);
  few.sparse_points = none.sparse_points = 10;
  // The smaller cloud has too few points at the leaf of the larger one, if that is coarse.
  few.parts = none.parts = EMTR_OFF;
  const Pair small(61, 8000, 0.13), large(62, 8000);
  const emtr_cloud source = small.source(), target = large.target();
  EXPECT_EQ(searches(source, target, few), 1);  // the coarse one ends before it
  expect_same_bits(*registered(source, target, few), *registered(source, target, none));
}

TEST_F(CoarseSearch, GivesItsPoseToARunThatIsStoppedBeforeAFinerOne) {
  int found = 0;
  std::string last;
  const auto stop_in_second = [&](const emtr_progress& p) {
    found += p.stage == std::string("downsampling") && last != p.stage;
    last = p.stage;
    return found == 2;
  };
  const ResultPtr r =
      registered(doubtful_source(), doubtful_target(), settings_with(2500), stop_in_second);
  EXPECT_EQ(found, 2);
  EXPECT_EQ(r->registered, 0);
  EXPECT_EQ(r->reason, EMTR_REASON_INTERRUPTED);
  EXPECT_TRUE(emtr::is_rigid(r->transformation));
}

TEST_F(CoarseSearch, StopsWithTheBestPoseSoFar) {
  const auto stop = [](const emtr_progress& p) { return p.stage == std::string("evolution"); };
  const ResultPtr r = registered(sure().source(), sure().target(), settings_with(2500), stop);
  EXPECT_EQ(r->registered, 0);
  EXPECT_EQ(r->reason, EMTR_REASON_INTERRUPTED);
  EXPECT_TRUE(emtr::is_rigid(r->transformation));
}

}  // namespace
