// ICP, NDT and TrICP of PCL, started by a RANSAC over FPFH (pcl::SampleConsensusPrerejective), as
// the paper's traditional methods are. One registration a line of standard input:
//   SOURCE.pcd TARGET.pcd VOXEL SEED
// The answer is a line of JSON for each method: the pose, row by row, and the seconds.
#include <pcl/features/fpfh_omp.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/io/pcd_io.h>
#include <pcl/registration/correspondence_rejection_trimmed.h>
#include <pcl/registration/icp.h>
#include <pcl/registration/ndt.h>
#include <pcl/registration/sample_consensus_prerejective.h>

#include <chrono>
#include <cstdlib>
#include <iomanip>
#include <iostream>
#include <sstream>
#include <string>

namespace {

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

// In voxels, but where it is said.
constexpr double kNormalRadius = 2, kFeatureRadius = 5, kRansacDistance = 1.5;
constexpr int kRansacIterations = 50000, kRansacSample = 3, kRansacNearest = 3;
constexpr float kEdgeSimilarity = 0.9F, kRansacInliers = 0.2F;
constexpr double kIcpDistance = 3, kNdtResolution = 4, kNdtStep = 0.5;
constexpr int kIterations = 100, kNdtIterations = 50;
constexpr float kTrimmedOverlap = 0.7F;  // a share of the matches

Cloud::Ptr downsampled(const Cloud::ConstPtr& cloud, double voxel) {
  auto out = pcl::make_shared<Cloud>();
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(cloud);
  const auto leaf = static_cast<float>(voxel);
  grid.setLeafSize(leaf, leaf, leaf);
  grid.filter(*out);
  return out;
}

Features::Ptr described(const Cloud::ConstPtr& cloud, double voxel) {
  auto normals = pcl::make_shared<Normals>();
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimate(1);
  estimate.setInputCloud(cloud);
  estimate.setRadiusSearch(kNormalRadius * voxel);
  Eigen::Vector4f centroid;
  pcl::compute3DCentroid(*cloud, centroid);
  estimate.setViewPoint(centroid[0], centroid[1], centroid[2]);  // so that no pose changes them
  estimate.compute(*normals);
  auto out = pcl::make_shared<Features>();
  pcl::FPFHEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> features(1);
  features.setInputCloud(cloud);
  features.setInputNormals(normals);
  features.setRadiusSearch(kFeatureRadius * voxel);
  features.compute(*out);
  return out;
}

Eigen::Matrix4f ransac(const Cloud::ConstPtr& source, const Cloud::ConstPtr& target, double voxel) {
  pcl::SampleConsensusPrerejective<pcl::PointXYZ, pcl::PointXYZ, pcl::FPFHSignature33> search;
  search.setInputSource(source);
  search.setInputTarget(target);
  search.setSourceFeatures(described(source, voxel));
  search.setTargetFeatures(described(target, voxel));
  search.setMaximumIterations(kRansacIterations);
  search.setNumberOfSamples(kRansacSample);
  search.setCorrespondenceRandomness(kRansacNearest);
  search.setSimilarityThreshold(kEdgeSimilarity);
  search.setMaxCorrespondenceDistance(kRansacDistance * voxel);
  search.setInlierFraction(kRansacInliers);
  Cloud aligned;
  search.align(aligned);
  return search.getFinalTransformation();
}

Eigen::Matrix4f icp(const Cloud::ConstPtr& source, const Cloud::ConstPtr& target,
                    const Eigen::Matrix4f& start, double voxel, bool trimmed) {
  pcl::IterativeClosestPoint<pcl::PointXYZ, pcl::PointXYZ> method;
  method.setInputSource(source);
  method.setInputTarget(target);
  method.setMaximumIterations(kIterations);
  method.setTransformationEpsilon(1e-10);
  if (trimmed) {
    auto rejector = pcl::make_shared<pcl::registration::CorrespondenceRejectorTrimmed>();
    rejector->setOverlapRatio(kTrimmedOverlap);
    method.addCorrespondenceRejector(rejector);
  } else {
    method.setMaxCorrespondenceDistance(kIcpDistance * voxel);
  }
  Cloud aligned;
  method.align(aligned, start);
  return method.getFinalTransformation();
}

Eigen::Matrix4f ndt(const Cloud::ConstPtr& source, const Cloud::ConstPtr& target,
                    const Eigen::Matrix4f& start, double voxel) {
  pcl::NormalDistributionsTransform<pcl::PointXYZ, pcl::PointXYZ> method;
  method.setResolution(static_cast<float>(kNdtResolution * voxel));
  method.setStepSize(kNdtStep * voxel);
  method.setTransformationEpsilon(1e-3 * voxel);
  method.setMaximumIterations(kNdtIterations);
  method.setInputSource(source);
  method.setInputTarget(target);
  Cloud aligned;
  method.align(aligned, start);
  return method.getFinalTransformation();
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void tell(const char* method, const Eigen::Matrix4f& pose, double seconds) {
  std::cout << R"({"method":")" << method << R"(","seconds":)" << seconds << R"(,"T":[)"
            << std::setprecision(9);
  for (int i = 0; i < 16; ++i) std::cout << (i ? "," : "") << pose(i / 4, i % 4);
  std::cout << "]}" << std::endl;
}

bool answer(const std::string& line) {
  std::istringstream words(line);
  std::string source_file, target_file;
  double voxel = 0;
  unsigned seed = 0;
  if (!(words >> source_file >> target_file >> voxel >> seed) || voxel <= 0) {
    std::cerr << "bench_traditional: expected SOURCE TARGET VOXEL SEED, got " << line << '\n';
    return false;
  }
  auto source = pcl::make_shared<Cloud>(), target = pcl::make_shared<Cloud>();
  if (pcl::io::loadPCDFile(source_file, *source) < 0) return false;
  if (pcl::io::loadPCDFile(target_file, *target) < 0) return false;
  std::srand(seed);  // PCL's own generator
  const double start = now();
  const Cloud::Ptr a = downsampled(source, voxel), b = downsampled(target, voxel);
  const Eigen::Matrix4f pose = ransac(a, b, voxel);
  const double searched = now() - start;
  const auto timed = [&](const char* name, const auto& refine) {
    const double begin = now();
    const Eigen::Matrix4f refined = refine();
    tell(name, refined, searched + now() - begin);
  };
  tell("RANSAC", pose, searched);
  timed("ICP+", [&] { return icp(a, b, pose, voxel, false); });
  timed("NDT+", [&] { return ndt(a, b, pose, voxel); });
  timed("TrICP+", [&] { return icp(a, b, pose, voxel, true); });
  return true;
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) {
    if (!answer(line)) return 1;
  }
  return 0;
}
