#pragma once

#include <array>
#include <limits>
#include <vector>

#include "geometry/cloud.h"
#include "settings/settings.h"

namespace emtr {

constexpr int kFeatureSize = 33;  ///< bins of FPFH

/// Normals (n, 3) and FPFH descriptors (n, 33) of a cloud, row-major; NaN where a point has too few
/// neighbors.
struct Features {
  std::vector<float> normals;
  std::vector<float> descriptors;

  bool valid(std::size_t i) const {
    const float first = descriptors[i * kFeatureSize];
    return first == first;
  }
};

/// The code that computes the features, which have one definition.
enum class FeatureBackend {
  Pcl = EMTR_FEATURES_PCL,   ///< PCL's functions
  Simd = EMTR_FEATURES_SIMD  ///< the kernels: an entry may fall on the other side of a bin's edge
};

/// Lengths in the normalized frame.
struct FeatureDefinition {
  double normal_radius, feature_radius;        ///< the second at least as large as the first
  std::array<float, 3> viewpoint = {0, 0, 0};  ///< normals point to it; the centroid by default
  FeatureBackend backend = FeatureBackend::Pcl;
  bool trust_normals = true;  ///< the user's keep the side they point to, else the viewpoint's
  bool normals_only = false;  ///< no descriptors

  /// All of it, to tell one definition from another.
  std::vector<double> numbers() const;
};

/// Returns the definition that the settings ask for on a cloud downsampled by that leaf.
FeatureDefinition feature_definition(const Settings& settings, double leaf);

/// Computes normals as pcl::NormalEstimationOMP and descriptors as pcl::FPFHEstimationOMP, the
/// latter from the points that have a normal. The cloud is finite. The result does not depend on
/// the kernels or the threads. Uses `normals`, unless empty, instead of estimated ones: one for
/// each point, NaN where there is none.
Features describe(const Cloud& cloud, const FeatureDefinition& definition, const Kernels& kernels,
                  int threads, const Cloud& normals = {});

/// Returns the features of the cloud with all normals reversed: the first and the last of the three
/// histograms are reversed, the second stays.
Features mirrored(const Features& features);

}  // namespace emtr
