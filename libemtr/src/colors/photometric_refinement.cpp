#include "colors/photometric_refinement.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "geometry/small_motion.h"
#include "refinement/constrained_step.h"

namespace emtr {
namespace {

constexpr std::size_t kQueries = 2500;
constexpr double kRadii[] = {5, 2.5};         // leaves, over which colors are smoothed
constexpr int kIterations = 15;               // at most, at each
constexpr double kReach = 1.5;                // leaves, to a match
constexpr double kGate = 0.7;                 // least cosine between its normals
constexpr double kCutOff = 3;                 // of Tukey's biweight, standard deviations
constexpr double kGeometricCutOff = 0.7;      // of the residuals along the normals, leaves
constexpr double kLeastGeometricNoise = 0.1;  // leaves: two exact planes leave the colors a say
constexpr double kLeastNoise = 0.05;          // of colors of variance 1
constexpr double kConverged = 5e-3;           // leaves
constexpr double kDamping = 1e-6;
constexpr double kFewPairs = 30;
constexpr double kLeastSquaredSum = 1;  // of two normals that agree

double tukey(double squared) {
  const double bend = 1 - squared;
  return bend > 0 ? bend * bend : 0;
}

/// How the colors of one cloud become those of the other.
struct Exposure {
  double gain = 1, offset = 0;
};

/// Returns a pair of points as a pose lays them; of normals that differ too much a sum of length 0.
MovedPair moved_pair(const Rigid& pose, const SurfacePoint& source, const SurfacePoint& target,
                     std::size_t i, std::size_t j) {
  const Eigen::Vector3d y = pose * Eigen::Vector3d(source.p[0], source.p[1], source.p[2]),
                        m = pose.rotate({source.n[0], source.n[1], source.n[2]});
  const double n[3] = {target.n[0], target.n[1], target.n[2]};
  const double cosine = m[0] * n[0] + m[1] * n[1] + m[2] * n[2];
  MovedPair out{};
  out.source = i;
  out.target = j;
  if (!(std::abs(cosine) > kGate)) return out;
  for (int a = 0; a < 3; ++a) {
    out.y[a] = y[a];
    out.v[a] = n[a] + (cosine < 0 ? -m[a] : m[a]);
    out.squared += out.v[a] * out.v[a];
    out.e += out.v[a] * (y[a] - static_cast<double>(target.p[a]));
  }
  return out;
}

void jacobian(const double y[3], const double v[3], double J[6]) {
  J[0] = y[1] * v[2] - y[2] * v[1];
  J[1] = y[2] * v[0] - y[0] * v[2];
  J[2] = y[0] * v[1] - y[1] * v[0];
  for (int a = 0; a < 3; ++a) J[3 + a] = v[a];
}

/// Color of the source point and of the target's plane where it moves to.
struct ColorPair {
  double from, to;
};

/// Fits the target's colors as gain times the source's plus an offset, by their means and standard
/// deviations: neither of the two is free of noise.
Exposure fit_exposure(const std::vector<ColorPair>& pairs) {
  double a = 0, b = 0, aa = 0, bb = 0;
  const auto n = static_cast<double>(pairs.size());
  for (const ColorPair& p : pairs) {
    a += p.from;
    b += p.to;
    aa += p.from * p.from;
    bb += p.to * p.to;
  }
  const double va = aa / n - (a / n) * (a / n), vb = bb / n - (b / n) * (b / n);
  Exposure out;
  if (va > 0 && vb > 0) out.gain = std::sqrt(vb / va);
  out.offset = b / n - out.gain * a / n;
  return out;
}

double residual(const ColorPair& pair, const Exposure& exposure) {
  return pair.to - exposure.gain * pair.from - exposure.offset;
}

/// Returns the standard deviation of the residuals by their median: outliers do not count.
double noise(const std::vector<ColorPair>& pairs, const Exposure& exposure) {
  std::vector<double> sizes;
  sizes.reserve(pairs.size());
  for (const ColorPair& p : pairs) sizes.push_back(std::abs(residual(p, exposure)));
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  // Most pairs may lie on plain parts, and tell nothing of the noise where the colors change.
  double squares = 0;
  for (const double size : sizes) squares += std::min(size * size, 1.0);
  const double rms = std::sqrt(squares / static_cast<double>(sizes.size()));
  return std::max({1.4826 * *middle, 0.5 * rms, kLeastNoise});
}

/// The color of each pair's source point, and that of the target's plane where it moves to.
std::vector<ColorPair> color_pairs(const std::vector<MovedPair>& pairs, const ColorField& source,
                                   const ColorField& target, const SurfacePoint* points, int k) {
  const std::vector<float>&from = channel(source.values, k), &to = channel(target.values, k);
  const auto& gradients = target.gradients[static_cast<std::size_t>(k)];
  std::vector<ColorPair> out;
  out.reserve(pairs.size());
  for (const MovedPair& p : pairs) {
    const std::array<float, 3>& d = gradients[p.target];
    double at = static_cast<double>(to[p.target]);
    for (std::size_t a = 0; a < 3; ++a)
      at += static_cast<double>(d[a]) * (p.y[a] - static_cast<double>(points[p.target].p[a]));
    out.push_back({static_cast<double>(from[p.source]), at});
  }
  return out;
}

/// Adds the residuals of one channel, by their variance.
void add_colors(const std::vector<MovedPair>& pairs, const std::vector<ColorPair>& colors,
                const std::vector<std::array<float, 3>>& gradients, NormalEquations& sums) {
  const Exposure exposure = fit_exposure(colors);
  const double sigma = noise(colors, exposure), limit = kCutOff * sigma;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const double r = residual(colors[i], exposure);
    const double w = tukey(r * r / (limit * limit));
    if (!(w > 0)) continue;
    const std::array<float, 3>& d = gradients[pairs[i].target];
    const double v[3] = {d[0], d[1], d[2]};
    double J[6];
    jacobian(pairs[i].y, v, J);
    sums.add_normal(J, r, w / (sigma * sigma));
  }
}

NormalEquations add_shape(const std::vector<MovedPair>& pairs, double cut_off) {
  NormalEquations out;
  for (const MovedPair& p : pairs) {
    const double squared = p.e * p.e / p.squared, w = tukey(squared / (cut_off * cut_off));
    if (!(w > 0)) continue;
    const double no_difference[3] = {};
    double J[6];
    jacobian(p.y, p.v, J);
    out.add_normal(J, p.e, w / p.squared);
    out.add_difference(p.y, no_difference, w);  // its sums of y are where the matches lie
    out.weights += w;
    out.squares += w * squared;
    out.inliers += 1;
  }
  return out;
}

/// Returns the step that lowers both costs, in units of the geometric residuals' variance.
Vector6 step_of(const NormalEquations& geometric, const NormalEquations& photometric,
                double least_noise, const Rigid& pose, const Prior* prior) {
  const double variance =
      std::max(least_noise * least_noise, geometric.squares / geometric.weights);
  NormalEquations both = geometric;
  for (int k = 0; k < 21; ++k) both.H[k] += variance * photometric.H[k];
  for (int k = 0; k < 6; ++k) both.g[k] += variance * photometric.g[k];
  Matrix6 H;
  both.normal_matrix(H.data());
  H.diagonal().array() += kDamping * both.weights;
  const Vector6 g = Vector6::Map(both.g);
  return prior ? constrained_step(H, g, prior->limits(pose)) : Vector6(-H.ldlt().solve(g));
}

}  // namespace

