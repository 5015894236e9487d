#include "options/scale_bounds.h"

#include "text/numbers.h"

namespace cli {

const char* const kScaleNumbers = "a factor, or the bounds of one as 0.8,1.25";

bool set_scale_bounds(emtr_settings& settings, const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto low = parse_real(text.substr(0, comma));
  const auto high = comma == std::string::npos ? low : parse_real(text.substr(comma + 1));
  if (!low || !high || *low > *high) return false;
  emtr_settings changed = settings;
  const bool fixed = *low == 1 && *high == 1;
  if (emtr_setting_set(&changed, "scale", fixed ? EMTR_SCALE_FIXED : EMTR_SCALE_BOUNDED) !=
          EMTR_OK ||
      emtr_setting_set(&changed, "scale_minimum", *low) != EMTR_OK ||
      emtr_setting_set(&changed, "scale_maximum", *high) != EMTR_OK)
    return false;
  settings = changed;
  return true;
}

}  // namespace cli
