#pragma once

#include <cstddef>
#include <vector>

#include "geometry/cloud.h"

namespace emtr {

/// How alike the values of two points of one cloud are, by the distance between them: 1, the same;
/// 0, unrelated. One value a bin of kCorrelogramBin.
using Correlogram = std::vector<double>;

constexpr double kCorrelogramBin = 0.02;          ///< radii
constexpr std::size_t kCorrelogramBins = 60;      ///< farther points count as unrelated
constexpr std::size_t kCorrelogramPoints = 1200;  ///< that are looked at, evenly over their order

/// Points with one value each, some of them; without those whose value is NaN.
struct SampledValues {
  std::vector<float> x, y, z, value;

  void append(float px, float py, float pz, float v) {
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
    value.push_back(v);
  }
  std::size_t size() const { return x.size(); }
};

/// Returns at most kCorrelogramPoints of the points, evenly over their order.
SampledValues sample_values(const Cloud& points, const std::vector<float>& values);

/// Returns the correlogram: in each bin the mean product of two values by their variance.
Correlogram correlogram(const SampledValues& values);

/// Returns how many independent points say as much as these about the correlation of two fields of
/// these correlograms (Dutilleul, Biometrics 49, 1993): their number by 1 + the mean over the
/// points of the sum of both correlograms' products over all others.
double effective_samples(const SampledValues& points, const Correlogram& a, const Correlogram& b);

/// Returns the correlation of the values of neighbors, consecutive points that are nearer to each
/// other than `reach`: the share of their variance that is not noise of single points; 0 where
/// there are next to none.
double coherence(const Cloud& points, const std::vector<float>& values, double reach);

}  // namespace emtr
