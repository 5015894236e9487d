#include "candidates/quick_scores.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace emtr {
namespace {

/// Writes the scores by every `step`-th point of those poses.
void score_by_few(const SurfacePair& surfaces, const std::vector<Rigid>& poses,
                  const std::vector<std::size_t>& rows, std::size_t step, ThreadTeam& team,
                  std::vector<double>& scores) {
  std::vector<Ranking::Scratch> scratch(team.size());
  team.parallel(rows.size(), [&](std::size_t i, std::size_t thread) {
    const std::size_t row = rows[i];
    scores[row] = surfaces.ranking().evaluate(poses[row], scratch[thread], step).score;
  });
}

std::vector<std::size_t> all_rows(const std::vector<Rigid>& poses) {
  std::vector<std::size_t> out(poses.size());
  std::iota(out.begin(), out.end(), std::size_t{0});
  return out;
}

}  // namespace

double quick_score(const SurfacePair& surfaces, const Rigid& pose, Ranking::Scratch& scratch) {
  return surfaces.ranking().evaluate(pose, scratch, SurfacePair::kQuickStep).score;
}

std::vector<std::size_t> order_by_quick_scores(const SurfacePair& surfaces,
                                               const std::vector<Rigid>& poses, std::size_t most,
                                               ThreadTeam& team) {
  std::vector<double> scores(poses.size());
  std::vector<std::size_t> order = all_rows(poses);
  const auto sort = [&] {
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return scores[a] > scores[b]; });
  };
  const std::size_t deserving =
      std::min(poses.size(), std::max(2 * std::min(most, poses.size()), poses.size() / 4));
  std::vector<std::size_t> rest;
  if (deserving < poses.size()) {
    score_by_few(surfaces, poses, order, SurfacePair::kQuickestStep, team, scores);
    sort();
    rest.assign(order.begin() + static_cast<std::ptrdiff_t>(deserving), order.end());
    order.resize(deserving);
    std::sort(order.begin(), order.end());  // equal scores stay in the order of the poses
  }
  score_by_few(surfaces, poses, order, SurfacePair::kQuickStep, team, scores);
  sort();
  order.insert(order.end(), rest.begin(), rest.end());
  return order;
}

std::vector<double> promising_quick_scores(const SurfacePair& surfaces,
                                           const std::vector<Rigid>& poses, std::size_t best,
                                           double promising, ThreadTeam& team) {
  std::vector<double> scores(poses.size());
  if (poses.empty()) return scores;
  score_by_few(surfaces, poses, all_rows(poses), SurfacePair::kQuickestStep, team, scores);
  const double enough = promising / 2 * std::max(scores[best], 0.0);
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i == best || scores[i] > enough)
      rows.push_back(i);
    else
      scores[i] = -std::numeric_limits<double>::infinity();
  }
  score_by_few(surfaces, poses, rows, SurfacePair::kQuickStep, team, scores);
  return scores;
}

}  // namespace emtr
