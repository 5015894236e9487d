#include "colors/color_correlation.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <utility>

#include "colors/correlogram.h"
#include "geometry/transform.h"

namespace emtr {
namespace {

constexpr double kMostCorrelation = 0.98;  // noise that is not seen in the colors
constexpr double kFewSamples = 3;          // any two points lie on a line
constexpr double kLeastShare = 0.05;     // of the variance of an overlap, for a channel of its own
constexpr double kLeastVariance = 1e-4;  // of the overlap's colors, by that of all

/// Sums over pairs of colors of one channel.
struct Pairs {
  double n = 0, a = 0, b = 0, aa = 0, bb = 0, ab = 0;

  void add(float from, float to) {
    const double u = static_cast<double>(from), v = static_cast<double>(to);
    n += 1;
    a += u;
    b += v;
    aa += u * u;
    bb += v * v;
    ab += u * v;
  }

  double correlation() const {
    if (n < 2) return 0;
    const double va = aa / n - (a / n) * (a / n), vb = bb / n - (b / n) * (b / n);
    if (!(va > kLeastVariance && vb > kLeastVariance)) return 0;
    return std::clamp((ab / n - (a / n) * (b / n)) / std::sqrt(va * vb), -kMostCorrelation,
                      kMostCorrelation);
  }
};

/// Sums up the channels.
class Sum {
 public:
  void add(double correlation, double samples) {
    if (samples < kFewSamples) return;
    const double said = -samples / 2 * std::log(1 - correlation * correlation);
    out_.evidence += correlation > 0 ? said : -said;
    weight_ += said;
    correlation_ += said * correlation;
  }
  ColorEvidence result(double overlap) const {
    ColorEvidence out = out_;
    out.correlation = weight_ > 0 ? correlation_ / weight_ : 0;
    out.overlap = overlap;
    return out;
  }

 private:
  ColorEvidence out_;
  double weight_ = 0, correlation_ = 0;
};

/// The principal axes of the colors of an overlap. Channels that are independent in the whole
/// clouds may show the same thing there, such as one dark sheet on a white wall: then they are one.
class OwnAxes {
 public:
  OwnAxes(const Cloud& from, const Cloud& to) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance(from) + covariance(to));
    axes_ = solver.eigenvectors();
    variances_ = solver.eigenvalues();
  }

  bool counts(int k) const { return variances_[k] > kLeastShare * variances_[2]; }

  std::vector<float> component(const Cloud& colors, int k) const {
    std::vector<float> out(colors.size());
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = static_cast<float>(axes_(0, k) * static_cast<double>(colors.x[i]) +
                                  axes_(1, k) * static_cast<double>(colors.y[i]) +
                                  axes_(2, k) * static_cast<double>(colors.z[i]));
    return out;
  }

 private:
  static Eigen::Matrix3d covariance(const Cloud& colors) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    Eigen::Matrix3d out = Eigen::Matrix3d::Zero();
    const auto n = static_cast<double>(std::max<std::size_t>(colors.size(), 1));
    for (std::size_t i = 0; i < colors.size(); ++i) {
      const Eigen::Vector3d color(colors.x[i], colors.y[i], colors.z[i]);
      mean += color;
      for (int k = 0; k < kChannels; ++k) out.col(k) += color * color[k];
    }
    mean /= n;
    out /= n;
    for (int k = 0; k < kChannels; ++k) out.col(k) -= mean * mean[k];
    return out;
  }

  Eigen::Matrix3d axes_;
  Eigen::Vector3d variances_;
};

std::vector<std::size_t> rows_with_color(const Cloud& colors, std::size_t maximum) {
  std::vector<std::size_t> known, out;
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (colors.x[i] == colors.x[i]) known.push_back(i);
  const std::size_t count = std::min(known.size(), maximum);
  for (std::size_t k = 0; k < count; ++k) out.push_back(known[k * known.size() / count]);
  return out;
}

}  // namespace

