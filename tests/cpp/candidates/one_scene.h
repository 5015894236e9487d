#pragma once

#include <gtest/gtest.h>

#include "candidates/scene.h"

namespace emtr_test {

/// Tests that share one scene, which takes a while to make.
class OneScene : public testing::Test {
 protected:
  static const Scene& scene() {
    static const Scene one(31);
    return one;
  }
  static const emtr::SurfacePair& surfaces() {
    static const emtr::SurfacePair both(scene().source, scene().target, {}, {},
                                        emtr::select_kernels());
    return both;
  }

  /// The score by every `step`-th point.
  static double score(const emtr::Rigid& pose, std::size_t step) {
    emtr::Ranking::Scratch scratch;
    return surfaces().ranking().evaluate(pose, scratch, step).score;
  }
  static double quick(const emtr::Rigid& pose) {
    return score(pose, emtr::SurfacePair::kQuickStep);
  }
};

}  // namespace emtr_test
