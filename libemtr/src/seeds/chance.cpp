#include "seeds/chance.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "util/portable_log.h"

namespace emtr {
namespace {

constexpr std::size_t kSamples = 16384;
constexpr std::size_t kCounted = 24, kRanks = 8;  // samples that count, and up to which they grow
constexpr double kTests = 4;                      // widths of noise that are tried
constexpr double kLeastResidual = 2e-7;           // what rounding to floats leaves

/// Returns the row that the s-th of some steps leads to from row i; they are spread over the list,
/// where neighbors may be near each other.
std::size_t other_row(std::size_t i, std::size_t s, std::size_t steps, std::size_t n) {
  return (i + s * (n - 1) / steps) % n;
}

std::vector<double> lengths_of(const Cloud& cloud) {
  const std::size_t n = cloud.size(), steps = std::min<std::size_t>(3, n - 1);
  std::vector<double> out;
  for (std::size_t s = 1; s <= steps; ++s)
    for (std::size_t i = 0; i < n; ++i)
      out.push_back(distance(point_of(cloud, i), point_of(cloud, other_row(i, s, steps, n))));
  return out;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

void Chance::Distribution::set(std::vector<double> samples, double exponent, double most) {
  samples_ = std::move(samples);
  std::sort(samples_.begin(), samples_.end());
  const std::size_t m = samples_.size(), counted = std::min(kCounted, m);
  smallest_ = std::max(samples_[counted - 1], kLeastResidual);
  log_smallest_share_ = portable_log10(static_cast<double>(counted) / static_cast<double>(m));
  exponent_ = exponent;
  if (m < kCounted * kRanks) return;
  const double growth = samples_[kCounted * kRanks - 1] / smallest_;
  if (growth > 1)
    exponent_ = std::clamp(portable_log10(double{kRanks}) / portable_log10(growth), 1.0, most);
}

double Chance::Distribution::log_share_within(double x) const {
  if (x < smallest_) return log_smallest_share_ + exponent_ * portable_log10(x / smallest_);
  const auto end = std::upper_bound(samples_.begin(), samples_.end(), x);
  return portable_log10(static_cast<double>(end - samples_.begin()) /
                        static_cast<double>(samples_.size()));
}

Chance::Chance(const MatchPoints& matches)
    : matches_(matches), n_(matches.size()), log_factorial_(n_ + 1) {
  for (std::size_t k = 2; k <= n_; ++k)
    log_factorial_[k] = log_factorial_[k - 1] + portable_log10(static_cast<double>(k));
  const std::vector<double> p = lengths_of(matches.p), q = lengths_of(matches.q);
  usual_length_ = std::min(median(p), median(q));
  std::vector<double> differences;
  for (std::size_t i = 0; i < p.size(); ++i)
    for (std::size_t s = 1; s <= 2; ++s)
      differences.push_back(std::abs(p[i] - q[other_row(i, s, 3, p.size())]));
  differences_.set(std::move(differences), 1, 1);
}

void Chance::measure(const Rigid& pose) {
  const std::size_t steps = std::min(n_ - 1, std::max<std::size_t>(1, kSamples / n_));
  std::vector<double> residuals;
  for (std::size_t i = 0; i < n_; ++i) {
    const Eigen::Vector3d moved = pose * point_of(matches_.p, i);
    for (std::size_t s = 1; s <= steps; ++s)
      residuals.push_back(distance(moved, point_of(matches_.q, other_row(i, s, steps, n_))));
  }
  // Shares grow with the cube of the radius in a volume, with its square on a surface.
  residuals_.set(std::move(residuals), 2, 3);
}

double Chance::log_expected(std::size_t k, double r) const {
  r = std::max(r, kLeastResidual);
  // The pose was fitted to these matches, which takes six numbers of all theirs.
  const double fitted = r / std::sqrt(1 - 2 / static_cast<double>(k));
  // Sets of three of n that keep their lengths, and k - 3 others that fit their pose.
  const double sets =
      log_factorial_[n_] - log_factorial_[3] - log_factorial_[k - 3] - log_factorial_[n_ - k];
  return portable_log10(kTests * static_cast<double>(n_)) + sets +
         3 * differences_.log_share_within(2 * r) +
         static_cast<double>(k - 3) * residuals_.log_share_within(fitted);
}

}  // namespace emtr
