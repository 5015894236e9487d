#include <emtr/emtr.h>

#include <memory>
#include <utility>

#include "pipeline/result.h"
#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "c_api/handles.h"

using emtr::guarded;
using emtr::required;
using emtr::settings_or_preset;

namespace {

emtr_result* run(const emtr::Settings& settings, emtr_progress_fn progress, void* user,
                 const emtr::Problem::Normalize& normalized) {
  emtr::CancellationToken watch(emtr::progress_function(progress, user), settings.time_limit);
  const emtr::Problem problem(normalized, settings, watch);
  return problem.solve(watch).release();
}

/// What is kept of a cloud, or is from now on.
emtr::PreprocessedCloudPtr preprocessed(const emtr_cloud* cloud, emtr_preprocessed** kept, const char* name,
                                const emtr::Settings& settings) {
  if (kept && *kept) return (*kept)->cloud;
  auto made = std::make_shared<const emtr::PreprocessedCloud>(emtr::kept(*cloud, settings), name,
                                                          emtr::thread_count(settings));
  if (kept) *kept = new emtr_preprocessed{made};
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
      return emtr::normalize(emtr::kept(*source, chosen), emtr::kept(*target, chosen),
                             emtr::thread_count(chosen));
    });
  });
}

emtr_status emtr_register_preprocessed(const emtr_preprocessed* source, const emtr_preprocessed* target,
                                   const emtr_settings* settings, emtr_progress_fn progress,
                                   void* user, emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    required(source, "source");
    required(target, "target");
    *result = run(settings_or_preset(settings), progress, user,
                  [&] { return emtr::normalize(source->cloud, target->cloud); });
  });
}

emtr_status emtr_register_cached(const emtr_cloud* source, emtr_preprocessed** cached_source,
                               const emtr_cloud* target, emtr_preprocessed** cached_target,
                               const emtr_settings* settings, emtr_progress_fn progress, void* user,
                               emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    if (!cached_source || !*cached_source) required(source, "source");
    if (!cached_target || !*cached_target) required(target, "target");
    const emtr::Settings chosen = settings_or_preset(settings);
    *result = run(chosen, progress, user, [&] {
      auto from = preprocessed(source, cached_source, "source", chosen);
      return emtr::normalize(std::move(from), preprocessed(target, cached_target, "target", chosen));
    });
  });
}

}  // extern "C"
