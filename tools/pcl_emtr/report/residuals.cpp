#include "report/residuals.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

#include "failure.h"
#include "read/coordinates.h"

namespace cli {

std::vector<double> measure_residuals(const CloudFile& source, const CloudFile& target,
                                      const Options& options, const emtr_result& result) {
  std::vector<double> source_copy, target_copy, out(source.size());
  const emtr_cloud from = coordinates(source, source_copy), to = coordinates(target, target_copy);
  const emtr_status status = emtr_residuals(&from, &to, result.transformation,
                                            options.settings.threads, out.data(), nullptr);
  if (status != EMTR_OK)
    throw Failure(kInputOutput, std::string("--residuals: ") + emtr_error_message());
  return out;
}

Json residuals_json(std::vector<double> residuals) {
  residuals.erase(std::remove_if(residuals.begin(), residuals.end(),
                                 [](double value) { return std::isnan(value); }),
                  residuals.end());
  std::sort(residuals.begin(), residuals.end());
  const auto n = static_cast<double>(residuals.size());
  double sum = 0, squares = 0;
  for (const double value : residuals) {
    sum += value;
    squares += value * value;
  }
  const auto quantile = [&](double share) {
    return residuals[static_cast<std::size_t>(share * (n - 1))];
  };
  return {{"count", residuals.size()},     {"mean", sum / n},
          {"rms", std::sqrt(squares / n)}, {"median", quantile(0.5)},
          {"quantile_90", quantile(0.9)},  {"quantile_95", quantile(0.95)},
          {"maximum", residuals.back()}};
}

}  // namespace cli
