#include "standing.h"

#include <algorithm>
#include <cmath>

#include "../candidates/modes.h"

namespace emtr {
namespace {

constexpr std::size_t kMostOthers = 10;

// A logistic model of "within 5 degrees and 0.06 radii", fitted to runs with and without their
// right candidates.
constexpr double kBias = -4, kOfScore = 10, kOfGap = 30;

}  // namespace

Standing stand(const std::vector<Candidate>& ranked) {
  Standing out;
  const Candidate& best = ranked.front();
  for (const Candidate& c : ranked) {
    if (out.others.size() == kMostOthers) break;
    const auto same = [&](const Candidate& other) { return within(c.pose, other.pose, kMode); };
    if (same(best) || std::any_of(out.others.begin(), out.others.end(), same)) continue;
    out.others.push_back(c);
  }
  const double second = out.others.empty() ? 0 : std::max(0.0, out.others.front().score);
  out.gap = best.score - second;
  out.confidence =
      1 / (1 + std::exp(-(kBias + kOfScore * best.score + kOfGap * std::max(0.0, out.gap))));
  return out;
}

}  // namespace emtr
