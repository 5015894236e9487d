#include "candidates/translation_votes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace emtr {
namespace {

constexpr double kSameHeight = 0.03;           // radii
constexpr int kAlike = 6;                      // steps between the directions that two points face
constexpr double kReach = 1.6;                 // radii
constexpr double kCell = 0.045;                // radii
constexpr int kCells = 72, kRow = kCells + 2;  // a border of empty cells
constexpr int kPeaks = 3;
constexpr int kApart = 2;  // cells between peaks

int cell_of(double translation) {
  return static_cast<int>(std::floor((translation + kReach) / kCell));
}

/// Sums each cell with its eight neighbors.
std::vector<int> box_sum(const std::vector<int>& votes) {
  std::vector<int> rows(votes.size()), out(votes.size());
  for (std::size_t i = 1; i + 1 < votes.size(); ++i)
    rows[i] = votes[i - 1] + votes[i] + votes[i + 1];
  for (std::size_t i = kRow; i + kRow < votes.size(); ++i)
    out[i] = rows[i - kRow] + rows[i] + rows[i + kRow];
  return out;
}

/// Returns the mean translation of the votes in a cell and its neighbors.
TranslationPeak centroid(const std::vector<int>& votes, int at, int yaw) {
  TranslationPeak out{0, yaw, 0, 0};
  for (int v = -1; v <= 1; ++v)
    for (int u = -1; u <= 1; ++u) {
      const int here = votes[static_cast<std::size_t>(at + v * kRow + u)];
      out.votes += here;
      out.x += here * u;
      out.y += here * v;
    }
  out.x = (at % kRow + out.x / out.votes - 0.5) * kCell - kReach;
  out.y = (at / kRow + out.y / out.votes - 0.5) * kCell - kReach;
  return out;
}

void clear_around(std::vector<int>& votes, int x, int y) {
  for (int v = std::max(y - kApart, 0); v <= std::min(y + kApart, kRow - 1); ++v)
    for (int u = std::max(x - kApart, 0); u <= std::min(x + kApart, kRow - 1); ++u)
      votes[static_cast<std::size_t>(v * kRow + u)] = 0;
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
                                                   const YawPairs& pairs, int yaw) {
  const double c = std::cos(yaw * kYawStep), s = std::sin(yaw * kYawStep);
  std::vector<double> x(source.size()), y(source.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    x[i] = c * source[i].x - s * source[i].y;
    y[i] = s * source[i].x + c * source[i].y;
  }
  std::vector<int> votes(static_cast<std::size_t>(kRow) * kRow);
  for (int step = yaw - kAlike; step <= yaw + kAlike; ++step)
    for (const YawPairs::Pair& pair : pairs.of(step)) {
      const int u = cell_of(target[pair.target].x - x[pair.source]);
      const int v = cell_of(target[pair.target].y - y[pair.source]);
      if (u >= 0 && u < kCells && v >= 0 && v < kCells)
        ++votes[static_cast<std::size_t>((v + 1) * kRow + u + 1)];
    }
  std::vector<int> sums = box_sum(votes);
  std::vector<TranslationPeak> peaks;
  for (int k = 0; k < kPeaks; ++k) {
    const auto most = std::max_element(sums.begin(), sums.end());
    if (*most == 0) break;
    const int at = static_cast<int>(most - sums.begin());
    peaks.push_back(centroid(votes, at, yaw));
    clear_around(sums, at % kRow, at / kRow);
  }
  return peaks;
}

}  // namespace emtr
