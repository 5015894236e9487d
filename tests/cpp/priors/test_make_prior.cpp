#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "priors/make_prior.h"
#include "priors/random_priors.h"
#include "settings/validation.h"
#include "util/error.h"

namespace {

const Eigen::Vector3d kNone(0, 0, 0);

using emtr::Settings;

/// The message of the error that these settings are.
std::string refused(const std::function<void(Settings&)>& change) {
  Settings s = emtr::preset("default");
  emtr::to_matrix(emtr::Rigid(), s.guess);
  change(s);
  emtr::Normalization normalization;
  normalization.scale = 10;
  try {
    emtr::validate(s);
    emtr::make_prior(s, normalization);
  } catch (const emtr::Error& error) {
    EXPECT_EQ(error.status(), EMTR_ERROR_SETTING);
    return error.what();
  }
  return "";
}

void up(Settings& s) { s.has_axis = 1, s.axis[2] = 2; }

void box(Settings& s, double low, double high) {
  s.has_translation_bounds = 1;
  for (int i = 0; i < 3; ++i) s.translation_minimum[i] = low, s.translation_maximum[i] = high;
}

void guess(Settings& s, const Eigen::Vector3d& degrees, const Eigen::Vector3d& translation) {
  s.has_guess = 1;
  emtr::to_matrix(emtr_test::motion(degrees, translation), s.guess);
}

void expect_named(const std::string& message, const std::vector<std::string>& names) {
  EXPECT_FALSE(message.empty());
  for (const auto& name : names)
    EXPECT_NE(message.find("'" + name + "'"), std::string::npos) << message;
}

TEST(MakePrior, BadValuesAreNamed) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_named(refused([](Settings& s) { s.has_axis = 1; }), {"axis"});
  expect_named(refused([&](Settings& s) { up(s), s.axis[0] = nan; }), {"axis"});
  expect_named(refused([](Settings& s) { up(s), s.axis_tilt = 91; }), {"axis_tilt"});
  expect_named(refused([](Settings& s) { s.maximum_rotation = -1; }), {"maximum_rotation"});
  expect_named(refused([&](Settings& s) { s.maximum_rotation = nan; }), {"maximum_rotation"});
  expect_named(refused([&](Settings& s) { box(s, 0, nan); }),
               {"translation_minimum", "translation_maximum"});
  expect_named(refused([](Settings& s) { box(s, 1, 0); }),
               {"translation_minimum", "translation_maximum"});
  expect_named(refused([](Settings& s) { up(s), s.axis_angle_minimum = 190; }),
               {"axis_angle_minimum", "axis_angle_maximum"});
}

TEST(MakePrior, ALimitOfWhatIsNotThereIsNamed) {
  expect_named(refused([](Settings& s) { s.guess_rotation = 10; }), {"guess_rotation", "guess"});
  expect_named(refused([](Settings& s) { s.guess_translation = 1; }),
               {"guess_translation", "guess"});
  expect_named(refused([](Settings& s) { s.axis_tilt = 1; }), {"axis_tilt", "axis"});
  expect_named(refused([](Settings& s) { s.axis_angle_maximum = 90; }),
               {"axis_angle_maximum", "axis"});
}

TEST(MakePrior, ContradictionsAreNamed) {
  expect_named(refused([](Settings& s) {
                 guess(s, {90, 0, 0}, kNone);
                 s.guess_rotation = 20;
                 s.maximum_rotation = 60;
               }),
               {"guess_rotation", "maximum_rotation"});
  expect_named(refused([](Settings& s) {
                 guess(s, {30, 0, 0}, kNone);
                 s.guess_rotation = 20;
                 up(s);
                 s.axis_tilt = 5;
               }),
               {"guess_rotation", "axis"});
  expect_named(refused([](Settings& s) {
                 up(s);
                 s.axis_angle_minimum = 60;
                 s.maximum_rotation = 50;
               }),
               {"axis", "maximum_rotation"});
  expect_named(refused([](Settings& s) {
                 guess(s, kNone, {5, 0, 0});
                 s.guess_translation = 1;
                 box(s, -2, 2);
               }),
               {"guess_translation", "translation_minimum", "translation_maximum"});
}

