// A robot that has lost its place: registers single scans to a map, without a guess. The map and
// the scans are made here, so the true poses are known. A scan that is not registered does no harm:
// the robot drives on and scans again. Returns 0 if no registered pose is wrong, most scans are
// found, and a scan of another storey is not.
#include <pcl/common/transforms.h>
#include <pcl/registration/emtr_ssc.h>

#include <chrono>
#include <iomanip>
#include <iostream>
#include <utility>
#include <vector>

#include "building.h"

using Emtr = pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ>;

// The map: scans from known poses, as a mapping run leaves it.
Cloud::Ptr make_map(const std::vector<Box>& building) {
  Cloud::Ptr map(new Cloud);
  unsigned seed = 100;
  const std::vector<std::pair<double, double>> places = {
      {2.0, 4.5},  {4.5, 7.0},  {8.5, 2.0}, {9.0, 5.0},
      {13.0, 5.0}, {14.0, 1.5}, {9.5, 8.0}, {13.0, 7.6},
  };
  for (const auto& [x, y] : places) {
    const Eigen::Isometry3d pose = level_pose(x, y, 0);
    Cloud moved;
    pcl::transformPointCloud(*scan(building, pose, seed++), moved, pose.matrix().cast<float>());
    *map += moved;
  }
  return map;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// What became of the scans.
struct Count {
  int found = 0, doubtful = 0, wrong = 0;
};

// Registers a scan to the map and counts it: found if the pose is the one where the scan was made.
void find(Emtr& emtr, const Cloud::Ptr& scan, const Eigen::Isometry3d& truth, Count& count) {
  const auto start = std::chrono::steady_clock::now();
  emtr.setInputSource(scan);
  Cloud aligned;
  emtr.align(aligned);
  const Eigen::Isometry3d found(emtr.getFinalTransformation().cast<double>());
  const double meters = (found.translation() - truth.translation()).norm();
  const double degrees =
      Eigen::AngleAxisd(found.linear() * truth.linear().transpose()).angle() * 180 / M_PI;
  std::cout << std::fixed << std::setprecision(3) << emtr.getReasonText() << ", confidence "
            << emtr.getConfidence() << ": " << meters << " m and " << degrees
            << " degrees from the true pose, " << seconds_since(start) << " s\n";
  if (!emtr.hasConverged())
    ++count.doubtful;
  else
    ++(meters < 0.1 && degrees < 1 ? count.found : count.wrong);
}

int main() {
  const std::vector<Box> building = make_building();
  Emtr emtr;
  emtr.setInputTarget(make_map(building));  // preprocessed once, for all the scans
  emtr.setSourceViewpoint({0, 0, 0});       // a scan is in its sensor's own frame
  emtr.setRotationAxis({0, 0, 1}, 1);       // the robot drives on a level floor, to a degree

  Count here;
  unsigned seed = 1;
  for (const auto& pose : {level_pose(3.0, 5.5, 40), level_pose(7.8, 4.6, 200),
                           level_pose(12.0, 4.4, -75), level_pose(11.5, 8.4, 120)})
    find(emtr, scan(building, pose, seed++), pose, here);

  std::cout << "another storey, built the other way round:\n";
  std::vector<Box> other = building;
  for (Box& box : other) {
    std::swap(box.low[0], box.low[1]);
    std::swap(box.high[0], box.high[1]);
  }
  Count elsewhere;
  const Eigen::Isometry3d pose = level_pose(3, 3, 10);
  find(emtr, scan(other, pose, seed), pose, elsewhere);
  return here.wrong == 0 && here.found >= 3 && elsewhere.doubtful == 1 ? 0 : 3;
}
