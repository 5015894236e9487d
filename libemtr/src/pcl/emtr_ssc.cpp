/* Instantiates pcl::EMTRSSCRegistration for libpcl_emtr. */
#define EMTR_SSC_CPP_
#include <pcl/registration/emtr_ssc.h>

#if !EMTR_SSC_IS_COMPILED
#error "emtr_ssc_abi.h was made with other compiler flags than this file is compiled with"
#endif

#ifndef PCL_NO_PRECOMPILE
#define EMTR_SSC_INSTANTIATE(PointT, Scalar) \
  template class EMTR_API pcl::EMTRSSCRegistration<PointT, PointT, Scalar>;
EMTR_SSC_FOR_EACH_INSTANTIATION(EMTR_SSC_INSTANTIATE)
#endif
