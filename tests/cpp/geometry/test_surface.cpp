#include <gtest/gtest.h>

#include <cmath>

#include "geometry/surface.h"
#include "ranking/surfaces.h"

namespace {

using emtr::SharedSurface;
using emtr::Surface;

Surface three() {
  Surface out;
  out.leaf = 0.1;
  emtr_test::push(out, {1, 2, 3}, {0, 0, 1});
  emtr_test::push(out, {4, 5, 6}, {0, 0, -1});
  emtr_test::push(out, {7, 8, 9}, {0, 1, 0});
  return out;
}

TEST(Surface, EveryNthKeepsTheFirstAndTheLeaf) {
  const Surface two = every_nth(three(), 2), one = every_nth(three(), 3);
  EXPECT_EQ(two.points.x, (std::vector<float>{1, 7}));
  EXPECT_EQ(two.normals.y, (std::vector<float>{0, 1}));
  EXPECT_EQ(two.leaf, 0.1);
  EXPECT_EQ(one.points.z, (std::vector<float>{3}));
}

TEST(Surface, NormalsPointToTheViewpoint) {
  Surface s = three();
  s.normals.x[2] = s.normals.y[2] = s.normals.z[2] = std::nanf("");
  emtr::orient_normals(s.points, {0, 0, 100}, s.normals);
  EXPECT_EQ(s.normals.z[0], 1);
  EXPECT_EQ(s.normals.z[1], 1);
  EXPECT_TRUE(std::isnan(s.normals.x[2]));  // a point without a normal stays one
  emtr::orient_normals(s.points, {0, 0, -100}, s.normals);
  EXPECT_EQ(s.normals.z[0], -1);
  EXPECT_EQ(s.normals.z[1], -1);
}

TEST(SharedSurface, HasOneOwnerHoweverManyHandles) {
  const SharedSurface first = three(), second = first;
  EXPECT_EQ(&*first, &*second);
  EXPECT_EQ(first.interleaved().data(), second.interleaved().data());
}

TEST(SharedSurface, InterleavesPointsAndNormals) {
  const SharedSurface s = three();
  ASSERT_EQ(s.interleaved().size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const emtr::SurfacePoint& at = s.interleaved()[i];
    EXPECT_EQ(at.p[0], s->points.x[i]);
    EXPECT_EQ(at.p[1], s->points.y[i]);
    EXPECT_EQ(at.p[2], s->points.z[i]);
    EXPECT_EQ(at.n[0], s->normals.x[i]);
    EXPECT_EQ(at.n[1], s->normals.y[i]);
    EXPECT_EQ(at.n[2], s->normals.z[i]);
  }
}

}  // namespace
