#include "preprocessing/keypoints.h"

#include <cmath>
#include <limits>
#include <utility>

#include "preprocessing/base_points.h"
#include "util/cancellation.h"
#include "voxels/voxel_order.h"

namespace emtr {
namespace {

constexpr std::size_t kLargestDimension = 65536;
constexpr int kBetweenChecks = 8;  // 2^8 descriptors of the largest dimension take about 10 ms

/// Reads the user's descriptors where they are.
class DescriptorReader {
 public:
  DescriptorReader(const emtr_cloud& cloud, const std::string& name)
      : first_(reinterpret_cast<const char*>(cloud.features)), dimension_(cloud.feature_dimension) {
    const auto refuse = [&](const std::string& what) {
      throw Error(EMTR_ERROR_ARGUMENT, name + ": " + what);
    };
    if (!first_) refuse("feature_dimension is given, but features is null");
    if (dimension_ < 1 || dimension_ > kLargestDimension)
      refuse("feature_dimension is " + std::to_string(dimension_) + ", expected 1 to " +
             std::to_string(kLargestDimension));
    const std::size_t packed = dimension_ * sizeof(float);
    if (cloud.feature_stride && cloud.feature_stride < packed)
      refuse("feature_stride is " + std::to_string(cloud.feature_stride) +
             " bytes, expected 0 or at least " + std::to_string(packed));
    if (cloud.count > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max()))
      refuse("features are taken of at most 2147483647 points");
    stride_ = cloud.feature_stride ? cloud.feature_stride : packed;
  }

  /// Reads one descriptor; returns false when it is not finite.
  bool read(std::size_t index, float* out) const {
    std::memcpy(out, first_ + index * stride_, dimension_ * sizeof(float));
    for (std::size_t d = 0; d < dimension_; ++d)
      if (!std::isfinite(out[d])) return false;
    return true;
  }

 private:
  const char* first_;
  std::size_t dimension_, stride_ = 0;
};

/// Keeps the points of these places and their rows; leaves the descriptors alone.
void select_points(Keypoints& keypoints, const std::vector<std::uint32_t>& places) {
  keypoints.points = keypoints.points.select(places);
  std::vector<std::int32_t> rows;
  rows.reserve(places.size());
  for (const std::uint32_t place : places) rows.push_back(keypoints.rows[place]);
  keypoints.rows = std::move(rows);
}

}  // namespace

Keypoints read_keypoints(const emtr_cloud& cloud, const CloudReader& reader, const Extent& extent,
                         const std::string& name) {
  Keypoints out;
  if (!cloud.features && !cloud.feature_dimension) return out;
  const DescriptorReader descriptors(cloud, name);
  out.dimension = cloud.feature_dimension;
  std::vector<float> descriptor(out.dimension);
  for (std::size_t block = 0; block < reader.blocks(); ++block)
    reader.each_finite(block, [&](std::size_t i, const double* p) {
      check_cancelled_each(i, kBetweenChecks);
      const std::size_t row = block * CloudReader::kBlock + i;
      if (!descriptors.read(row, descriptor.data())) return;
      float q[3];
      extent.to_unit_ball(p, q);
      out.points.append(q[0], q[1], q[2]);
      out.rows.push_back(static_cast<std::int32_t>(row));
    });
  if (out.rows.empty())
    throw Error(EMTR_ERROR_ARGUMENT,
                name + ": features are given, but no finite point has one that is finite");
  if (out.rows.size() > kDownsampledAbove)
    select_points(out, one_row_per_voxel(out.points, kBaseLeaf));
  out.descriptors.resize(out.rows.size() * out.dimension);
  for (std::size_t k = 0; k < out.rows.size(); ++k) {
    check_cancelled_each(k, kBetweenChecks);
    descriptors.read(static_cast<std::size_t>(out.rows[k]), &out.descriptors[k * out.dimension]);
  }
  return out;
}

Keypoints downsample(const Keypoints& keypoints, float leaf) {
  Keypoints out = keypoints;
  const std::vector<std::uint32_t> places = one_row_per_voxel(keypoints.points, leaf);
  select_points(out, places);
  for (std::size_t k = 0; k < places.size(); ++k)
    std::copy_n(&keypoints.descriptors[places[k] * out.dimension], out.dimension,
                &out.descriptors[k * out.dimension]);
  out.descriptors.resize(places.size() * out.dimension);
  return out;
}

}  // namespace emtr
