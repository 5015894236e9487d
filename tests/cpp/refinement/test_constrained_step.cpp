#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <algorithm>

#include "refinement/constrained_step.h"
#include "refinement/shapes.h"

namespace {

using emtr::Matrix6;
using emtr::Vector6;
using emtr_test::Draw;
using Limits = std::vector<emtr::Prior::Limit>;

Vector6 any(Draw& d) {
  Vector6 out;
  for (double& v : out) v = d.gaussian();
  return out;
}

struct Quadratic {
  Matrix6 H = Matrix6::Identity();
  Vector6 g;
  explicit Quadratic(Draw& d) : g(any(d)) {
    for (int k = 0; k < 8; ++k) {
      const Vector6 v = any(d);
      H += v * v.transpose();
    }
  }
  double at(const Vector6& x) const { return 0.5 * x.dot(H * x) + g.dot(x); }
};

emtr::Prior::Limit limit(const Vector6& J, double room, bool equality) {
  emtr::Prior::Limit out{{}, room, equality};
  Vector6::Map(out.J) = J;
  return out;
}

TEST(ConstrainedStep, WithRoomEnoughItIsTheFreeStep) {
  Draw d(1);
  const Quadratic q(d);
  const Vector6 free = -q.H.ldlt().solve(q.g);
  EXPECT_EQ(emtr::constrained_step(q.H, q.g, {}), free);
  EXPECT_EQ(emtr::constrained_step(q.H, q.g, {limit(any(d), 100, false)}), free);
}

TEST(ConstrainedStep, NoStepWithinTheLimitsIsBetter) {
  Draw d(2);
  int held = 0;
  for (int k = 0; k < 2000; ++k) {
    const Quadratic q(d);
    Limits limits;
    for (int i = 0; i < k % 3; ++i) limits.push_back(limit(any(d), 0, true));
    for (int i = 0; i < k % 11; ++i) {
      const double room = d.uniform(0, 0.3);  // drawn in an order that no compiler chooses
      limits.push_back(limit(any(d), room, false));
    }
    if (k % 5 == 0 && !limits.empty() && !limits.back().equality)
      limits.push_back(limits.back());  // said twice
    const Vector6 x = emtr::constrained_step(q.H, q.g, limits);
    for (const auto& l : limits) {
      const double along = Vector6::Map(l.J).dot(x);
      if (l.equality) {
        EXPECT_NEAR(along, 0, 1e-10);
      } else {
        EXPECT_LE(along, l.room + 1e-10);
      }
    }
    held += q.at(x) > q.at(-q.H.ldlt().solve(q.g)) + 1e-6;
    // Convex: were there a better one, there would be one on the way to any direction.
    for (int j = 0; j < 50; ++j) {
      Vector6 step = 0.1 * any(d);
      for (const auto& l : limits) {
        if (!l.equality) continue;
        Vector6 e = Vector6::Map(l.J);
        for (const auto& before : limits) {
          if (&before == &l) break;
          if (before.equality)
            e -= Vector6::Map(before.J) *
                 (Vector6::Map(before.J).dot(e) / Vector6::Map(before.J).squaredNorm());
        }
        step -= e * (e.dot(step) / e.squaredNorm());
      }
      const bool inside = std::all_of(limits.begin(), limits.end(), [&](const auto& l) {
        return l.equality || Vector6::Map(l.J).dot(x + step) <= l.room;
      });
      if (inside) {
        EXPECT_GE(q.at(x + step), q.at(x) - 1e-10);
      }
    }
  }
  EXPECT_GT(held, 1200);
}

}  // namespace
