#pragma once

#include <array>
#include <cstddef>

#include "input.h"

namespace fuzz {

/// Points of a bumpy surface that can be registered, with its normals, and with descriptors that
/// are alike where points of the same shape are near each other. Or else a lattice of small whole
/// numbers, which has many equal coordinates. Both in any unit and at any place.
class AnySurface {
 public:
  using Vector = std::array<double, 3>;

  explicit AnySurface(Input& input)
      : lattice_(input.ConsumeIntegralInRange(0, 3) == 3),
        // One byte chooses the shape, another the points on it, so that two clouds can share a
        // shape.
        shape_(input.ConsumeIntegral<std::uint8_t>() % 4),
        drawing_(input.ConsumeIntegral<std::uint8_t>() * 0.37),
        angle_(input.ConsumeIntegral<std::uint8_t>() / 8.0),
        unit_(input.ConsumeIntegralInRange(0, 3) == 3 ? any_double(input) : 1),
        place_(input.ConsumeIntegralInRange(0, 3) == 3 ? any_double(input) : 0) {}

  Vector point(std::size_t i, Input& input) const {
    Vector p;
    if (lattice_) {
      for (double& value : p) value = input.ConsumeIntegral<std::int8_t>();
    } else {
      const double u = across(i), v = along(i);
      p = rotated({u, v, 0.5 * std::sin(bumps() * u) * std::cos(3 * v) + 0.2 * shape_ * u * v});
    }
    for (double& value : p) value = value * unit_ + place_;
    return p;
  }

  /// Returns a normal of the bumpy surface, whose length is not one.
  Vector normal(std::size_t i) const {
    const double u = across(i), v = along(i);
    return rotated({-0.5 * bumps() * std::cos(bumps() * u) * std::cos(3 * v) - 0.2 * shape_ * v,
                    1.5 * std::sin(bumps() * u) * std::sin(3 * v) - 0.2 * shape_ * u, 1});
  }

  double descriptor(std::size_t i, std::size_t d) const {
    const auto k = static_cast<double>(d);
    return std::sin((1 + k) * across(i) + shape_) + std::cos((2 + k) * along(i));
  }

 private:
  double bumps() const { return 2 + shape_; }
  double number(std::size_t i) const { return static_cast<double>(i) + drawing_; }
  double across(std::size_t i) const {
    return 2 * std::fmod(number(i) * 0.7548776662466927, 1) - 1;
  }
  double along(std::size_t i) const { return 2 * std::fmod(number(i) * 0.5698402909980532, 1) - 1; }
  Vector rotated(const Vector& p) const {
    return {std::cos(angle_) * p[0] - std::sin(angle_) * p[1],
            std::sin(angle_) * p[0] + std::cos(angle_) * p[1], p[2]};
  }

  bool lattice_;
  double shape_, drawing_, angle_, unit_, place_;
};

}  // namespace fuzz
