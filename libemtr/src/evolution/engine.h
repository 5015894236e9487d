#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "evolution/knowledge_complement.h"
#include "evolution/search_space.h"
#include "evolution/swarm.h"
#include "tasks/task_alpha.h"
#include "tasks/task_beta.h"

namespace emtr {

/// A pose that a particle of task alpha remembers.
struct Hypothesis {
  Rigid pose;      ///< normalized frame
  double fitness;  ///< task alpha's, at `resolution` of the evolution
};

/// Poses at which the first particles of both swarms start.
struct Starts {
  std::vector<Rigid> guesses;  ///< the user's
  std::vector<Rigid> seeds;    ///< of the correspondences
};

/// The result of an evolution.
struct Evolution {
  /// The pbests of task alpha; empty when the run was stopped before the first.
  std::vector<Hypothesis> hypotheses;
  std::size_t best = 0;  ///< which of them is gbest
  emtr_resolution resolution = EMTR_RESOLUTION_SPARSE;
  bool stopped = false;
  std::vector<double> history_alpha, history_beta;  ///< gbest's fitness after each iteration
  std::uint64_t queries_evaluation = 0, queries_switch = 0, queries_complement = 0;
};

/// Called after each iteration with how many are done and the fitness of both gbests; returns true
/// to stop.
using OnIteration = std::function<bool(int, double, double)>;

/// Tells whether an evolution that starts from seeds may end once gbest stays in one place.
inline bool may_stall(const Settings& settings) {
  return settings.candidates > 0 && settings.stall_iterations > 0;
}

/// Evolves both swarms together (Algorithm 1), in parallel over the particles of both tasks. All
/// particles keep to the prior, unless it is null.
Evolution evolve(const TaskAlpha& alpha, const TaskBeta& beta,
                 const KnowledgeComplement& complement, const Settings& settings,
                 const Starts& starts, const OnIteration& on_iteration, const Prior* prior);

}  // namespace emtr
