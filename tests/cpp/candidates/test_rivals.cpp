#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "candidates/rivals.h"
#include "candidates/scene.h"

namespace {

using Eigen::Vector3d;
using emtr::Rigid;
using emtr::Surface;
using emtr::SurfacePair;

/// The walls of a room of 2 x 1.2 x 0.8 without floor, about `middle`.
Surface room(const Vector3d& middle, double phase) {
  Surface out;
  out.leaf = 0.05;
  const auto push = [&](const Vector3d& p, const emtr_test::Vector& n) {
    const Vector3d at = middle + p;
    emtr_test::push(out, {at.x(), at.y(), at.z()}, n);
  };
  for (double z = -0.4; z < 0.4; z += 0.05) {
    for (double x = -1 + 0.05 * phase; x < 1; x += 0.05)
      for (const double y : {-0.6, 0.6}) push({x, y, z}, {0, 1, 0});
    for (double y = -0.6 + 0.05 * phase; y < 0.6; y += 0.05)
      for (const double x : {-1.0, 1.0}) push({x, y, z}, {1, 0, 0});
  }
  return out;
}

TEST(Rivals, AreTheRotationsOfARoomThatLooksAlikeFromBothEnds) {
  const Vector3d middle(0.3, -0.1, 0.2);
  const SurfacePair surfaces(room(middle, 0), room(middle, 0.4), {}, {}, emtr::select_kernels());
  const std::vector<Rigid> rivals = emtr::quarter_rotated_rivals(surfaces, Rigid{});
  for (const Vector3d& axis : {Vector3d(0, 0, 1), Vector3d(1, 0, 0), Vector3d(0, 1, 0)}) {
    Rigid rotation;
    rotation.R = 2 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
    rotation.t = middle - rotation.rotate(middle);
    EXPECT_TRUE(std::any_of(rivals.begin(), rivals.end(), [&](const Rigid& rival) {
      return is_same_pose(rival, rotation, {0.1, 0.06});
    })) << axis.transpose();
  }
}

TEST(Rivals, AreRigidAndDifferFromEachOtherAndTheBest) {
  const emtr_test::Scene scene(32);
  const SurfacePair surfaces(scene.source, scene.target, {}, {}, emtr::select_kernels());
  const std::vector<Rigid> rivals = emtr::quarter_rotated_rivals(surfaces, scene.truth);
  EXPECT_GE(rivals.size(), 9u);
  EXPECT_LE(rivals.size(), 24u);
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    double T[16];
    to_matrix(rivals[i], T);
    EXPECT_TRUE(emtr::is_rigid(T));
    EXPECT_FALSE(is_same_pose(rivals[i], scene.truth, emtr::kDistinctPose));
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(is_same_pose(rivals[i], rivals[j], emtr::kDuplicatePose));
  }
}

TEST(Rivals, MoveWithTheScene) {
  const Vector3d middle(0.3, -0.1, 0.2);
  const Rigid M = emtr_test::motion({20, -40, 70}, {0.1, 0.2, -0.3});
  const Surface a = room(middle, 0), b = room(middle, 0.4);
  const SurfacePair here(a, b, {}, {}, emtr::select_kernels()),
      there(a, emtr_test::moved(b, M), {}, {}, emtr::select_kernels());
  const auto rotations = emtr::quarter_rotated_rivals(here, Rigid{});
  const auto moved = emtr::quarter_rotated_rivals(there, M);
  ASSERT_EQ(rotations.size(), moved.size());
  for (const Rigid& rotation : rotations)
    EXPECT_TRUE(std::any_of(moved.begin(), moved.end(), [&](const Rigid& other) {
      return is_same_pose(other, M * rotation, {0.05, 0.03});
    }));
}

