#pragma once

#include <emtr/emtr.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <pcl/registration/impl/emtr_ssc_user_input.hpp>
#include <pcl/registration/impl/emtr_ssc_points.hpp>
#include <vector>

namespace pcl {
namespace detail {

/** \brief An input cloud as the library prepares it, kept from one align() to the next.
 *
 * Prepared again when any coordinate has changed, also in place, which no setter is told of: so
 * the coordinates are kept too and compared, which takes far less time than to prepare them. Who
 * hands in other normals or features says so by forget(). */
class CachedCloud {
 public:
  /** \brief The cloud made ready; \a name and \a threads as in emtr_preprocess(), \a keep_points as in
   * emtr_cloud.
   * \return null when it cannot be registered: emtr_error_message() tells why */
  template <typename PointT>
  std::shared_ptr<const emtr_preprocessed> of(const PointCloud<PointT>& cloud, const char* name,
                                          std::int32_t threads, const UserInput& handed = {},
                                          bool keep_points = false) {
    if (prepared_ && (keeps_points_ || !keep_points) && isOf(cloud)) return prepared_;
    forget();
    keeps_points_ = keep_points;
    // Plain arrays of our own: what is in a pcl::PointCloud depends on how the caller was compiled.
    packed_ = packPoints(cloud);
    emtr_cloud view = {packed_.data(), cloud.size(), 0, EMTR_FLOAT32};
    if (handed.normals.given) view.normals = handed.normals.values.data();
    if (handed.features.given) {
      view.features = handed.features.values.data();
      view.feature_dimension = handed.features.width;
    }
    view.keep_points = keep_points;
    emtr_preprocessed* made = nullptr;
    if (emtr_preprocess(&view, name, threads, &made) == EMTR_OK)
      prepared_ = std::shared_ptr<const emtr_preprocessed>(
          made, [](const emtr_preprocessed* p) { emtr_preprocessed_free(const_cast<emtr_preprocessed*>(p)); });
    return prepared_;
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
      // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bit by bit, a NaN is itself
      if (std::memcmp(p, &packed_[3 * i], sizeof p) != 0) return false;
    }
    return true;
  }

  std::vector<float> packed_;
  bool keeps_points_ = false;
  std::shared_ptr<const emtr_preprocessed> prepared_;
};

}  // namespace detail
}  // namespace pcl
