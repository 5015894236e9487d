#include "candidates/translation_votes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace emtr {
namespace {

constexpr double kSameHeight = 0.03;  // radii
constexpr int kAlike = 6;             // steps between the directions that two points face
constexpr double kReach = 1.6;        // radii
constexpr double kCell = 0.045;       // radii
constexpr std::size_t kCells = 72, kRow = kCells + 2;  // a border of empty cells
constexpr VoteCells kVoteCells = {-kReach, kCell, static_cast<std::int32_t>(kCells),
                                  static_cast<std::int32_t>(kRow)};
constexpr int kPeaks = 3;
constexpr std::size_t kApart = 2;  // cells between peaks

/// Sums each cell that has all eight neighbors with them.
std::vector<int> box_sum(const std::vector<int>& votes) {
  std::vector<int> rows(votes.size()), out(votes.size());
  for (std::size_t i = 1; i + 1 < votes.size(); ++i)
    rows[i] = votes[i - 1] + votes[i] + votes[i + 1];
  for (std::size_t i = kRow + 1; i + kRow + 1 < votes.size(); ++i)
    out[i] = rows[i - kRow] + rows[i] + rows[i + kRow];
  return out;
}

/// Returns the mean translation of the votes in a cell and its neighbors.
TranslationPeak centroid(const std::vector<int>& votes, std::size_t at, int yaw) {
  TranslationPeak out{0, yaw, 0, 0};
  for (std::size_t v = 0; v < 3; ++v)
    for (std::size_t u = 0; u < 3; ++u) {
      const int here = votes[at - kRow - 1 + v * kRow + u];
      out.votes += here;
      out.x += here * (static_cast<double>(u) - 1);
      out.y += here * (static_cast<double>(v) - 1);
    }
  const std::size_t column = at % kRow, row = at / kRow;
  out.x = (static_cast<double>(column) + out.x / out.votes - 0.5) * kCell - kReach;
  out.y = (static_cast<double>(row) + out.y / out.votes - 0.5) * kCell - kReach;
  return out;
}

void clear_around(std::vector<int>& votes, std::size_t at) {
  const std::size_t x = at % kRow, y = at / kRow;
  for (std::size_t v = y - std::min(y, kApart); v <= std::min(y + kApart, kRow - 1); ++v)
    for (std::size_t u = x - std::min(x, kApart); u <= std::min(x + kApart, kRow - 1); ++u)
      votes[v * kRow + u] = 0;
}

}  // namespace

YawPairs::YawPairs(const std::vector<UprightPoint>& source,
                   const std::vector<UprightPoint>& target) {
  for (std::size_t i = 0; i < source.size(); ++i)
    for (std::size_t j = 0; j < target.size(); ++j) {
      if (std::abs(source[i].height - target[j].height) > kSameHeight) continue;
      const double yaw = target[j].azimuth - source[i].azimuth;
      const int step = static_cast<int>(std::floor(yaw / kYawStep + 0.5));
      pairs_[static_cast<std::size_t>((step + kYaws) % (kYaws / 2))].push_back(
          {static_cast<std::uint16_t>(i), static_cast<std::uint16_t>(j)});
    }
}

const std::vector<YawPairs::Pair>& YawPairs::of(int step) const {
  return pairs_[static_cast<std::size_t>((step + kYaws) % (kYaws / 2))];
}

std::vector<TranslationPeak> vote_for_translations(const std::vector<UprightPoint>& source,
                                                   const std::vector<UprightPoint>& target,
                                                   const YawPairs& pairs, int yaw,
                                                   const Kernels& kernels) {
  const double c = std::cos(yaw * kYawStep), s = std::sin(yaw * kYawStep);
  std::vector<double> x(source.size()), y(source.size()), u, v;
  for (std::size_t i = 0; i < source.size(); ++i) {
    x[i] = c * source[i].x - s * source[i].y;
    y[i] = s * source[i].x + c * source[i].y;
  }
  for (const UprightPoint& p : target) u.push_back(p.x), v.push_back(p.y);
  const double *const from[2] = {x.data(), y.data()}, *const to[2] = {u.data(), v.data()};
  std::vector<int> votes(kRow * kRow + 1);  // the last of those beyond the cells
  for (int step = yaw - kAlike; step <= yaw + kAlike; ++step) {
    const std::vector<YawPairs::Pair>& some = pairs.of(step);
    search_kernels(kernels).vote(some.data(), some.size(), from, to, kVoteCells, votes.data());
  }
  votes.pop_back();
  std::vector<int> sums = box_sum(votes);
  std::vector<TranslationPeak> peaks;
  for (int k = 0; k < kPeaks; ++k) {
    int most = 0;  // found by a loop without a branch, and then its place
    for (const int sum : sums) most = sum > most ? sum : most;
    if (most == 0) break;
    const auto at =
        static_cast<std::size_t>(std::find(sums.begin(), sums.end(), most) - sums.begin());
    peaks.push_back(centroid(votes, at, yaw));
    clear_around(sums, at);
  }
  return peaks;
}

}  // namespace emtr
