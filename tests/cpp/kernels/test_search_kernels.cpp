#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "geometry/euler.h"
#include "kernels/search_kernels.h"
#include "neighbors/cells.h"
#include "ranking/direction_bins.h"
#include "support/clouds.h"

namespace {

using emtr::Cloud;
using emtr::Kernels;
using emtr::SearchKernels;
using emtr_test::kernels_here;
using emtr_test::uniform_cloud;

std::vector<std::uint64_t> random_words(std::size_t n, unsigned seed) {
  std::mt19937_64 random(seed);
  std::vector<std::uint64_t> out(n);
  for (std::uint64_t& word : out) word = random();
  return out;
}

TEST(SearchKernels, CountCommonIsWhatTheBitsSay) {
  for (std::size_t words = 0; words < 300; ++words) {
    const auto a = random_words(words, 1), b = random_words(words, 2);
    const std::vector<std::uint64_t> all(words, ~std::uint64_t{0});
    std::size_t expected = 0;
    for (std::size_t i = 0; i < words; ++i)
      for (std::size_t bit = 0; bit < 64; ++bit) expected += a[i] >> bit & b[i] >> bit & 1;
    for (const Kernels* k : kernels_here()) {
      EXPECT_EQ(k->count_common(a.data(), b.data(), words), expected) << k->name;
      EXPECT_EQ(k->count_common(all.data(), all.data(), words), 64 * words) << k->name;
    }
  }
}

TEST(SearchKernels, PoseInliersAreThoseThatThePoseSays) {
  const double particle[6] = {0.4, -0.3, 1.1, 0.1, -0.05, 0.2};
  const emtr::Rigid pose = emtr::decode(particle);
  double matrix[16];
  emtr::to_matrix(pose, matrix);
  for (const std::size_t n : {1u, 63u, 64u, 65u, 300u}) {
    Cloud p = uniform_cloud(n, 1), q = uniform_cloud(n, 2);
    std::vector<std::uint64_t> expected((n + 63) / 64);
    std::size_t count = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto row = [i](const Cloud& c) {
        return Eigen::Vector3d(double{c.x[i]}, double{c.y[i]}, double{c.z[i]});
      };
      const Eigen::Vector3d d = pose * row(p) - row(q);
      if ((d.x() * d.x() + d.y() * d.y()) + d.z() * d.z() >= 0.6) continue;
      expected[i / 64] |= std::uint64_t{1} << (i % 64);
      ++count;
    }
    if (n == 300) {
      ASSERT_GT(count, 20u);
    }
    emtr::PointsView from = p.view(), to = q.view();
    for (Cloud* c : {&p, &q}) c->resize(expected.size() * 64);
    from.x = p.x.data(), from.y = p.y.data(), from.z = p.z.data();
    to.x = q.x.data(), to.y = q.y.data(), to.z = q.z.data();
    for (const Kernels* k : kernels_here()) {
      std::vector<std::uint64_t> bits(expected.size(), 7);
      EXPECT_EQ(search_kernels(*k).pose_inliers(from, to, matrix, 0.6, bits.data()), count);
      EXPECT_EQ(bits, expected) << k->name;
    }
  }
}

