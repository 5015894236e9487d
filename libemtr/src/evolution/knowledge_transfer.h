#pragma once

#include <array>
#include <cstdint>

#include "settings/settings.h"
#include "evolution/knowledge_complement.h"
#include "evolution/search_space.h"
#include "evolution/swarm.h"

namespace emtr {

/// Knowledge transfer: what guides each swarm in one iteration. The guide takes
/// gbest's place in the velocities of that iteration only; pbest and gbest stay as they are.
class KnowledgeTransfer {
 public:
  /// `arc`: along the shortest arc between both rotations, instead of gene by gene.
  KnowledgeTransfer(const KnowledgeComplement& complement, const SearchSpace& space,
                    const Settings& settings, bool arc)
      : complement_(complement), space_(space), settings_(settings), arc_(arc) {}

  struct Guides {  ///< as many of them as the swarm has genes
    std::array<double, 6> alpha;
    std::array<double, 3> beta;
  };

  /// Without a transfer each gbest guides its own swarm.
  static Guides own(const Swarm& alpha, const Swarm& beta);

  /// Whether there is a transfer in this iteration: once for both directions, with chance rmp.
  bool due(int iteration) const;

  /// gbest_alpha_new = la gbest_alpha + (1 - la) (gbest_beta completed); beta likewise from
  /// alpha's rotation with lb. The complement is worked out again only when beta's gbest has
  /// changed. Of the many angles for one rotation the nearest to the receiver's are mixed in.
  Guides exchange(int iteration, const Swarm& alpha, const Swarm& beta, bool beta_changed);

  std::uint64_t queries() const { return queries_; }

 private:
  /// The rotation of a guide: `share` of one's own, the rest of the other's.
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
