// User-provided data, from the problem to the result.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <string>

#include "support/known_pair.h"
#include "support/problems.h"
#include "util/error.h"

namespace {

using emtr_test::KnownPair;

std::vector<std::pair<std::int32_t, std::int32_t>> rows_of(const emtr::Problem& p) {
  std::vector<std::pair<std::int32_t, std::int32_t>> out;
  for (const emtr::Correspondence& c : p.correspondences) out.emplace_back(c.source, c.target);
  return out;
}

std::vector<float> packed(const emtr::Cloud& cloud) {
  std::vector<float> out;
  for (std::size_t i = 0; i < cloud.size(); ++i)
    out.insert(out.end(), {cloud.x[i], cloud.y[i], cloud.z[i]});
  return out;
}

emtr_cloud view(const std::vector<float>& points, const std::vector<float>* features,
                std::size_t dimension) {
  emtr_cloud out{points.data(), points.size() / 3, 0, EMTR_FLOAT32};
  if (features) out.features = features->data();
  if (features) out.feature_dimension = dimension;
  return out;
}

std::unique_ptr<emtr::Result> solve(const emtr_cloud& source, const emtr_cloud& target,
                                    const emtr::Settings& settings) {
  return emtr_test::solve(*emtr_test::problem_of(source, target, settings));
}

/// Descriptors that tell where on the relief a point is, the same from both sides, with some noise.
std::vector<float> codes(const std::vector<float>& points, bool source, std::size_t dimension) {
  std::mt19937 random(source ? 3 : 4);
  std::vector<float> out;
  for (std::size_t i = 0; i < points.size() / 3; ++i) {
    const float x = source ? points[3 * i + 2] - 4 : points[3 * i],
                y = source ? points[3 * i] - 4 : points[3 * i + 1];
    for (std::size_t d = 0; d < dimension; ++d) {
      const float phase = static_cast<float>(d);
      const float noise = 0.02f * static_cast<float>(random() % 1000) / 1000;
      out.push_back(std::sin((2 + phase / 3) * x + phase) * std::cos(2.5f * y - phase) + noise);
    }
  }
  return out;
}

TEST(UserInput, OurOwnFeaturesGiveOurOwnCorrespondences) {
  const KnownPair pair(8000);
  const emtr::Settings settings = emtr::preset("default");
  const auto own = emtr_test::problem_of(pair.source_cloud(), pair.target_cloud(), settings);
  ASSERT_GT(own->correspondences.size(), 100u);
  const auto source = packed(own->downsampled.source_dense),
             target = packed(own->downsampled.target_dense);
  const auto provided = emtr_test::problem_of(
      view(source, &own->source_features->descriptors, emtr::kFeatureSize),
      view(target, &own->target_features->descriptors, emtr::kFeatureSize), settings);
  ASSERT_TRUE(provided->user_keypoints);
  EXPECT_TRUE(provided->source_features->descriptors.empty());
  auto found = rows_of(*provided);
  for (auto& [s, t] : found) {
    s = provided->user_keypoints->source.rows[static_cast<std::size_t>(s)];
    t = provided->user_keypoints->target.rows[static_cast<std::size_t>(t)];
  }
  EXPECT_EQ(found, rows_of(*own));
}

TEST(UserInput, FeaturesOfAnyDimensionRegister) {
  const KnownPair pair(6000);
  const emtr::Settings settings = emtr::preset("default");
  for (const std::size_t dimension : {5u, 33u, 352u}) {
    const auto source = codes(pair.source, true, dimension),
               target = codes(pair.target, false, dimension);
    const auto result = solve(view(pair.source, &source, dimension),
                              view(pair.target, &target, dimension), settings);
    EXPECT_TRUE(result->registered) << dimension;
    EXPECT_LT(KnownPair::error(result->transformation), 0.05) << dimension;
  }
}

TEST(UserInput, AFewKeypointsAreEnough) {
  const KnownPair pair(6000);
  auto source = codes(pair.source, true, 8), target = codes(pair.target, false, 8);
  const float none = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < source.size(); i += 8)
    if (i / 8 % 10) source[i + 3] = none;
  for (std::size_t i = 0; i < target.size(); i += 8)
    if (i / 8 % 7) target[i] = none;
  const auto problem = emtr_test::problem_of(
      view(pair.source, &source, 8), view(pair.target, &target, 8), emtr::preset("default"));
  EXPECT_EQ(problem->matched_source().size(), (source.size() / 8 + 9) / 10);
  EXPECT_EQ(problem->matched_target().size(), (target.size() / 8 + 6) / 7);
  const auto result = emtr_test::solve(*problem);
  EXPECT_TRUE(result->registered);
  EXPECT_LT(KnownPair::error(result->transformation), 0.05);
}

