#include "settings/settings.h"

#include <emtr/emtr.h>

#include <string>

#include "c_api/arguments.h"
#include "c_api/guarded.h"

using emtr::checked;
using emtr::copy_info;
using emtr::guarded;
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
    copy_info(emtr::setting(emtr::checked_index(index, emtr::setting_count())).info, info, size);
  });
}

emtr_status emtr_setting_set(emtr_settings* settings, const char* name, double value) {
  return guarded([&] { emtr::set(checked(settings), &required(name, "name"), value); });
}

emtr_status emtr_setting_get(const emtr_settings* settings, const char* name, double* value) {
  return guarded([&] {
    required(value, "value") =
        emtr::get(checked(settings), emtr::find_setting(&required(name, "name")));
  });
}

}  // extern "C"
