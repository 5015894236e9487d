#include <gtest/gtest.h>

#include <cmath>

#include "geometry/euler.h"
#include "support/clouds.h"
#include "tasks/task_beta.h"

namespace {

struct Case {
  emtr::Cloud p, q;
  std::vector<emtr::Correspondence> correspondences;
  Eigen::Matrix3d R;
};

/// Half of the correspondences follow a rotation with a little noise, half are wrong.
Case make_case(std::size_t n) {
  Case c;
  const double angles[3] = {0.7, 0.2, -1.3};
  c.R = emtr::euler_to_rotation(angles);
  c.p = emtr_test::uniform_cloud(n, 1);
  const emtr::Cloud noise = emtr_test::uniform_cloud(n, 2, 0.01f);
  const emtr::Cloud wrong = emtr_test::uniform_cloud(n, 3);
  for (std::size_t i = 0; i < n; ++i) {
    const double p[3] = {double{c.p.x[i]}, double{c.p.y[i]}, double{c.p.z[i]}};
    const auto row = [&](int a) {
      return static_cast<float>(c.R(a, 0) * p[0] + c.R(a, 1) * p[1] + c.R(a, 2) * p[2]);
    };
    if (i % 2)
      emtr_test::push(c.q, wrong.x[i], wrong.y[i], wrong.z[i]);
    else
      emtr_test::push(c.q, row(0) + noise.x[i], row(1) + noise.y[i], row(2) + noise.z[i]);
    c.correspondences.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(i)});
  }
  return c;
}

double oracle(const Case& c, const Eigen::Matrix3d& R, double tau) {
  const double threshold = 5 * tau, eta = 50 * tau;
  double sum = 0;
  for (std::size_t j = 0; j < c.p.size(); ++j)
    for (std::size_t k = j + 1; k < c.p.size(); ++k) {
      const double p[3] = {double{c.p.x[k]} - double{c.p.x[j]}, double{c.p.y[k]} - double{c.p.y[j]},
                           double{c.p.z[k]} - double{c.p.z[j]}};
      const double q[3] = {double{c.q.x[k]} - double{c.q.x[j]}, double{c.q.y[k]} - double{c.q.y[j]},
                           double{c.q.z[k]} - double{c.q.z[j]}};
      double squared = 0;
      for (int a = 0; a < 3; ++a) {
        const double d = q[a] - (R(a, 0) * p[0] + R(a, 1) * p[1] + R(a, 2) * p[2]);
        squared += d * d;
      }
      sum += std::sqrt(squared) < threshold ? std::sqrt(squared) : eta;
    }
  return sum;
}

TEST(TaskBeta, IsTheModifiedConsensus) {
  const Case c = make_case(61);
  const double tau = 0.01;
  const emtr::Settings settings = emtr::preset("paper");
  const emtr::Tims tims =
      emtr::form_tims(c.p, c.q, c.correspondences, emtr::TaskBeta::threshold(tau, settings));
  ASSERT_GT(tims.pruned, 0u);
  const emtr::TaskBeta beta(tims, tau, settings, emtr::select_kernels());
  for (int i = 0; i < 20; ++i) {
    const double angles[3] = {0.7 + 0.02 * i, 0.2, -1.3 + 0.1 * i};
    const Eigen::Matrix3d R = emtr::euler_to_rotation(angles);
    EXPECT_NEAR(beta.evaluate(R) / oracle(c, R, tau), 1, 1e-4);
  }
}

TEST(TaskBeta, PruningChangesNothing) {
  const Case c = make_case(80);
  const double tau = 0.02;
  const emtr::Settings settings = emtr::preset("paper");
  const emtr::Tims pruned =
      emtr::form_tims(c.p, c.q, c.correspondences, emtr::TaskBeta::threshold(tau, settings));
  const emtr::Tims all = emtr::form_tims(c.p, c.q, c.correspondences, 1e3);
  ASSERT_EQ(all.pruned, 0u);
  ASSERT_GT(pruned.pruned, 500u);
  const emtr::TaskBeta a(pruned, tau, settings, emtr::select_kernels()),
      b(all, tau, settings, emtr::select_kernels());
  for (int i = 0; i < 50; ++i) {
    const double angles[3] = {0.1 * i, 0.05 * i, -0.2 * i};
    const Eigen::Matrix3d R = emtr::euler_to_rotation(angles);
    EXPECT_NEAR(a.evaluate(R), b.evaluate(R), 1e-5);
  }
}

TEST(TaskBeta, PrefersTheTrueRotation) {
  const Case c = make_case(80);
  const emtr::Settings settings = emtr::preset("paper");
  const emtr::Tims tims = emtr::form_tims(c.p, c.q, c.correspondences, 0.05);
  const emtr::TaskBeta beta(tims, 0.01, settings, emtr::select_kernels());
  const double at_truth = beta.evaluate(c.R);
  for (int i = 1; i < 30; ++i) {
    const double angles[3] = {0.7 + 0.2 * i, 0.2, -1.3};
    const Eigen::Matrix3d R = emtr::euler_to_rotation(angles);
    EXPECT_LT(at_truth, beta.evaluate(R));
  }
}

TEST(TaskBeta, SaysWhenItKnowsNothing) {
  const emtr::Tims none;
  const emtr::TaskBeta beta(none, 0.01, emtr::preset("paper"), emtr::select_kernels());
  EXPECT_FALSE(beta.informative());
}

}  // namespace
