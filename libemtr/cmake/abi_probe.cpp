/* Is compiled but never run: pcl_abi.cmake reads these strings from the program. */
#include <pcl/pcl_config.h>

#include <Eigen/Core>

#ifndef EIGEN_HAS_CXX17_OVERALIGN /* before Eigen 3.4 */
#define EIGEN_HAS_CXX17_OVERALIGN 0
#endif

#define TEXT_OF(value) #value
#define PROBE(name, value) "emtr_ssc_abi " name "=" TEXT_OF(value) ";"

extern const char* const probe;
const char* const probe = PROBE("PCL_MAJOR", PCL_MAJOR_VERSION)  //
    PROBE("PCL_MINOR", PCL_MINOR_VERSION)                        //
    PROBE("MAX_ALIGN", EIGEN_MAX_ALIGN_BYTES)                    //
    PROBE("MALLOC_ALIGNED", EIGEN_MALLOC_ALREADY_ALIGNED)        //
    PROBE("OVERALIGN", EIGEN_HAS_CXX17_OVERALIGN);

int main() { return probe[0] == 'e' ? 0 : 1; }
