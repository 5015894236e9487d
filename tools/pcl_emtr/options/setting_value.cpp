#include "options/setting_value.h"

#include <algorithm>
#include <optional>

#include "failure.h"
#include "options/scale_bounds.h"
#include "options/setting_text.h"
#include "options/suggestion.h"
#include "text/numbers.h"

namespace cli {
namespace {

std::optional<double> value_of(const emtr_setting_info& info, const std::string& text) {
  if (info.type == EMTR_SETTING_SWITCH) {
    if (text == "1" || text == "on") return 1;
    if (text == "0" || text == "off") return 0;
    return std::nullopt;
  }
  if (info.type == EMTR_SETTING_CHOICE) {
    const auto names = choices_of(info);
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) return std::nullopt;
    return static_cast<double>(found - names.begin());
  }
  const auto value = parse_real(text);
  const bool whole = info.type == EMTR_SETTING_INTEGER;
  if (!value || (whole && !parse_unsigned(text))) return std::nullopt;
  if (!(*value >= info.minimum && *value <= info.maximum)) return std::nullopt;
  return value;
}

std::string suggested(const emtr_setting_info& info, const std::string& text) {
  if (info.type == EMTR_SETTING_CHOICE) return did_you_mean(text, choices_of(info));
  if (info.type == EMTR_SETTING_SWITCH) return did_you_mean(text, {"on", "off"});
  return "";
}

}  // namespace

void set_setting(emtr_settings& settings, const emtr_setting_info& info, const std::string& text,
                 const std::string& called) {
  const bool is_scale = info.name == std::string("scale");
  const std::string more = is_scale ? std::string(", nor ") + kScaleNumbers : "";
  const UsageFailure wrong(called + ": '" + text + "' is not " + expected(info) + more +
                           suggested(info, text));
  if (info.name == std::string("seed")) {  // a double would lose digits
    const auto seed = parse_unsigned(text);
    if (!seed) throw wrong;
    settings.seed = *seed;
    return;
  }
  const auto value = value_of(info, text);
  if (!value && is_scale && set_scale_bounds(settings, text)) return;
  if (!value) throw wrong;
  if (emtr_setting_set(&settings, info.name, *value) != EMTR_OK)
    throw UsageFailure(called + ": " + emtr_error_message());
}

}  // namespace cli
