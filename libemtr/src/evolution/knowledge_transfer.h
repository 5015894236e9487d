#pragma once

#include <array>
#include <cstdint>

#include "evolution/knowledge_complement.h"
#include "evolution/search_space.h"
#include "evolution/swarm.h"
#include "settings/settings.h"

namespace emtr {

/// Knowledge transfer: mixes a guide for each swarm out of both gbests. The guide replaces gbest in
/// the velocities of one iteration; pbest and gbest do not change.
class KnowledgeTransfer {
 public:
  /// `arc`: rotations are mixed along the shortest arc between them, instead of gene by gene.
  KnowledgeTransfer(const KnowledgeComplement& complement, const SearchSpace& space,
                    const Settings& settings, bool arc)
      : complement_(complement), space_(space), settings_(settings), arc_(arc) {}

  struct Guides {  ///< as many numbers as the swarm has genes
    std::array<double, 6> alpha;
    std::array<double, 3> beta;
  };

  /// Returns the guides of an iteration without a transfer: each gbest guides its own swarm.
  static Guides own(const Swarm& alpha, const Swarm& beta);

  /// Tells whether there is a transfer in this iteration, for both directions at once, with chance
  /// rmp.
  bool due(int iteration) const;

  /// Returns the guides of an iteration with a transfer: la gbest_alpha + (1 - la) (gbest_beta
  /// completed) for alpha, and likewise with alpha's rotation and lb for beta. Computes the
  /// complement again only when beta's gbest has changed. Of the many angles for one rotation it
  /// mixes those that are nearest to the receiver's.
  Guides exchange(int iteration, const Swarm& alpha, const Swarm& beta, bool beta_changed);

  std::uint64_t queries() const { return queries_; }

 private:
  /// Mixes the rotation of a guide: `share` of the swarm's own, the rest of the other's.
  void mix(const double* own, const double* other, double share, double* out) const;

  const KnowledgeComplement& complement_;
  const SearchSpace& space_;
  Settings settings_;
  bool arc_;
  bool known_ = false;
  std::array<double, 3> translation_{};
  std::uint64_t queries_ = 0;
};

}  // namespace emtr
