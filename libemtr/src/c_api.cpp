#include <emtr/emtr.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "enum_number.h"
#include "error.h"
#include "problem.h"
#include "problem_arrays.h"
#include "result.h"
#include "settings.h"
#include "tasks/euler.h"
#include "team.h"
#include "verdict/residuals.h"
#include "watch.h"

#define EMTR_TEXT_(x) #x
#define EMTR_TEXT(x) EMTR_TEXT_(x)

struct emtr_problem : emtr::Problem {
  using Problem::Problem;
  emtr::ProblemArrays arrays{*this};
};

struct emtr_prepared {
  emtr::PreparedCloudPtr cloud;
};

namespace {

thread_local std::string last_error;

struct Interrupt {
  emtr_interrupt_fn ask = nullptr;
  void* user = nullptr;
};
thread_local Interrupt interrupt;

/// Of this thread, as a run asks it; null when there is none.
emtr::OnProgress interrupt_function() {
  if (!interrupt.ask) return nullptr;
  return [](const emtr_progress&) {
    struct Unasked {
      const Interrupt now = std::exchange(interrupt, {});
      ~Unasked() { interrupt = now; }
    } const unasked;
    return unasked.now.ask(unasked.now.user) != 0;
  };
}

/// Keeps the message even when there is no memory for it: a short one needs none.
void tell(const char* prefix, const char* text) noexcept {
  try {
    last_error = std::string(prefix) + text;
  } catch (const std::bad_alloc&) {
    last_error = "out of memory";
  }
}

/// The default floating-point environment while it lives: rounding to nearest, and no denormal
/// taken for zero, whatever the caller or a library of its that was built with -ffast-math has set.
class DefaultArithmetic {
 public:
  DefaultArithmetic() {
    std::fegetenv(&callers_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultArithmetic() { std::fesetenv(&callers_); }
  DefaultArithmetic(const DefaultArithmetic&) = delete;
  DefaultArithmetic& operator=(const DefaultArithmetic&) = delete;

 private:
  std::fenv_t callers_;
};

/// Runs a body that may throw; what it throws becomes a status and this thread's message.
template <class Body>
emtr_status guarded(Body body) noexcept {
  const DefaultArithmetic arithmetic;
  try {
    // Not the watch of the run that this may be called back from.
    emtr::Watch watch(interrupt_function());
    const emtr::Watched watched(interrupt.ask ? &watch : nullptr);
    body();
    return EMTR_OK;
  } catch (const emtr::Error& error) {
    tell("", error.what());
    return error.status();
  } catch (const emtr::Stopped&) {
    tell("", "interrupted");
    return EMTR_ERROR_INTERRUPTED;
  } catch (const std::bad_alloc&) {
    tell("", "out of memory");
    return EMTR_ERROR_MEMORY;
  } catch (const std::length_error&) {
    tell("", "out of memory");
    return EMTR_ERROR_MEMORY;
  } catch (const std::exception& error) {
    tell("unexpected: ", error.what());
    return EMTR_ERROR_INTERNAL;
  } catch (...) {
    tell("", "the progress function threw what is no std::exception");
    return EMTR_ERROR_INTERNAL;
  }
}

template <class T>
T& required(T* pointer, const char* name) {
  if (!pointer) throw emtr::Error(EMTR_ERROR_ARGUMENT, std::string(name) + " is null");
  return *pointer;
}

/// To a caller who was compiled with this header or a later one, whose further fields become zero.
template <class Info>
void hand_out(const Info& info, Info* out, std::size_t size) {
  required(out, "info");
  if (size < sizeof(Info))
    throw emtr::Error(
        EMTR_ERROR_ARGUMENT,
        "size is " + std::to_string(size) + ", expected at least " + std::to_string(sizeof(Info)));
  std::memset(static_cast<void*>(out), 0, size);
  std::memcpy(static_cast<void*>(out), &info, sizeof(Info));
}

emtr::Settings& checked(emtr_settings* settings) {
  if (required(settings, "settings").size != sizeof(emtr_settings))
    throw emtr::Error(EMTR_ERROR_ARGUMENT, "settings: size is " + std::to_string(settings->size) +
                                               ", expected " +
                                               std::to_string(sizeof(emtr_settings)) +
                                               "; fill it with emtr_settings_init()");
  return *settings;
}

emtr::Settings settings_or_preset(const emtr_settings* settings) {
  if (!settings) return emtr::preset("default");
  return checked(const_cast<emtr_settings*>(settings));
}

emtr::OnProgress progress_function(emtr_progress_fn progress, void* user) {
  if (!progress) return interrupt_function();
  return [=](const emtr_progress& p) { return progress(&p, user) != 0; };
}

emtr_result* run(const emtr::Settings& settings, emtr_progress_fn progress, void* user,
                 const emtr::Problem::Normalise& normalised) {
  emtr::Watch watch(progress_function(progress, user), settings.time_limit);
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

emtr::Rigid rigid(const double T[16]) {
  if (!emtr::is_rigid(T))
    throw emtr::Error(EMTR_ERROR_ARGUMENT,
                      "transformation: expected a row-major 4x4 of a rotation, a translation "
                      "and (0, 0, 0, 1)");
  return emtr::from_matrix(T);
}

/// As the setting of that name.
int thread_count(std::int32_t threads) {
  emtr::Settings settings{};
  emtr::set(settings, "threads", threads);
  return emtr::thread_count(settings);
}

/// Of clouds, or of prepared ones.
template <class Cloud>
emtr_problem* made(const Cloud& source, const Cloud& target, const emtr_settings* settings) {
  auto problem = std::make_unique<emtr_problem>(source, target, settings_or_preset(settings),
                                                interrupt_function());
  if (problem->stopped()) throw emtr::Stopped();
  return problem.release();
}

/// A problem that tasks can be evaluated on.
emtr_problem& checked(emtr_problem* problem) { return required(problem, "problem"); }
const emtr_problem& checked(const emtr_problem* problem) { return required(problem, "problem"); }

void require_near(const double* values, std::size_t count, const char* name) {
  if (!emtr::is_near(values, count))
    throw emtr::Error(EMTR_ERROR_ARGUMENT, std::string(name) + ": not finite or beyond 1e6");
}

/// Scores n particles of `genes` numbers in parallel, on the problem's own count of threads.
template <class Score>
void evaluate_all(const emtr_problem& problem, const double* particles, std::size_t n,
                  std::size_t genes, double* fitness, Score score) {
  if (n == 0) return;
  required(particles, "particles");
  required(fitness, "fitness");
  for (std::size_t i = 0; i < n; ++i)
    if (!emtr::is_near(particles + genes * i, genes))
      throw emtr::Error(EMTR_ERROR_ARGUMENT,
                        "particles: row " + std::to_string(i) + ": not finite or beyond 1e6");
  const int threads = emtr::thread_count(problem.settings);
  std::vector<emtr::TaskAlpha::Scratch> scratch(static_cast<std::size_t>(threads));
  emtr::Team::with(threads, [&](emtr::Team& team) {
    team.parallel(n, [&](std::size_t i, std::size_t thread) {
      fitness[i] = score(particles + genes * i, scratch[thread]);
    });
  });
}

}  // namespace

extern "C" {

const char* emtr_status_text(emtr_status status) {
  switch (emtr::number_of(status)) {
    case EMTR_OK:
      return "no error";
    case EMTR_ERROR_ARGUMENT:
      return "bad argument";
    case EMTR_ERROR_SETTING:
      return "bad setting";
    case EMTR_ERROR_CLOUD:
      return "cloud cannot be registered";
    case EMTR_ERROR_MEMORY:
      return "out of memory";
    case EMTR_ERROR_INTERNAL:
      return "internal error";
    case EMTR_ERROR_INTERRUPTED:
      return "interrupted";
  }
  return "unknown status";
}

const char* emtr_reason_name(emtr_reason reason) {
  switch (emtr::number_of(reason)) {
    case EMTR_REASON_REGISTERED:
      return "registered";
    case EMTR_REASON_LOW_OVERLAP:
      return "low_overlap";
    case EMTR_REASON_AMBIGUOUS:
      return "ambiguous";
    case EMTR_REASON_FEW_MATCHES:
      return "few_matches";
    case EMTR_REASON_INTERRUPTED:
      return "interrupted";
    case EMTR_REASON_DEGENERATE:
      return "degenerate";
    case EMTR_REASON_TIME_LIMIT:
      return "time_limit";
  }
  return "unknown";
}

const char* emtr_reason_text(emtr_reason reason) {
  switch (emtr::number_of(reason)) {
    case EMTR_REASON_REGISTERED:
      return "registered";
    case EMTR_REASON_LOW_OVERLAP:
      return "too few points of the clouds lie on each other";
    case EMTR_REASON_AMBIGUOUS:
      return "a clearly different pose fits about as well";
    case EMTR_REASON_FEW_MATCHES:
      return "too few feature matches";
    case EMTR_REASON_INTERRUPTED:
      return "interrupted";
    case EMTR_REASON_DEGENERATE:
      return "the surfaces can slide or spin along themselves";
    case EMTR_REASON_TIME_LIMIT:
      return "the time limit was reached";
  }
  return "unknown reason";
}

const char* emtr_error_message(void) { return last_error.c_str(); }

void emtr_set_interrupt(emtr_interrupt_fn function, void* user) { interrupt = {function, user}; }

const char* emtr_version(void) {
  return EMTR_TEXT(EMTR_VERSION_MAJOR) "." EMTR_TEXT(EMTR_VERSION_MINOR) "." EMTR_TEXT(
      EMTR_VERSION_PATCH);
}

const char* emtr_kernel_name(void) {
  const char* name = nullptr;
  guarded([&] { name = emtr::select_kernels().name; });
  return name;
}

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

emtr_status emtr_residuals(const emtr_cloud* source, const emtr_cloud* target, const double T[16],
                           int32_t threads, double* of_source, double* of_target) {
  return guarded([&] {
    const emtr::Rigid pose = T ? rigid(T) : emtr::Rigid();
    emtr::residuals(required(source, "source"), required(target, "target"), pose,
                    thread_count(threads), of_source, of_target);
  });
}

emtr_status emtr_prepare(const emtr_cloud* cloud, const char* name, int32_t threads,
                         emtr_prepared** prepared) {
  return guarded([&] {
    required(prepared, "prepared") = nullptr;
    *prepared = new emtr_prepared{std::make_shared<const emtr::PreparedCloud>(
        required(cloud, "cloud"), name ? name : "", thread_count(threads))};
  });
}

void emtr_prepared_free(emtr_prepared* prepared) { delete prepared; }

emtr_status emtr_prepared_describe(const emtr_prepared* prepared, emtr_prepared_info* info,
                                   size_t size) {
  return guarded([&] {
    const emtr::PreparedCloud& cloud = *required(prepared, "prepared").cloud;
    emtr_prepared_info out{};
    out.points = cloud.count;
    out.dropped = cloud.dropped;
    out.kept = cloud.base.size();
    std::copy_n(cloud.center, 3, out.center);
    out.radius = cloud.radius;
    out.normals = cloud.normals.size() != 0;
    out.described = cloud.described.rows.size();
    out.feature_dimension = cloud.described.dimension;
    hand_out(out, info, size);
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

emtr_status emtr_problem_create_prepared(const emtr_prepared* source, const emtr_prepared* target,
                                         const emtr_settings* settings, emtr_problem** problem) {
  return guarded([&] {
    required(problem, "problem") = nullptr;
    *problem = made(required(source, "source").cloud, required(target, "target").cloud, settings);
  });
}

emtr_status emtr_problem_create(const emtr_cloud* source, const emtr_cloud* target,
                                const emtr_settings* settings, emtr_problem** problem) {
  return guarded([&] {
    required(problem, "problem") = nullptr;
    *problem = made(required(source, "source"), required(target, "target"), settings);
  });
}

void emtr_problem_free(emtr_problem* problem) { delete problem; }

emtr_status emtr_problem_solve(emtr_problem* problem, emtr_progress_fn progress, void* user,
                               emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    *result = checked(problem).solve(progress_function(progress, user)).release();
  });
}

emtr_status emtr_task_alpha_evaluate(emtr_problem* problem, emtr_stage stage,
                                     const double* particles, size_t count, double* fitness) {
  return guarded([&] {
    emtr_problem& p = checked(problem);
    const int number = emtr::number_of(stage);
    if (number != EMTR_STAGE_SPARSE && number != EMTR_STAGE_DENSE)
      throw emtr::Error(EMTR_ERROR_ARGUMENT, "stage must be EMTR_STAGE_SPARSE or EMTR_STAGE_DENSE");
    evaluate_all(p, particles, count, 6, fitness,
                 [&](const double* particle, emtr::TaskAlpha::Scratch& scratch) {
                   return p.alpha->evaluate(stage, emtr::decode(particle), scratch);
                 });
    p.lookups += count * p.alpha->lookups(stage);
  });
}

emtr_status emtr_task_beta_evaluate(emtr_problem* problem, const double* particles, size_t count,
                                    double* fitness) {
  return guarded([&] {
    const emtr_problem& p = checked(problem);
    evaluate_all(p, particles, count, 3, fitness,
                 [&](const double* angles, emtr::TaskAlpha::Scratch&) {
                   double R[9];
                   emtr::euler_to_rotation(angles, R);
                   return p.beta->evaluate(R);
                 });
  });
}

emtr_status emtr_complement(emtr_problem* problem, const double angles[3], double translation[3]) {
  return guarded([&] {
    emtr_problem& p = checked(problem);
    double R[9];
    require_near(&required(angles, "angles"), 3, "angles");
    emtr::euler_to_rotation(angles, R);
    p.complement->translation(R, &required(translation, "translation"), p.prior.get());
    p.lookups += p.complement->lookups();
  });
}

emtr_status emtr_particle_to_transformation(const emtr_problem* problem, const double particle[6],
                                            double T[16]) {
  return guarded([&] {
    require_near(&required(particle, "particle"), 6, "particle");
    const emtr::Rigid pose = checked(problem).frame.to_user(emtr::decode(particle));
    emtr::to_matrix(pose, &required(T, "transformation"));
  });
}

emtr_status emtr_transformation_to_particle(const emtr_problem* problem, const double T[16],
                                            double particle[6]) {
  return guarded([&] {
    const emtr::Rigid pose =
        checked(problem).frame.to_normalised(rigid(&required(T, "transformation")));
    emtr::encode(pose, &required(particle, "particle"));
  });
}

uint64_t emtr_problem_lookups(const emtr_problem* problem) {
  return problem ? problem->lookups.load() : 0;
}

emtr_status emtr_problem_describe(const emtr_problem* problem, emtr_problem_info* info,
                                  size_t size) {
  return guarded([&] {
    const emtr_problem& p = checked(problem);
    emtr_problem_info out{};
    out.scale = p.frame.scale;
    std::copy_n(p.frame.center_source, 3, out.center_source);
    std::copy_n(p.frame.center_target, 3, out.center_target);
    out.leaf_sparse = p.densities.leaf_sparse;
    out.leaf_dense = p.densities.leaf_dense;
    out.c_sparse = p.alpha->scale(EMTR_STAGE_SPARSE);
    out.c_dense = p.alpha->scale(EMTR_STAGE_DENSE);
    out.tau = p.tau;
    out.tims = p.tims.formed();
    out.tims_pruned = p.tims.pruned;
    hand_out(out, info, size);
  });
}

emtr_status emtr_problem_array(const emtr_problem* problem, emtr_array which, const void** data,
                               size_t* rows, size_t* columns) {
  return guarded([&] {
    const emtr_problem& p = checked(problem);
    const int number = emtr::number_of(which);
    if (number < EMTR_SOURCE_SPARSE || number > EMTR_TARGET_FEATURE_ROWS)
      throw emtr::Error(EMTR_ERROR_ARGUMENT, "array: there is none of that number");
    const emtr::ProblemArrays::View array = p.arrays.view(which);
    required(data, "data") = array.data;
    required(rows, "rows") = array.rows;
    required(columns, "columns") = array.columns;
  });
}

}  // extern "C"
