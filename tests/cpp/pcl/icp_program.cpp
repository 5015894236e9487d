// A plain PCL program: aligns the first cloud with the second by ICP.
#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/registration/icp.h>

#include <iostream>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  pcl::PointCloud<pcl::PointXYZ>::Ptr source(new pcl::PointCloud<pcl::PointXYZ>);
  pcl::PointCloud<pcl::PointXYZ>::Ptr target(new pcl::PointCloud<pcl::PointXYZ>);
  if (pcl::io::loadPCDFile(argv[1], *source) < 0) return 2;
  if (pcl::io::loadPCDFile(argv[2], *target) < 0) return 2;

  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> registration;
  registration.setInputSource(source);
  registration.setInputTarget(target);
  pcl::PointCloud<pcl::PointXYZ> aligned;
  registration.align(aligned);

  std::cout << registration.hasConverged() << ' ' << registration.getFitnessScore() << '\n'
            << registration.getFinalTransformation() << '\n';
  return registration.hasConverged() ? 0 : 1;
}
