#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "candidates/upright_points.h"
#include "kernels/search_kernels.h"
#include "util/constants.h"

namespace emtr {

constexpr int kYaws = 180;  ///< rotations about the normal of a plane
constexpr double kYawStep = 2 * kPi / kYaws;

/// The pairs of a source and a target point at one height, by the rotation about the normal that
/// makes both face the same way.
class YawPairs {
 public:
  using Pair = VotePair;

  YawPairs(const std::vector<UprightPoint>& source, const std::vector<UprightPoint>& target);

  /// Returns those whose rotation is in this step. Steps 180 degrees apart have the same ones.
  const std::vector<Pair>& of(int step) const;

 private:
  std::array<std::vector<Pair>, kYaws / 2> pairs_;
};

/// A translation along the planes for which many pairs vote.
struct TranslationPeak {
  int votes;
  int yaw;      ///< steps of kYawStep
  double x, y;  ///< radii
};

/// Returns the translations of most votes at one rotation, the best first.
std::vector<TranslationPeak> vote_for_translations(const std::vector<UprightPoint>& source,
                                                   const std::vector<UprightPoint>& target,
                                                   const YawPairs& pairs, int yaw,
                                                   const Kernels& kernels);

}  // namespace emtr
