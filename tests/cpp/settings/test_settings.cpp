#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>
#include <string>

#include "settings/settings.h"
#include "settings/validation.h"
#include "util/error.h"

namespace {

using emtr::Settings;

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const emtr::Error& error) {
    EXPECT_EQ(error.status(), EMTR_ERROR_SETTING);
    return error.what();
  }
  return "no error";
}

TEST(Settings, EveryRowStoresAndReadsBackItsOwnField) {
  std::set<std::size_t> offsets;
  for (std::size_t i = 0; i < emtr::setting_count(); ++i) {
    const emtr::Setting& row = emtr::setting(i);
    EXPECT_TRUE(offsets.insert(row.offset).second) << row.info.name;
    Settings s = emtr::preset("default");
    EXPECT_EQ(emtr::get(s, row), row.info.value) << row.info.name;
    for (const double value : {row.info.minimum, row.info.maximum}) {
      emtr::set(s, row.info.name, value);
      EXPECT_EQ(emtr::get(s, row), value) << row.info.name;
    }
    for (std::size_t k = 0; k < emtr::setting_count(); ++k) {
      const emtr::Setting& other = emtr::setting(k);
      const double expected = k == i ? row.info.maximum : other.info.value;
      EXPECT_EQ(emtr::get(s, other), expected) << other.info.name;
    }
  }
}

TEST(Settings, RefusesWhatIsOutOfRange) {
  for (std::size_t i = 0; i < emtr::setting_count(); ++i) {
    const emtr_setting_info& info = emtr::setting(i).info;
    Settings s = emtr::preset("default");
    for (const double value :
         {info.minimum - 1, info.maximum * 2 + 1, std::numeric_limits<double>::quiet_NaN(),
          std::numeric_limits<double>::infinity()})
      EXPECT_NE(message_of([&] { emtr::set(s, info.name, value); }).find(info.name),
                std::string::npos)
          << value;
    if (info.type != EMTR_SETTING_REAL) {
      EXPECT_THROW(emtr::set(s, info.name, info.minimum + 0.5), emtr::Error) << info.name;
    }
  }
}

TEST(Settings, RefusesUnknownNames) {
  Settings s = emtr::preset("default");
  EXPECT_EQ(message_of([&] { emtr::set(s, "populaton", 3); }), "there is no setting 'populaton'");
  EXPECT_NE(message_of([] { emtr::preset("quick"); }).find("quick"), std::string::npos);
}

TEST(Settings, RefusesContradictions) {
  const auto refused = [](const char* a, double x, const char* b, double y) {
    Settings s = emtr::preset("default");
    emtr::set(s, a, x);
    emtr::set(s, b, y);
    const std::string message = message_of([&] { emtr::validate(s); });
    return message.find(a) != std::string::npos && message.find(b) != std::string::npos;
  };
  EXPECT_TRUE(refused("sparse_points", 500, "dense_points", 400));
  EXPECT_TRUE(refused("normal_radius", 6, "feature_radius", 5));
  EXPECT_TRUE(refused("complement_scale_start", 0.1, "complement_scale_end", 0.2));
}

TEST(Settings, RefusesACoarseSearchByHardlyAnyPoints) {
  Settings s = emtr::preset("default");
  for (const double points : {0, 100, 20000}) {
    emtr::set(s, "coarse_points", points);
    EXPECT_NO_THROW(emtr::validate(s)) << points;
  }
  emtr::set(s, "coarse_points", 99);
  EXPECT_EQ(message_of([&] { emtr::validate(s); }),
            "setting 'coarse_points' is 99, expected 0 or from 100 on");
}

TEST(Settings, RefusesAGuessThatIsNoRigidMotion) {
  Settings s = emtr::preset("default");
  s.has_guess = 1;  // all zero
  EXPECT_NE(message_of([&] { emtr::validate(s); }).find("guess"), std::string::npos);
  for (int i = 0; i < 4; ++i) s.guess[5 * i] = 1;
  EXPECT_NO_THROW(emtr::validate(s));
}

}  // namespace
