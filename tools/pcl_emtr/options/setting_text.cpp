#include "options/setting_text.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "text/numbers.h"
#include "text/words.h"

namespace cli {
namespace {

std::string range_of(const emtr_setting_info& info) {
  if (info.name == std::string("seed")) return "from 0 to 18446744073709551615";
  const bool whole = info.type == EMTR_SETTING_INTEGER;  // no exponents in whole numbers
  const auto text = [&](double v) { return whole ? std::to_string(std::llround(v)) : brief(v); };
  return "from " + text(info.minimum) + " to " + text(info.maximum);
}

std::string default_of(const emtr_setting_info& info) {
  if (info.type == EMTR_SETTING_SWITCH) return info.value != 0 ? "on" : "off";
  if (info.type == EMTR_SETTING_CHOICE)
    return choices_of(info).at(static_cast<std::size_t>(info.value));
  return brief(info.value);
}

}  // namespace

std::string option_name(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

std::vector<std::string> choices_of(const emtr_setting_info& info) {
  std::vector<std::string> names;
  std::istringstream in(info.choices);
  for (std::string name; std::getline(in, name, ',');) names.push_back(name);
  return names;
}

std::string kind_of(const emtr_setting_info& info) {
  switch (info.type) {
    case EMTR_SETTING_SWITCH:
      return "on|off";
    case EMTR_SETTING_CHOICE:
      return "NAME";
    case EMTR_SETTING_INTEGER:
      return "N";
    case EMTR_SETTING_REAL:
      break;
  }
  return "X";
}

std::string expected(const emtr_setting_info& info) {
  switch (info.type) {
    case EMTR_SETTING_SWITCH:
      return "on, off, 1 or 0";
    case EMTR_SETTING_CHOICE:
      return joined(choices_of(info), " or ");
    case EMTR_SETTING_INTEGER:
      return "a whole number " + range_of(info);
    case EMTR_SETTING_REAL:
      break;
  }
  return "a number " + range_of(info);
}

std::string description_of(const emtr_setting_info& info) {
  std::string text = std::string(info.text) + " [";
  if (info.type == EMTR_SETTING_CHOICE) text += expected(info) + "; ";
  if (info.type == EMTR_SETTING_INTEGER || info.type == EMTR_SETTING_REAL)
    text += (*info.unit ? std::string(info.unit) + ", " : "") + range_of(info).substr(5) + "; ";
  return text + "default " + default_of(info) + "]";
}

std::string group_of(const std::string& part) { return "Settings of the method: " + part; }

}  // namespace cli
