// Tests user-provided normals, features and correspondences.
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include "known_pair.h"
#include "support.h"

namespace {

using emtr_test::KnownPair;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ, double>;
using Fpfh = pcl::PointCloud<pcl::FPFHSignature33>;

Cloud::Ptr cloudOf(const std::vector<float>& packed) {
  auto cloud = pcl::make_shared<Cloud>();
  for (std::size_t i = 0; i < packed.size(); i += 3)
    cloud->emplace_back(packed[i], packed[i + 1], packed[i + 2]);
  return cloud;
}

pcl::PointCloud<pcl::Normal>::Ptr normalsOf(const std::vector<float>& packed) {
  auto cloud = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  for (std::size_t i = 0; i < packed.size(); i += 3)
    cloud->emplace_back(packed[i], packed[i + 1], packed[i + 2]);
  return cloud;
}

/// Returns a number of a descriptor that depends on the place on the relief alone, so that both
/// clouds have the same.
float code(const std::vector<float>& packed, bool source, std::size_t point, std::size_t number) {
  const float x = source ? packed[3 * point + 2] - 4 : packed[3 * point],
              y = source ? packed[3 * point] - 4 : packed[3 * point + 1],
              phase = static_cast<float>(number);
  return std::sin((2 + phase / 3) * x + phase) * std::cos(2.5f * y - phase);
}

template <typename FeatureT, typename Set>
typename pcl::PointCloud<FeatureT>::Ptr featuresOf(const std::vector<float>& packed, bool source,
                                                   std::size_t numbers, const Set& set) {
  auto cloud = pcl::make_shared<pcl::PointCloud<FeatureT>>();
  cloud->resize(packed.size() / 3);
  for (std::size_t i = 0; i < cloud->size(); ++i)
    for (std::size_t d = 0; d < numbers; ++d) set((*cloud)[i], d, code(packed, source, i, d));
  return cloud;
}

Fpfh::Ptr fpfhOf(const std::vector<float>& packed, bool source) {
  return featuresOf<pcl::FPFHSignature33>(
      packed, source, 33, [](auto& to, std::size_t d, float v) { to.histogram[d] = v; });
}

pcl::CorrespondencesPtr correspondencesOf(const std::vector<std::int32_t>& rows) {
  auto out = pcl::make_shared<pcl::Correspondences>();
  for (std::size_t i = 0; i < rows.size(); i += 2) out->emplace_back(rows[i], rows[i + 1], 0.5f);
  return out;
}

class UserInput : public testing::Test {
 protected:
  void SetUp() override {
    reg.setPreset("fast");
    reg.setNumberOfThreads(2);
    reg.setInputSource(source);
    reg.setInputTarget(target);
  }

  Eigen::Matrix4d align() {
    Cloud output;
    reg.align(output);
    return reg.getFinalTransformation();
  }

  double error() {
    const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> T = align();
    return KnownPair::error(T.data());
  }

  /// Returns the pose that the C API gives for the same input.
  Eigen::Matrix4d byC(emtr_cloud from, emtr_cloud to, const std::vector<std::int32_t>& rows = {}) {
    emtr_settings settings = reg.getSettings();
    if (!rows.empty()) settings.correspondences = rows.data();
    settings.correspondence_count = rows.size() / 2;
    emtr_result* result = nullptr;
    EXPECT_EQ(emtr_register(&from, &to, &settings, nullptr, nullptr, &result), EMTR_OK)
        << emtr_error_message();
    if (!result) return Eigen::Matrix4d::Zero();
    const Eigen::Matrix4d T =
        Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(result->transformation);
    emtr_result_free(result);
    return T;
  }

