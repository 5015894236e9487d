#pragma once

#include <emtr/emtr.h>

#include <memory>
#include <vector>

#include "geometry/cloud.h"
#include "geometry/ladder.h"
#include "geometry/similarity.h"
#include "preprocessing/preprocessed_cloud.h"

namespace emtr {

/// The map into the normalized frame: it centers each cloud on its own centroid and divides both by
/// one scale, the larger of the two radii or the rung above it, so that all points lie in the unit
/// ball.
struct Normalization {
  double scale = 1;              ///< the user's unit
  double center_source[3] = {};  ///< the user's unit
  double center_target[3] = {};

  /// Returns the pose in the user's unit of one in the normalized frame.
  Rigid to_user(const Rigid& pose) const;
  Similarity to_user(const Similarity& similarity) const;
  /// Returns the pose in the normalized frame of one in the user's unit.
  Rigid to_normalized(const Rigid& pose) const;
};

/// Both clouds in the normalized frame, and the preprocessed clouds that they come from.
struct NormalizedPair {
  Normalization normalization;
  Cloud source, target;  ///< the base points; scaled
  PreprocessedCloudPtr preprocessed_source, preprocessed_target;
  bool extruded = false;  ///< from two dimensions, see extrude_flat_pair()
  bool ladder = false;    ///< the scale is a rung, and leaves are to be

  /// Returns the leaf that stands for one, both in the normalized frame.
  double leaf(double wanted) const { return ladder ? Ladder::nearest(wanted) : wanted; }
  /// Returns the leaf that stands for one in radii of the larger cloud.
  double leaf_of_radii(double leaf) const;

  /// Returns what make() makes of the points of one side, 0 the source, and of the arguments alone;
  /// from the memory of that cloud where it made the same before, beside whichever other cloud.
  template <class Value, class Make>
  std::shared_ptr<const Value> remembered(int side, std::vector<double> arguments,
                                          const Make& make) const {
    const PreprocessedCloudPtr& cloud = side == 0 ? preprocessed_source : preprocessed_target;
    if (!cloud || extruded) return std::make_shared<const Value>(make());
    arguments.push_back(cloud->radius / normalization.scale);
    return cloud->memo().get<Value>(arguments, make);
  }
};

/// Returns all coordinates times a factor.
Cloud scale_cloud(const Cloud& cloud, double factor);

/// Returns the mean distance of a cloud's base point to its nearest other, in the normalized frame.
double spacing(const PreprocessedCloud& cloud, const Normalization& normalization);

/// Normalizes both clouds. With `ladder` the scale is the next larger rung.
NormalizedPair normalize(PreprocessedCloudPtr source, PreprocessedCloudPtr target,
                         bool ladder = false);

/// Tells whether both clouds came with normals, so that for both the side is known to which they
/// point. Beside estimated normals, the user's are no more than directions.
bool trust_normals(const NormalizedPair& pair);

/// Preprocesses the two clouds, named source and target, one after the other, and normalizes them.
NormalizedPair normalize(const emtr_cloud& source, const emtr_cloud& target, int threads);

}  // namespace emtr
