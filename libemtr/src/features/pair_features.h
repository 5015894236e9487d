#pragma once

namespace emtr {

/// The angles between two oriented points and their distance: f1 to f4 of a point feature
/// histogram.
struct PairFeatures {
  float f1 = 0, f2 = 0, f3 = 0, f4 = 0;
};

/// Returns the features of a pair, with the same bits as pcl::computePairFeatures; all are 0 if the
/// points are at one place or a normal points to the other point. That function alone would load
/// libpcl_features and the libraries that it needs in turn: 70 MB. Each array has 3 numbers.
PairFeatures pair_features(const float p1[3], const float n1[3], const float p2[3],
                           const float n2[3]);

}  // namespace emtr
