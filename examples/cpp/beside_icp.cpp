// Registers two clouds of PCD by emtr and by PCL's ICP, both from the poses in the files:
// beside_icp SOURCE TARGET. Prints both transformations, and the angle between their rotations.
#include <pcl/io/pcd_io.h>
#include <pcl/registration/emtr_ssc.h>
#include <pcl/registration/icp.h>

#include <cmath>
#include <iostream>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Registration = pcl::Registration<pcl::PointXYZ, pcl::PointXYZ>;

// Both are a pcl::Registration, so the same code runs them.
Eigen::Matrix4f align(Registration& registration, const Cloud::Ptr& source,
                      const Cloud::Ptr& target) {
  registration.setInputSource(source);
  registration.setInputTarget(target);
  Cloud aligned;
  registration.align(aligned);
  return registration.getFinalTransformation();
}

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: beside_icp SOURCE TARGET\n";
    return 1;
  }
  Cloud::Ptr source(new Cloud), target(new Cloud);
  if (pcl::io::loadPCDFile(argv[1], *source) < 0) return 2;
  if (pcl::io::loadPCDFile(argv[2], *target) < 0) return 2;

  pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ> emtr;
  const Eigen::Matrix4f global = align(emtr, source, target);
  std::cout << "emtr, from nothing: " << emtr.getReasonText() << ", confidence "
            << emtr.getConfidence() << '\n'
            << global << '\n';

  // ICP finds the nearest minimum. It needs a start, and a distance that fits the clouds' unit.
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> icp;
  icp.setMaximumIterations(50);
  const Eigen::Matrix4f local = align(icp, source, target);
  std::cout << "ICP, from the poses in the files: "
            << (icp.hasConverged() ? "converged" : "not converged") << '\n'
            << local << '\n';

  const Eigen::AngleAxisf apart(
      Eigen::Matrix3f(global.topLeftCorner<3, 3>().transpose() * local.topLeftCorner<3, 3>()));
  std::cout << "the two rotations are " << apart.angle() * 180 / M_PI << " degrees apart\n";
  return emtr.hasConverged() ? 0 : 3;
}