TEST(UserInput, VeryManyFeaturesAreDownsampledToOneADenseLeaf) {
  const KnownPair pair(40000);
  const auto source = codes(pair.source, true, 4), target = codes(pair.target, false, 4);
  ASSERT_GT(pair.source.size() / 3, emtr::kMaximumKeypoints);
  const auto problem = emtr_test::problem_of(
      view(pair.source, &source, 4), view(pair.target, &target, 4), emtr::preset("default"));
  EXPECT_EQ(problem->matched_source().size(), problem->downsampled.source_dense.size());
  EXPECT_EQ(problem->matched_target().size(), problem->downsampled.target_dense.size());
}

TEST(UserInput, TrueMatchesAmongFourTimesAsManyWrongOnesRegister) {
  const KnownPair pair(5000);
  const auto rows = pair.correspondences(500, 5);
  for (const char* preset : {"default", "fast"}) {
    emtr::Settings settings = emtr::preset(preset);
    settings.correspondences = rows.data();
    settings.correspondence_count = rows.size() / 2;
    const auto problem = emtr_test::problem_of(pair.source_cloud(), pair.target_cloud(), settings);
    EXPECT_EQ(problem->correspondences.size(), 500u);
    EXPECT_TRUE(problem->source_features->descriptors.empty());
    EXPECT_EQ(problem->settings.correspondences, nullptr);  // nothing of the caller's is kept
    const auto result = emtr_test::solve(*problem);
    EXPECT_TRUE(result->registered) << preset;
    EXPECT_LT(KnownPair::error(result->transformation), 0.02) << preset;
    EXPECT_EQ(result->correspondences, 500u);
  }
}

TEST(UserInput, MatchesGoBeforeFeatures) {
  const KnownPair pair(3000);
  const auto rows = pair.correspondences(300, 2);
  const auto source = codes(pair.source, true, 3), target = codes(pair.target, false, 3);
  emtr::Settings settings = emtr::preset("fast");
  settings.correspondences = rows.data();
  settings.correspondence_count = rows.size() / 2;
  const auto beside = solve(view(pair.source, &source, 3), view(pair.target, &target, 3), settings);
  const auto alone = solve(pair.source_cloud(), pair.target_cloud(), settings);
  EXPECT_EQ(0, std::memcmp(beside->transformation, alone->transformation, sizeof(double[16])));
}

TEST(UserInput, AFallbackSearchLooksWithOurOwnFeatures) {
  // Matches that are all wrong, and hardly any swarm.
  const KnownPair pair(5000);
  auto rows = pair.correspondences(200, 1);
  for (std::size_t i = 1; i < rows.size(); i += 2)
    rows[i] = static_cast<std::int32_t>((static_cast<std::size_t>(rows[i]) * 7919 + 13) %
                                        (pair.target.size() / 3));
  emtr::Settings settings = emtr::preset("default");
  settings.iterations = 1;
  settings.population = 2;
  settings.seeds = 0;
  settings.fallback_search = EMTR_ALWAYS;
  settings.correspondences = rows.data();
  settings.correspondence_count = rows.size() / 2;
  const auto result = solve(pair.source_cloud(), pair.target_cloud(), settings);
  EXPECT_TRUE(result->used_fallback_search);
  EXPECT_TRUE(result->registered);
  EXPECT_LT(KnownPair::error(result->transformation), 0.02);
}

TEST(UserInput, AFallbackSearchKeepsWhatTheMatchesLedTo) {
  const KnownPair pair(5000);
  const auto rows = pair.correspondences(200, 2);
  emtr::Settings settings = emtr::preset("thorough");
  settings.iterations = 1;
  settings.population = 2;
  settings.fallback_seeds = 1;  // of our own, hardly any
  settings.fallback_correspondences = 3;
  settings.correspondences = rows.data();
  settings.correspondence_count = rows.size() / 2;
  const auto result = solve(pair.source_cloud(), pair.target_cloud(), settings);
  EXPECT_TRUE(result->used_fallback_search);
  EXPECT_LT(KnownPair::error(result->transformation), 0.02);
}

TEST(UserInput, NormalsReplaceTheEstimatedOnes) {
  const KnownPair pair(6000);
  emtr_cloud source = pair.source_cloud(), target = pair.target_cloud();
  source.normals = pair.source_normals.data();
  target.normals = pair.target_normals.data();
  for (const emtr_features features : {EMTR_FEATURES_PCL, EMTR_FEATURES_SIMD}) {
    emtr::Settings settings = emtr::preset("default");
    settings.features = features;
    const auto problem = emtr_test::problem_of(source, target, settings);
    const auto estimated =
        emtr_test::problem_of(pair.source_cloud(), pair.target_cloud(), settings);
    // Normals of the relief all point up, which is the source's y; estimated ones to the centroid.
    std::size_t up = 0, estimated_up = 0;
    const auto& normals = problem->source_features->normals;
    for (std::size_t i = 0; i < normals.size(); i += 3) {
      up += normals[i + 1] > 0;
      estimated_up += estimated->source_features->normals[i + 1] > 0;
      const double length = std::hypot(normals[i], normals[i + 1], normals[i + 2]);
      ASSERT_NEAR(length, 1, 1e-5);
    }
    EXPECT_EQ(up, normals.size() / 3);
    EXPECT_LT(estimated_up, normals.size() / 3);
    ASSERT_EQ(problem->source_features->descriptors.size(),
              emtr::kFeatureSize * problem->downsampled.source_dense.size());
    EXPECT_EQ(problem->surfaces->source().normals.x, problem->downsampled.source_normals.x);
    const auto result = emtr_test::solve(*problem);
    EXPECT_TRUE(result->registered) << features;
    EXPECT_LT(KnownPair::error(result->transformation), 0.02) << features;
  }
}