TEST(SearchKernels, SamplingSumsAreTheSameBitsInEach) {
  const std::size_t n = 203, padded = 208;
  Cloud p = uniform_cloud(n, 1), normals = uniform_cloud(n, 2);
  std::vector<float> log_count = uniform_cloud(n, 3).x, present(n, 1.0f);
  const float at[3] = {0.3f, -1.5f, 0.2f};
  double expected[3] = {};
  for (std::size_t i = 0; i < n; ++i) {
    const double d[3] = {double{at[0]} - double{p.x[i]}, double{at[1]} - double{p.y[i]},
                         double{at[2]} - double{p.z[i]}};
    const double squared = d[0] * d[0] + d[1] * d[1] + d[2] * d[2] + 1e-6;
    const double along = std::abs(d[0] * double{normals.x[i]} + d[1] * double{normals.y[i]} +
                                  d[2] * double{normals.z[i]});
    const double value = std::log2((along / std::sqrt(squared) + 0.1) / squared);
    expected[0] += value;
    expected[1] += value * value;
    expected[2] += value * double{log_count[i]};
  }
  for (Cloud* c : {&p, &normals}) c->resize(padded);
  log_count.resize(padded);
  present.resize(padded);
  const emtr::SamplingView view = {p.x.data(),       p.y.data(),       p.z.data(),
                                   normals.x.data(), normals.y.data(), normals.z.data(),
                                   log_count.data(), present.data(),   padded};
  double first[3];
  search_kernels(*emtr::kernels_at(0)).sampling_sums(view, at, first);
  for (int a = 0; a < 3; ++a) EXPECT_NEAR(first[a], expected[a], 0.1);
  for (const Kernels* k : kernels_here()) {
    double sums[3];
    search_kernels(*k).sampling_sums(view, at, sums);
    for (int a = 0; a < 3; ++a) EXPECT_EQ(sums[a], first[a]) << k->name;
  }
}

TEST(SearchKernels, RhoPieceByPieceIsRhoAtOnce) {
  std::vector<float> squared = uniform_cloud(500, 1).x;
  for (float& s : squared) s = std::abs(s);
  for (const std::size_t n : {0u, 5u, 16u, 64u, 67u, 500u})
    for (const Kernels* k : kernels_here()) {
      double lanes[emtr::kLanes] = {};
      for (std::size_t i = 0; i < n; i += 16)
        search_kernels(*k).add_rho(&squared[i], std::min<std::size_t>(16, n - i), 0.9f, lanes);
      EXPECT_EQ(emtr::total_of_lanes(lanes), k->rho_sum(squared.data(), n, 0.9f)) << k->name;
    }
}

TEST(SearchKernels, DirectionsHaveTheBinsOfTheirFaces) {
  const double viewpoint[3] = {0, 0, 0}, facing[3] = {0, 0, 1};
  const emtr::DirectionBins bins(viewpoint, facing, 0.01);
  Cloud d = uniform_cloud(1000, 7);
  for (const float x : {-1.0f, 0.0f, 1.0f})  // corners, edges and middles of faces
    for (const float y : {-1.0f, 0.0f, 1.0f})
      for (const float z : {-1.0f, 0.0f, 1.0f}) emtr_test::push(d, x, y, z);
  const std::size_t n = d.size();
  d.resize(n + 16);
  for (const Kernels* k : kernels_here()) {
    std::vector<std::int32_t> face(n + 16), column(n + 16), row(n + 16);
    search_kernels(*k).direction_bins({d.x.data(), d.y.data(), d.z.data(), n}, bins.half_side(),
                                      {face.data(), column.data(), row.data()});
    for (std::size_t i = 0; i < n; ++i) {
      const auto expected = bins(d.x[i], d.y[i], d.z[i]);
      ASSERT_EQ(face[i], expected.face) << k->name << " " << i;
      ASSERT_EQ(std::min(column[i], bins.side() - 1), expected.column);
      ASSERT_EQ(std::min(row[i], bins.side() - 1), expected.row);
    }
  }
}

