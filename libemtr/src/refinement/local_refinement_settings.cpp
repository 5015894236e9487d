#include "refinement/local_refinement_settings.h"

#include <cmath>
#include <string>

#include "util/error.h"

namespace emtr {
namespace {

void require(bool holds, const char* expected) {
  if (!holds) throw Error(EMTR_ERROR_ARGUMENT, std::string("local refinement: ") + expected);
}

}  // namespace

LocalRefinementSettings coarse_refinement() {
  LocalRefinementSettings out;
  out.first_scale = 4;
  out.last_scale = 1;
  out.softness = 1e-2;
  out.step = 2e-2;
  out.iterations = 8;
  out.queries = 1500;
  out.first_queries = 500;
  out.both_ways = false;
  return out;
}

const LocalRefinementSettings& validated(const LocalRefinementSettings& s) {
  require(s.last_scale > 0 && s.first_scale >= s.last_scale && std::isfinite(s.first_scale),
          "expected 0 < last_scale <= first_scale");
  require(s.shrink > 0 && s.shrink < 1, "expected shrink in (0, 1)");
  require(s.reach > 0 && std::isfinite(s.reach), "expected a finite reach above 0");
  require(s.normal_gate >= 0 && s.normal_gate < 1, "expected normal_gate in [0, 1)");
  require(s.softness > 0 && s.softness < 1, "expected softness in (0, 1)");
  require(s.step > 0, "expected a step above 0");
  require(s.iterations >= 1, "expected 1 iteration or more");
  require(s.queries >= 1 && s.first_queries >= 1, "expected 1 query or more");
  require(s.minimum_inliers >= 6, "expected minimum_inliers of 6 or more");
  return s;
}

}  // namespace emtr