TEST(UserInput, NormalsOfOneCloudAloneAreOrientedAsTheEstimatedOnes) {
  const KnownPair pair(6000);
  emtr_cloud source = pair.source_cloud();
  source.normals = pair.source_normals.data();
  const emtr::Settings settings = emtr::preset("default");
  const auto problem = emtr_test::problem_of(source, pair.target_cloud(), settings);
  const emtr::Cloud& p = problem->downsampled.source_dense;
  const auto& n = problem->source_features->normals;
  for (std::size_t i = 0; i < p.size(); ++i)
    if (n[3 * i] == n[3 * i]) {
      ASSERT_LE(p.x[i] * n[3 * i] + p.y[i] * n[3 * i + 1] + p.z[i] * n[3 * i + 2], 1e-6);
    }
  const auto result = emtr_test::solve(*problem);
  EXPECT_TRUE(result->registered);
  EXPECT_LT(KnownPair::error(result->transformation), 0.02);
}

TEST(UserInput, PointsWithoutANormalStayWithout) {
  KnownPair pair(4000);
  for (std::size_t i = 0; i < pair.target.size(); i += 3)
    if (pair.target[i] < -0.5f) std::fill_n(&pair.target_normals[i], 3, 0.0f);
  emtr_cloud source = pair.source_cloud(), target = pair.target_cloud();
  source.normals = pair.source_normals.data();
  target.normals = pair.target_normals.data();
  const auto problem = emtr_test::problem_of(source, target, emtr::preset("default"));
  const double scale = problem->pair.normalization.scale,
               center = problem->pair.normalization.center_target[0];
  std::size_t without = 0;
  for (std::size_t i = 0; i < problem->downsampled.target_dense.size(); ++i) {
    const double x = problem->downsampled.target_dense.x[i] * scale + center;
    const bool none = std::isnan(problem->target_features->normals[3 * i]);
    if (std::abs(x + 0.5) > 0.05) {
      EXPECT_EQ(none, x < -0.5) << x;
    }
    EXPECT_EQ(none, std::isnan(problem->target_features->descriptors[emtr::kFeatureSize * i]));
    without += none;
  }
  EXPECT_GT(without, 100u);
  EXPECT_LT(KnownPair::error(emtr_test::solve(*problem)->transformation), 0.02);
}

TEST(UserInput, PreprocessedCloudsGiveTheSameBits) {
  const KnownPair pair(4000);
  const auto source_codes = codes(pair.source, true, 6),
             target_codes = codes(pair.target, false, 6);
  emtr_cloud source = view(pair.source, &source_codes, 6),
             target = view(pair.target, &target_codes, 6);
  source.normals = pair.source_normals.data();
  target.normals = pair.target_normals.data();
  const auto rows = pair.correspondences(100, 2);
  for (const bool matches : {false, true}) {
    emtr::Settings settings = emtr::preset("fast");
    if (matches) settings.correspondences = rows.data();
    if (matches) settings.correspondence_count = rows.size() / 2;
    const auto plain = solve(source, target, settings);
    const auto s = std::make_shared<const emtr::PreprocessedCloud>(source, "", 1),
               t = std::make_shared<const emtr::PreprocessedCloud>(target, "", 1);
    for (const int threads : {1, 3}) {
      settings.threads = threads;
      const auto preprocessed = emtr_test::solve(*emtr_test::problem_of(s, t, settings));
      EXPECT_EQ(0, std::memcmp(plain->transformation, preprocessed->transformation,
                               sizeof plain->transformation));
    }
  }
}

TEST(UserInput, FeaturesOfOneCloudOnlyAreRefused) {
  const KnownPair pair(1000);
  const auto source = codes(pair.source, true, 4), target = codes(pair.target, false, 6);
  const auto refusal = [&](const emtr_cloud& s, const emtr_cloud& t) -> std::string {
    try {
      solve(s, t, emtr::preset("fast"));
    } catch (const emtr::Error& error) {
      EXPECT_EQ(error.status(), EMTR_ERROR_ARGUMENT);
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal(view(pair.source, &source, 4), pair.target_cloud()),
            "features are given for the source cloud only, expected for both or none");
  EXPECT_EQ(refusal(pair.source_cloud(), view(pair.target, &target, 6)),
            "features are given for the target cloud only, expected for both or none");
  EXPECT_EQ(refusal(view(pair.source, &source, 4), view(pair.target, &target, 6)),
            "features have 4 numbers in the source cloud and 6 in the target cloud, expected as "
            "many in both");
}

}  // namespace
