#pragma once

#include <emtr/emtr.h>
#include <pcl/pcl_config.h>

#include <Eigen/Core>
#include <string>

namespace cli {

inline std::string eigen_version() {
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}

inline std::string version_line() {
  return std::string("pcl_emtr ") + emtr_version() + " (PCL " + PCL_VERSION_PRETTY + ", Eigen " +
         eigen_version() + ")";
}

}  // namespace cli
