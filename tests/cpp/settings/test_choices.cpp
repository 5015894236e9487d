#include <gtest/gtest.h>

#include <string>

#include "settings/settings.h"
#include "settings/settings_table.h"

namespace {

using emtr::When;

TEST(Choices, OffIsNeverAutoWhereItHelpsAlwaysInAnyCase) {
  for (const bool helps : {false, true}) {
    EXPECT_FALSE(emtr::in_use(EMTR_OFF, helps));
    EXPECT_EQ(emtr::in_use(EMTR_AUTO, helps), helps);
    EXPECT_TRUE(emtr::in_use(EMTR_ALWAYS, helps));
  }
}

TEST(Choices, SettingsAreComparedByName) {
  EXPECT_TRUE(emtr::preset("default").fallback_search == When::Auto);
  EXPECT_TRUE(emtr::preset("thorough").fallback_search == When::Always);
  EXPECT_TRUE(emtr::preset("paper").fallback_search == When::Off);
  EXPECT_TRUE(emtr::preset("paper").neighbors == emtr::NeighborStructure::Grid);
}

TEST(Choices, EveryValueHasItsName) {
  for (const emtr::Setting& row : emtr::setting_table()) {
    if (row.info.type != EMTR_SETTING_CHOICE) {
      EXPECT_STREQ(row.info.choices, "") << row.info.name;
      continue;
    }
    std::size_t names = 1;
    for (const char c : std::string(row.info.choices)) names += c == ',';
    EXPECT_EQ(row.info.minimum, 0) << row.info.name;
    EXPECT_EQ(row.info.maximum, static_cast<double>(names - 1)) << row.info.name;
  }
}

}  // namespace
