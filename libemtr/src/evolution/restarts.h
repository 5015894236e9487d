#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "evolution/swarm.h"

namespace emtr {

/// Restarts on stagnation: when gbest of task alpha has not become better for `patience`
/// iterations, the share of either swarm with the worst pbests is drawn anew. Both gbests stay.
class Restarts {
 public:
  /// What a particle of task alpha remembered before it was drawn anew.
  struct Left {
    std::array<double, 6> position;
    double fitness;
  };

  /// `patience` 0: never.
  Restarts(int patience, double share) : patience_(patience), share_(share) {}

  /// To be called after each iteration.
  void after(int iteration, Swarm& poses, Swarm& rotations);

  /// The best of them, no more than the swarm has particles.
  std::vector<Left>& left() { return left_; }

  /// Fitness of before cannot be compared with any from now on.
  void objective_changed() { best_ = HUGE_VAL; }

 private:
  void keep(const Swarm& poses, std::size_t particle);

  int patience_;
  double share_;
  int stagnant_ = 0;  // iterations
  double best_ = HUGE_VAL;
  std::vector<Left> left_;
};

}  // namespace emtr
