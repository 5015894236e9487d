#include "settings/settings.h"

#include <emtr/emtr.h>

#include <string>

#include "c_api/arguments.h"
#include "c_api/guarded.h"

using emtr::checked;
using emtr::guarded;
using emtr::hand_out;
using emtr::required;

extern "C" {

emtr_status emtr_settings_init(emtr_settings* settings, size_t size, const char* preset) {
  return guarded([&] {
    required(settings, "settings");
    if (size != sizeof(emtr_settings))
      throw emtr::Error(EMTR_ERROR_ARGUMENT, "size is " + std::to_string(size) + ", expected " +
                                                 std::to_string(sizeof(emtr_settings)) +
                                                 ": header and library are of different versions");
    *settings = emtr::preset(preset ? preset : "default");
  });
}

const char* emtr_preset_name(size_t index) { return emtr::preset_name(index); }

size_t emtr_setting_count(void) { return emtr::setting_count(); }

emtr_status emtr_setting_describe(size_t index, emtr_setting_info* info, size_t size) {
  return guarded([&] {
    if (index >= emtr::setting_count())
      throw emtr::Error(EMTR_ERROR_ARGUMENT, "index is " + std::to_string(index) +
                                                 ", expected below " +
                                                 std::to_string(emtr::setting_count()));
    hand_out(emtr::setting(index).info, info, size);
  });
}

emtr_status emtr_setting_set(emtr_settings* settings, const char* name, double value) {
  return guarded([&] { emtr::set(checked(settings), &required(name, "name"), value); });
}

emtr_status emtr_setting_get(const emtr_settings* settings, const char* name, double* value) {
  return guarded([&] {
    required(value, "value") = emtr::get(checked(const_cast<emtr_settings*>(settings)),
                                         emtr::find_setting(&required(name, "name")));
  });
}

}  // extern "C"
