// Registers a synthetic pair with the class. Prints the true and the found transformation, whether
// the class of the library is used, and the alignment of this program.
#include <pcl/registration/emtr_ssc.h>

#include <cstdio>
#include <vector>

#include "bumpy_pair.h"

template <typename PointT>
typename pcl::PointCloud<PointT>::Ptr makeCloud(const float* points, std::size_t count) {
  typename pcl::PointCloud<PointT>::Ptr cloud(new pcl::PointCloud<PointT>);
  for (std::size_t i = 0; i < count; ++i) {
    PointT point;
    point.x = points[3 * i];
    point.y = points[3 * i + 1];
    point.z = points[3 * i + 2];
    cloud->push_back(point);
  }
  return cloud;
}

// Allocates, fills, aligns, scores, copies and frees: each fails if two memory layouts meet.
template <typename PointT, typename Scalar>
Eigen::Matrix<Scalar, 4, 4> run(const bumpy_pair& pair) {
  using Registration = pcl::EMTRSSCRegistration<PointT, PointT, Scalar>;
  typename Registration::Ptr reg = pcl::make_shared<Registration>();
  reg->setInputSource(makeCloud<PointT>(pair.source, pair.count));
  reg->setInputTarget(makeCloud<PointT>(pair.target, pair.count));
  pcl::PointCloud<PointT> aligned;
  reg->align(aligned);
  if (!reg->hasConverged() || reg->getFitnessScore() > 0.1 || aligned.size() != pair.count)
    std::fprintf(stderr, "%s %s\n", reg->getReasonText().c_str(), reg->getErrorMessage().c_str());
  Registration copy(*reg);
  reg.reset();
  return copy.getFinalTransformation();
}

int main() {
  bumpy_pair pair;
  if (bumpy_pair_make(&pair, 4, 3000, 1.0) != 0) return 1;
  const Eigen::Matrix4d found = run<pcl::PointXYZ, double>(pair);
  const Eigen::Matrix4f other = run<pcl::PointNormal, float>(pair);
  if (found.cast<float>() != other) {
    std::fprintf(stderr, "the point types give different poses\n");
    return 1;
  }
  for (const double value : pair.pose) std::printf("%.17g ", value);
  std::printf("\n");
  for (int i = 0; i < 16; ++i) std::printf("%.17g ", found(i / 4, i % 4));
#ifdef PCL_NO_PRECOMPILE
  const bool compiled = false;
#else
  const bool compiled = EMTR_SSC_IS_COMPILED;
#endif
  std::printf("\ncompiled %d align %d standard %ld\n", compiled, EIGEN_MAX_ALIGN_BYTES,
              __cplusplus);
  bumpy_pair_free(&pair);
  return 0;
}
