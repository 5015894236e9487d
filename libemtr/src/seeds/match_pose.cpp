#include "seeds/match_pose.h"

#include <algorithm>
#include <iterator>
#include <numeric>
#include <optional>
#include <utility>

#include "seeds/chance.h"
#include "seeds/consistency.h"
#include "seeds/procrustes.h"
#include "seeds/triangles.h"
#include "seeds/truncated_fit.h"

namespace emtr {
namespace {

// Differences of lengths, over the usual length, at which matches are consistent. The widest is
// last but one: exact matches among very many are found where few others are consistent.
constexpr double kWidths[] = {0.02, 0.07, 0.25, 0.6, 0.002};
constexpr std::size_t kWidest = 3;
constexpr double kReach = 1.2;         // residual that supports a triangle, over that difference
constexpr std::size_t kSubset = 2000;  // matches in one search
constexpr double kCertain = -30, kFound = -4;  // decimal logarithms that end the search
constexpr double kWidestResidual = 0.5;        // over the usual length
constexpr double kHopeless = 9;  // decimal logarithm for a pose that no matches agree on
constexpr double kRivalShare = 0.8;
constexpr int kRefits = 6;

using Rows = std::vector<std::uint32_t>;

Rows every(std::size_t count, std::size_t step, std::size_t first) {
  Rows rows;
  for (std::size_t i = first; i < count; i += step) rows.push_back(static_cast<std::uint32_t>(i));
  return rows;
}

/// Returns the largest residual of an inlier. Residuals as long as the matches are apart say
/// nothing of a rotation, yet those of a pose that was fitted to them are less than chance has it.
double widest_residual(const Chance& chance) { return kWidestResidual * chance.usual_length(); }

/// Returns the pose with the nearest matches, as many as say most about it.
MatchPose most_telling(const MatchPoints& matches, const Rigid& pose, double limit,
                       const Chance& chance) {
  std::vector<std::pair<double, std::uint32_t>> near;
  for (std::uint32_t i = 0; i < matches.size(); ++i) {
    const double r = distance(pose * point_of(matches.p, i), point_of(matches.q, i));
    if (r < limit) near.emplace_back(r, i);
  }
  std::sort(near.begin(), near.end());
  MatchPose out;
  out.pose = pose;
  out.log_chance = HUGE_VAL;
  std::size_t count = 0;
  for (std::size_t k = 3; k <= near.size(); ++k) {
    const double value = chance.log_expected(k, near[k - 1].first);
    if (value >= out.log_chance) continue;
    out.log_chance = value;
    out.threshold = near[k - 1].first;
    count = k;
  }
  for (std::size_t k = 0; k < count; ++k) out.inliers.push_back(near[k].second);
  return out;
}

class Search {
 public:
  Search(const MatchPoints& matches, const Kernels& kernels, int threads)
      : matches_(matches), kernels_(kernels), threads_(threads), chance_(matches) {}

  /// `widest`: the last of the widths that is tried, unless the search ends before.
  std::optional<MatchPose> run(std::size_t least, double widest) {
    const std::size_t parts = (matches_.size() + kSubset - 1) / kSubset;
    for (const double width : kWidths) {
      if (width > widest) continue;
      width_ = width;
      for (std::size_t part = 0; part < parts; ++part) {
        search(every(matches_.size(), parts, part), width * chance_.usual_length(), least / parts);
        if (best_ && best_->log_chance < kCertain) return best_;
      }
      if (best_ && best_->log_chance < kFound) break;
    }
    return best_;
  }

  /// Returns the width that was tried last.
  double width() const { return width_; }

