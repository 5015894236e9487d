#include "swarm.h"

#include <algorithm>
#include <cmath>

namespace emtr {

std::vector<Gene> rotation_genes() {
  constexpr double pi = 3.14159265358979323846;
  return {{-pi, pi, false}, {-pi / 2, pi / 2, false}, {-pi, pi, false}};
}

std::vector<Gene> pose_genes(double bound) {
  std::vector<Gene> genes = rotation_genes();
  genes.insert(genes.end(), 3, {-bound, bound, true});
  return genes;
}

Swarm::Swarm(std::vector<Gene> genes, const Settings& settings, Stream stream)
    : genes_(std::move(genes)), settings_(settings), stream_(stream) {
  const auto population = static_cast<std::size_t>(settings.population);
  const std::size_t d = genes_.size();
  position_.resize(population * d);
  velocity_.resize(population * d);
  fitness_.assign(population, HUGE_VAL);
  best_fitness_.assign(population, HUGE_VAL);
  for (std::size_t i = 0; i < population; ++i)
    for (std::size_t k = 0; k < d; ++k) {
      const auto word = draw(settings.seed, 0, stream, i, k);
      const double range = genes_[k].high - genes_[k].low;
      position_[i * d + k] = genes_[k].low + range * uniform(word[0]);
      velocity_[i * d + k] = settings.velocity_limit * range * (2 * uniform(word[1]) - 1);
    }
  best_position_ = position_;
}

void Swarm::place(std::size_t i, const double* position) {
  std::copy_n(position, dimensions(), &position_[i * dimensions()]);
}

bool Swarm::update_bests() {
  const std::size_t d = dimensions();
  std::size_t best = gbest_;
  bool moved = false;
  for (std::size_t i = 0; i < size(); ++i) {
    if (fitness_[i] < best_fitness_[i]) {
      best_fitness_[i] = fitness_[i];
      std::copy_n(&position_[i * d], d, &best_position_[i * d]);
      moved |= i == gbest_;
    }
    if (best_fitness_[i] < best_fitness_[best]) best = i;
  }
  moved |= best != gbest_;
  gbest_ = best;
  return moved;
}

void Swarm::move(int iteration, double inertia, const double* guide) {
  const std::size_t d = dimensions();
  for (std::size_t i = 0; i < size(); ++i)
    for (std::size_t k = 0; k < d; ++k) {
      const Gene& gene = genes_[k];
      // Iteration 0 of the counter was the initial population's.
      const auto word =
          draw(settings_.seed, static_cast<std::uint64_t>(iteration) + 1, stream_, i, k);
      double& x = position_[i * d + k];
      double& v = velocity_[i * d + k];
      const double limit = settings_.velocity_limit * (gene.high - gene.low);
      v = inertia * v + settings_.cognitive * uniform(word[0]) * (best_position_[i * d + k] - x) +
          settings_.social * uniform(word[1]) * (guide[k] - x);
      v = std::clamp(v, -limit, limit);
      x += v;
      if (gene.wall && (x < gene.low || x > gene.high)) {
        x = std::clamp(x, gene.low, gene.high);
        v = 0;
      }
    }
}

}  // namespace emtr
