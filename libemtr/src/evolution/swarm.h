#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "evolution/philox.h"
#include "evolution/rotation_step.h"
#include "settings/settings.h"

namespace emtr {

/// The range that a gene is drawn from. A `wall` also stops it at the ends: a translation stays in
/// its box, an angle is periodic and needs none.
struct Gene {
  double low, high;
  bool wall;
};

std::vector<Gene> rotation_genes();                      ///< of task beta: three angles
std::vector<Gene> pose_genes(double translation_bound);  ///< of task alpha: six

/// A population of particle swarm optimization, which minimizes. Does not know what a particle
/// means, except that its first three genes are Euler angles when they step by rotation vectors.
class Swarm {
 public:
  Swarm(std::vector<Gene> genes, const Settings& settings, Stream stream, RotationSteps steps);

  std::size_t size() const { return fitness_.size(); }
  std::size_t dimensions() const { return genes_.size(); }

  const double* position(std::size_t i) const { return &position_[i * dimensions()]; }
  const double* best_position(std::size_t i) const { return &best_position_[i * dimensions()]; }
  double best_fitness(std::size_t i) const { return best_fitness_[i]; }

  /// Places a particle, before the first evaluation.
  void place(std::size_t i, const double* position);

  /// The fitness of each position, to be written by the caller from any thread, each i once.
  std::vector<double>& fitness() { return fitness_; }
  /// Replaces the pbests' fitness after the objective has changed (lines 22-26 of Algorithm 1).
  void set_best_fitness(const std::vector<double>& fitness) { best_fitness_ = fitness; }

  /// Updates each pbest whose position is better, then gbest. Returns true when gbest moved.
  bool update_bests();

  std::size_t gbest() const { return gbest_; }
  const double* gbest_position() const { return best_position(gbest_); }
  double gbest_fitness() const { return best_fitness_[gbest_]; }

  /// Moves all particles: v <- w v + c1 r1 (pbest - x) + c2 r2 (guide - x), x <- x + v. For
  /// rotations that step by vectors, v and both differences are rotation vectors, and the sum is
  /// exp(v) R(x).
  void move(int iteration, double inertia, const double* guide);

 private:
  void draw_particle(std::size_t i);
  double velocity_limit(std::size_t gene) const;
  void difference(const double* from, const double* to, double* out) const;
  void advance(double* position, double* velocity) const;

  std::vector<Gene> genes_;
  Settings settings_;
  Stream stream_;
  std::size_t vector_genes_;  // leading genes that step by a rotation vector, 0 or 3
  std::vector<double> position_, velocity_, best_position_;
  std::vector<double> fitness_, best_fitness_;
  std::size_t gbest_ = 0;
};

}  // namespace emtr
