#include <emtr/emtr.h>

#include <memory>
#include <utility>

#include "../result.h"
#include "arguments.h"
#include "guarded.h"
#include "handles.h"

using emtr::guarded;
using emtr::required;
using emtr::settings_or_preset;

namespace {

emtr_result* run(const emtr::Settings& settings, emtr_progress_fn progress, void* user,
                 const emtr::Problem::Normalise& normalised) {
  emtr::Watch watch(emtr::progress_function(progress, user), settings.time_limit);
  const emtr::Problem problem(normalised, settings, watch);
  return problem.solve(watch).release();
}

/// What is kept of a cloud, or is from now on.
emtr::PreparedCloudPtr prepared(const emtr_cloud* cloud, emtr_prepared** kept, const char* name,
                                const emtr::Settings& settings) {
  if (kept && *kept) return (*kept)->cloud;
  auto made = std::make_shared<const emtr::PreparedCloud>(emtr::kept(*cloud, settings), name,
                                                          emtr::thread_count(settings));
  if (kept) *kept = new emtr_prepared{made};
  return made;
}

}  // namespace

extern "C" {

void emtr_result_free(emtr_result* result) { delete static_cast<emtr::Result*>(result); }

emtr_status emtr_register(const emtr_cloud* source, const emtr_cloud* target,
                          const emtr_settings* settings, emtr_progress_fn progress, void* user,
                          emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    required(source, "source");
    required(target, "target");
    const emtr::Settings chosen = settings_or_preset(settings);
    *result = run(chosen, progress, user, [&] {
      return emtr::normalise(emtr::kept(*source, chosen), emtr::kept(*target, chosen),
                             emtr::thread_count(chosen));
    });
  });
}

emtr_status emtr_register_prepared(const emtr_prepared* source, const emtr_prepared* target,
                                   const emtr_settings* settings, emtr_progress_fn progress,
                                   void* user, emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    required(source, "source");
    required(target, "target");
    *result = run(settings_or_preset(settings), progress, user,
                  [&] { return emtr::normalise(source->cloud, target->cloud); });
  });
}

emtr_status emtr_register_kept(const emtr_cloud* source, emtr_prepared** kept_source,
                               const emtr_cloud* target, emtr_prepared** kept_target,
                               const emtr_settings* settings, emtr_progress_fn progress, void* user,
                               emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    if (!kept_source || !*kept_source) required(source, "source");
    if (!kept_target || !*kept_target) required(target, "target");
    const emtr::Settings chosen = settings_or_preset(settings);
    *result = run(chosen, progress, user, [&] {
      auto from = prepared(source, kept_source, "source", chosen);
      return emtr::normalise(std::move(from), prepared(target, kept_target, "target", chosen));
    });
  });
}

}  // extern "C"
