#include "verdict/residuals.h"

#include <emtr/emtr.h>

#include "c_api/arguments.h"
#include "c_api/guarded.h"

using emtr::required;

extern "C" {

emtr_status emtr_residuals(const emtr_cloud* source, const emtr_cloud* target,
                           const double transformation[16], int32_t threads, double* of_source,
                           double* of_target) {
  return emtr::guarded([&] {
    const emtr::Similarity similarity =
        transformation ? emtr::checked_similarity(transformation) : emtr::Similarity();
    emtr::residuals(required(source, "source"), required(target, "target"), similarity,
                    emtr::checked_threads(threads), of_source, of_target);
  });
}

}  // extern "C"
