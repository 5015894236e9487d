#include "residuals.h"

#include <pcl/common/io.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "coordinates.h"
#include "failure.h"

namespace cli {
namespace {

const std::string kField = "residual";

/// Room for one float at the end of each point.
std::size_t appended_field(pcl::PCLPointCloud2& blob) {
  const std::size_t points = std::size_t{blob.width} * blob.height, before = blob.point_step,
                    after = before + sizeof(float);
  std::vector<std::uint8_t> data(points * after);
  for (std::size_t i = 0; i < points; ++i)
    std::copy_n(blob.data.data() + i * before, before, data.data() + i * after);
  blob.data = std::move(data);
  pcl::PCLPointField field;
  field.name = kField;
  field.offset = static_cast<std::uint32_t>(before);
  field.datatype = pcl::PCLPointField::FLOAT32;
  field.count = 1;
  blob.fields.push_back(field);
  blob.point_step = static_cast<std::uint32_t>(after);
  blob.row_step = blob.point_step * blob.width;
  return before;
}

}  // namespace

std::vector<double> measure_residuals(const CloudFile& source, const CloudFile& target,
                                      const Options& options, const emtr_result& result) {
  std::vector<double> source_copy, target_copy, out(source.size());
  const emtr_cloud from = coordinates(source, source_copy), to = coordinates(target, target_copy);
  const emtr_status status = emtr_residuals(&from, &to, result.transformation,
                                            options.settings.threads, out.data(), nullptr);
  if (status != EMTR_OK)
    throw Failure(kInputOutput, std::string("--residuals: ") + emtr_error_message());
  return out;
}

void require_place_for_residuals(const CloudFile& cloud) {
  const int index = pcl::getFieldIndex(cloud.blob, kField);
  if (index < 0) return;
  const auto& field = cloud.blob.fields[static_cast<std::size_t>(index)];
  if (field.datatype != pcl::PCLPointField::FLOAT32 || field.count > 1)
    throw FileFailure(cloud.path,
                      "--residuals writes field 'residual', which is there already "
                      "and no single float");
}

void set_residuals(CloudFile& cloud, const std::vector<double>& residuals) {
  const int index = pcl::getFieldIndex(cloud.blob, kField);
  const std::size_t offset = index < 0 ? appended_field(cloud.blob)
                                       : cloud.blob.fields[static_cast<std::size_t>(index)].offset;
  std::uint8_t* place = cloud.blob.data.data() + offset;
  for (const double residual : residuals) {
    const auto value = static_cast<float>(residual);
    std::memcpy(place, &value, sizeof value);
    place += cloud.blob.point_step;
  }
}

Json residuals_json(std::vector<double> residuals) {
  residuals.erase(std::remove_if(residuals.begin(), residuals.end(),
                                 [](double value) { return std::isnan(value); }),
                  residuals.end());
  std::sort(residuals.begin(), residuals.end());
  const auto n = static_cast<double>(residuals.size());
  double sum = 0, squares = 0;
  for (const double value : residuals) {
    sum += value;
    squares += value * value;
  }
  const auto quantile = [&](double share) {
    return residuals[static_cast<std::size_t>(share * (n - 1))];
  };
  return {{"count", residuals.size()},     {"mean", sum / n},
          {"rms", std::sqrt(squares / n)}, {"median", quantile(0.5)},
          {"quantile_90", quantile(0.9)},  {"quantile_95", quantile(0.95)},
          {"maximum", residuals.back()}};
}

}  // namespace cli
