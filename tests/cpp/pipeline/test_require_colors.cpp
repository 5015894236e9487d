// Colors that the settings insist on must be there, whichever way the clouds come in.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "pipeline/require_colors.h"
#include "settings/settings.h"
#include "util/error.h"

namespace {

using emtr::ColorKind;

/// Returns what is said of clouds with these colors; nothing where they will do.
std::string refusal(ColorKind source, ColorKind target, double use_colors = EMTR_ALWAYS) {
  emtr::Settings settings = emtr::preset("default");
  emtr::set(settings, "use_colors", use_colors);
  const std::vector<float> points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1,
                                  2, 1, 0, 0, 2, 1, 1, 0, 2, 2, 2, 1, 1, 2, 2};
  const emtr_cloud view{points.data(), points.size() / 3, 0, EMTR_FLOAT32};
  emtr::PreprocessedCloud from(view, "source", 1), to(view, "target", 1);
  from.color_kind = source;
  to.color_kind = target;
  try {
    emtr::require_colors(settings, from, to);
  } catch (const emtr::Error& error) {
    EXPECT_EQ(error.status(), EMTR_ERROR_ARGUMENT);
    return error.what();
  }
  return "";
}

TEST(RequireColors, TheCloudWithoutThemIsNamed) {
  EXPECT_EQ(refusal(ColorKind::None, ColorKind::Colors).find("source cloud: has neither"), 0u);
  EXPECT_EQ(refusal(ColorKind::Intensities, ColorKind::None).find("target cloud: has neither"), 0u);
}

TEST(RequireColors, ColorsAndIntensitiesCannotBeCompared) {
  EXPECT_EQ(refusal(ColorKind::Colors, ColorKind::Intensities).find("clouds: one has colors"), 0u);
  EXPECT_EQ(refusal(ColorKind::Colors, ColorKind::Colors), "");
  EXPECT_EQ(refusal(ColorKind::Intensities, ColorKind::Intensities), "");
}

TEST(RequireColors, OnlyWhereTheSettingsInsist) {
  EXPECT_EQ(refusal(ColorKind::None, ColorKind::None, EMTR_AUTO), "");
  EXPECT_EQ(refusal(ColorKind::None, ColorKind::Colors, EMTR_OFF), "");
}

}  // namespace
