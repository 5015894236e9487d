#include "pipeline/problem.h"

#include <emtr/emtr.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "c_api/handles.h"
#include "pipeline/require_colors.h"
#include "pipeline/solve.h"
#include "util/enum_number.h"

using emtr::checked;
using emtr::guarded;
using emtr::InputCloud;
using emtr::required;

namespace {

/// Makes a problem within no time limit.
emtr_problem* make(InputCloud source, InputCloud target, const emtr_settings* settings) {
  emtr::CancellationToken token(emtr::interrupt_function());
  auto problem = emtr::make_problem(source, target, emtr::settings_or_preset(settings), token);
  if (problem->stopped) throw emtr::Cancelled();
  const emtr::NormalizedPair& pair = problem->pair;
  emtr::require_colors(problem->settings, *pair.preprocessed_source, *pair.preprocessed_target);
  return new emtr_problem(std::move(problem));
}

}  // namespace

extern "C" {

emtr_status emtr_problem_create_preprocessed(const emtr_preprocessed* source,
                                             const emtr_preprocessed* target,
                                             const emtr_settings* settings,
                                             emtr_problem** problem) {
  return guarded([&] {
    required(problem, "problem") = nullptr;
    *problem = make({nullptr, required(source, "source").cloud},
                    {nullptr, required(target, "target").cloud}, settings);
  });
}

emtr_status emtr_problem_create(const emtr_cloud* source, const emtr_cloud* target,
                                const emtr_settings* settings, emtr_problem** problem) {
  return guarded([&] {
    required(problem, "problem") = nullptr;
    *problem = make({&required(source, "source"), nullptr}, {&required(target, "target"), nullptr},
                    settings);
  });
}

void emtr_problem_free(emtr_problem* problem) { delete problem; }

emtr_status emtr_problem_solve(emtr_problem* problem, emtr_progress_fn progress, void* user,
                               emtr_result** result) {
  return guarded([&] {
    required(result, "result") = nullptr;
    const emtr::Problem& p = *checked(problem).data;
    emtr::CancellationToken token(emtr::progress_function(progress, user), p.settings.time_limit);
    *result = emtr::solve(p, token).release();
  });
}

uint64_t emtr_problem_queries(const emtr_problem* problem) {
  return problem ? problem->queries.load() : 0;
}

emtr_status emtr_problem_describe(const emtr_problem* problem, emtr_problem_info* info,
                                  size_t size) {
  return guarded([&] {
    const emtr::Problem& p = *checked(problem).data;
    const emtr::Normalization& normalization = p.pair.normalization;
    emtr_problem_info out{};
    out.normalization_scale = normalization.scale;
    std::copy_n(normalization.center_source, 3, out.center_source);
    std::copy_n(normalization.center_target, 3, out.center_target);
    out.leaf_sparse = p.downsampled.leaf_sparse;
    out.leaf_dense = p.downsampled.leaf_dense;
    out.c_sparse = p.alpha->scale(EMTR_RESOLUTION_SPARSE);
    out.c_dense = p.alpha->scale(EMTR_RESOLUTION_DENSE);
    out.tau = p.tau;
    out.tims = p.tims.formed();
    out.tims_pruned = p.tims.pruned;
    emtr::copy_info(out, info, size);
  });
}

emtr_status emtr_problem_array(const emtr_problem* problem, emtr_array which, const void** data,
                               size_t* rows, size_t* columns) {
  return guarded([&] {
    const emtr::ProblemArrays& arrays = checked(problem).arrays;
    const int number = emtr::number_of(which);
    if (number < EMTR_SOURCE_SPARSE || number > EMTR_TARGET_FEATURE_ROWS)
      throw emtr::Error(EMTR_ERROR_ARGUMENT, "array: there is none of that number");
    const emtr::ProblemArrays::View array = arrays.view(which);
    required(data, "data") = array.data;
    required(rows, "rows") = array.rows;
    required(columns, "columns") = array.columns;
  });
}

}  // extern "C"
