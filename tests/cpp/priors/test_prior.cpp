#include <gtest/gtest.h>

#include "geometry/small_motion.h"
#include "priors/prior.h"
#include "priors/random_priors.h"

namespace {

const Eigen::Vector3d kNone(0, 0, 0);

using namespace emtr_test;
using Eigen::Vector3d;
using emtr::Prior;
using emtr::PriorPtr;
using emtr::Rigid;

struct Case {
  emtr::Normalization normalization;
  Rigid inside;
  emtr::Settings settings;
  PriorPtr prior;

  Case(Draw& d, int which, double lever)
      : normalization(any_frame(d, lever)),
        inside(any_pose(d)),
        settings(limits_around(inside, normalization, which, d)),
        prior(emtr::make_prior(settings, normalization)) {}
};

double angle_between(const Rigid& a, const Rigid& b) { return emtr::rotation_distance(a.R, b.R); }

/// Expects a pose to satisfy the settings, computed anew from the user's matrix.
void expect_satisfied(const emtr::Settings& s, const emtr::Normalization& normalization,
                      const Rigid& pose) {
  constexpr double degree = M_PI / 180, tiny = 1e-8;
  const Rigid user = normalization.to_user(pose);
  const Eigen::Matrix3d R = user.R;
  EXPECT_NEAR((R * R.transpose() - Eigen::Matrix3d::Identity()).norm(), 0, 1e-12);
  if (s.has_guess) {
    const Rigid guess = emtr::from_matrix(s.guess);
    EXPECT_LE(angle_between(user, guess), s.guess_rotation * degree + tiny);
    const Vector3d c = Vector3d::Map(normalization.center_source);
    const Vector3d at = R * c + user.t;
    const Vector3d wanted = guess.R * c + guess.t;
    EXPECT_LE((at - wanted).norm(), s.guess_translation + tiny * normalization.scale);
  }
  if (s.has_axis) {
    const Vector3d a = Vector3d::Map(s.axis).normalized();
    EXPECT_LE(std::atan2(a.cross(R * a).norm(), a.dot(R * a)), s.axis_tilt * degree + tiny);
    const emtr::SwingTwist parts(Eigen::Quaterniond(R), a);
    const double middle = (s.axis_angle_minimum + s.axis_angle_maximum) / 2 * degree,
                 half = (s.axis_angle_maximum - s.axis_angle_minimum) / 2 * degree;
    EXPECT_LE(std::abs(std::remainder(parts.angle - middle, 2 * M_PI)), half + tiny);
  }
  if (s.has_translation_bounds) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(user.t[i], s.translation_minimum[i] - tiny * normalization.scale);
      EXPECT_LE(user.t[i], s.translation_maximum[i] + tiny * normalization.scale);
    }
  }
  EXPECT_LE(angle_between(user, Rigid()), s.maximum_rotation * degree + tiny);
}

TEST(Prior, AllPosesAreAdmissibleByDefault) {
  EXPECT_EQ(emtr::make_prior(emtr::preset("default"), emtr::Normalization()), nullptr);
  emtr::Settings hypothesis = emtr::preset("default");
  hypothesis.has_guess = 1;
  emtr::to_matrix(Rigid(), hypothesis.guess);
  EXPECT_EQ(emtr::make_prior(hypothesis, emtr::Normalization()), nullptr);
}

TEST(Prior, WhatItProjectsIsAdmissibleAndStays) {
  Draw d(1);
  for (int which = 1; which < kAll; ++which)
    for (int k = 0; k < 40; ++k) {
      const Case c(d, which, k % 2 ? 2 : 0);
      ASSERT_TRUE(c.prior) << which;
      EXPECT_TRUE(c.prior->admits(c.inside)) << which;
      for (int j = 0; j < 5; ++j) {
        const Rigid pose = any_pose(d, 2), found = c.prior->project(pose),
                    again = c.prior->project(found);
        EXPECT_TRUE(c.prior->admits(found)) << which;
        expect_satisfied(c.settings, c.normalization, found);
        EXPECT_TRUE(found.R == again.R && found.t == again.t);
      }
      if (HasFailure()) FAIL() << "limits " << which << ", case " << k;
    }
}

