#include <gtest/gtest.h>

#include <cmath>

#include "features/nearest_normals.h"
#include "refinement/shapes.h"

namespace {

TEST(NearestNormals, AreRadialOnASphereHoweverSparse) {
  for (const int points : {200, 3000}) {
    emtr_test::Draw draw(5);
    emtr::Cloud sphere;
    for (int i = 0; i < points; ++i) {
      const Eigen::Vector3f p = draw.direction().cast<float>();
      sphere.append(p.x(), p.y(), p.z());
    }
    const emtr::Cloud normals = emtr::nearest_normals(sphere, 16);
    ASSERT_EQ(normals.size(), sphere.size());
    double sum = 0;
    for (std::size_t i = 0; i < normals.size(); ++i)
      sum += std::abs(normals.x[i] * sphere.x[i] + normals.y[i] * sphere.y[i] +
                      normals.z[i] * sphere.z[i]);
    EXPECT_GT(sum / points, 0.98) << points;
  }
}

}  // namespace
