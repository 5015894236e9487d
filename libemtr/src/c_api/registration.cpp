#include "pipeline/registration.h"

#include <emtr/emtr.h>

#include <memory>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "c_api/handles.h"
#include "pipeline/input_cloud.h"
#include "pipeline/result.h"
#include "settings/validation.h"
#include "util/cancellation.h"
#include "util/thread_team.h"

using emtr::guarded;
using emtr::InputCloud;
using emtr::required;

namespace {

/// Returns the settings with the number of threads resolved: inside its own parallel region a run
/// can no longer ask OpenMP for it.
emtr::Settings resolved_settings(const emtr_settings* settings) {
  emtr::Settings chosen = emtr::settings_or_preset(settings);
  emtr::validate(chosen);
  chosen.threads = emtr::thread_count(chosen);
  return chosen;
}

/// Registers in one parallel region: between two regions OpenMP would have its threads spin.
emtr_result* run(InputCloud& source, InputCloud& target, const emtr_settings* settings,
                 emtr_progress_fn progress, void* user) {
  const emtr::Settings chosen = resolved_settings(settings);
  emtr::CancellationToken token(emtr::progress_function(progress, user), chosen.time_limit);
  emtr::CancellationToken* const outer = emtr::CancellationScope::current();
  const emtr::CancellationScope scope(&token);  // by which the stages find the region's team
  emtr_result* result = nullptr;
  emtr::ThreadTeam::with(chosen.threads, [&](emtr::ThreadTeam&) {
    const emtr::CancellationScope between_stages(outer);  // a stopped run has its result to write
    result = emtr::register_clouds(source, target, chosen, token).release();
  });
  return result;
}

/// A cloud whose preprocessed form the user keeps, unless `slot` is null. Fills an empty slot with
/// what a run has preprocessed, also when the run has failed.
class CachedCloud {
 public:
  CachedCloud(const emtr_cloud* cloud, emtr_preprocessed** slot, const char* name) : slot_(slot) {
    if (slot && *slot)
      input.preprocessed = (*slot)->cloud;
    else
      input.cloud = &required(cloud, name);
  }
  ~CachedCloud() {
    if (!slot_ || *slot_ || !input.preprocessed) return;
    fresh_->cloud = input.preprocessed;
    *slot_ = fresh_.release();
  }
  CachedCloud(const CachedCloud&) = delete;
  CachedCloud& operator=(const CachedCloud&) = delete;

  InputCloud input;

 private:
  emtr_preprocessed** const slot_;
  std::unique_ptr<emtr_preprocessed> fresh_ = std::make_unique<emtr_preprocessed>();
};

}  // namespace

extern "C" {

void emtr_result_free(emtr_result* result) { delete static_cast<emtr::Result*>(result); }

emtr_status emtr_register(const emtr_cloud* source, const emtr_cloud* target,
                          const emtr_settings* settings, emtr_progress_fn progress, void* user,
                          emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    InputCloud from{&required(source, "source"), nullptr}, to{&required(target, "target"), nullptr};
    *result = run(from, to, settings, progress, user);
  });
}

emtr_status emtr_register_preprocessed(const emtr_preprocessed* source,
                                       const emtr_preprocessed* target,
                                       const emtr_settings* settings, emtr_progress_fn progress,
                                       void* user, emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    InputCloud from{nullptr, required(source, "source").cloud},
        to{nullptr, required(target, "target").cloud};
    *result = run(from, to, settings, progress, user);
  });
}

emtr_status emtr_register_cached(const emtr_cloud* source, emtr_preprocessed** cached_source,
                                 const emtr_cloud* target, emtr_preprocessed** cached_target,
                                 const emtr_settings* settings, emtr_progress_fn progress,
                                 void* user, emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    CachedCloud from(source, cached_source, "source"), to(target, cached_target, "target");
    *result = run(from.input, to.input, settings, progress, user);
  });
}

}  // extern "C"
