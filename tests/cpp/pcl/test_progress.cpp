// Tests the progress callback: what it is told, and how it stops a run.
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <stdexcept>

#include "support.h"

namespace {

class Progress : public SharedPairTest {};

TEST_F(Progress, ItIsReportedAndChangesNothing) {
  reg.align(output);
  const Eigen::Matrix4f first = reg.getFinalTransformation();
  int iterations = 0;
  reg.setProgressCallback([&](const emtr_progress& progress) {
    iterations = std::max(iterations, progress.iteration);
    return false;
  });
  reg.align(output);
  EXPECT_EQ(static_cast<std::size_t>(iterations), reg.getResult()->iterations);
  EXPECT_GT(iterations, 0);
  EXPECT_TRUE(sameBits(first, reg.getFinalTransformation()));
}

TEST_F(Progress, TrueStopsTheRun) {
  reg.setProgressCallback([](const emtr_progress& progress) { return progress.iteration >= 3; });
  reg.align(output);
  EXPECT_FALSE(reg.hasConverged());
  EXPECT_EQ(reg.getErrorMessage(), "");
  ASSERT_NE(reg.getResult(), nullptr);
  EXPECT_EQ(reg.getResult()->reason, EMTR_REASON_INTERRUPTED);
  EXPECT_EQ(reg.getResult()->iterations, 3u);
  EXPECT_EQ(reg.getReasonText(), emtr_reason_text(EMTR_REASON_INTERRUPTED));
}

TEST_F(Progress, StoppedBeforeAnyPoseTheOutputStaysUnmoved) {
  reg.setProgressCallback([](const emtr_progress&) { return true; });
  reg.align(output);
  EXPECT_FALSE(reg.hasConverged());
  EXPECT_TRUE(allNaN(reg.getFinalTransformation()));
  ASSERT_EQ(output.size(), source->size());
  EXPECT_EQ(output[1].x, (*source)[1].x);
}

TEST_F(Progress, AnExceptionOfTheCallbackComesOutOfAlign) {
  reg.setProgressCallback([](const emtr_progress& progress) {
    if (progress.iteration == 3) throw std::runtime_error("enough");
    return false;
  });
  EXPECT_THROW(reg.align(output), std::runtime_error);
  EXPECT_FALSE(reg.hasConverged());
  EXPECT_TRUE(allNaN(reg.getFinalTransformation()));
  EXPECT_NE(reg.getErrorMessage(), "");
  reg.setProgressCallback({});
  reg.align(output);
  EXPECT_TRUE(reg.hasConverged());
  EXPECT_EQ(reg.getErrorMessage(), "");
}

}  // namespace
