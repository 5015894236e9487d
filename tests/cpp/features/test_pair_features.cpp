#include <gtest/gtest.h>
#include <pcl/features/pfh_tools.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <random>

#include "features/pair_features.h"
#include "support/pcl_rounding.h"

namespace {

using Vector = std::array<float, 3>;

struct Pair {
  Vector p1, n1, p2, n2;
};

Eigen::Vector4f of_pcl(const Vector& v, float fourth) { return {v[0], v[1], v[2], fourth}; }

void expect_the_same_bits(const Pair& pair) {
  if (emtr_test::kPclContracts) GTEST_SKIP() << emtr_test::kNoOracle;
  const emtr::PairFeatures found =
      emtr::pair_features(pair.p1.data(), pair.n1.data(), pair.p2.data(), pair.n2.data());
  emtr::PairFeatures expected;
  pcl::computePairFeatures(of_pcl(pair.p1, 1), of_pcl(pair.n1, 0), of_pcl(pair.p2, 1),
                           of_pcl(pair.n2, 0), expected.f1, expected.f2, expected.f3, expected.f4);
  ASSERT_FALSE(std::memcmp(&found, &expected, sizeof found))
      << found.f1 << ' ' << found.f2 << ' ' << found.f3 << ' ' << found.f4
      << ", PCL: " << expected.f1 << ' ' << expected.f2 << ' ' << expected.f3 << ' ' << expected.f4;
}

class Draw {
 public:
  explicit Draw(unsigned seed) : engine_(seed) {}
  float number() { return uniform_(engine_); }
  Vector point() { return {number(), number(), number()}; }
  Vector direction() {
    const Vector v = point();
    const float length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    return {v[0] / length, v[1] / length, v[2] / length};
  }
  /// A point of a coarse lattice and a direction along an axis: many angles are 0 or equal.
  Vector coarse() { return {step(), step(), step()}; }
  Vector axis() {
    Vector v = {0, 0, 0};
    v[static_cast<std::size_t>(engine_() % 3)] = engine_() % 2 ? 1.0f : -1.0f;
    return v;
  }

 private:
  float step() { return static_cast<float>(static_cast<int>(engine_() % 3) - 1); }

  std::mt19937 engine_;
  std::uniform_real_distribution<float> uniform_{-1, 1};
};

TEST(PairFeatures, AreTheSameBitsAsThoseOfPcl) {
  Draw draw(1);
  for (int i = 0; i < 200000; ++i)
    expect_the_same_bits({draw.point(), draw.direction(), draw.point(), draw.direction()});
}

TEST(PairFeatures, AreTheSameBitsWhereAnglesAreEqual) {
  Draw draw(2);
  for (int i = 0; i < 20000; ++i) {
    expect_the_same_bits({draw.coarse(), draw.axis(), draw.coarse(), draw.axis()});
    const Vector normal = draw.direction();
    expect_the_same_bits({draw.point(), normal, draw.point(), normal});
  }
}

TEST(PairFeatures, AreZeroWithoutAFrame) {
  const Vector p = {1, 2, 3}, n = {0, 0, 1}, above = {1, 2, 4};
  for (const Pair& pair : {Pair{p, n, p, n}, Pair{p, n, above, n}}) {
    const emtr::PairFeatures found =
        emtr::pair_features(pair.p1.data(), pair.n1.data(), pair.p2.data(), pair.n2.data());
    EXPECT_EQ(found.f1, 0);
    EXPECT_EQ(found.f2, 0);
    EXPECT_EQ(found.f3, 0);
    EXPECT_EQ(found.f4, 0);
    expect_the_same_bits(pair);
  }
}

TEST(PairFeatures, HasTheAnglesOfARightCorner) {
  // Normals along x and z, the second point along y: v is z cross x or the like, whatever the sign.
  const Vector p1 = {0, 0, 0}, n1 = {1, 0, 0}, p2 = {0, 2, 0}, n2 = {0, 0, 1};
  const emtr::PairFeatures found = emtr::pair_features(p1.data(), n1.data(), p2.data(), n2.data());
  EXPECT_FLOAT_EQ(found.f4, 2);
  EXPECT_FLOAT_EQ(found.f3, 0);
  EXPECT_FLOAT_EQ(std::fabs(found.f2), 1);
}

}  // namespace