PhotometricRefinement::PhotometricRefinement(const FineSurfaces& fine, const Channels& channels,
                                             const Kernels& kernels)
    : fine_(fine),
      used_{channels.used[0], channels.used[1], channels.used[2]},
      matcher_({fine.source, kQueries, kQueries}, {fine.target, kQueries, kQueries},
               fine.near_source.get(), fine.near_target.get(), kernels) {
  for (const double radius : kRadii)
    levels_.push_back(
        {radius, fit_color_field(*fine.source, channels.source, used_, radius * fine.leaf(), false),
         fit_color_field(*fine.target, channels.target, used_, radius * fine.leaf(), true)});
}

std::vector<MovedPair> PhotometricRefinement::match(const Rigid& pose, const Level& level,
                                                    SurfaceMatcher::Scratch& scratch) const {
  std::vector<MovedPair> out;
  const SurfacePoint *first_source = fine_.source.interleaved().data(),
                     *first_target = fine_.target.interleaved().data();
  const auto visit = [&](const SurfacePoint& source, const SurfacePoint& target) {
    const auto i = static_cast<std::size_t>(&source - first_source),
               j = static_cast<std::size_t>(&target - first_target);
    const float from = level.source.values.x[i], to = level.target.values.x[j];
    if (from != from || to != to) return;
    const MovedPair pair = moved_pair(pose, source, target, i, j);
    if (pair.squared > kLeastSquaredSum) out.push_back(pair);
  };
  for (const bool reversed : {false, true}) {
    const QueryPoints& queries = reversed ? matcher_.target() : matcher_.source();
    scratch.grow(queries.size());
    matcher_.for_each_match(pose, kReach * fine_.leaf(), {reversed, 0, queries.size(), 0}, scratch,
                            visit);
  }
  return out;
}

bool PhotometricRefinement::iterate(const Level& level, const Prior* prior,
                                    SurfaceMatcher::Scratch& scratch,
                                    PhotometricResult& out) const {
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const std::vector<MovedPair> pairs = match(out.pose, level, scratch);
    out.geometric = add_shape(pairs, kGeometricCutOff * fine_.leaf());
    if (out.geometric.inliers < kFewPairs) return false;
    out.photometric = {};
    for (int k = 0; k < kChannels; ++k) {
      if (!used_[k]) continue;
      add_colors(
          pairs,
          color_pairs(pairs, level.source, level.target, fine_.target.interleaved().data(), k),
          level.target.gradients[static_cast<std::size_t>(k)], out.photometric);
    }
    const Vector6 step = step_of(out.geometric, out.photometric,
                                 kLeastGeometricNoise * fine_.leaf(), out.pose, prior);
    if (!step.allFinite()) return false;
    out.pose = moved(out.pose, step.data());
    if (prior) out.pose = prior->project(out.pose);
    if (step.norm() < kConverged * fine_.leaf()) break;
  }
  return true;
}

PhotometricResult PhotometricRefinement::operator()(const Rigid& start, const Prior* prior) const {
  PhotometricResult out;
  out.pose = start;
  SurfaceMatcher::Scratch scratch;
  for (const Level& level : levels_)
    if (!iterate(level, prior, scratch, out)) {
      out.pose = start;
      return out;
    }
  out.succeeded = true;
  return out;
}

}  // namespace emtr
