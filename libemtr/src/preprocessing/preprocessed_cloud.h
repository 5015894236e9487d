#pragma once

#include <emtr/emtr.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "preprocessing/base_points.h"
#include "preprocessing/keypoints.h"

namespace emtr {

/// What is known of one cloud before it meets a partner, so that it can be kept for many of them.
/// Does not change, so threads may share it.
class PreprocessedCloud {
 public:
  /// Reads the caller's memory in passes and keeps nothing of it. Errors begin with `name`, or
  /// with "cloud" when it is empty. Throws Error when the cloud cannot be registered.
  PreprocessedCloud(const emtr_cloud& cloud, const std::string& name, int threads);

  std::size_t count = 0;    ///< finite points
  std::size_t dropped = 0;  ///< points with a NaN or an infinity
  double center[3] = {};    ///< centroid, the user's unit
  double radius = 0;        ///< largest distance from it, the user's unit
  /// (p - center) / radius: all finite points, or, of a large cloud, their centroids in cubes far
  /// smaller than any that the densities come down to.
  Cloud base;
  Cloud normals;              ///< of the base points, see BasePoints; empty when none were given
  Keypoints described;  ///< those that came with descriptors

  /// Where a row of the caller's array lies, (p - center) / radius; false when it was dropped.
  /// Throws Error when the cloud was thinned and did not ask to keep its points.
  bool find(std::size_t row, float p[3]) const;
  std::size_t rows() const { return count + dropped; }  ///< of the caller's array

  /// Mean distance of a base point to its nearest other; made when first asked for. Nobody waits
  /// for another who makes it, to the same bits: that one may be asking its caller just now, who
  /// may come back with this cloud.
  double spacing() const;

 private:
  const std::string title_;
  Cloud kept_;                        ///< all finite points of a thinned cloud that keeps them
  std::vector<std::int64_t> finite_;  ///< the caller's rows of all finite points, when some are not
  mutable std::atomic<double> spacing_{-1};
};

using PreprocessedCloudPtr = std::shared_ptr<const PreprocessedCloud>;

}  // namespace emtr
