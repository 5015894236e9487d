#include "c_api/arguments.h"

namespace emtr {

Settings& checked(emtr_settings* settings) {
  if (required(settings, "settings").size != sizeof(emtr_settings))
    throw Error(EMTR_ERROR_ARGUMENT, "settings: size is " + std::to_string(settings->size) +
                                         ", expected " + std::to_string(sizeof(emtr_settings)) +
                                         "; fill it with emtr_settings_init()");
  return *settings;
}

Settings settings_or_preset(const emtr_settings* settings) {
  if (!settings) return preset("default");
  return checked(const_cast<emtr_settings*>(settings));
}

Rigid given_rigid(const double T[16]) {
  if (!is_rigid(T))
    throw Error(EMTR_ERROR_ARGUMENT,
                "transformation: expected a row-major 4x4 of a rotation, a translation "
                "and (0, 0, 0, 1)");
  return from_matrix(T);
}

int given_threads(std::int32_t threads) {
  Settings settings{};
  set(settings, "threads", threads);
  return thread_count(settings);
}

}  // namespace emtr
