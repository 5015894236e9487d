#pragma once

#include <emtr/emtr.h>

#include <memory>
#include <vector>

#include "input.h"

namespace fuzz {

/// A cloud for the C API in a block of memory that ends with its last point, so that a byte read
/// too many is seen: of either scalar type, with any stride and alignment.
class AnyCloud {
 public:
  /// Of at most `most` points: a bumpy surface that can be registered, a lattice of small whole
  /// numbers with its many equal coordinates, or whatever bytes come; in any unit and place.
  AnyCloud(Input& input, std::size_t most) {
    const bool single = input.ConsumeBool();
    const std::size_t packed = 3 * (single ? sizeof(float) : sizeof(double));
    const std::size_t stride =
        input.ConsumeBool() ? packed + input.ConsumeIntegralInRange<std::size_t>(0, 9) : 0;
    const std::size_t step = stride ? stride : packed;
    const std::size_t count = most - input.ConsumeIntegralInRange<std::size_t>(0, most);
    const std::size_t unaligned = input.ConsumeIntegralInRange<std::size_t>(0, 7);
    const std::size_t bytes = count ? (count - 1) * step + packed : 0;
    memory_.reset(new char[unaligned + bytes]());
    char* points = memory_.get() + unaligned;
    if (input.ConsumeIntegralInRange(0, 7) == 7) {
      input.ConsumeData(points, bytes);
    } else {
      const std::vector<double> xyz = coordinates(input, count);
      for (std::size_t i = 0; i < xyz.size(); ++i) {
        char* place = points + i / 3 * step + i % 3 * packed / 3;
        const auto value = static_cast<float>(xyz[i]);
        single ? std::memcpy(place, &value, sizeof value)
               : std::memcpy(place, &xyz[i], sizeof xyz[i]);
      }
    }
    view_ = {points, count, stride, single ? EMTR_FLOAT32 : EMTR_FLOAT64};
  }

  const emtr_cloud& view() const { return view_; }

 private:
  static std::vector<double> coordinates(Input& input, std::size_t count) {
    std::vector<double> xyz(3 * count);
    const bool lattice = input.ConsumeIntegralInRange(0, 3) == 3;
    // One byte chooses the shape, another the points on it: two clouds may well be of one shape.
    const double shape = input.ConsumeIntegral<std::uint8_t>() % 4;
    const double drawing = input.ConsumeIntegral<std::uint8_t>();
    const double angle = input.ConsumeIntegral<std::uint8_t>() / 8.0;
    for (std::size_t i = 0; i < count; ++i) {
      double* p = &xyz[3 * i];
      if (lattice) {
        for (int k = 0; k < 3; ++k) p[k] = input.ConsumeIntegral<std::int8_t>();
        continue;
      }
      const double n = static_cast<double>(i) + drawing * 0.37;
      const double u = 2 * std::fmod(n * 0.7548776662466927, 1) - 1;
      const double v = 2 * std::fmod(n * 0.5698402909980532, 1) - 1;
      const double height = 0.5 * std::sin((2 + shape) * u) * std::cos(3 * v) + 0.2 * shape * u * v;
      p[0] = std::cos(angle) * u - std::sin(angle) * v;
      p[1] = std::sin(angle) * u + std::cos(angle) * v;
      p[2] = height;
    }
    const double unit = input.ConsumeIntegralInRange(0, 3) == 3 ? any_double(input) : 1;
    const double place = input.ConsumeIntegralInRange(0, 3) == 3 ? any_double(input) : 0;
    for (double& value : xyz) value = value * unit + place;
    for (int n = input.ConsumeIntegralInRange(0, 4); n > 0 && count; --n)
      xyz[input.ConsumeIntegralInRange<std::size_t>(0, xyz.size() - 1)] = any_double(input);
    return xyz;
  }

  std::unique_ptr<char[]> memory_;
  emtr_cloud view_{};
};

}  // namespace fuzz
