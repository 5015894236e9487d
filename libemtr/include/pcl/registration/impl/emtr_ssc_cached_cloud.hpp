#pragma once

#include <emtr/emtr.h>
#include <pcl/point_cloud.h>

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <pcl/registration/impl/emtr_ssc_points.hpp>
#include <pcl/registration/impl/emtr_ssc_user_input.hpp>
#include <utility>
#include <vector>

namespace pcl {
namespace detail {

/** \brief Caches the preprocessing of an input cloud from one align() to the next.
 *
 * A cloud is preprocessed again when any coordinate or color changes. It may change in place, which
 * no setter sees, so the cache keeps a copy of them and compares; that is far cheaper than
 * preprocessing. It does not compare normals and features: reset() it when they change. */
class CachedCloud {
 public:
  /** \brief Returns the preprocessed cloud, from the cache if it is there.
   * \param[in] cloud the cloud
   * \param[in] name the name in error messages, as in emtr_preprocess()
   * \param[in] threads the number of threads, as in emtr_preprocess()
   * \param[in] input the user's normals and features of the cloud's points
   * \param[in] keep_points whether correspondences can refer to the points, as in emtr_cloud
   * \param[in] use_colors whether the colors or intensities of the points are taken too
   * \return null if the cloud cannot be registered: emtr_error_message() says why */
  template <typename PointT>
  std::shared_ptr<const emtr_preprocessed> get(const PointCloud<PointT>& cloud, const char* name,
                                               std::int32_t threads, const UserInput& input = {},
                                               bool keep_points = false, bool use_colors = false) {
    std::vector<float> colors, intensities;
    if (use_colors) {
      colors = packColors(cloud, 0);
      intensities = packIntensities(cloud, 0);
    }
    if (preprocessed_ && (keeps_points_ || !keep_points) && holds(cloud) &&
        sameBits(colors, colors_) && sameBits(intensities, intensities_))
      return preprocessed_;
    reset();
    keeps_points_ = keep_points;
    colors_ = std::move(colors);
    intensities_ = std::move(intensities);
    // Plain arrays: the layout of a pcl::PointCloud depends on how the caller was compiled.
    packed_ = packPoints(cloud);
    emtr_cloud view = {packed_.data(), cloud.size(), 0, EMTR_FLOAT32};
    if (input.normals.given) view.normals = input.normals.values.data();
    if (input.features.given) {
      view.features = input.features.values.data();
      view.feature_dimension = input.features.width;
    }
    view.keep_points = keep_points;
    if (!colors_.empty()) view.colors = colors_.data();
    if (!intensities_.empty()) view.intensities = intensities_.data();
    emtr_preprocessed* made = nullptr;
    if (emtr_preprocess(&view, name, threads, &made) == EMTR_OK)
      preprocessed_ =
          std::shared_ptr<const emtr_preprocessed>(made, [](const emtr_preprocessed* p) {
            emtr_preprocessed_free(const_cast<emtr_preprocessed*>(p));
          });
    return preprocessed_;
  }

  /** \brief Empties the cache. */
  void reset() {
    preprocessed_.reset();
    packed_ = colors_ = intensities_ = std::vector<float>();
  }

 private:
  /** \brief Checks whether the cache is of these coordinates. */
  template <typename PointT>
  bool holds(const PointCloud<PointT>& cloud) const {
    if (packed_.size() != 3 * cloud.size()) return false;
    for (std::size_t i = 0; i < cloud.size(); ++i) {
      const float p[3] = {cloud[i].x, cloud[i].y, cloud[i].z};
      // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bit by bit, a NaN equals itself
      if (std::memcmp(p, &packed_[3 * i], sizeof p) != 0) return false;
    }
    return true;
  }

  static bool sameBits(const std::vector<float>& a, const std::vector<float>& b) {
    if (a.size() != b.size()) return false;
    // NOLINTNEXTLINE(bugprone-suspicious-memory-comparison): bit by bit, a NaN equals itself
    return a.empty() || std::memcmp(a.data(), b.data(), sizeof(float) * a.size()) == 0;
  }

  std::vector<float> packed_, colors_, intensities_;
  bool keeps_points_ = false;
  std::shared_ptr<const emtr_preprocessed> preprocessed_;
};

}  // namespace detail
}  // namespace pcl
