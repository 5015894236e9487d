#include "evolution/swarm.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "util/constants.h"

namespace emtr {

std::vector<Gene> rotation_genes() {
  return {{-kPi, kPi, false}, {-kPi / 2, kPi / 2, false}, {-kPi, kPi, false}};
}

std::vector<Gene> pose_genes(double bound) {
  std::vector<Gene> genes = rotation_genes();
  genes.insert(genes.end(), 3, {-bound, bound, true});
  return genes;
}

Swarm::Swarm(std::vector<Gene> genes, const Settings& settings, Stream stream, RotationSteps steps)
    : genes_(std::move(genes)),
      settings_(settings),
      stream_(stream),
      vector_genes_(steps == RotationSteps::Vector ? 3 : 0) {
  const auto population = static_cast<std::size_t>(settings.population);
  position_.resize(population * dimensions());
  velocity_.resize(population * dimensions());
  fitness_.assign(population, HUGE_VAL);
  best_fitness_.assign(population, HUGE_VAL);
  for (std::size_t i = 0; i < population; ++i) draw_particle(i);
  best_position_ = position_;
}

void Swarm::draw_particle(std::size_t i) {
  const std::size_t d = dimensions();
  for (std::size_t k = 0; k < d; ++k) {
    const auto words = draw(settings_.seed, 0, stream_, i, k);
    const double range = genes_[k].high - genes_[k].low;
    position_[i * d + k] = genes_[k].low + range * uniform(words[0]);
    velocity_[i * d + k] = velocity_limit(k) * (2 * uniform(words[1]) - 1);
  }
}

double Swarm::velocity_limit(std::size_t gene) const {
  constexpr double whole_rotation = 2 * kPi;
  const double range = gene < vector_genes_ ? whole_rotation : genes_[gene].high - genes_[gene].low;
  return settings_.velocity_limit * range;
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
  std::array<double, 6> to_best, to_guide;
  for (std::size_t i = 0; i < size(); ++i) {
    double* x = &position_[i * d];
    double* v = &velocity_[i * d];
    difference(x, best_position(i), to_best.data());
    difference(x, guide, to_guide.data());
    for (std::size_t k = 0; k < d; ++k) {
      // Iteration 0 of the counter drew the initial population.
      const auto word =
          draw(settings_.seed, static_cast<std::uint64_t>(iteration) + 1, stream_, i, k);
      v[k] = inertia * v[k] + settings_.cognitive * uniform(word[0]) * to_best[k] +
             settings_.social * uniform(word[1]) * to_guide[k];
      v[k] = std::clamp(v[k], -velocity_limit(k), velocity_limit(k));
    }
    advance(x, v);
  }
}

void Swarm::difference(const double* from, const double* to, double* out) const {
  if (vector_genes_) rotation_between(from, to, out);
  for (std::size_t k = vector_genes_; k < dimensions(); ++k) out[k] = to[k] - from[k];
}

void Swarm::advance(double* x, double* v) const {
  if (vector_genes_) rotate_angles(x, v);
  for (std::size_t k = vector_genes_; k < dimensions(); ++k) {
    const Gene& gene = genes_[k];
    x[k] += v[k];
    if (gene.wall && (x[k] < gene.low || x[k] > gene.high)) {
      x[k] = std::clamp(x[k], gene.low, gene.high);
      v[k] = 0;
    }
  }
}

}  // namespace emtr
