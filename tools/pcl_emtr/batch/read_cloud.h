#pragma once

#include <emtr/emtr.h>

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <string>

#include "options/options.h"

namespace cli {

struct FreePreprocessed {
  void operator()(emtr_preprocessed* cloud) const { emtr_preprocessed_free(cloud); }
};

/// What a registration needs of a file: the preprocessed cloud, and where its sensor stood.
struct ReadCloud {
  std::unique_ptr<emtr_preprocessed, FreePreprocessed> preprocessed;
  Eigen::Vector3d sensor_origin = Eigen::Vector3d::Zero();
  bool sensor_known = false;
  std::size_t bytes = 0;  ///< about what it takes in memory
  std::string note;       ///< what was left out of the file, or empty
};

/// Reads and preprocesses a cloud. Throws FileFailure.
std::shared_ptr<const ReadCloud> read_cloud(const std::string& path, std::size_t mesh_points,
                                            const Options& options);

}  // namespace cli
