// Distances of each point of two clouds from the other one, moved by anything.
#include <emtr/emtr.h>

#include <vector>

#include "any_cloud.h"
#include "calls.h"
#include "input.h"

namespace {

void require_distances(const std::vector<double>& distances) {
  for (const double value : distances) fuzz::require(std::isnan(value) || value >= 0);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::Input input(data, size);
  const fuzz::AnyCloud source(input, 32), target(input, 32);
  double T[16] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  for (int n = input.ConsumeIntegralInRange(0, 2); n > 0; --n) {
    // Mostly the shift, any of which keeps it rigid.
    const int place = 4 * input.ConsumeIntegralInRange(0, 2) + 3;
    T[input.ConsumeBool() ? place : input.ConsumeIntegralInRange(0, 15)] = fuzz::any_double(input);
  }
  std::vector<double> of_source(source.view().count), of_target(target.view().count);
  const bool both = input.ConsumeBool();
  if (fuzz::accepted(emtr_residuals(&source.view(), &target.view(),
                                    input.ConsumeBool() ? T : nullptr, 1, of_source.data(),
                                    both ? of_target.data() : nullptr))) {
    require_distances(of_source);
    if (both) require_distances(of_target);
  }
  return 0;
}
