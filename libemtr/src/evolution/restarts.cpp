#include "evolution/restarts.h"

#include <algorithm>

namespace emtr {

void Restarts::after(int iteration, Swarm& poses, Swarm& rotations) {
  if (patience_ == 0) return;
  stagnant_ = poses.gbest_fitness() < best_ ? 0 : stagnant_ + 1;
  best_ = poses.gbest_fitness();
  if (stagnant_ < patience_) return;
  stagnant_ = 0;
  for (const std::size_t i : poses.worst(share_)) {
    keep(poses, i);
    poses.restart(i, iteration);
  }
  for (const std::size_t i : rotations.worst(share_)) rotations.restart(i, iteration);
  std::stable_sort(left_.begin(), left_.end(),
                   [](const Left& a, const Left& b) { return a.fitness < b.fitness; });
  left_.resize(std::min(left_.size(), poses.size()));
}

void Restarts::keep(const Swarm& poses, std::size_t particle) {
  Left left{{}, poses.best_fitness(particle)};
  std::copy_n(poses.best_position(particle), poses.dimensions(), left.position.begin());
  left_.push_back(left);
}

}  // namespace emtr
