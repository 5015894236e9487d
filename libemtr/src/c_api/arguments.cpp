#include "c_api/arguments.h"

namespace emtr {
namespace {

void check_size(const emtr_settings* settings) {
  const std::size_t size = required(settings, "settings").size;
  if (size != sizeof(emtr_settings))
    throw Error(EMTR_ERROR_ARGUMENT, "settings: size is " + std::to_string(size) + ", expected " +
                                         std::to_string(sizeof(emtr_settings)) +
                                         "; fill it with emtr_settings_init()");
}

}  // namespace

Settings& checked(emtr_settings* settings) {
  check_size(settings);
  return *settings;
}

const Settings& checked(const emtr_settings* settings) {
  check_size(settings);
  return *settings;
}

Settings settings_or_preset(const emtr_settings* settings) {
  return settings ? checked(settings) : preset("default");
}

Similarity checked_similarity(const double transformation[16]) {
  const std::optional<Similarity> similarity = similarity_from_matrix(transformation);
  if (!similarity)
    throw Error(EMTR_ERROR_ARGUMENT,
                "transformation: expected a row-major 4x4 of a rotation, times a scale or not, a "
                "translation and (0, 0, 0, 1)");
  return *similarity;
}

Rigid checked_pose(const double transformation[16]) {
  if (!is_rigid(transformation))
    throw Error(EMTR_ERROR_ARGUMENT,
                "transformation: expected a row-major 4x4 of a rotation, a translation "
                "and (0, 0, 0, 1)");
  return from_matrix(transformation);
}

int checked_threads(std::int32_t threads) {
  Settings settings{};
  set(settings, "threads", threads);
  return thread_count(settings);
}

std::size_t checked_index(std::size_t index, std::size_t count) {
  if (index >= count)
    throw Error(EMTR_ERROR_ARGUMENT,
                "index is " + std::to_string(index) + ", expected below " + std::to_string(count));
  return index;
}

}  // namespace emtr