/// A wall along x with pillars of 0.1 before it, every 0.4.
Surface colonnade(double phase) {
  Surface out;
  out.leaf = 0.03;
  for (double z = -0.3; z < 0.3; z += 0.03)
    for (double x = -1 + 0.03 * phase; x < 1; x += 0.03) {
      const double place = x + 1 - 0.4 * std::floor((x + 1) / 0.4);
      emtr_test::push(out, {x, place < 0.1 ? -0.1 : 0.0, z}, {0, 1, 0});
      if (place < 0.1) {
        emtr_test::push(out, {x - place, -0.1 * (z + 0.3) / 0.6, z}, {1, 0, 0});
        emtr_test::push(out, {x - place + 0.1, -0.1 * (z + 0.3) / 0.6, z}, {1, 0, 0});
      }
    }
  return out;
}

TEST(Rivals, AreTheTranslationsOfAColonnadeByItsPeriod) {
  const SurfacePair surfaces(colonnade(0), colonnade(0.4), {}, {}, emtr::select_kernels());
  emtr::ThreadTeam::with(2, [&](emtr::ThreadTeam& team) {
    const std::vector<Rigid> rivals = emtr::translated_rivals(surfaces, Rigid{}, team);
    EXPECT_LE(rivals.size(), emtr::kMostPeaks);
    EXPECT_TRUE(std::any_of(rivals.begin(), rivals.end(), [&](const Rigid& rival) {
      return (rival.t - Vector3d(std::copysign(0.4, rival.t.x()), 0, 0)).norm() < 0.05;
    }));
  });
}

TEST(Rivals, WithoutAPeriodNoTranslationIsOne) {
  const emtr_test::Scene scene(32);
  const SurfacePair surfaces(scene.source, scene.target, {}, {}, emtr::select_kernels());
  emtr::ThreadTeam::with(1, [&](emtr::ThreadTeam& team) {
    EXPECT_LE(emtr::translated_rivals(surfaces, scene.truth, team).size(), 1u);
  });
}

/// A hub with five blades at equal angles, which lean the same way.
Surface propeller(double phase) {
  Surface out;
  out.leaf = 0.04;
  for (int blade = 0; blade < 5; ++blade) {
    const Rigid M = emtr_test::motion({0, 0, 72.0 * blade}, {0, 0, 0});
    for (double r = 0.2 + 0.04 * phase; r < 1; r += 0.04)
      for (double w = -0.15; w < 0.15; w += 0.04) {
        const Vector3d p = M * Vector3d(r, w, 0.7 * w), n = M.rotate({0, -0.573, 0.819});
        emtr_test::push(out, {p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()});
      }
  }
  for (double angle = 0; angle < 2 * M_PI; angle += 0.2)
    for (double z = -0.2; z < 0.3; z += 0.04)
      emtr_test::push(out, {0.2 * std::cos(angle), 0.2 * std::sin(angle), z},
                      {std::cos(angle), std::sin(angle), 0});
  return out;
}

TEST(Rivals, AreTheRotationsOfAPropellerOfFiveBlades) {
  const SurfacePair surfaces(propeller(0), propeller(0.4), {}, {}, emtr::select_kernels());
  emtr::ThreadTeam::with(2, [&](emtr::ThreadTeam& team) {
    const std::vector<Rigid> rivals = emtr::rotated_rivals(surfaces, Rigid{}, team);
    EXPECT_LE(rivals.size(), emtr::kMostPeaks);
    for (const double degrees : {72.0, 144.0, 216.0, 288.0}) {
      const Rigid rotation = emtr_test::motion({0, 0, degrees}, {0, 0, 0});
      EXPECT_TRUE(std::any_of(rivals.begin(), rivals.end(), [&](const Rigid& rival) {
        return is_same_pose(rival, rotation, {0.1, 0.06});
      })) << degrees;
    }
  });
}

TEST(Rivals, WithoutFoldsNoRotationIsOne) {
  const emtr_test::Scene scene(32);
  const SurfacePair surfaces(scene.source, scene.target, {}, {}, emtr::select_kernels());
  emtr::ThreadTeam::with(1, [&](emtr::ThreadTeam& team) {
    EXPECT_LE(emtr::rotated_rivals(surfaces, scene.truth, team).size(), 1u);
  });
}

}  // namespace