  const KnownPair pair{4000};
  Cloud::Ptr source = cloudOf(pair.source), target = cloudOf(pair.target);
  Registration reg;
};

TEST_F(UserInput, FeaturesOfEachKindRegister) {
  reg.setSourceFeatures(fpfhOf(pair.source, true));
  reg.setTargetFeatures(Fpfh::ConstPtr(fpfhOf(pair.target, false)));
  EXPECT_LT(error(), 0.02) << reg.getErrorMessage();
  EXPECT_GT(reg.getResult()->correspondences, 900u);

  const auto shot = [&](const std::vector<float>& packed, bool side) {
    return featuresOf<pcl::SHOT352>(packed, side, 352,
                                    [](auto& to, std::size_t d, float v) { to.descriptor[d] = v; });
  };
  reg.setSourceFeatures(shot(pair.source, true));
  reg.setTargetFeatures(shot(pair.target, false));
  EXPECT_LT(error(), 0.02) << reg.getErrorMessage();

  const auto learned = [&](const std::vector<float>& packed, bool side) {
    return featuresOf<pcl::Histogram<16>>(
        packed, side, 16, [](auto& to, std::size_t d, float v) { to.histogram[d] = v; });
  };
  reg.setSourceFeatures(learned(pair.source, true));
  reg.setTargetFeatures(learned(pair.target, false));
  const Eigen::Matrix4d found = align();
  std::vector<float> codes[2];
  for (const bool side : {true, false}) {
    const auto& packed = side ? pair.source : pair.target;
    for (std::size_t i = 0; i < packed.size() / 3; ++i)
      for (std::size_t d = 0; d < 16; ++d) codes[side].push_back(code(packed, side, i, d));
  }
  emtr_cloud from = pair.source_cloud(), to = pair.target_cloud();
  from.features = codes[1].data();
  to.features = codes[0].data();
  from.feature_dimension = to.feature_dimension = 16;
  EXPECT_TRUE(sameBits(found, byC(from, to)));
}

TEST_F(UserInput, ARepresentationScalesAndChooses) {
  pcl::CustomPointRepresentation<pcl::FPFHSignature33> first(4);
  const float scales[] = {1, 0.5f, 2, 3};
  first.setRescaleValues(scales);
  auto from = fpfhOf(pair.source, true);
  (*from)[7].histogram[2] = kNaN;  // invalid: no descriptor
  reg.setSourceFeatures(from, first);
  reg.setTargetFeatures(fpfhOf(pair.target, false), first);
  const Eigen::Matrix4d found = align();
  std::vector<float> codes[2];
  for (const bool side : {true, false}) {
    const auto& packed = side ? pair.source : pair.target;
    for (std::size_t i = 0; i < packed.size() / 3; ++i)
      for (std::size_t d = 0; d < 4; ++d)
        codes[side].push_back(side && i == 7 ? kNaN : code(packed, side, i, d) * scales[d]);
  }
  emtr_cloud a = pair.source_cloud(), b = pair.target_cloud();
  a.features = codes[1].data();
  b.features = codes[0].data();
  a.feature_dimension = b.feature_dimension = 4;
  EXPECT_TRUE(sameBits(found, byC(a, b)));
}

struct Unknown {
  float values[9];
};

TEST_F(UserInput, ATypeThatPclCannotReadIsRefused) {
  reg.setSourceFeatures(fpfhOf(pair.source, true));
  reg.setSourceFeatures(pcl::make_shared<pcl::PointCloud<Unknown>>());  // none are left
  const Eigen::Matrix4d plain = align();
  EXPECT_TRUE(sameBits(plain, byC(pair.source_cloud(), pair.target_cloud())));
}

TEST_F(UserInput, NormalsGiveThePoseOfTheCApi) {
  reg.setSourceNormals(normalsOf(pair.source_normals));
  const Eigen::Matrix4d one = align();
  reg.setTargetNormals(normalsOf(pair.target_normals));
  const Eigen::Matrix4d both = align();
  emtr_cloud from = pair.source_cloud(), to = pair.target_cloud();
  from.normals = pair.source_normals.data();
  EXPECT_TRUE(sameBits(one, byC(from, to)));
  to.normals = pair.target_normals.data();
  EXPECT_TRUE(sameBits(both, byC(from, to)));
  EXPECT_FALSE(sameBits(one, both));
  reg.setSourceNormals(nullptr);
  reg.clearTargetNormals();
  EXPECT_TRUE(sameBits(align(), byC(pair.source_cloud(), pair.target_cloud())));
}

TEST_F(UserInput, CorrespondencesMayMostlyBeWrong) {
  const auto rows = pair.correspondences(400, 5);
  reg.setCorrespondences(correspondencesOf(rows));
  const Eigen::Matrix4d found = align();
  EXPECT_TRUE(reg.hasConverged());
  EXPECT_LT(error(), 0.02);
  EXPECT_EQ(reg.getResult()->correspondences, 400u);
  EXPECT_TRUE(sameBits(found, byC(pair.source_cloud(), pair.target_cloud(), rows)));
  EXPECT_EQ(reg.getSettings().correspondences, nullptr);
  reg.clearCorrespondences();
  EXPECT_TRUE(sameBits(align(), byC(pair.source_cloud(), pair.target_cloud())));
}

TEST_F(UserInput, CorrespondencesInSettingsAreIgnored) {
  const auto rows = pair.correspondences(400, 5);
  emtr_settings settings = reg.getSettings();
  settings.correspondences = rows.data();
  settings.correspondence_count = 400;
  reg.setSettings(settings);
  EXPECT_EQ(reg.getSettings().correspondences, nullptr);
}

TEST_F(UserInput, WithIndicesTheyAreThoseOfTheWholeCloud) {
  auto indices = pcl::make_shared<pcl::Indices>(source->size());
  std::iota(indices->begin(), indices->end(), 0);
  std::reverse(indices->begin(), indices->end());
  indices->resize(source->size() - source->size() / 4);
  KnownPair part = pair;
  part.source.clear();
  part.source_normals.clear();
  const auto features = fpfhOf(pair.source, true), to_features = fpfhOf(pair.target, false);
  std::vector<float> codes[2];
  for (const auto index : *indices) {
    const auto i = static_cast<std::ptrdiff_t>(index);
    part.source.insert(part.source.end(), &pair.source[3 * static_cast<std::size_t>(i)],
                       &pair.source[3 * static_cast<std::size_t>(i)] + 3);
    const auto& histogram = (*features)[static_cast<std::size_t>(i)].histogram;
    codes[0].insert(codes[0].end(), histogram, histogram + 33);
  }
  for (const auto& feature : *to_features)
    codes[1].insert(codes[1].end(), feature.histogram, feature.histogram + 33);

  reg.setSourceFeatures(features);
  reg.setTargetFeatures(to_features);
  const Eigen::Matrix4d whole = align();
  reg.setIndices(indices);
  emtr_cloud from = part.source_cloud(), to = part.target_cloud();
  from.features = codes[0].data();
  to.features = codes[1].data();
  from.feature_dimension = to.feature_dimension = 33;
  EXPECT_TRUE(sameBits(align(), byC(from, to)));

  const auto rows = pair.correspondences(400, 2);
  std::vector<std::int32_t> left;
  for (std::size_t k = 0; k < rows.size(); k += 2) {
    const auto place = std::find(indices->begin(), indices->end(), rows[k]);
    if (place != indices->end())
      left.insert(left.end(), {static_cast<std::int32_t>(place - indices->begin()), rows[k + 1]});
  }
  ASSERT_LT(left.size(), rows.size());
  reg.setCorrespondences(correspondencesOf(rows));
  EXPECT_TRUE(sameBits(align(), byC(part.source_cloud(), part.target_cloud(), left)));
  EXPECT_EQ(reg.getResult()->correspondences, left.size() / 2);
  reg.clearCorrespondences();
  reg.setIndices(pcl::IndicesPtr());
  reg.setInputSource(source);
  EXPECT_TRUE(sameBits(align(), whole));
}

TEST_F(UserInput, InputThatDoesNotFitIsReported) {
  const auto message = [&] {
    align();
    EXPECT_FALSE(reg.hasConverged());
    EXPECT_TRUE(allNaN(reg.getFinalTransformation()));
    return reg.getErrorMessage();
  };
  const std::string points = std::to_string(source->size());
  auto features = fpfhOf(pair.source, true);
  features->resize(10);
  reg.setSourceFeatures(features);
  EXPECT_EQ(message(),
            "source cloud: 10 features, expected one for each of its " + points + " points");
  reg.setSourceFeatures(fpfhOf(pair.source, true));
  EXPECT_EQ(message(), "features are given for the source cloud only, expected for both or none");
  reg.clearSourceFeatures();
  reg.setTargetNormals(pcl::make_shared<pcl::PointCloud<pcl::Normal>>());
  EXPECT_EQ(message().find("target cloud: 0 normals, expected one for each"), 0u);
  reg.clearTargetNormals();
  reg.setCorrespondences(correspondencesOf({0, 0, 1, 1}));
  EXPECT_EQ(message(), "correspondences: 2 different ones, expected at least 3");
  reg.setCorrespondences(correspondencesOf({0, 0, 1, -1, 2, 2}));
  EXPECT_EQ(message().find("correspondences: row 1: target point -1, expected 0 to"), 0u);
  reg.setCorrespondences(correspondencesOf({}));
  EXPECT_EQ(message(), "correspondences: 0 different ones, expected at least 3");
  reg.clearCorrespondences();
  EXPECT_LT(error(), 0.02);
}

}  // namespace
