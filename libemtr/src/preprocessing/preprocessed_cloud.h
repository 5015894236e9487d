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
#include "util/recent_memo.h"

namespace emtr {

/// All that is known of one cloud before it meets the other, so that it can be cached and
/// registered with many others. It never changes, so threads may share it.
class PreprocessedCloud {
 public:
  /// Reads the user's memory in passes and keeps no reference to it. Throws Error when the cloud
  /// cannot be registered; the message begins with `name`, or with "cloud" when it is empty.
  PreprocessedCloud(const emtr_cloud& cloud, const std::string& name, int threads);

  std::size_t count = 0;    ///< finite points
  std::size_t dropped = 0;  ///< points with a NaN or an infinity
  /// Finite points that it leaves out: far outside of all the others or, in a cloud of at most 3000
  /// points, scattered off its surface.
  std::size_t strays = 0;
  double center[3] = {};  ///< centroid, the user's unit
  double radius = 0;      ///< largest distance from it, the user's unit
  /// (p - center) / radius: all finite points but strays or, for a large cloud, their centroids in
  /// voxels far smaller than those of any downsampled cloud.
  Cloud base;
  Cloud normals;  ///< of the base points, see BasePoints; empty when the user provided none
  Cloud colors;   ///< of the base points, see ColorReader; empty when the user provided none
  ColorKind color_kind = ColorKind::None;
  Keypoints keypoints;  ///< points with the user's descriptors

  /// Returns all finite points but strays where they are kept, in the frame of the base points;
  /// else the base points.
  const Cloud& finest() const { return all_points_.size() ? all_points_ : base; }

  /// Writes the position of a row of the user's array, (p - center) / radius; returns false when
  /// the row was dropped or is a stray. Throws Error when the cloud was downsampled and did not ask
  /// to keep its points.
  bool find(std::size_t row, float p[3]) const;
  /// Tells whether a row of the user's array is a stray; find() must be able to tell its position.
  bool is_stray(std::size_t row) const;
  std::size_t rows() const { return count + dropped; }  ///< of the user's array

  /// Returns the mean distance of a base point to its nearest other, computed at the first call. No
  /// thread waits for another that computes it, which gets the same bits: that thread may be in its
  /// progress callback, and the callback may register this very cloud.
  double spacing() const;

  /// What the stages have made of the cloud, see NormalizedPair::remembered(). Few clouds of a
  /// process remember, those that were used last.
  Memo& memo() const { return memo_.use(); }

  /// Returns the same cloud with all lengths multiplied, about the origin of the user's frame.
  std::shared_ptr<const PreprocessedCloud> rescaled(double factor) const;

 private:
  /// A number that is computed once, by whoever asks first.
  struct Cached : std::atomic<double> {
    Cached() : std::atomic<double>(-1) {}
    Cached(const Cached& other) : std::atomic<double>(other.load()) {}
  };

  void leave_out_scattered();

  const std::string title_;
  Cloud all_points_;                  ///< the finite points of a downsampled cloud that keeps them
  bool whole_ = false;                ///< the base points are all points
  std::vector<std::int64_t> finite_;  ///< the user's rows of all points, when some are left out
  std::vector<std::int64_t> strays_;  ///< the user's rows of the strays
  mutable Cached spacing_;
  mutable RecentMemo memo_;
};

using PreprocessedCloudPtr = std::shared_ptr<const PreprocessedCloud>;

}  // namespace emtr
