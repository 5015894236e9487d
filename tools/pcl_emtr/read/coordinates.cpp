#include "read/coordinates.h"

#include <string>

#include "read/vector_field.h"

namespace cli {
namespace {

const std::string kCoordinates[3] = {"x", "y", "z"};

}  // namespace

void require_coordinates(const CloudFile& cloud) { require_vector(cloud, kCoordinates); }

emtr_cloud coordinates(const CloudFile& cloud, std::vector<double>& copy) {
  const VectorField field = require_vector(cloud, kCoordinates);
  const std::size_t stride = cloud.blob.point_step;
  const std::uint8_t* data = cloud.blob.data.data();
  if (field.contiguous())
    return {data + field.offset[0], cloud.size(), stride,
            field.single ? EMTR_FLOAT32 : EMTR_FLOAT64};

  copy.resize(3 * cloud.size());
  for (std::size_t i = 0; i < cloud.size(); ++i)
    Eigen::Vector3d::Map(&copy[3 * i]) = field.get(data + i * stride);
  return {copy.data(), cloud.size(), 0, EMTR_FLOAT64};
}

}  // namespace cli
