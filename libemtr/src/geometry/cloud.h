#pragma once

#include <cstddef>
#include <vector>

#include "kernels/kernels.h"

namespace emtr {

/// Points of one cloud in the normalized frame, as a structure of arrays of float.
struct Cloud {
  std::vector<float> x, y, z;

  std::size_t size() const noexcept { return x.size(); }
  PointsView view() const noexcept { return {x.data(), y.data(), z.data(), x.size()}; }

  void resize(std::size_t n) {
    x.resize(n);
    y.resize(n);
    z.resize(n);
  }

  void set(std::size_t i, const float p[3]) {
    x[i] = p[0];
    y[i] = p[1];
    z[i] = p[2];
  }

  void append(float px, float py, float pz) {
    x.push_back(px);
    y.push_back(py);
    z.push_back(pz);
  }

  void append(const Cloud& other) {
    x.insert(x.end(), other.x.begin(), other.x.end());
    y.insert(y.end(), other.y.begin(), other.y.end());
    z.insert(z.end(), other.z.begin(), other.z.end());
  }

  /// Writes the points of these rows, in this order, and reuses the memory of `out`, which must be
  /// another cloud.
  template <class Row>
  void select(const std::vector<Row>& rows, Cloud& out) const {
    out.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto row = static_cast<std::size_t>(rows[i]);
      out.x[i] = x[row];
      out.y[i] = y[row];
      out.z[i] = z[row];
    }
  }

  /// Returns the points of these rows, in this order.
  template <class Row>
  Cloud select(const std::vector<Row>& rows) const {
    Cloud out;
    select(rows, out);
    return out;
  }
};

}  // namespace emtr
