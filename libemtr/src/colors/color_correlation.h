#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "colors/channels.h"
#include "geometry/rigid.h"
#include "neighbors/neighbors.h"

namespace emtr {

/// What the colors of two clouds say of a pose.
struct ColorEvidence {
  double correlation = 0;  ///< of both colors where the clouds overlap, the channels' mean by what
                           ///< each one says; -1 to 1
  /// Logarithm of the likelihood of these colors if they are correlated as they are, by that if
  /// they are unrelated: - n / 2 ln(1 - r^2), summed over the channels, n the number of independent
  /// points. Below 0 for colors that contradict each other.
  double evidence = 0;
  double overlap = 0;  ///< share of the source's points with a color that lie on the target
};

/// Compares the colors of two clouds under a pose: each point of the source with the nearest of
/// the target. Gain and offset of the exposure are free, as a correlation is blind to them.
class ColorCorrelation {
 public:
  struct Scratch {
    std::vector<float> x, y, z, squared;
    std::vector<std::int32_t> index;
  };

  /// Clouds with a color for each point, both downsampled by one leaf. At most `maximum_queries`
  /// points of the source are looked at, evenly over their order. The kernels must outlive it.
  ColorCorrelation(const Cloud& source, const Cloud& target, Channels channels, double leaf,
                   std::size_t maximum_queries, const Kernels& kernels);

  /// Takes the number of independent points by the correlograms of the whole clouds: quick.
  ColorEvidence evaluate(const Rigid& pose, Scratch& scratch) const;

  /// Takes it by the correlograms of the points that overlap under this pose, and channels that are
  /// independent there: where they show one edge only, they say little, whatever the rest of the
  /// clouds shows.
  ColorEvidence evaluate_locally(const Rigid& pose, Scratch& scratch) const;

  double leaf() const { return leaf_; }

 private:
  std::size_t match(const Rigid& pose, Scratch& scratch) const;
  double most_effective() const;

  const Kernels& kernels_;
  const double leaf_;
  const bool used_[3];
  Cloud queries_, colors_, target_;
  Cloud target_colors_;
  std::unique_ptr<Neighbors> near_target_;
  double effective_[3] = {};  ///< independent points of the whole source, by channel
};

}  // namespace emtr