ColorCorrelation::ColorCorrelation(const Cloud& source, const Cloud& target, Channels channels,
                                   double leaf, std::size_t maximum_queries, const Kernels& kernels)
    : kernels_(kernels),
      leaf_(leaf),
      used_{channels.used[0], channels.used[1], channels.used[2]},
      target_(target),
      target_colors_(std::move(channels.target)) {
  const std::vector<std::size_t> rows = rows_with_color(channels.source, maximum_queries);
  queries_ = source.select(rows);
  colors_ = channels.source.select(rows);
  const auto radius = static_cast<float>(leaf);
  near_target_ = make_candidate_grid(target_, radius, radius, kernels);
  for (int k = 0; k < kChannels; ++k) {
    if (!used_[k]) continue;
    const SampledValues from = sample_values(queries_, channel(colors_, k)),
                        to = sample_values(target_, channel(target_colors_, k));
    effective_[k] = effective_samples(from, correlogram(from), correlogram(to));
  }
}

std::size_t ColorCorrelation::match(const Rigid& pose, Scratch& s) const {
  const std::size_t n = queries_.size();
  if (s.index.size() < n) {
    for (auto* v : {&s.x, &s.y, &s.z, &s.squared}) v->resize(n);
    s.index.resize(n);
  }
  transform(kernels_, queries_, pose, s.x.data(), s.y.data(), s.z.data());
  near_target_->nearest({s.x.data(), s.y.data(), s.z.data(), n}, s.index.data(), s.squared.data());
  std::size_t matched = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::int32_t j = s.index[i];
    if (j < 0) continue;
    const float color = target_colors_.x[static_cast<std::size_t>(j)];
    if (color != color)
      s.index[i] = -1;
    else
      ++matched;
  }
  return matched;
}

ColorEvidence ColorCorrelation::evaluate(const Rigid& pose, Scratch& s) const {
  const std::size_t n = queries_.size();
  const double overlap =
      static_cast<double>(match(pose, s)) / static_cast<double>(std::max<std::size_t>(n, 1));
  Sum sum;
  for (int k = 0; k < kChannels; ++k) {
    if (!used_[k]) continue;
    const std::vector<float>&from = channel(colors_, k), &to = channel(target_colors_, k);
    Pairs pairs;
    for (std::size_t i = 0; i < n; ++i)
      if (s.index[i] >= 0) pairs.add(from[i], to[static_cast<std::size_t>(s.index[i])]);
    sum.add(pairs.correlation(), overlap * effective_[k]);
  }
  return sum.result(overlap);
}

ColorEvidence ColorCorrelation::evaluate_locally(const Rigid& pose, Scratch& s) const {
  const std::size_t n = queries_.size(), matched = match(pose, s);
  const double overlap =
      static_cast<double>(matched) / static_cast<double>(std::max<std::size_t>(n, 1));
  Cloud places, from, to;
  for (std::size_t i = 0; i < n; ++i) {
    if (s.index[i] < 0) continue;
    const auto j = static_cast<std::size_t>(s.index[i]);
    places.append(s.x[i], s.y[i], s.z[i]);
    from.append(colors_.x[i], colors_.y[i], colors_.z[i]);
    to.append(target_colors_.x[j], target_colors_.y[j], target_colors_.z[j]);
  }
  Sum sum;
  const OwnAxes axes(from, to);
  for (int k = 0; k < kChannels; ++k) {
    if (!axes.counts(k)) continue;
    const std::vector<float> a = axes.component(from, k), b = axes.component(to, k);
    Pairs pairs;
    for (std::size_t i = 0; i < matched; ++i) pairs.add(a[i], b[i]);
    const SampledValues first = sample_values(places, a), second = sample_values(places, b);
    // The mean over an overlap hides how alike points of it are: no more than by the whole clouds.
    const double samples =
        std::min(effective_samples(first, correlogram(first), correlogram(second)),
                 overlap * most_effective());
    sum.add(pairs.correlation(), samples);
  }
  return sum.result(overlap);
}

double ColorCorrelation::most_effective() const {
  return *std::max_element(effective_, effective_ + kChannels);
}

}  // namespace emtr
