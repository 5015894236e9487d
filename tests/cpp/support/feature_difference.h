#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "features/fpfh.h"

namespace emtr_test {

/// How far two descriptions of the same points differ.
struct FeatureDifference {
  std::size_t entries = 0, moved = 0;  ///< of descriptors; moved by more than 1e-3 of 100
  std::size_t part_moved[3] = {0, 0, 0};
  std::size_t only_one = 0;    ///< points that have a normal or a descriptor in only one of both
  double largest = 0;          ///< difference of an entry
  std::vector<double> angles;  ///< between the normals, ascending, radians

  double share() const { return static_cast<double>(moved) / static_cast<double>(entries); }
  double part_share(int part) const {
    return 3 * static_cast<double>(part_moved[part]) / static_cast<double>(entries);
  }
  double angle(double quantile) const {
    return angles[static_cast<std::size_t>(quantile * static_cast<double>(angles.size() - 1))];
  }
};

inline FeatureDifference feature_difference(const emtr::Features& a, const emtr::Features& b) {
  FeatureDifference out;
  for (std::size_t i = 0; i < a.descriptors.size(); ++i) {
    const float x = a.descriptors[i], y = b.descriptors[i];
    if (std::isnan(x) != std::isnan(y)) ++out.only_one;
    if (std::isnan(x) || std::isnan(y)) continue;
    const double difference = std::abs(double{x} - double{y});
    out.largest = std::max(out.largest, difference);
    ++out.entries;
    if (difference > 1e-3) {
      ++out.moved;
      ++out.part_moved[i % emtr::kFeatureSize / 11];
    }
  }
  for (std::size_t i = 0; i < a.normals.size(); i += 3) {
    if (std::isnan(a.normals[i]) != std::isnan(b.normals[i])) ++out.only_one;
    if (std::isnan(a.normals[i]) || std::isnan(b.normals[i])) continue;
    double chord = 0;
    for (std::size_t k = 0; k < 3; ++k)
      chord += std::pow(double{a.normals[i + k]} - double{b.normals[i + k]}, 2);
    out.angles.push_back(2 * std::asin(std::min(1.0, std::sqrt(chord) / 2)));
  }
  std::sort(out.angles.begin(), out.angles.end());
  return out;
}

}  // namespace emtr_test
