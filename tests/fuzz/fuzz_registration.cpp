// Fuzzes a whole registration of two tiny clouds: at once, of preprocessed clouds, stage by stage.
#include <emtr/emtr.h>

#include <memory>
#include <string>

#include "any_cloud.h"
#include "any_correspondences.h"
#include "calls.h"
#include "input.h"
#include "keeps_to_prior.h"
#include "small_settings.h"

namespace {

using fuzz::accepted;
using fuzz::any_double;
using fuzz::Input;
using fuzz::require;

template <class T>
using Owned = std::unique_ptr<T, void (*)(T*)>;

bool in_unit(double value) { return value >= 0 && value <= 1; }

/// Requires a rotation, a translation and the row (0, 0, 0, 1).
void require_rigid(const double (&T)[16]) {
  for (int i = 0; i < 3; ++i) {
    require(std::isfinite(T[4 * i + 3]));
    for (int j = 0; j <= i; ++j) {
      double dot = 0;
      for (int k = 0; k < 3; ++k) dot += T[4 * i + k] * T[4 * j + k];
      require(std::abs(dot - (i == j)) < 1e-9);
    }
  }
  require(T[12] == 0 && T[13] == 0 && T[14] == 0 && T[15] == 1);
}

void check(const emtr_result& result, const emtr_settings& settings) {
  require(result.size == sizeof result);
  require(result.registered == (result.reason == EMTR_REASON_REGISTERED));
  if (std::isnan(result.transformation[0])) {
    require(result.reason == EMTR_REASON_INTERRUPTED || result.reason == EMTR_REASON_TIME_LIMIT);
    return;
  }
  const fuzz::KeptPrior prior(settings, result);
  require_rigid(result.transformation);
  prior.require_kept(result.transformation);
  require(std::isnan(result.confidence) || in_unit(result.confidence));
  const bool by_matches = std::isnan(result.fitness);  // then nothing is measured on surfaces
  require(by_matches ||
          (in_unit(result.inlier_ratio_source) && in_unit(result.inlier_ratio_target)));
  require(by_matches || result.fitness >= 0);
  require(result.iterations <= static_cast<std::size_t>(settings.iterations));
  require(by_matches ||
          result.correspondences <= static_cast<std::size_t>(settings.max_correspondences));
  require(result.correspondences <= result.correspondences_found);
  require(result.alternative_count <= 10);
  for (std::size_t i = 0; i < result.alternative_count; ++i) {
    require_rigid(result.alternatives[i].transformation);
    prior.require_kept(result.alternatives[i].transformation);
  }
}

/// Stops a run at one of its calls of the progress callback.
struct Stop {
  int left;
  static int at(const emtr_progress* progress, void* user) {
    require(progress->stage && progress->iteration <= progress->iterations);
    return static_cast<Stop*>(user)->left-- == 0;
  }
};

Owned<emtr_preprocessed> preprocessed(const emtr_cloud& cloud) {
  emtr_preprocessed* out = nullptr;
  accepted(emtr_preprocess(&cloud, nullptr, 1, &out));
  return {out, emtr_preprocessed_free};
}

void read_array(const emtr_problem* problem, Input& input) {
  const auto which = static_cast<emtr_array>(input.ConsumeIntegralInRange(0, 15));
  const void* data = nullptr;
  std::size_t rows = 0, columns = 0;
  if (!accepted(emtr_problem_array(problem, which, &data, &rows, &columns))) return;
  unsigned sum = 0;
  for (std::size_t i = 0; i < rows * columns * 4; ++i)
    sum += static_cast<const unsigned char*>(data)[i];
  require(sum < 0x80000000u);
}

/// Scores and refines a pose.
void use_pose(const emtr_problem* problem, const double T[16]) {
  emtr_alternative scored;
  if (accepted(emtr_problem_score(problem, T, 1, &scored))) {
    require_rigid(scored.transformation);
    require(scored.score <= 1 && scored.surface_fit >= 0 && scored.violation >= 0);
  }
  double refined[16];
  if (accepted(emtr_problem_refine(problem, T, 1, refined))) require_rigid(refined);
}

/// Uses the tasks, the complement and the conversions of a problem, for any particles.
void use(emtr_problem* problem, Input& input) {
  double particles[12], fitness[2], T[16], back[6], translation[3];
  for (double& value : particles) value = any_double(input);
  const auto resolution = input.ConsumeBool() ? EMTR_RESOLUTION_DENSE : EMTR_RESOLUTION_SPARSE;
  if (accepted(emtr_task_alpha_evaluate(problem, resolution, particles, 2, fitness)))
    require(fitness[0] >= 0 && fitness[1] >= 0);
  if (accepted(emtr_task_beta_evaluate(problem, particles, 2, fitness)))
    require(fitness[0] >= 0 && fitness[1] >= 0);
  if (accepted(emtr_complement(problem, particles, translation)))
    for (const double value : translation) require(std::isfinite(value));
  if (accepted(emtr_particle_to_transformation(problem, particles, T))) {
    require_rigid(T);
    require(accepted(emtr_transformation_to_particle(problem, T, back)));
    for (const double value : back) require(std::isfinite(value));
    use_pose(problem, T);
    T[input.ConsumeIntegralInRange(0, 15)] = any_double(input);
    accepted(emtr_transformation_to_particle(problem, T, back));
  }
  emtr_problem_info info;
  require(accepted(emtr_problem_describe(problem, &info, sizeof info)));
  require(info.normalization_scale > 0 && info.tims_pruned <= info.tims && info.leaf_dense > 0);
  read_array(problem, input);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Input input(data, size);
  emtr_settings settings = fuzz::small_settings(input);
  const fuzz::UserData user = fuzz::any_user_data(input);
  const fuzz::AnyCloud source(input, 48, user), target(input, 48, user);
  const fuzz::AnyCorrespondences correspondences(input, source.view().count, target.view().count);
  correspondences.add_to(settings);
  Stop stop{input.ConsumeBool() ? input.ConsumeIntegralInRange(0, 15) : -1};
  emtr_result* result = nullptr;
  bool done = false;
  switch (input.ConsumeIntegralInRange(0, 2)) {
    case 0:
      done = accepted(
          emtr_register(&source.view(), &target.view(), &settings, Stop::at, &stop, &result));
      break;
    case 1: {
      const auto a = preprocessed(source.view()), b = preprocessed(target.view());
      done = accepted(
          emtr_register_preprocessed(a.get(), b.get(), &settings, Stop::at, &stop, &result));
      break;
    }
    default: {
      emtr_problem* raw = nullptr;
      const bool made =
          accepted(emtr_problem_create(&source.view(), &target.view(), &settings, &raw));
      require(made == (raw != nullptr));
      if (!made) break;
      const Owned<emtr_problem> problem(raw, emtr_problem_free);
      use(problem.get(), input);
      const double particle[6] = {0.1, 0.2, 0.3, 0, 0, any_double(input)};
      double T[16];
      if (input.ConsumeBool() &&
          accepted(emtr_particle_to_transformation(problem.get(), particle, T)))
        done = accepted(emtr_problem_solve_from(problem.get(), T, 1, Stop::at, &stop, &result));
      else
        done = accepted(emtr_problem_solve(problem.get(), Stop::at, &stop, &result));
    }
  }
  require(done == (result != nullptr));
  if (!done) return 0;
  const Owned<emtr_result> owned(result, emtr_result_free);
  check(*result, settings);
  return 0;
}
