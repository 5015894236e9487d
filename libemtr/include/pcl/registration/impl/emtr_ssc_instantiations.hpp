#pragma once

#include <pcl/pcl_config.h>
#include <pcl/point_types.h>
#include <pcl/registration/emtr_ssc.h>
#include <pcl/registration/emtr_ssc_abi.h>

/** \brief Lists the instantiations in libpcl_emtr: DO(point type, scalar) for each. */
#define EMTR_SSC_FOR_EACH_INSTANTIATION(DO) \
  DO(pcl::PointXYZ, float)                  \
  DO(pcl::PointXYZ, double)                 \
  DO(pcl::PointXYZI, float)                 \
  DO(pcl::PointXYZI, double)                \
  DO(pcl::PointXYZRGB, float)               \
  DO(pcl::PointXYZRGB, double)              \
  DO(pcl::PointXYZRGBA, float)              \
  DO(pcl::PointXYZRGBA, double)             \
  DO(pcl::PointXYZRGBNormal, float)         \
  DO(pcl::PointXYZRGBNormal, double)        \
  DO(pcl::PointNormal, float)               \
  DO(pcl::PointNormal, double)              \
  DO(pcl::PointXYZINormal, float)           \
  DO(pcl::PointXYZINormal, double)

/* The layout of pcl::Registration, and how it is allocated, depend on how Eigen aligns: -mavx
 * changes both, and C++14 allocates in another way than C++17. The compiled code serves programs
 * that are compiled alike; other programs instantiate the class themselves. */
#ifndef EIGEN_HAS_CXX17_OVERALIGN /* before Eigen 3.4 */
#define EIGEN_HAS_CXX17_OVERALIGN 0
#endif
#define EMTR_SSC_IS_COMPILED                                                                     \
  (PCL_MAJOR_VERSION == EMTR_SSC_ABI_PCL_MAJOR && PCL_MINOR_VERSION == EMTR_SSC_ABI_PCL_MINOR && \
   EIGEN_MAX_ALIGN_BYTES == EMTR_SSC_ABI_MAX_ALIGN &&                                            \
   EIGEN_MALLOC_ALREADY_ALIGNED == EMTR_SSC_ABI_MALLOC_ALIGNED &&                                \
   EIGEN_HAS_CXX17_OVERALIGN == EMTR_SSC_ABI_OVERALIGN)

#if !defined(PCL_NO_PRECOMPILE) && !defined(EMTR_SSC_CPP_) && EMTR_SSC_IS_COMPILED
#define EMTR_SSC_DECLARE(PointT, Scalar) \
  extern template class EMTR_API pcl::EMTRSSCRegistration<PointT, PointT, Scalar>;
EMTR_SSC_FOR_EACH_INSTANTIATION(EMTR_SSC_DECLARE)
#undef EMTR_SSC_DECLARE
#endif
