#pragma once

#include <emtr/emtr.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <pcl/registration/impl/emtr_ssc_points.hpp>
#include <vector>

namespace pcl {
namespace detail {

/** \brief An input cloud as the library prepares it, kept from one align() to the next.
 *
 * Prepared again when any coordinate has changed, also in place, which no setter is told of: so
 * the coordinates are kept too and compared, which takes far less time than to prepare them. */
class PreparedInput {
 public:
  /** \brief Looks whether what is kept is of these points, and forgets it when it is not. */
  template <typename PointT>
  void read(const PointCloud<PointT>& cloud) {
    if (prepared_ && isOf(cloud)) return;
    forget();
    // Plain arrays of our own: what is in a pcl::PointCloud depends on how the caller was compiled.
    packed_ = packPoints(cloud);
  }

  /** \brief The points read, for as long as no others are. */
  emtr_cloud view() const { return {packed_.data(), packed_.size() / 3, 0, EMTR_FLOAT32}; }

  /** \brief What is kept of them, null when nothing is. It is never changed. */
  emtr_prepared* kept() const { return const_cast<emtr_prepared*>(prepared_.get()); }

  /** \brief Takes what emtr_register_kept() has left. */
  void keep(emtr_prepared* made) {
    if (made == prepared_.get()) return;
    prepared_ = std::shared_ptr<const emtr_prepared>(
        made, [](const emtr_prepared* p) { emtr_prepared_free(const_cast<emtr_prepared*>(p)); });
  }

  void forget() {
    prepared_.reset();
    packed_ = std::vector<float>();
  }

 private:
  template <typename PointT>
  bool isOf(const PointCloud<PointT>& cloud) const {
    if (packed_.size() != 3 * cloud.size()) return false;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const float p[3] = {cloud[i].x, cloud[i].y, cloud[i].z};
      if (std::memcmp(p, &packed_[3 * i], sizeof p) != 0) return false;  // a NaN is itself
    }
    return true;
  }

  std::vector<float> packed_;
  std::shared_ptr<const emtr_prepared> prepared_;
};

}  // namespace detail
}  // namespace pcl
