#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "tasks/task_alpha.h"
#include "tasks/task_beta.h"
#include "evolution/knowledge_complement.h"
#include "evolution/search_space.h"
#include "evolution/swarm.h"

namespace emtr {

/// A pose that some particle of task alpha remembers.
struct Hypothesis {
  Rigid pose;      ///< normalized frame
  double fitness;  ///< task alpha's, at `stage` of the evolution
};

/// Poses that take the first particles' places in both swarms, as many as there are.
struct Starts {
  std::vector<Rigid> guesses;  ///< the caller's
  std::vector<Rigid> seeds;    ///< the matches'
};

/// What the evolution leaves behind.
struct Evolution {
  /// Pbests of alpha, also those from before a restart; empty if stopped before the first.
  std::vector<Hypothesis> hypotheses;
  std::size_t best = 0;  ///< gbest among them
  emtr_stage stage = EMTR_STAGE_SPARSE;
  bool stopped = false;
  std::vector<double> history_alpha, history_beta;  ///< gbest's fitness after each iteration
  std::uint64_t queries_evaluation = 0, queries_switch = 0, queries_complement = 0;
};

/// Called after each iteration with the number done and both gbests' fitness; true stops.
using OnIteration = std::function<bool(int, double, double)>;

/// Algorithm 1: both swarms evolve together, work spread over the particles of both tasks.
/// `prior`: what all particles are to keep to, or null.
Evolution evolve(const TaskAlpha& alpha, const TaskBeta& beta,
                 const KnowledgeComplement& complement, const Settings& settings,
                 const Starts& starts, const OnIteration& on_iteration, const Prior* prior);

}  // namespace emtr
