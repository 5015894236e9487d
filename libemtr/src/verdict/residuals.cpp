#include "verdict/residuals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "neighbors/nearest_point.h"
#include "preprocessing/cloud_reader.h"
#include "util/error.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

using Point = std::array<double, 3>;

/// The finite points of a cloud in floats, in a box of side 2 about the origin, and their tree.
class Reference {
 public:
  Reference(const CloudReader& reader, const std::string& name) : reader_(reader), name_(name) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Point low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
    each([&](std::size_t row, const double* p) {
      for (std::size_t a = 0; a < 3; ++a) {
        low[a] = std::min(low[a], p[a]);
        high[a] = std::max(high[a], p[a]);
      }
      rows_.push_back(row);
    });
    if (rows_.empty()) throw Error(EMTR_ERROR_CLOUD, name + ": no finite point");
    if (rows_.size() > std::size_t{std::numeric_limits<std::int32_t>::max()})
      throw Error(EMTR_ERROR_CLOUD, name + ": more than 2^31 points");
    double side = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      center_[a] = low[a] / 2 + high[a] / 2;
      side = std::max(side, high[a] / 2 - low[a] / 2);
    }
    if (side > 0) inverse_ = 1 / side;
    Cloud cloud;
    cloud.resize(rows_.size());
    std::size_t i = 0;
    each([&](std::size_t, const double* p) { cloud.set(i++, in_box(p).data()); });
    tree_ = std::make_unique<const NearestPoint>(cloud);
  }

  /// Returns the distance of a finite point in this cloud's frame to the nearest point.
  double distance(const Point& p) const {
    double q[3];
    reader_.read(rows_[(*tree_)(in_box(p.data()).data())], q);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  }

 private:
  template <class Visit>
  void each(const Visit& visit) const {
    for (std::size_t block = 0; block < reader_.blocks(); ++block)
      reader_.each_finite(block, [&](std::size_t i, const double* p) {
        visit(block * CloudReader::kBlock + i, p);
      });
  }

  std::array<float, 3> in_box(const double* p) const {
    Point unit;
    for (std::size_t a = 0; a < 3; ++a) unit[a] = (p[a] - center_[a]) * inverse_;
    if (!is_near(unit.data(), 3))
      throw Error(EMTR_ERROR_ARGUMENT, name_ +
                                           ": a point of the other cloud lies more than a "
                                           "million times its size away");
    return {static_cast<float>(unit[0]), static_cast<float>(unit[1]), static_cast<float>(unit[2])};
  }

  const CloudReader& reader_;
  const std::string name_;
  std::vector<std::size_t> rows_;  // of the finite points in the user's memory
  Point center_{};
  double inverse_ = 1;
  std::unique_ptr<const NearestPoint> tree_;
};

Point moved(const double* p, const Similarity& similarity) {
  Point out;
  Eigen::Vector3d::Map(out.data()) = similarity * Eigen::Vector3d::Map(p);
  return out;
}

/// `unit`: of the distances, over that of `to`.
void one_way(const CloudReader& from, const CloudReader& to, const std::string& name,
             const Similarity& similarity, double unit, int threads, double* out) {
  const Reference reference(to, name);
  std::fill_n(out, from.count(), std::numeric_limits<double>::quiet_NaN());
  parallel_for(from.blocks(), threads, [&](std::size_t block) {
    from.each_finite(block, [&](std::size_t i, const double* p) {
      check_cancelled_each(i, 10);
      out[block * CloudReader::kBlock + i] = unit * reference.distance(moved(p, similarity));
    });
  });
}

}  // namespace

void residuals(const emtr_cloud& source, const emtr_cloud& target, const Similarity& similarity,
               int threads, double* source_residuals, double* target_residuals) {
  const CloudReader from(source, "source cloud"), to(target, "target cloud");
  if (source_residuals) one_way(from, to, "target cloud", similarity, 1, threads, source_residuals);
  if (target_residuals)
    one_way(to, from, "source cloud", similarity.inverse(), similarity.scale, threads,
            target_residuals);
}

}  // namespace emtr
