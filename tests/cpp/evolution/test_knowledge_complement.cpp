#include <gtest/gtest.h>

#include <cmath>

#include "evolution/knowledge_complement.h"
#include "geometry/euler.h"
#include "support/clouds.h"

namespace {

/// A bumpy ball, so that every translation is constrained.
emtr::Cloud ball(float offset_x, float offset_y, float offset_z) {
  emtr::Cloud cloud;
  for (int i = 0; i < 600; ++i) {
    const double a = i * 2.399963, z = 2 * (i + 0.5) / 600 - 1, r = std::sqrt(1 - z * z);
    const double u[3] = {r * std::cos(a), r * std::sin(a), z};
    const double radius = 0.7 + 0.15 * std::sin(5 * u[0]) * std::cos(4 * u[1] + u[2]);
    emtr_test::push(cloud, static_cast<float>(radius * u[0]) + offset_x,
                    static_cast<float>(radius * u[1]) + offset_y,
                    static_cast<float>(radius * u[2]) + offset_z);
  }
  return cloud;
}

struct Fixture {
  emtr::Settings settings = emtr::preset("paper");
  const emtr::Kernels& kernels = emtr::select_kernels();
  emtr::Cloud source, target;
  emtr::KnowledgeComplement complement() {
    const auto radius = static_cast<float>(settings.complement_scale_start);
    return {source, target, emtr::make_candidate_grid(target, radius, 0.1f, kernels), settings,
            kernels};
  }
};

TEST(KnowledgeComplement, FindsTheTranslationOfTheTrueRotation) {
  Fixture f;
  f.source = ball(0, 0, 0);
  f.target = ball(0.12f, -0.08f, 0.1f);
  const Eigen::Vector3d t = f.complement().translation(Eigen::Matrix3d::Identity(), nullptr);
  EXPECT_NEAR(t[0], 0.12, 0.005);
  EXPECT_NEAR(t[1], -0.08, 0.005);
  EXPECT_NEAR(t[2], 0.1, 0.005);
}

TEST(KnowledgeComplement, StaysWhenNothingIsNear) {
  Fixture f;
  f.source = ball(0, 0, 0);
  f.target = ball(50, 0, 0);
  EXPECT_EQ(f.complement().translation(Eigen::Matrix3d::Identity(), nullptr),
            Eigen::Vector3d(0, 0, 0));
}

TEST(KnowledgeComplement, CountsItsQueries) {
  Fixture f;
  f.source = ball(0, 0, 0);
  f.target = f.source;
  f.settings.complement_iterations = 7;
  EXPECT_EQ(f.complement().queries(), 7u * 600);
}

}  // namespace
