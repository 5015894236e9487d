#pragma once

#include <emtr/emtr.h>
#include <pcl/pcl_config.h>

#include <Eigen/Core>
#include <string>

namespace cli {

// Eigen 5 stands for 3.5 no longer, and has one number more.
inline std::string eigen_version() {
#ifdef EIGEN_PATCH_VERSION
  const int parts[3] = {EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, EIGEN_PATCH_VERSION};
#else
  const int parts[3] = {EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION};
#endif
  return std::to_string(parts[0]) + "." + std::to_string(parts[1]) + "." + std::to_string(parts[2]);
}

inline std::string version_line() {
  return std::string("pcl_emtr ") + emtr_version() + " (PCL " + PCL_VERSION_PRETTY + ", Eigen " +
         eigen_version() + ")";
}

}  // namespace cli
