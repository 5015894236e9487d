#pragma once

#include <memory>
#include <vector>

#include "priors/prior.h"
#include "evolution/swarm.h"

namespace emtr {

/// What the genes of both swarms mean. Without a prior a rotation is three Euler angles and a
/// translation itself. With one the genes' ranges cover the admissible poses and little else, and
/// what they decode to is admissible: a rotation is the angle about the prior's axis, and two
/// components of a tilt where it may lean; or a rotation vector from the middle of the prior's
/// smallest ball; or the Euler angles. A translation is that of the user's matrix, less a constant,
/// along an axis of coordinates where a box is narrower than what else is known.
class SearchSpace {
 public:
  SearchSpace(double translation_bound, const Prior* prior);

  std::size_t angles() const { return rotation_genes_.size(); }  ///< genes of a rotation, 1 or 3

  std::vector<Gene> rotation_genes() const { return rotation_genes_; }  ///< task beta's
  std::vector<Gene> pose_genes() const;  ///< task alpha's: the same, then three of a translation

  Eigen::Matrix3d rotation(const double* genes) const;
  Rigid pose(const double* genes) const;
  void encode(const Rigid& pose, double* genes) const;
  void encode_translation(const Rigid& pose, double* genes) const;  ///< those three alone

  /// Of all genes for the same rotation those nearest to `reference`.
  void nearest_alias(const double* genes, const double* reference, double* out) const;

  /// The rotation that lies `share` of the way from one to another, along the shortest arc, as the
  /// genes for it nearest to `from`.
  void arc(const double* from, const double* to, double share, double* out) const;

  /// Whether a rotation's genes are Euler angles: no limit of the rotation is known.
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
  Arc angle_;                  // of Chart::Axis
  Eigen::Vector3d e1_, e2_;    // of its tilts
  Eigen::Quaterniond center_;  // of Chart::Vector
  bool of_matrix_[3] = {false, false, false};
};

}  // namespace emtr
