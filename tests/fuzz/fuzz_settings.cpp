// Fuzzes settings: by name, and as any bytes that the struct can hold.
#include <emtr/emtr.h>

#include <string>

#include "calls.h"
#include "input.h"

namespace {

using fuzz::accepted;
using fuzz::Input;
using fuzz::require;

std::string any_name(Input& input) {
  emtr_setting_info info;
  if (accepted(emtr_setting_describe(input.ConsumeIntegral<std::uint8_t>(), &info, sizeof info)))
    return info.name;
  return input.ConsumeRandomLengthString(24);
}

/// Sets any value; requires that it can be read back if it was taken, and changed nothing if not.
void set(emtr_settings& settings, Input& input) {
  const std::string name = any_name(input);
  const double value = fuzz::any_double(input);
  double before = 0, after = 0;
  const bool known = accepted(emtr_setting_get(&settings, name.c_str(), &before));
  const bool taken = accepted(emtr_setting_set(&settings, name.c_str(), value));
  require(known || !taken);
  if (!known) return;
  require(accepted(emtr_setting_get(&settings, name.c_str(), &after)));
  const double expected = taken ? value : before;
  require(after == expected || (std::isnan(after) && std::isnan(expected)));
}

void overwrite(emtr_settings& settings, Input& input) {
  const auto at = input.ConsumeIntegralInRange<std::size_t>(0, sizeof settings - 1);
  const auto bytes =
      input.ConsumeBytes<char>(input.ConsumeIntegralInRange<std::size_t>(0, sizeof settings - at));
  if (!bytes.empty())
    std::memcpy(reinterpret_cast<char*>(&settings) + at, bytes.data(), bytes.size());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  emtr_settings settings;
  std::memset(&settings, 0, sizeof settings);
  const char* preset = emtr_preset_name(input.ConsumeIntegralInRange<std::size_t>(0, 4));
  const std::string other = preset ? "" : input.ConsumeRandomLengthString(16);
  if (!accepted(emtr_settings_init(&settings, sizeof settings, preset ? preset : other.c_str())))
    accepted(emtr_settings_init(&settings, input.ConsumeIntegral<std::size_t>(), nullptr));
  for (int i = 0; i < 20 && input.remaining_bytes() > 0; ++i)
    input.ConsumeBool() ? set(settings, input) : overwrite(settings, input);

  settings.correspondences = nullptr;  // an array of the caller, which has to exist
  settings.correspondence_count = 0;

  // The library checks all settings before it looks at the clouds, and these have no points.
  const emtr_cloud empty{nullptr, 0, 0, EMTR_FLOAT32};
  emtr_result* result = nullptr;
  const bool ran = accepted(emtr_register(&empty, &empty, &settings, nullptr, nullptr, &result));
  require(ran == (result != nullptr));
  // A time limit near zero ends the run before it looks at the clouds.
  require(!ran || result->reason == EMTR_REASON_TIME_LIMIT);
  emtr_result_free(result);
  return 0;
}
