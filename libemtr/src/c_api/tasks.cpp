#include <emtr/emtr.h>

#include <string>
#include <vector>

#include "c_api/arguments.h"
#include "c_api/guarded.h"
#include "c_api/handles.h"
#include "geometry/euler.h"
#include "util/enum_number.h"
#include "util/thread_team.h"

using emtr::checked;
using emtr::guarded;
using emtr::required;

namespace {

void require_near(const double* values, std::size_t count, const char* name) {
  if (!emtr::is_near(values, count))
    throw emtr::Error(EMTR_ERROR_ARGUMENT, std::string(name) + ": not finite or beyond 1e6");
}

/// Evaluates n particles of `genes` numbers in parallel, on as many threads as the problem uses.
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
  const int threads = emtr::thread_count(problem.data->settings);
  std::vector<emtr::TaskAlpha::Scratch> scratch(static_cast<std::size_t>(threads));
  emtr::ThreadTeam::with(threads, [&](emtr::ThreadTeam& team) {
    team.parallel(n, [&](std::size_t i, std::size_t thread) {
      fitness[i] = score(particles + genes * i, scratch[thread]);
    });
  });
}

}  // namespace

extern "C" {

emtr_status emtr_task_alpha_evaluate(emtr_problem* problem, emtr_resolution resolution,
                                     const double* particles, size_t count, double* fitness) {
  return guarded([&] {
    emtr_problem& p = checked(problem);
    const int number = emtr::number_of(resolution);
    if (number != EMTR_RESOLUTION_SPARSE && number != EMTR_RESOLUTION_DENSE)
      throw emtr::Error(EMTR_ERROR_ARGUMENT,
                        "resolution must be EMTR_RESOLUTION_SPARSE or EMTR_RESOLUTION_DENSE");
    evaluate_all(p, particles, count, 6, fitness,
                 [&](const double* particle, emtr::TaskAlpha::Scratch& scratch) {
                   return p.data->alpha->evaluate(resolution, emtr::decode(particle), scratch);
                 });
    p.queries += count * p.data->alpha->queries(resolution);
  });
}

emtr_status emtr_task_beta_evaluate(emtr_problem* problem, const double* particles, size_t count,
                                    double* fitness) {
  return guarded([&] {
    const emtr_problem& p = checked(problem);
    evaluate_all(p, particles, count, 3, fitness,
                 [&](const double* angles, emtr::TaskAlpha::Scratch&) {
                   return p.data->beta->evaluate(emtr::euler_to_rotation(angles));
                 });
  });
}

emtr_status emtr_complement(emtr_problem* problem, const double angles[3], double translation[3]) {
  return guarded([&] {
    emtr_problem& p = checked(problem);
    require_near(&required(angles, "angles"), 3, "angles");
    Eigen::Vector3d::Map(&required(translation, "translation")) =
        p.data->complement->translation(emtr::euler_to_rotation(angles), p.data->prior.get());
    p.queries += p.data->complement->queries();
  });
}

emtr_status emtr_particle_to_transformation(const emtr_problem* problem, const double particle[6],
                                            double transformation[16]) {
  return guarded([&] {
    require_near(&required(particle, "particle"), 6, "particle");
    const emtr::Rigid pose =
        checked(problem).data->pair.normalization.to_user(emtr::decode(particle));
    emtr::to_matrix(pose, &required(transformation, "transformation"));
  });
}

emtr_status emtr_transformation_to_particle(const emtr_problem* problem,
                                            const double transformation[16], double particle[6]) {
  return guarded([&] {
    const emtr::Rigid pose = checked(problem).data->pair.normalization.to_normalized(
        emtr::checked_pose(&required(transformation, "transformation")));
    emtr::encode(pose, &required(particle, "particle"));
  });
}

}  // extern "C"
