#pragma once

#include <memory>
#include <vector>

#include "evolution/swarm.h"
#include "priors/prior.h"

namespace emtr {

/// Decodes the genes of both swarms. Without a prior they are three Euler angles and a translation.
/// With a prior their ranges cover the admissible poses and little else, and every pose that they
/// decode to is admissible. A rotation is then
///  * the angle about the prior's axis, with two components of a tilt where the axis may lean, or
///  * a rotation vector from the middle of the prior's smallest ball, or
///  * the Euler angles.
/// Along an axis of coordinates where a box is the narrowest limit, the translation is that of the
/// user's matrix, less a constant.
class SearchSpace {
 public:
  SearchSpace(double translation_bound, const Prior* prior);

  std::size_t angles() const { return rotation_genes_.size(); }  ///< genes of a rotation: 1 or 3

  std::vector<Gene> rotation_genes() const { return rotation_genes_; }  ///< of task beta
  std::vector<Gene> pose_genes() const;  ///< of task alpha: these and a translation

  Eigen::Matrix3d rotation(const double* genes) const;
  Rigid pose(const double* genes) const;
  void encode(const Rigid& pose, double* genes) const;
  void encode_translation(const Rigid& pose, double* genes) const;  ///< the last three

  /// Writes, of all genes for the same rotation, those nearest to `reference`.
  void nearest_alias(const double* genes, const double* reference, double* out) const;

  /// Writes the rotation that lies `share` of the way along the shortest arc from one to another,
  /// as the genes nearest to `from`.
  void arc(const double* from, const double* to, double share, double* out) const;

  /// Tells whether a rotation's genes are Euler angles: the prior does not limit it.
  bool has_euler_angles() const { return chart_ == Chart::Euler; }

  const Prior* prior() const { return prior_; }

 private:
  enum class Chart { Euler, Axis, Vector };

  void make_translation_genes(double bound);
  Eigen::Quaterniond rotated(const double* genes) const;
  Eigen::Vector3d lever_translation(const Eigen::Matrix3d& R) const;

  const Prior* prior_;
  Chart chart_ = Chart::Euler;
  std::vector<Gene> rotation_genes_, translation_genes_;
  Arc angle_;                  // about the axis, with Chart::Axis
  Eigen::Vector3d e1_, e2_;    // directions of its tilts
  Eigen::Quaterniond center_;  // with Chart::Vector
  bool of_matrix_[3] = {false, false,
                        false};  // genes that are the translation of the user's matrix
};

}  // namespace emtr
