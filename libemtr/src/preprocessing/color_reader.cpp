#include "preprocessing/color_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "util/constants.h"
#include "util/error.h"

namespace emtr {
namespace {

std::size_t checked_stride(std::size_t stride, std::size_t packed, const std::string& what) {
  if (stride && stride < packed)
    throw Error(EMTR_ERROR_ARGUMENT, what + " is " + std::to_string(stride) +
                                         " bytes, expected 0 or at least " +
                                         std::to_string(packed));
  return stride ? stride : packed;
}

}  // namespace

std::optional<ColorReader> ColorReader::of(const emtr_cloud& cloud, const std::string& name) {
  const std::size_t of_colors = checked_stride(cloud.color_stride, 3 * sizeof(float),
                                               name + ": color_stride"),
                    of_intensities = checked_stride(cloud.intensity_stride, sizeof(float),
                                                    name + ": intensity_stride");
  if (cloud.colors) return ColorReader(ColorKind::Colors, cloud.colors, of_colors);
  if (cloud.intensities)
    return ColorReader(ColorKind::Intensities, cloud.intensities, of_intensities);
  return std::nullopt;
}

void ColorReader::read(std::size_t index, float channels[3]) const {
  float raw[3] = {};
  const std::size_t columns = kind_ == ColorKind::Colors ? 3 : 1;
  std::memcpy(raw, first_ + index * stride_, columns * sizeof(float));  // may not be aligned
  std::fill_n(channels, 3, kNone);
  if (!(std::isfinite(raw[0]) && std::isfinite(raw[1]) && std::isfinite(raw[2]))) return;
  if (kind_ == ColorKind::Colors) {
    channels[0] = (raw[0] + raw[1] + raw[2]) / 3;
    channels[1] = raw[0] - raw[1];
    channels[2] = (raw[0] + raw[1]) / 2 - raw[2];
  } else if (raw[0] >= 0) {
    channels[0] = raw[0];
    channels[1] = channels[2] = 0;
  }
}

}  // namespace emtr