 private:
  void search(const Rows& rows, double difference, std::size_t least) {
    if (rows.size() < 3 || !(difference > 0)) return;
    const MatchPoints part = matches_.select(rows);
    std::vector<Correspondence> own(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      own[i] = {static_cast<std::int32_t>(i), static_cast<std::int32_t>(i)};
    const Consistency consistency(part.p, part.q, own, difference, kernels_, threads_);
    bool measured = false;
    const auto consider = [&](const Triangle& triangle) {
      if (!measured) chance_.measure(triangle.pose);
      measured = true;
      const MatchPose found =
          improve(triangle.pose, std::min(3 * difference, widest_residual(chance_)));
      if (!best_ || found.log_chance < best_->log_chance) best_ = found;
      return best_->log_chance < kCertain;
    };
    const auto triangles = find_triangles(consistency, kReach * difference, least, consider);
    for (const Triangle& triangle : triangles)
      if (consider(triangle)) return;
  }

  /// Fits the pose again and again to the matches that agree on it least by chance.
  MatchPose improve(const Rigid& start, double limit) const {
    MatchPose best;
    best.log_chance = HUGE_VAL;
    Rigid pose = start;
    for (int k = 0; k < kRefits; ++k) {
      MatchPose now = most_telling(matches_, pose, limit, chance_);
      if (!(now.log_chance < best.log_chance)) break;
      best = std::move(now);
      Procrustes sums;
      for (const std::uint32_t i : best.inliers)
        sums.add(point_of(matches_.p, i), point_of(matches_.q, i));
      pose = sums.pose();
    }
    return best;
  }

  const MatchPoints& matches_;
  const Kernels& kernels_;
  const int threads_;
  Chance chance_;
  double width_ = 0;
  std::optional<MatchPose> best_;
};

/// Fits the pose by truncated least squares and takes stock of its inliers.
void finish(const MatchPoints& matches, MatchPose& found) {
  const TruncatedFit fit = truncated_fit(matches, found.pose, found.threshold);
  Rows inliers;
  for (std::uint32_t i = 0; i < matches.size(); ++i)
    if (distance(fit.pose * point_of(matches.p, i), point_of(matches.q, i)) <= fit.threshold)
      inliers.push_back(i);
  std::sort(found.inliers.begin(), found.inliers.end());
  found.noise = fit.noise;
  if (inliers.size() < found.inliers.size()) return;  // of three, two may fit better
  found.pose = fit.pose;
  found.threshold = fit.threshold;
  found.inliers = std::move(inliers);
}

/// Returns the pose of all matches, which say nothing about it.
MatchPose least_squares(const MatchPoints& matches) {
  Procrustes sums;
  for (std::size_t i = 0; i < matches.size(); ++i)
    sums.add(point_of(matches.p, i), point_of(matches.q, i));
  MatchPose out;
  out.pose = sums.pose();
  out.log_chance = kHopeless;
  return out;
}

/// Returns the rows that are not the pose's.
Rows others(std::size_t count, const Rows& inliers) {
  Rows all(count), out;
  std::iota(all.begin(), all.end(), std::uint32_t{0});
  std::set_difference(all.begin(), all.end(), inliers.begin(), inliers.end(),
                      std::back_inserter(out));
  return out;
}

/// Tells whether the matches of one pose are as well explained by the other.
bool is_same(const MatchPoints& matches, const MatchPose& best, const MatchPose& other) {
  double squares = 0;
  for (const std::uint32_t i : best.inliers) {
    const Eigen::Vector3d p = point_of(matches.p, i);
    const double d = distance(best.pose * p, other.pose * p);
    squares += d * d;
  }
  const double most = 2 * std::max(best.threshold, other.threshold);
  return squares <= most * most * static_cast<double>(best.inliers.size());
}

}  // namespace

MatchPose rate_match_pose(const MatchPoints& matches, const Rigid& pose) {
  Chance chance(matches);
  chance.measure(pose);
  MatchPose out = most_telling(matches, pose, widest_residual(chance), chance);
  out.log_chance = std::min(out.log_chance, kHopeless);
  out.noise = out.threshold / 2;
  return out;
}

std::vector<MatchPose> find_match_poses(const MatchPoints& matches, const Kernels& kernels,
                                        int threads) {
  Search search(matches, kernels, threads);
  std::optional<MatchPose> best = search.run(3, kWidths[kWidest]);
  if (!best) return {least_squares(matches)};
  finish(matches, *best);
  std::vector<MatchPose> out{*best};
  if (best->log_chance >= 0) return out;  // chance has rivals enough
  const Rows rest = others(matches.size(), best->inliers);
  const std::size_t least = std::max<std::size_t>(
      3, static_cast<std::size_t>(kRivalShare * static_cast<double>(best->inliers.size())));
  if (rest.size() < least) return out;
  const MatchPoints left = matches.select(rest);
  std::optional<MatchPose> rival = Search(left, kernels, threads).run(least, search.width());
  if (!rival) return out;
  finish(left, *rival);
  for (std::uint32_t& i : rival->inliers) i = rest[i];
  if (rival->log_chance < 0 && rival->inliers.size() >= least && !is_same(matches, *best, *rival))
    out.push_back(*rival);
  return out;
}

}  // namespace emtr
