#include <gtest/gtest.h>

#include "colors/color_search.h"
#include "colors/painted.h"
#include "voxels/voxel_order.h"

namespace {

using emtr::Rigid;
using emtr_test::Painted;

constexpr double kLeaf = 0.02;

/// The spectrum of a plane z = 0 about the origin.
emtr::HessianSpectrum of_a_plane() {
  emtr::HessianSpectrum out;
  out.radius = 0.6;
  out.unconstrained = 3;
  out.eigenvectors[0][2] = out.eigenvectors[1][3] = out.eigenvectors[2][4] = 1;
  out.eigenvectors[3][0] = out.eigenvectors[4][1] = out.eigenvectors[5][5] = 1;
  return out;
}

struct Searched {
  Painted source, target;
  emtr::FineSurfaces fine;
  emtr::ColorLevels levels;

  Searched(const Painted& a, const Painted& b)
      : source(a),
        target(b),
        fine(emtr_test::fine_surfaces_of(a.points, b.points, kLeaf)),
        levels(fine, channels(), emtr::select_kernels()) {}

  emtr::Channels channels() const {
    const auto leaf = static_cast<float>(fine.leaf());
    return emtr::make_channels(emtr::mean_colors(source.points, source.colors, leaf),
                               emtr::mean_colors(target.points, target.colors, leaf));
  }

  emtr::FoundByColor search(const Rigid& start, int threads = 1) const {
    const emtr::FreeMotions motions(of_a_plane(), start);
    emtr::FoundByColor out;
    emtr::ThreadTeam::with(threads, [&](emtr::ThreadTeam& team) {
      out = emtr::search_by_color(levels, motions, nullptr, 4, team);
    });
    return out;
  }
};

TEST(ColorSearch, FindsAPlaneAnywhereWithinItself) {
  const emtr_test::Patches patches(1);
  const Rigid away = emtr_test::motion({0, 0, 130}, {0.2, -0.1, 0});
  Painted source = emtr_test::painted_plane(patches, 2, 0, 0.7, 0.1);
  source.points = emtr_test::moved_by(away.inverse(), source.points);
  const Searched searched(source, emtr_test::painted_plane(patches, 3, 0.3));
  const emtr::FoundByColor found = searched.search({});
  ASSERT_FALSE(found.poses.empty());
  EXPECT_LT(emtr_test::degrees_between(found.poses.front(), away), 2);
  EXPECT_LT(emtr_test::translation_between(found.poses.front(), away), 0.02);
  EXPECT_GT(found.looked_at, 10000u);
}

TEST(ColorSearch, DoesNotDependOnTheThreads) {
  const emtr_test::Patches patches(1);
  const Searched searched(emtr_test::painted_plane(patches, 2),
                          emtr_test::painted_plane(patches, 3, 0.3));
  const emtr::FoundByColor one = searched.search({}, 1), four = searched.search({}, 4);
  ASSERT_EQ(one.poses.size(), four.poses.size());
  for (std::size_t i = 0; i < one.poses.size(); ++i) {
    EXPECT_EQ(one.poses[i].R, four.poses[i].R);
    EXPECT_EQ(one.poses[i].t, four.poses[i].t);
  }
}

TEST(ColorSearch, FindsNothingWithoutFreeMotions) {
  const emtr_test::Patches patches(1);
  const Searched searched(emtr_test::painted_plane(patches, 2),
                          emtr_test::painted_plane(patches, 3));
  emtr::HessianSpectrum cube;
  cube.radius = 0.6;
  emtr::ThreadTeam::with(1, [&](emtr::ThreadTeam& team) {
    const emtr::FoundByColor found =
        emtr::search_by_color(searched.levels, emtr::FreeMotions(cube, {}), nullptr, 4, team);
    EXPECT_TRUE(found.poses.empty());
    EXPECT_EQ(found.looked_at, 0u);
  });
}

}  // namespace
