#include <gtest/gtest.h>

#include <cmath>

#include "refinement/shapes.h"
#include "verdict/symmetry.h"

namespace {

using emtr::Candidate;
using emtr::Rigid;
using emtr::Symmetry;
using emtr_test::motion;

Candidate candidate(const Rigid& pose, double score) {
  Candidate out;
  out.pose = pose;
  out.score = score;
  return out;
}

/// Candidates that differ from an oblique pose by these motions, all about as good.
std::vector<Candidate> ranked(const std::vector<Rigid>& motions) {
  const Rigid best = motion({20, 50, -30}, {0.3, 0.1, 0.2});
  std::vector<Candidate> out{candidate(best, 0.7)};
  for (const Rigid& m : motions) out.push_back(candidate(m * best, 0.65));
  return out;
}

Symmetry find_symmetry(const std::vector<Candidate>& ranked,
                       const emtr::HessianSpectrum* spectrum) {
  return emtr::find_symmetry(ranked.front(), {ranked.begin() + 1, ranked.end()}, spectrum);
}

TEST(Symmetry, OfAGearIsRotationalWithAsManyFoldsAsTeeth) {
  const Symmetry s =
      find_symmetry(ranked({motion({0, 0, 90}, {0, 0, 0}), motion({0, 0, -120}, {0, 0, 0}),
                            motion({0, 0, 31}, {0, 0, 0})}),
                    nullptr);
  EXPECT_EQ(s.kind, Symmetry::Rotational);
  EXPECT_EQ(s.order, 12);
  EXPECT_NEAR(std::abs(s.axis.z()), 1, 1e-9);
  EXPECT_TRUE(std::isnan(s.period));
}

TEST(Symmetry, OfABoxIsTwofoldAboutTheAxisOfItsBestRival) {
  const Symmetry s = find_symmetry(
      ranked({motion({0, 180, 0}, {0, 0, 0}), motion({180, 0, 0}, {0, 0, 0})}), nullptr);
  EXPECT_EQ(s.order, 2);
  EXPECT_NEAR(std::abs(s.axis.y()), 1, 1e-9);
}

TEST(Symmetry, OfAFacadeIsTranslationalWithTheShortestPeriod) {
  const Symmetry s = find_symmetry(
      ranked({motion({0, 0, 0}, {-0.8, 0, 0}), motion({0, 0, 1}, {0.4, 0, 0})}), nullptr);
  EXPECT_EQ(s.kind, Symmetry::Translational);
  EXPECT_NEAR(s.period, 0.4, 0.03);
  EXPECT_GT(std::abs(s.axis.x()), 0.99);
  EXPECT_EQ(s.order, 0);
}

TEST(Symmetry, IsNoneWithoutARivalOrWithAScrew) {
  EXPECT_EQ(find_symmetry(ranked({}), nullptr).kind, Symmetry::None);
  std::vector<Candidate> poor = ranked({motion({0, 0, 90}, {0, 0, 0})});
  poor.back().score = 0.3;
  EXPECT_EQ(find_symmetry(poor, nullptr).kind, Symmetry::None);
  EXPECT_EQ(find_symmetry(ranked({motion({0, 0, 90}, {0, 0, 0.5})}), nullptr).kind, Symmetry::None);
}

TEST(Symmetry, OfUnconstrainedSurfacesIsContinuous) {
  emtr::HessianSpectrum spectrum;
  spectrum.radius = 1;
  spectrum.unconstrained = 2;  // a cylinder about x, in mixed directions
  const double part = std::sqrt(0.5);
  spectrum.eigenvectors[0][0] = spectrum.eigenvectors[0][3] = part;
  spectrum.eigenvectors[1][0] = -part;
  spectrum.eigenvectors[1][3] = part;
  const Symmetry cylinder = find_symmetry(ranked({}), &spectrum);
  EXPECT_EQ(cylinder.kind, Symmetry::Continuous);
  EXPECT_NEAR(std::abs(cylinder.axis.x()), 1, 1e-9);

  emtr::HessianSpectrum corridor;
  corridor.unconstrained = 1;
  corridor.eigenvectors[0][4] = 1;
  const Symmetry found = find_symmetry(ranked({}), &corridor);
  EXPECT_EQ(found.kind, Symmetry::Translational);
  EXPECT_EQ(found.period, 0);
  EXPECT_NEAR(std::abs(found.axis.y()), 1, 1e-9);
}

}  // namespace