TEST(MakePrior, WhatJustTouchesIsNoContradiction) {
  EXPECT_EQ(refused([](Settings& s) {
              guess(s, {90, 0, 0}, kNone);
              s.guess_rotation = 30;
              s.maximum_rotation = 60.001;
            }),
            "");
  EXPECT_EQ(refused([](Settings& s) {
              up(s);
              s.axis_angle_minimum = 50;
              s.axis_angle_maximum = 70;
              s.maximum_rotation = 50;
            }),
            "");
  EXPECT_EQ(refused([](Settings& s) { up(s), s.axis_angle_minimum = s.axis_angle_maximum = 170; }),
            "");
  EXPECT_EQ(refused([](Settings& s) { box(s, 1, 1); }), "");
}

TEST(MakePrior, ASideWithoutALimitDoesNotBlurTheOthers) {
  for (const double none : {1e9, 1e12, 1e243, 1.7e308}) {
    Settings s = emtr::preset("default");
    box(s, -none, none);
    s.translation_maximum[2] = 0.25;
    emtr::Normalization normalization;
    normalization.scale = 0.1;
    const auto prior = emtr::make_prior(s, normalization);
    const emtr::Rigid out = prior->project(emtr_test::motion(kNone, {0.5, 0, 3}));
    EXPECT_NEAR(out.t[2], 2.5, 1e-10) << none;
    EXPECT_FALSE(prior->admits(emtr_test::motion(kNone, {0.5, 0, 2.5 + 1e-9}))) << none;
  }
}

TEST(MakePrior, ABoxOutOfSightIsRefused) {
  for (const double far : {1.1e7, 1e243, 1.7e308}) {
    const std::vector<std::string> names = {"translation_minimum", "translation_maximum"};
    expect_named(refused([&](Settings& s) { box(s, far, 1.7e308); }), names);
    expect_named(refused([&](Settings& s) { box(s, -1.7e308, -far); }), names);
  }
}

TEST(MakePrior, AGuessOfFewDigitsIsARotationToAllOfThem) {
  Settings s = emtr::preset("default");
  guess(s, {20, -35, 70}, {0.1, 0.2, 0.3});
  for (int i = 0; i < 12; ++i) s.guess[i] = std::round(1e4 * s.guess[i]) / 1e4;
  ASSERT_TRUE(emtr::is_rigid(s.guess));
  const emtr::Rigid pose = emtr::normalized_guess(s, emtr::Normalization());
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k) dot += pose.R(i, k) * pose.R(j, k);
      EXPECT_NEAR(dot, i == j, 1e-14);
    }
  for (int i = 0; i < 9; ++i) EXPECT_NEAR(pose.R(i / 3, i % 3), s.guess[i / 3 * 4 + i % 3], 2e-4);
}

TEST(MakePrior, AnAxisMayHaveAnyLength) {
  for (const double length : {std::numeric_limits<double>::denorm_min(), 1e-310, 1e-200, 1.0, 1e200,
                              std::numeric_limits<double>::max()}) {
    Settings s = emtr::preset("default");
    s.has_axis = 1;
    s.axis[0] = s.axis[1] = length;
    s.axis[2] = -length;
    const auto prior = emtr::make_prior(s, emtr::Normalization());
    const Eigen::Vector3d axis = prior->rotation().axis->axis;
    EXPECT_LT((axis - Eigen::Vector3d(1, 1, -1).normalized()).norm(), 1e-15) << length;
  }
}

TEST(MakePrior, AnAngleMayCrossHalfATurn) {
  Settings s = emtr::preset("default");
  up(s);
  s.axis_angle_minimum = 170;
  s.axis_angle_maximum = 200;
  const auto prior = emtr::make_prior(s, emtr::Normalization());
  for (const double inside : {170.0, 180.0, -179.0, -160.0})
    EXPECT_TRUE(prior->admits(emtr_test::motion({0, 0, inside}, kNone))) << inside;
  for (const double outside : {169.9, -159.9, 0.0})
    EXPECT_FALSE(prior->admits(emtr_test::motion({0, 0, outside}, kNone))) << outside;
}

}  // namespace
