#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "kernels/kernels.h"
#include "support/clouds.h"
#include "tasks/m_estimator.h"
#include "util/error.h"

namespace {

using emtr::Cloud;
using emtr::Kernels;
using emtr_test::kernels_here;
using emtr_test::uniform_cloud;

constexpr float kR[9] = {0.36f, 0.48f, -0.8f, -0.8f, 0.6f, 0, 0.48f, 0.64f, 0.6f};
constexpr float kT[3] = {0.5f, -0.25f, 0.125f};

/// Sets the variable EMTR_KERNEL for as long as it lives.
class Asked {
 public:
  explicit Asked(const char* name) { setenv("EMTR_KERNEL", name, 1); }
  ~Asked() { unsetenv("EMTR_KERNEL"); }
};

TEST(Kernels, TransformIsTheSameBitsInEach) {
  for (const std::size_t n : {1u, 7u, 8u, 9u, 100u}) {
    const Cloud p = uniform_cloud(n, 1);
    Cloud expected;
    expected.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
      expected.x[i] = ((kR[0] * p.x[i] + kR[1] * p.y[i]) + kR[2] * p.z[i]) + kT[0];
      expected.y[i] = ((kR[3] * p.x[i] + kR[4] * p.y[i]) + kR[5] * p.z[i]) + kT[1];
      expected.z[i] = ((kR[6] * p.x[i] + kR[7] * p.y[i]) + kR[8] * p.z[i]) + kT[2];
    }
    for (const Kernels* k : kernels_here()) {
      Cloud out;
      out.resize(n);
      k->transform(p.view(), kR, kT, out.x.data(), out.y.data(), out.z.data());
      EXPECT_EQ(out.x, expected.x) << k->name;
      EXPECT_EQ(out.y, expected.y) << k->name;
      EXPECT_EQ(out.z, expected.z) << k->name;
    }
  }
}

TEST(Kernels, RhoSumIsEveryTermAndTheSameBitsInEach) {
  for (std::size_t n = 0; n < 60; ++n) {
    std::vector<float> squared;
    double expected = 0;
    for (std::size_t i = 0; i < n; ++i) {
      squared.push_back(static_cast<float>(i) / 60);
      expected += static_cast<double>(emtr::rho(squared.back(), 1));
    }
    const double first = emtr::kernels_at(0)->rho_sum(squared.data(), n, 1);
    EXPECT_NEAR(first, expected, 1e-12);
    for (const Kernels* k : kernels_here())
      EXPECT_EQ(k->rho_sum(squared.data(), n, 1), first) << k->name;
  }
}

TEST(Kernels, ConsensusCountsTheInliersOfAllPairsAndIsTheSameBitsInEach) {
  for (const std::size_t n : {0u, 1u, 2u, 15u, 16u, 17u, 33u, 200u})
    for (const float size : {1.0f, 8.0f}) {  // blocks that touch, and blocks that lie apart
      const Cloud p = uniform_cloud(n, 3, size), q = uniform_cloud(n, 4, size);
      const float threshold = 0.8f;
      double inliers = 0, residuals = 0;
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t k = j + 1; k < n; ++k) {
          double squared = 0;
          for (int a = 0; a < 3; ++a) {
            const auto end = [&](std::size_t i) {
              const double to[3] = {double{q.x[i]}, double{q.y[i]}, double{q.z[i]}};
              return double{kR[3 * a]} * double{p.x[i]} + double{kR[3 * a + 1]} * double{p.y[i]} +
                     double{kR[3 * a + 2]} * double{p.z[i]} - to[a];
            };
            squared += (end(k) - end(j)) * (end(k) - end(j));
          }
          if (std::sqrt(squared) >= double{threshold}) continue;
          inliers += 1;
          residuals += std::sqrt(squared);
        }
      if (n == 200) {
        ASSERT_GT(inliers, size > 1 ? 2 : 500);
      }
      const auto ask = [&](const Kernels& kernels) {
        std::vector<float> room(emtr::consensus_room(n), 7.0f);
        return kernels.consensus(p.view(), q.view(), kR, threshold * threshold, room.data());
      };
      const auto first = ask(*emtr::kernels_at(0));
      EXPECT_EQ(first.inliers, inliers) << n;
      EXPECT_NEAR(first.residuals, residuals, 1e-6 * residuals + 1e-6) << n;
      for (const Kernels* k : kernels_here()) {
        const auto found = ask(*k);
        EXPECT_EQ(found.inliers, first.inliers) << k->name;
        EXPECT_EQ(found.residuals, first.residuals) << k->name;
      }
    }
}

TEST(Kernels, CanBeChosenByName) {
  for (const Kernels* k : kernels_here()) {
    const Asked asked(k->name);
    EXPECT_EQ(&emtr::select_kernels(), k);
    EXPECT_STREQ(emtr_kernel_name(), k->name);
  }
  const Asked asked("");
  EXPECT_EQ(&emtr::select_kernels(), kernels_here().back());
}

TEST(Kernels, AnUnknownNameIsAnError) {
  const Asked asked("sse9");
  EXPECT_EQ(emtr_kernel_name(), nullptr);
  EXPECT_NE(std::string(emtr_error_message()).find("'sse9'"), std::string::npos);
  EXPECT_NE(std::string(emtr_error_message()).find("generic"), std::string::npos);
  const emtr_test::Pair pair(1, 1000);
  const emtr_cloud source = pair.source(), target = pair.target();
  emtr_result* result = nullptr;
  EXPECT_EQ(emtr_register(&source, &target, nullptr, nullptr, nullptr, &result),
            EMTR_ERROR_SETTING);
}

TEST(Kernels, ARegistrationIsTheSameBitsInEach) {
  const emtr_test::Pair pair(2, 5000);
  const emtr_cloud source = pair.source(), target = pair.target();
  std::vector<std::vector<double>> answers;
  for (const Kernels* k : kernels_here()) {
    const Asked asked(k->name);
    emtr_result* result = nullptr;
    ASSERT_EQ(emtr_register(&source, &target, nullptr, nullptr, nullptr, &result), EMTR_OK);
    EXPECT_STREQ(result->kernel, k->name);
    std::vector<double> answer(result->transformation, result->transformation + 16);
    answer.insert(answer.end(), result->history_alpha, result->history_alpha + result->iterations);
    answer.insert(answer.end(), result->history_beta, result->history_beta + result->iterations);
    answer.push_back(static_cast<double>(result->queries_evaluation));
    answers.push_back(answer);
    emtr_result_free(result);
  }
  for (const auto& answer : answers) EXPECT_EQ(answer, answers.front());
}

}  // namespace
