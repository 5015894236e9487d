#include "colors/color_gradients.h"

#include <cmath>
#include <utility>

#include "util/cancellation.h"
#include "util/constants.h"
#include "voxels/cell_grid.h"

namespace emtr {
namespace {

constexpr double kFewPoints = 6;       // for a plane over two coordinates
constexpr double kLeastSpread = 0.05;  // determinant of their scatter, by that of a disc's
constexpr int kAxes = 2;

/// Two directions that span the plane across a normal.
struct Tangents {
  float u[3], v[3];

  explicit Tangents(const float n[3]) {
    // The axis that leans least towards the normal.
    const int a = std::abs(n[0]) <= std::abs(n[1]) && std::abs(n[0]) <= std::abs(n[2]) ? 0
                  : std::abs(n[1]) <= std::abs(n[2])                                   ? 1
                                                                                       : 2;
    float length = 0;
    for (int k = 0; k < 3; ++k) {
      u[k] = (k == a ? 1.0f : 0.0f) - n[a] * n[k];
      length += u[k] * u[k];
    }
    for (float& x : u) x /= std::sqrt(length);
    for (int k = 0; k < 3; ++k)
      v[k] = n[(k + 1) % 3] * u[(k + 2) % 3] - n[(k + 2) % 3] * u[(k + 1) % 3];
  }
};

/// Sums over the points near one, with coordinates s, t in its plane.
struct PlaneSums {
  double n = 0, s = 0, t = 0, ss = 0, st = 0, tt = 0;
  double c[3] = {}, sc[3] = {}, tc[3] = {};

  void add(float u, float v, const float color[3]) {
    const double x = static_cast<double>(u), y = static_cast<double>(v);
    n += 1;
    s += x;
    t += y;
    ss += x * x;
    st += x * y;
    tt += y * y;
    for (int k = 0; k < 3; ++k) {
      const double value = static_cast<double>(color[k]);
      c[k] += value;
      sc[k] += x * value;
      tc[k] += y * value;
    }
  }
};

struct Fit {
  float value = kNone;
  double along[kAxes] = {};
};

/// Returns the plane of a channel; the mean where the points do not spread enough.
Fit fit(const PlaneSums& sums, int k, double radius) {
  Fit out;
  const double n = sums.n, s = sums.s / n, t = sums.t / n, mean = sums.c[k] / n;
  out.value = static_cast<float>(mean);
  const double ss = sums.ss / n - s * s, st = sums.st / n - s * t, tt = sums.tt / n - t * t;
  const double determinant = ss * tt - st * st, disc = radius * radius / 4;
  if (n < kFewPoints || !(determinant > kLeastSpread * disc * disc)) return out;
  const double sc = sums.sc[k] / n - s * mean, tc = sums.tc[k] / n - t * mean;
  out.along[0] = (tt * sc - st * tc) / determinant;
  out.along[1] = (ss * tc - st * sc) / determinant;
  out.value = static_cast<float>(mean - out.along[0] * s - out.along[1] * t);
  return out;
}

class FieldFit {
 public:
  FieldFit(const Surface& surface, const Cloud& colors, const bool used[3], double radius,
           bool gradients)
      : surface_(surface),
        colors_(colors),
        radius_(radius),
        grid_(surface.points, radius),
        used_{used[0], used[1], used[2]} {
    out_.values = colors;
    for (std::size_t k = 0; k < out_.gradients.size(); ++k)
      if (gradients && used_[k]) out_.gradients[k].assign(colors.size(), {});
  }

  ColorField run() {
    for (std::size_t cell = 0; cell < grid_.occupied(); ++cell) {
      check_cancelled_each(cell, 4);
      grid_.around(cell, grid_.reach(radius_), ranges_);
      for (std::uint32_t i = grid_.begin(cell); i < grid_.end(cell); ++i) fit_point(i);
    }
    return std::move(out_);
  }

 private:
  void fit_point(std::size_t i) {
    const auto row = static_cast<std::size_t>(grid_.rows[i]);
    const float n[3] = {surface_.normals.x[row], surface_.normals.y[row], surface_.normals.z[row]};
    if (n[0] != n[0]) {
      const float none[3] = {kNone, kNone, kNone};
      out_.values.set(row, none);
      return;
    }
    const Tangents tangents(n);
    const PlaneSums sums = sums_about(i, tangents);
    if (sums.n == 0) return;
    float values[3] = {};
    for (int k = 0; k < kChannels; ++k) {
      const auto channel = static_cast<std::size_t>(k);
      if (!used_[k]) continue;
      const Fit plane = fit(sums, k, radius_);
      values[k] = plane.value;
      if (out_.gradients[channel].empty()) continue;
      for (std::size_t a = 0; a < 3; ++a)
        out_.gradients[channel][row][a] =
            static_cast<float>(plane.along[0] * static_cast<double>(tangents.u[a]) +
                               plane.along[1] * static_cast<double>(tangents.v[a]));
    }
    out_.values.set(row, values);
  }

  PlaneSums sums_about(std::size_t i, const Tangents& tangents) const {
    PlaneSums sums;
    const Cloud& p = grid_.sorted;
    const auto limit = static_cast<float>(radius_ * radius_);
    for (const CellGrid::Range& range : ranges_)
      for (std::size_t j = range.begin; j < range.end; ++j) {
        const float x = p.x[j] - p.x[i], y = p.y[j] - p.y[i], z = p.z[j] - p.z[i];
        if (!((x * x + y * y) + z * z < limit)) continue;
        const auto row = static_cast<std::size_t>(grid_.rows[j]);
        const float color[3] = {colors_.x[row], colors_.y[row], colors_.z[row]};
        if (color[0] != color[0]) continue;
        sums.add((tangents.u[0] * x + tangents.u[1] * y) + tangents.u[2] * z,
                 (tangents.v[0] * x + tangents.v[1] * y) + tangents.v[2] * z, color);
      }
    return sums;
  }

  const Surface& surface_;
  const Cloud& colors_;
  const double radius_;
  const CellGrid grid_;
  const bool used_[3];
  std::vector<CellGrid::Range> ranges_;
  ColorField out_;
};

}  // namespace

ColorField fit_color_field(const Surface& surface, const Cloud& colors, const bool used[3],
                           double radius, bool gradients) {
  return FieldFit(surface, colors, used, radius, gradients).run();
}

}  // namespace emtr
