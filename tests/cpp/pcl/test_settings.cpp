// Tests own and inherited settings: which act, which do not, and how they are refused.
#include <pcl/registration/emtr_ssc.h>

#include "support.h"

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/// Gives access to a protected member of the base class.
struct Registration : pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ> {
  int iterationsDone() const { return nr_iterations_; }
};

/// Counts how often it is called.
struct Rejector : pcl::registration::CorrespondenceRejector {
  void getRemainingCorrespondences(const pcl::Correspondences&, pcl::Correspondences&) override {
    ++calls;
  }
  void applyRejection(pcl::Correspondences&) override { ++calls; }
  int calls = 0;
};

class Settings : public testing::Test {
 protected:
  void SetUp() override {
    reg.setNumberOfThreads(2);
    reg.setInputSource(source);
    reg.setInputTarget(target);
  }

  Eigen::Matrix4f align(const Eigen::Matrix4f& guess = Eigen::Matrix4f::Identity()) {
    reg.align(output, guess);
    return reg.getFinalTransformation();
  }

  Cloud::Ptr source = sharedPair().source();
  Cloud::Ptr target = sharedPair().target();
  Cloud output;
  Registration reg;
};

TEST_F(Settings, TheSameBitsEveryTimeAndForEveryNumberOfThreads) {
  const Eigen::Matrix4f first = align();
  EXPECT_TRUE(sameBits(first, align()));
  for (unsigned int threads : {1u, 4u, 8u}) {
    reg.setNumberOfThreads(threads);
    EXPECT_TRUE(sameBits(first, align())) << threads << " threads";
  }
}

TEST_F(Settings, AnotherSeedTakesAnotherWay) {
  // By the swarm alone: the refinement would bring any seed to the same pose.
  ASSERT_TRUE(reg.setPreset("paper"));
  EXPECT_EQ(reg.getSeed(), 0u);
  const Eigen::Matrix4f first = align();
  reg.setSeed(std::numeric_limits<std::uint64_t>::max());
  const Eigen::Matrix4f second = align();
  EXPECT_EQ(reg.getResult()->seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_FALSE(sameBits(first, second));
  EXPECT_LT(sharedPair().error(second), kRight);
}

TEST_F(Settings, MaximumIterationsIsTheNumberOfGenerations) {
  EXPECT_EQ(reg.getMaximumIterations(), 25);
  align();
  EXPECT_EQ(reg.iterationsDone(), 5);  // the best pose stays in one place
  ASSERT_TRUE(reg.setSetting("stall_iterations", 0));
  align();
  EXPECT_EQ(reg.iterationsDone(), 25);
  ASSERT_TRUE(reg.setPreset("paper"));
  align();
  EXPECT_EQ(reg.iterationsDone(), 100);
  reg.setMaximumIterations(7);
  align();
  EXPECT_EQ(reg.iterationsDone(), 7);
  EXPECT_EQ(reg.getResult()->iterations, 7u);
  reg.setInputSource(source);
  EXPECT_EQ(reg.iterationsDone(), 0);
}

TEST_F(Settings, IterationsHaveOneValueByEveryName) {
  ASSERT_TRUE(reg.setSetting("iterations", 30));
  EXPECT_EQ(reg.getMaximumIterations(), 30);
  reg.setMaximumIterations(40);
  double value = 0;
  ASSERT_TRUE(reg.getSetting("iterations", value));
  EXPECT_EQ(value, 40);
  emtr_settings settings = reg.getSettings();
  EXPECT_EQ(settings.iterations, 40);
  settings.iterations = 50;
  settings.population = 20;
  reg.setSettings(settings);
  EXPECT_EQ(reg.getMaximumIterations(), 50);
  EXPECT_EQ(reg.getSettings().population, 20);
  ASSERT_TRUE(reg.setPreset("paper"));
  EXPECT_EQ(reg.getMaximumIterations(), 100);
  EXPECT_EQ(reg.getSettings().population, 50);
}

TEST_F(Settings, AWrongNameOrValueIsRefusedAndChangesNothing) {
  double value = 3;
  EXPECT_FALSE(reg.setSetting("polulation", 20));
  EXPECT_FALSE(reg.setSetting("population", -1));
  EXPECT_FALSE(reg.getSetting("polulation", value));
  EXPECT_EQ(value, 3);
  reg.setSeed(5);
  EXPECT_FALSE(reg.setPreset("papier"));
  EXPECT_EQ(reg.getSeed(), 5u);
  EXPECT_EQ(reg.getSettings().population, 50);
}

TEST_F(Settings, AGuessIsOneHypothesis) {
  // The run is too short to find the pose by itself, and has no seeds.
  ASSERT_TRUE(reg.setPreset("paper"));
  reg.setMaximumIterations(2);
  ASSERT_TRUE(reg.setSetting("transfer", 0));
  EXPECT_GT(sharedPair().error(align()), kRight);
  const Eigen::Matrix4f pose = sharedPair().pose().cast<float>();
  // The transformation maps the original source, with the guess included; so does the output.
  EXPECT_LT(sharedPair().error(align(pose)), kRight);
  const pcl::PointXYZ& p = (*source)[0];
  const Eigen::Vector4f moved = pose * Eigen::Vector4f(p.x, p.y, p.z, 1);
  EXPECT_LT((Eigen::Vector3f(output[0].x, output[0].y, output[0].z) - moved.head<3>()).norm(),
            4 * kRight);
}

TEST_F(Settings, ConfidenceIsOfTheLastAlign) {
  EXPECT_TRUE(std::isnan(reg.getConfidence()));
  align();
  EXPECT_GT(reg.getConfidence(), 0.9);
  EXPECT_EQ(reg.getConfidence(), reg.getResult()->confidence);
  reg.setInputSource(source);
  EXPECT_TRUE(std::isnan(reg.getConfidence()));
  ASSERT_TRUE(reg.setPreset("paper"));  // has no candidates to compare with
  align();
  EXPECT_TRUE(reg.hasConverged());
  EXPECT_TRUE(std::isnan(reg.getConfidence()));
}

TEST_F(Settings, AWrongGuessDoesNoHarm) {
  Eigen::Matrix4f guess = Eigen::Matrix4f::Identity();
  guess(0, 3) = 0.5f;
  const Eigen::Matrix4f pose = align(guess);
  EXPECT_TRUE(reg.hasConverged()) << reg.getReasonText();
  EXPECT_LT(sharedPair().error(pose), kRight);
}

TEST_F(Settings, WhatIsSaidNotToActDoesNotAct) {
  const Eigen::Matrix4f first = align();
  reg.setMaxCorrespondenceDistance(1e-3);
  reg.setTransformationEpsilon(1.0);
  reg.setTransformationRotationEpsilon(0.5);
  reg.setEuclideanFitnessEpsilon(100.0);
  reg.setRANSACIterations(50);
  reg.setRANSACOutlierRejectionThreshold(1e-3);
  const auto rejector = pcl::make_shared<Rejector>();
  reg.addCorrespondenceRejector(rejector);
  EXPECT_TRUE(sameBits(first, align()));
  EXPECT_EQ(rejector->calls, 0);
}

}  // namespace
