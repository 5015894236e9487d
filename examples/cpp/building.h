// A storey of a building made of boxes, and a spinning LiDAR in it: data for relocalize.cpp.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

struct Box {
  std::array<double, 3> low, high;  // meters
};

// Rooms of 16 x 10 m with doors and furniture, so that most places look different.
inline std::vector<Box> make_building() {
  return {
      {{-0.2, 0, 0}, {0, 10, 3}},
      {{16, 0, 0}, {16.2, 10, 3}},
      {{0, -0.2, 0}, {16, 0, 3}},
      {{0, 10, 0}, {16, 10.2, 3}},
      {{0, 0, -0.2}, {16, 10, 0}},
      {{0, 0, 3}, {16, 10, 3.2}},
      {{6, 0, 0}, {6.2, 4, 3}},
      {{6, 5.2, 0}, {6.2, 10, 3}},
      {{6.2, 6.5, 0}, {9, 6.7, 3}},
      {{10.2, 6.5, 0}, {16, 6.7, 3}},
      {{0.3, 0.3, 0.7}, {2.1, 1.2, 0.8}},
      {{0.3, 0.3, 0}, {0.5, 1.2, 0.7}},
      {{0, 6, 0}, {0.6, 8.4, 2.1}},
      {{3.5, 9.3, 0}, {5.1, 10, 1.1}},
      {{3.2, 2.6, 0}, {4.4, 3.8, 0.45}},
      {{8.2, 0, 0}, {9.1, 0.5, 1.9}},
      {{11.5, 2.2, 0}, {13.7, 3.4, 0.75}},
      {{15.2, 4.1, 0}, {16, 6.2, 1.4}},
      {{7.1, 3.1, 0}, {7.5, 3.5, 3}},
      {{13.2, 9.1, 0}, {15.8, 10, 0.9}},
      {{7, 8.1, 0}, {8.9, 8.9, 0.6}},
      {{10.6, 7.0, 0}, {11.2, 7.4, 1.7}},
  };
}

// Returns the range at which a ray meets the first box, infinite if it meets none.
inline double range(const std::vector<Box>& boxes, const Eigen::Vector3d& from,
                    const Eigen::Vector3d& direction) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Box& box : boxes) {
    double enter = 0, leave = nearest;
    for (int i = 0; i < 3; ++i) {
      const double a = (box.low[i] - from[i]) / direction[i];
      const double b = (box.high[i] - from[i]) / direction[i];
      enter = std::max(enter, std::min(a, b));
      leave = std::min(leave, std::max(a, b));
    }
    if (enter < leave) nearest = enter;
  }
  return nearest;
}

// Scans the building from a pose: 48 rings of 900 points, 1 cm of noise, in the sensor's frame.
inline Cloud::Ptr scan(const std::vector<Box>& boxes, const Eigen::Isometry3d& pose,
                       unsigned seed) {
  std::mt19937 generator(seed);
  std::normal_distribution<double> noise(0, 0.01);
  Cloud::Ptr cloud(new Cloud);
  for (int ring = 0; ring < 48; ++ring) {
    const double up = (-35 + ring * 70.0 / 47) * M_PI / 180;
    for (int step = 0; step < 900; ++step) {
      const double around = 2 * M_PI * (step + 0.5) / 900 + 1e-4;
      const Eigen::Vector3d ray(std::cos(up) * std::cos(around), std::cos(up) * std::sin(around),
                                std::sin(up));
      const double r = range(boxes, pose.translation(), pose.linear() * ray) + noise(generator);
      if (!std::isfinite(r)) continue;
      const Eigen::Vector3f p = (r * ray).cast<float>();
      cloud->push_back(pcl::PointXYZ(p.x(), p.y(), p.z()));
    }
  }
  return cloud;
}

// A level sensor at (x, y), 1.1 m above the floor, that looks along an angle in degrees.
inline Eigen::Isometry3d level_pose(double x, double y, double angle) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translate(Eigen::Vector3d(x, y, 1.1));
  pose.rotate(Eigen::AngleAxisd(angle * M_PI / 180, Eigen::Vector3d::UnitZ()));
  return pose;
}
