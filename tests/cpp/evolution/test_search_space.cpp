#include <gtest/gtest.h>

#include "evolution/search_space.h"
#include "geometry/euler.h"
#include "priors/random_priors.h"

namespace {

using namespace emtr_test;
using emtr::Rigid;
using emtr::SearchSpace;

TEST(SearchSpace, WithoutAPriorGenesAreAnglesAndTranslation) {
  const SearchSpace space(1.2, nullptr);
  ASSERT_EQ(space.pose_genes().size(), 6u);
  Draw d(1);
  for (int k = 0; k < 50; ++k) {
    double genes[6], back[6];
    for (double& v : genes) v = d.uniform(-4, 4);
    const Rigid a = space.pose(genes), b = emtr::decode(genes);
    EXPECT_TRUE(a.R == b.R && a.t == b.t);
    space.encode(a, genes);
    emtr::encode(a, back);
    EXPECT_TRUE(std::equal(genes, genes + 6, back));
  }
}

TEST(SearchSpace, AnUprightAxisLeavesFourGenes) {
  emtr::Settings s = emtr::preset("default");
  s.has_axis = 1;
  s.axis[2] = 1;
  const auto yaw = emtr::make_prior(s, emtr::Normalization());
  EXPECT_EQ(SearchSpace(1.2, yaw.get()).pose_genes().size(), 4u);
  EXPECT_FALSE(SearchSpace(1.2, yaw.get()).rotation_genes()[0].wall);
  s.axis_tilt = 3;
  const auto leaning = emtr::make_prior(s, emtr::Normalization());
  EXPECT_EQ(SearchSpace(1.2, leaning.get()).pose_genes().size(), 6u);
}

TEST(SearchSpace, GenesDecodeToAdmissiblePosesAndReachAllOfThem) {
  constexpr double bound = 1.2;
  Draw d(2);
  for (int which = 1; which < kAll; ++which)
    for (int k = 0; k < 20; ++k) {
      const emtr::Normalization normalization = any_frame(d, k % 2 ? 2 : 0);
      const Rigid inside = any_pose(d);
      const auto prior =
          emtr::make_prior(limits_around(inside, normalization, which, d), normalization);
      const SearchSpace space(bound, prior.get());
      const auto genes = space.pose_genes();
      for (int j = 0; j < 20; ++j) {
        double at[6], back[6], alias[6];
        for (std::size_t g = 0; g < genes.size(); ++g)
          at[g] = d.uniform(genes[g].low, genes[g].high);
        const Rigid pose = space.pose(at);
        EXPECT_TRUE(prior->admits(pose)) << which;
        EXPECT_LT(prior->rotation().excess(Eigen::Quaterniond(space.rotation(at))), 1e-9);
        // There and back again; and what was decoded lies within the genes' ranges.
        space.encode(pose, back);
        const Rigid again = space.pose(back);
        EXPECT_LT(emtr::rotation_distance(again.R, pose.R), 1e-7) << which;
        EXPECT_LT(translation_between(again, pose), 1e-7) << which;
        space.nearest_alias(back, at, alias);
        EXPECT_LT(emtr::rotation_distance(space.pose(alias).R, pose.R), 1e-7);
        for (std::size_t g = 0; g < space.angles(); ++g) {
          if (!genes[g].wall) continue;
          EXPECT_GE(back[g], genes[g].low - 1e-7) << which << ", gene " << g;
          EXPECT_LE(back[g], genes[g].high + 1e-7) << which << ", gene " << g;
        }
      }
      // The pose that the limits were drawn around.
      double at[6];
      space.encode(inside, at);
      for (std::size_t g = 0; g < genes.size(); ++g) {
        if (!genes[g].wall) continue;
        EXPECT_GE(at[g], genes[g].low - 1e-7) << which << ", gene " << g;
        EXPECT_LE(at[g], genes[g].high + 1e-7) << which << ", gene " << g;
      }
      if (HasFailure()) FAIL() << "limits " << which << ", case " << k;
    }
}

TEST(SearchSpace, AnArcIsTheShortestAndHasItsShare) {
  Draw d(3);
  emtr::Settings tilted = emtr::preset("default"), near = tilted;
  tilted.has_axis = 1;
  tilted.axis[1] = 1;
  tilted.axis_tilt = 40;
  near.maximum_rotation = 80;
  const auto leaning = emtr::make_prior(tilted, emtr::Normalization());
  const auto ball = emtr::make_prior(near, emtr::Normalization());
  for (const emtr::Prior* prior :
       {static_cast<const emtr::Prior*>(nullptr), leaning.get(), ball.get()}) {
    const SearchSpace space(1.2, prior);
    const auto genes = space.rotation_genes();
    for (int k = 0; k < 200; ++k) {
      double from[3], to[3], at[3];
      for (std::size_t g = 0; g < 3; ++g) {
        // Angles fly on beyond their range.
        const double beyond = genes[g].wall ? 1 : 2;
        from[g] = d.uniform(beyond * genes[g].low, beyond * genes[g].high);
        to[g] = d.uniform(beyond * genes[g].low, beyond * genes[g].high);
      }
      const double share = d.uniform(0, 1);
      space.arc(from, to, share, at);
      const Eigen::Matrix3d R[3] = {space.rotation(from), space.rotation(to), space.rotation(at)};
      const double whole = emtr::rotation_distance(R[0], R[1]);
      if (prior != leaning.get()) {  // a tilt's limit need not hold on the way
        EXPECT_NEAR(emtr::rotation_distance(R[0], R[2]), share * whole, 1e-6);
        EXPECT_NEAR(emtr::rotation_distance(R[2], R[1]), (1 - share) * whole, 1e-6);
      }
      if (prior) {
        emtr::Rigid pose;
        pose.R = R[2];
        EXPECT_TRUE(prior->admits(prior->project(pose)));
        EXPECT_LT(emtr::rotation_distance(prior->project(pose).R, R[2]), 1e-9);
      }
      double none[3];
      space.arc(from, to, 0, none);
      EXPECT_LT(emtr::rotation_distance(space.rotation(none), R[0]), 1e-7);
      if (!prior) {  // of all angles those nearest to where the receiver is
        for (std::size_t g = 0; g < 3; ++g) EXPECT_LE(std::abs(at[g] - from[g]), 2 * M_PI);
      }
    }
  }
}

}  // namespace
