#pragma once

#include <vector>

#include "colors/color_correlation.h"
#include "colors/free_motions.h"
#include "priors/prior.h"
#include "refinement/fine_surfaces.h"
#include "util/thread_team.h"

namespace emtr {

/// Both clouds' colors, coarse to fine, for searches.
class ColorLevels {
 public:
  static constexpr double kCoarseLeaf = 0.08, kMiddleLeaf = 0.03;  ///< radii

  /// Takes the fine surfaces and their channels. The kernels must outlive it.
  ColorLevels(const FineSurfaces& fine, const Channels& channels, const Kernels& kernels);

  const ColorCorrelation& coarse() const { return coarse_; }
  const ColorCorrelation& middle() const { return middle_; }
  const ColorCorrelation& fine() const { return fine_; }

 private:
  ColorCorrelation coarse_, middle_, fine_;
};

struct FoundByColor {
  std::vector<Rigid> poses;   ///< where the colors agree best, the best first
  std::size_t looked_at = 0;  ///< places of the lattice
};

/// Searches poses along motions that the surfaces leave unconstrained, up to three: each place of a
/// lattice is judged by coarse colors, the best of them are moved uphill by finer ones. At most
/// `maximum_count` different poses. Finds none where there are no free motions, or more than three.
FoundByColor search_by_color(const ColorLevels& levels, const FreeMotions& motions,
                             const Prior* prior, std::size_t maximum_count, ThreadTeam& team);

}  // namespace emtr
