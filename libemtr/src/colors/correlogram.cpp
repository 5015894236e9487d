#include "colors/correlogram.h"

#include <algorithm>
#include <cmath>

namespace emtr {
namespace {

constexpr double kUnrelated = 0.05;     // a correlogram below this is one of unrelated values
constexpr std::size_t kFewPairs = 100;  // of neighbors

struct Statistics {
  double mean = 0, variance = 0;
};

Statistics statistics(const std::vector<float>& values) {
  Statistics out;
  double count = 0;
  for (const float v : values) {
    if (v != v) continue;
    out.mean += static_cast<double>(v);
    ++count;
  }
  if (count == 0) return out;
  out.mean /= count;
  for (const float v : values) {
    if (v != v) continue;
    const double d = static_cast<double>(v) - out.mean;
    out.variance += d * d;
  }
  out.variance /= count;
  return out;
}

/// Calls visit(i, j, bin) for each pair of points within the last bin.
template <class Visit>
void for_each_pair(const SampledValues& p, const Visit& visit) {
  const auto inverse = static_cast<float>(1 / kCorrelogramBin);
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t j = i + 1; j < p.size(); ++j) {
      const float x = p.x[i] - p.x[j], y = p.y[i] - p.y[j], z = p.z[i] - p.z[j];
      const auto bin = static_cast<std::size_t>(std::sqrt((x * x + y * y) + z * z) * inverse);
      if (bin < kCorrelogramBins) visit(i, j, bin);
    }
}

}  // namespace

SampledValues sample_values(const Cloud& points, const std::vector<float>& values) {
  std::vector<std::size_t> known;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i] == values[i]) known.push_back(i);
  const std::size_t count = std::min(known.size(), kCorrelogramPoints);
  SampledValues out;
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t i = known[k * known.size() / count];
    out.append(points.x[i], points.y[i], points.z[i], values[i]);
  }
  return out;
}

Correlogram correlogram(const SampledValues& p) {
  Correlogram out(kCorrelogramBins, 0.0);
  const Statistics all = statistics(p.value);
  if (!(all.variance > 0)) return out;
  std::vector<double> pairs(kCorrelogramBins, 0.0);
  for_each_pair(p, [&](std::size_t i, std::size_t j, std::size_t bin) {
    out[bin] +=
        (static_cast<double>(p.value[i]) - all.mean) * (static_cast<double>(p.value[j]) - all.mean);
    ++pairs[bin];
  });
  for (std::size_t bin = 0; bin < out.size(); ++bin)
    out[bin] = pairs[bin] > 0 ? out[bin] / (pairs[bin] * all.variance) : (bin ? out[bin - 1] : 1);
  return out;
}

double effective_samples(const SampledValues& points, const Correlogram& a, const Correlogram& b) {
  const auto n = static_cast<double>(points.size());
  if (points.size() < 2) return n;
  std::vector<double> product(kCorrelogramBins, 0.0);
  for (std::size_t bin = 0; bin < product.size(); ++bin) {
    product[bin] = a[bin] * b[bin];
    if (!(a[bin] > kUnrelated && b[bin] > kUnrelated)) {  // what is beyond is chance
      product[bin] = 0;
      break;
    }
  }
  double sum = 0;
  for_each_pair(points, [&](std::size_t, std::size_t, std::size_t bin) { sum += product[bin]; });
  return n / (1 + 2 * sum / n);
}

double coherence(const Cloud& points, const std::vector<float>& values, double reach) {
  const Statistics all = statistics(values);
  if (!(all.variance > 0)) return 0;
  const auto limit = static_cast<float>(reach * reach);
  double sum = 0;
  std::size_t pairs = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const float x = points.x[i] - points.x[i - 1], y = points.y[i] - points.y[i - 1],
                z = points.z[i] - points.z[i - 1];
    if (!((x * x + y * y) + z * z < limit) || values[i] != values[i] ||
        values[i - 1] != values[i - 1])
      continue;
    sum += (static_cast<double>(values[i]) - all.mean) *
           (static_cast<double>(values[i - 1]) - all.mean);
    ++pairs;
  }
  return pairs < kFewPairs ? 0 : sum / (static_cast<double>(pairs) * all.variance);
}

}  // namespace emtr