/// First the rotation, then the translation, as the class says.
TEST(Prior, NoAdmissiblePoseIsNearerThanThatOfASingleLimit) {
  Draw d(2);
  for (const int which : std::initializer_list<int>{kGuessRotation, kGuessTranslation, kAxis,
                                                    kBounds, kLargest, kGuessTranslation + kBounds})
    for (int k = 0; k < 30; ++k) {
      const Case c(d, which, which & kBounds && which & kGuessTranslation ? 0 : 1);
      const Rigid pose = any_pose(d, 2), found = c.prior->project(pose);
      for (int j = 0; j < 300; ++j) {
        // Near what was found, where a nearer one would be.
        const double reach = std::pow(10, d.uniform(-5, 0));
        double x[6];
        for (double& v : x) v = reach * d.gaussian();
        Rigid other = emtr::moved(found, x);
        if (which & (kGuessTranslation | kBounds)) other.R = found.R;
        other = c.prior->project(other);
        EXPECT_GE(angle_between(other, pose), angle_between(found, pose) - 1e-9) << which;
        if (which & (kGuessTranslation | kBounds)) {
          EXPECT_GE(translation_between(other, pose), translation_between(found, pose) - 1e-9)
              << which;
        }
      }
    }
}

TEST(Prior, ATurnAboutAnUprightAxisNearAGuessIsTheNearestThereIs) {
  Draw d(3);
  for (int k = 0; k < 100; ++k) {
    Case c(d, kAxis + kGuessRotation, 1);
    if (c.settings.axis_tilt > 0) continue;
    const Vector3d axis = Vector3d::Map(c.settings.axis).normalized();
    const Rigid pose = any_pose(d), found = c.prior->project(pose);
    double nearest = HUGE_VAL;
    for (int degree = 0; degree < 3600; ++degree) {
      Rigid rotated;
      rotated.R = Eigen::AngleAxisd(degree * M_PI / 1800, axis).toRotationMatrix();
      if (c.prior->admits(rotated)) nearest = std::min(nearest, angle_between(rotated, pose));
    }
    EXPECT_LE(angle_between(found, pose), nearest + 1e-9);
  }
}

TEST(Prior, ItsLimitsAreThoseOfSmallMotions) {
  Draw d(4);
  int reached = 0;
  for (int which = 1; which < kAll; ++which)
    for (int k = 0; k < 20; ++k) {
      const Case c(d, which, k % 2 ? 2 : 0);
      const Rigid pose = c.prior->project(any_pose(d, 2));  // mostly on a border
      const auto limits = c.prior->limits(pose);
      for (int j = 0; j < 20; ++j) {
        Eigen::Matrix<double, 6, 1> x;
        for (double& v : x) v = 1e-4 * d.gaussian();
        bool free = true, over = false;
        for (const Prior::Limit& limit : limits) {
          const double along = Eigen::Matrix<double, 6, 1>::Map(limit.J).dot(x);
          free &= limit.equality ? false : along < limit.room - 1e-6;
          over |= limit.equality ? std::abs(along) > 1e-6 : along > limit.room + 1e-6;
          EXPECT_GE(limit.room, -1e-9);
        }
        const bool admitted = c.prior->admits(emtr::moved(pose, x.data()));
        if (free) {
          EXPECT_TRUE(admitted) << which;
        }
        if (over) {
          EXPECT_FALSE(admitted) << which;
        }
        reached += over;
      }
      if (HasFailure()) FAIL() << "limits " << which << ", case " << k;
    }
  EXPECT_GT(reached, 1000);
}

TEST(Prior, SeedsThatAreFarOutAreDropped) {
  emtr::Settings s = emtr::preset("default");
  s.has_axis = 1;
  s.axis[2] = 1;
  const PriorPtr prior = emtr::make_prior(s, emtr::Normalization());
  const std::vector<Rigid> seeds = {motion({0, 0, 150}, {0.4, 0, 0}), motion({12, 0, 0}, kNone),
                                    motion({60, 0, 0}, kNone)};
  EXPECT_EQ(emtr::admissible(seeds, nullptr).size(), 3u);
  const auto kept = emtr::admissible(seeds, prior.get());
  ASSERT_EQ(kept.size(), 2u);
  EXPECT_LT(angle_between(kept[0], seeds[0]), 1e-9);
  EXPECT_LT(angle_between(kept[1], Rigid()), 1e-9);
}

}  // namespace
