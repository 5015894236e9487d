#include "tasks/task_gamma.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "util/thread_team.h"

namespace emtr {
namespace {

constexpr double kLeastLength = 6;  // leaves; shorter pairs vote for everything
constexpr float kOctavesPerNeper = 1.44269504f;
constexpr int kSuppressed = 14;     // bins on either side of a peak
constexpr std::size_t kBlock = 32;  // matches whose votes are one piece of work

/// Returns log2 of a positive normal number to about 1e-4, by the same few products on every
/// machine: C libraries differ in the last digits of theirs.
float approximate_log2(float v) {
  std::uint32_t bits;
  std::memcpy(&bits, &v, sizeof bits);
  const auto exponent = static_cast<float>(static_cast<std::int32_t>(bits >> 23) - 127);
  bits = (bits & 0x7fffffu) | 0x3f800000u;
  float m;
  std::memcpy(&m, &bits, sizeof m);                     // in [1, 2)
  const float z = (m - 1.0f) / (m + 1.0f), z2 = z * z;  // artanh series: log2 m = 2 artanh z / ln 2
  return exponent + 2 * kOctavesPerNeper * z * (1.0f + z2 * (1.0f / 3 + z2 * (0.2f + z2 / 7)));
}

/// The scales within half a width of the one at which matches were made, as bins.
struct Window {
  double lowest;  ///< octaves
  int bins;

  /// Returns where an octave lies, within the window.
  int bin(float octaves) const {
    const float at = (octaves - static_cast<float>(lowest)) * TaskGamma::kBinsOfOctave;
    return static_cast<int>(std::clamp(at, 0.0f, static_cast<float>(bins)));
  }
};

/// Counts the votes of the pairs at match i, and adds their squares.
void add_votes(const MatchPoints& matches, std::size_t i, float leaf, float octaves,
               const Window& window, std::vector<std::int32_t>& steps,
               std::vector<std::int64_t>& squares) {
  const Cloud &p = matches.p, &q = matches.q;
  const auto least = static_cast<float>(kLeastLength) * leaf;
  std::fill(steps.begin(), steps.end(), 0);
  for (std::size_t j = 0; j < matches.size(); ++j) {
    const float px = p.x[j] - p.x[i], py = p.y[j] - p.y[i], pz = p.z[j] - p.z[i];
    const float qx = q.x[j] - q.x[i], qy = q.y[j] - q.y[i], qz = q.z[j] - q.z[i];
    const float pp = (px * px + py * py) + pz * pz, qq = (qx * qx + qy * qy) + qz * qz;
    if (!(qq > least * least) || !(pp > 1e-12f)) continue;
    const float x = octaves + 0.5f * approximate_log2(qq / pp);
    const float half = kOctavesPerNeper * leaf / std::sqrt(qq);
    const int from = window.bin(x - half), to = window.bin(x + half);
    if (from == to) continue;  // outside of the window
    ++steps[static_cast<std::size_t>(from)];
    --steps[static_cast<std::size_t>(to)];
  }
  std::int64_t votes = 0;
  for (std::size_t b = 0; b < squares.size(); ++b) {
    votes += steps[b];
    squares[b] += votes * votes;
  }
}

}  // namespace

TaskGamma::TaskGamma(double lowest, double highest)
    : lowest_(lowest),
      scores_(static_cast<std::size_t>(std::ceil((highest - lowest) * kBinsOfOctave)) + 1) {}

double TaskGamma::octaves_of(std::size_t bin) const {
  return lowest_ + (static_cast<double>(bin) + 0.5) / kBinsOfOctave;
}

void TaskGamma::add(const MatchPoints& matches, double leaf, double octaves, double half_width,
                    int threads) {
  // Bins of the window are bins of the range, so that they can be added.
  const double first = std::floor((octaves - half_width - lowest_) * kBinsOfOctave);
  const Window window{lowest_ + first / kBinsOfOctave,
                      static_cast<int>(std::ceil(2 * half_width * kBinsOfOctave)) + 1};
  const auto bins = static_cast<std::size_t>(window.bins);
  const std::size_t blocks = (matches.size() + kBlock - 1) / kBlock;
  std::vector<std::vector<std::int64_t>> squares(blocks);
  parallel_for(blocks, threads, [&](std::size_t block) {
    check_cancelled();
    squares[block].assign(bins, 0);
    std::vector<std::int32_t> steps(bins + 1);
    const std::size_t end = std::min(matches.size(), (block + 1) * kBlock);
    for (std::size_t i = block * kBlock; i < end; ++i)
      add_votes(matches, i, static_cast<float>(leaf), static_cast<float>(octaves), window, steps,
                squares[block]);
  });
  for (std::size_t b = 0; b < bins; ++b) {
    const double bin = first + static_cast<double>(b);
    if (bin < 0 || bin >= static_cast<double>(scores_.size())) continue;
    std::int64_t sum = 0;
    for (const auto& block : squares) sum += block[b];
    const std::size_t at = static_cast<std::size_t>(bin);
    const double nearness = 1 - std::abs(octaves_of(at) - octaves) / half_width;
    scores_[at] +=
        std::max(0.0, nearness) * static_cast<double>(sum) / static_cast<double>(matches.size());
  }
}

double TaskGamma::evaluate(double octaves) const {
  const double at = std::floor((octaves - lowest_) * kBinsOfOctave);
  return at >= 0 && at < static_cast<double>(scores_.size()) ? scores_[static_cast<std::size_t>(at)]
                                                             : 0;
}

std::vector<TaskGamma::Peak> TaskGamma::peaks(std::size_t count) const {
  std::vector<double> left = scores_;
  std::vector<Peak> out;
  while (out.size() < count) {
    const auto best = std::max_element(left.begin(), left.end());
    if (best == left.end() || !(*best > 0)) break;
    const auto at = best - left.begin();
    out.push_back({octaves_of(static_cast<std::size_t>(at)), *best});
    const auto begin = std::max<std::ptrdiff_t>(0, at - kSuppressed),
               end = std::min<std::ptrdiff_t>(static_cast<std::ptrdiff_t>(left.size()),
                                              at + kSuppressed + 1);
    std::fill(left.begin() + begin, left.begin() + end, 0);
  }
  return out;
}

}  // namespace emtr