TEST(SearchKernels, VotesGoToTheCellsOfTheTranslations) {
  const emtr::VoteCells cells = {-1.6, 0.045, 72, 74};
  std::mt19937 random(3);
  std::vector<double> at[4];  // source x, y, target x, y
  for (auto& axis : at)
    for (int i = 0; i < 400; ++i) axis.push_back(double(random()) / 2147483648.0 - 1);
  for (const std::size_t n : {0u, 1u, 15u, 16u, 17u, 5000u}) {
    std::vector<emtr::VotePair> pairs;
    std::vector<int> expected(74 * 74 + 1);
    for (std::size_t i = 0; i < n; ++i) {
      pairs.push_back({std::uint16_t(random() % 400), std::uint16_t(random() % 400)});
      double cell[2];
      for (int a = 0; a < 2; ++a)
        cell[a] = std::floor((at[2 + a][pairs[i].target] - at[a][pairs[i].source] + 1.6) / 0.045);
      const bool inside = cell[0] >= 0 && cell[0] < 72 && cell[1] >= 0 && cell[1] < 72;
      ++expected[inside ? std::size_t(cell[1] + 1) * 74 + std::size_t(cell[0] + 1) : 74 * 74];
    }
    if (n == 5000) {
      ASSERT_GT(expected.back(), 10);
    }
    const double *source[2] = {at[0].data(), at[1].data()},
                 *target[2] = {at[2].data(), at[3].data()};
    for (const Kernels* k : kernels_here()) {
      std::vector<int> votes(expected.size());
      search_kernels(*k).vote(pairs.data(), n, source, target, cells, votes.data());
      EXPECT_EQ(votes, expected) << k->name;
    }
  }
}

/// A point is a candidate of the cells it reaches where it is near enough; cell by cell.
TEST(SearchKernels, CandidatesAreThePointsThatCellsAreNear) {
  const Cloud cloud = uniform_cloud(200, 5);
  for (const float side : {0.05f, 0.31f, 0.8f}) {
    const float radius = 0.3f;
    const emtr::CellLayout layout = emtr::make_cell_layout(cloud, radius, radius, side, 1e6);
    const emtr::ReachView grid = {layout.view, radius, layout.cell, layout.margin};
    const std::int32_t* size = layout.view.size;
    const auto cells = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                       static_cast<std::size_t>(size[2]);
    // Squared distances to the nearest and the farthest place of a cell, in double.
    const auto distance = [&](std::size_t cell, std::size_t point, bool farthest) {
      const auto c = static_cast<std::int64_t>(cell);
      const std::int64_t at[3] = {c % size[0], c / size[0] % size[1], c / size[0] / size[1]};
      const float p[3] = {cloud.x[point], cloud.y[point], cloud.z[point]};
      double sum = 0;
      for (int a = 0; a < 3; ++a) {
        const double low = double{layout.view.origin[a]} + double(at[a]) * double{layout.cell},
                     below = low - double{p[a]}, above = double{p[a]} - low - double{layout.cell};
        const double d = farthest ? std::max(-below, -above) : std::max({below, above, 0.0});
        sum += d * d;
      }
      return sum;
    };
    std::vector<float> first_bound;
    std::vector<std::uint32_t> first_count;
    for (const Kernels* k : kernels_here()) {
      const SearchKernels& search = search_kernels(*k);
      std::vector<float> room(emtr::reach_room(grid));
      std::vector<float> bound(cells + emtr::kLanes, layout.view.limit);
      std::vector<std::uint32_t> count(cells + emtr::kLanes);
      search.reach_bounds(grid, cloud.view(), room.data(), bound.data());
      search.count_candidates(grid, cloud.view(), room.data(), bound.data(), count.data());
      if (first_bound.empty()) {
        first_bound = bound, first_count = count;
        for (std::size_t c = 0; c < cells; c += 7) {
          double least = double{layout.view.limit};
          for (std::size_t n = 0; n < cloud.size(); ++n)
            least = std::min(least, distance(c, n, true));
          EXPECT_NEAR(double{bound[c]}, least, 1e-3);
          EXPECT_GE(double{bound[c]}, least - 1e-6);
          std::uint32_t surely = 0, perhaps = 0;
          for (std::size_t n = 0; n < cloud.size(); ++n) {
            surely += distance(c, n, false) < double{bound[c]} - 1e-6;
            perhaps += distance(c, n, false) < double{bound[c]} + 1e-3;
          }
          EXPECT_GE(count[c], surely);
          EXPECT_LE(count[c], perhaps);
        }
      }
      EXPECT_EQ(bound, first_bound) << k->name;
      EXPECT_EQ(count, first_count) << k->name;
    }
  }
}

}  // namespace
