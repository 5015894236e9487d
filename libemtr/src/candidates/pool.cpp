#include "pool.h"

#include <algorithm>
#include <numeric>

#include "modes.h"

namespace emtr {

Pool::Pool(const Fit& fit, std::size_t step, const LocalPolish& polish, Violation violation)
    : fit_(fit), step_(step), polish_(polish), violation_(std::move(violation)) {}

std::vector<Rigid> Pool::shortlist(const std::vector<Rigid>& poses, std::size_t most,
                                   Team& team) const {
  std::vector<double> quick(poses.size());
  std::vector<Fit::Scratch> scratch(team.size());
  team.parallel(poses.size(), [&](std::size_t i, std::size_t thread) {
    quick[i] = fit_.evaluate(poses[i], step_, scratch[thread]).chf;
  });
  std::vector<std::size_t> order(poses.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return quick[a] > quick[b]; });
  std::vector<Rigid> out;
  for (const std::size_t i : order) {
    if (out.size() == most) break;
    const bool copy = std::any_of(out.begin(), out.end(), [&](const Rigid& other) {
      return within(poses[i], other, kCopy);
    });
    if (!copy) out.push_back(poses[i]);
  }
  return out;
}

void Pool::add(const std::vector<Rigid>& poses, Team& team) {
  std::vector<Candidate> fresh(poses.size());
  std::vector<Fit::Scratch> fit(team.size());
  std::vector<LocalPolish::Scratch> polish(team.size());
  team.parallel(poses.size(), [&](std::size_t i, std::size_t thread) {
    fresh[i] = judged(poses[i], fit[thread], polish[thread]);
  });
  ranked_.insert(ranked_.end(), fresh.begin(), fresh.end());
  std::stable_sort(ranked_.begin(), ranked_.end(),
                   [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  std::vector<Candidate> distinct;
  for (const Candidate& c : ranked_) {
    const bool copy = std::any_of(distinct.begin(), distinct.end(), [&](const Candidate& other) {
      return within(c.pose, other.pose, kCopy);
    });
    if (!copy) distinct.push_back(c);
  }
  ranked_ = std::move(distinct);
}

Candidate Pool::judged(const Rigid& start, Fit::Scratch& fit, LocalPolish::Scratch& polish) const {
  Candidate out;
  const Polished polished = polish_(start, polish);
  out.pose = polished.pose;
  out.fit = fit_.evaluate(out.pose, fit);
  // Polish can run off along a plane; then the start was the better answer.
  const FitValue before = fit_.evaluate(start, fit);
  if (before.chf > out.fit.chf) {
    out.pose = start;
    out.fit = before;
  }
  if (violation_) out.violation = violation_(out.pose, out.fit);
  out.score = out.fit.chf - 2 * out.violation;
  return out;
}

}  // namespace emtr
