#pragma once

#ifdef _OPENMP
#include <omp.h>  // PCL 1.15 calls it in its headers for registration, but does not include it
#endif

#include <emtr/emtr.h>
#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/registration/registration.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <pcl/registration/impl/emtr_ssc_cached_cloud.hpp>
#include <pcl/registration/impl/emtr_ssc_user_input.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl {

/** \brief @b EMTRSSCRegistration registers two partially overlapping clouds from any initial pose:
 * global registration by evolutionary multitasking with solution space cutting.
 *
 * Two particle swarms search at once. One searches the pose that brings the clouds together, the
 * other the rotation on which most pairs of correspondences agree, and they exchange what they
 * learn. In preset "default" poses on which consistent correspondences agree join the swarms, the
 * best poses are ranked on the surfaces, and the answer is refined. Preset "paper" is the method as
 * published.
 *
 * Y. Wu et al., "Evolutionary Multitasking with Solution Space Cutting for Point Cloud
 * Registration", IEEE Transactions on Emerging Topics in Computational Intelligence, 2023.
 *
 * \code
 * pcl::EMTRSSCRegistration<pcl::PointXYZ, pcl::PointXYZ> reg;
 * reg.setInputSource(source);
 * reg.setInputTarget(target);
 * pcl::PointCloud<pcl::PointXYZ> aligned;
 * reg.align(aligned);
 * if (reg.hasConverged())
 *   std::cout << reg.getFinalTransformation() << '\n'  // source into target: q = R p + t
 *             << reg.getConfidence() << '\n';           // 0 to 1
 * else
 *   std::cout << reg.getReasonText() << '\n';
 * \endcode
 *
 * Most programs need only these calls: setInputSource(), setInputTarget(), align(), the inherited
 * hasConverged() and getFinalTransformation(), getConfidence() and getReasonText(); perhaps
 * setPreset().
 *
 * No length needs tuning: all lengths are derived from the clouds, in any unit. The same clouds,
 * settings and seed give the same bits for any number of threads.
 *
 * \note hasConverged() means that the pose is probably right, not that a loop has ended. It is
 * false for an input that cannot be registered; then PCL_ERROR and getErrorMessage() say why, the
 * final transformation is NaN, and the output is the source, unmoved. Before any align() the final
 * transformation is NaN too. An input setter that gets a null or empty cloud drops the old one.
 *
 * \note Inherited settings that act:
 * - setMaximumIterations(): the number of generations of the evolution, 25 by default and 100 in
 *   preset "paper". All of them run, there is no stopping rule. getResult()->iterations tells how
 *   many ran.
 * - setIndices(): only these source points are registered and put out.
 * - the guess of align(): unless it is the identity, it is tried as one hypothesis among the
 *   particles. The search stays near it only if setGuessRadius() says so. The final transformation
 *   maps the original source into the target, with or without a guess.
 * - setSearchMethodTarget(), setPointRepresentation(): only for getFitnessScore().
 *
 * \note Inherited settings that do not act: setMaxCorrespondenceDistance(), the transformation,
 * rotation and fitness epsilons, setRANSACIterations(), setRANSACOutlierRejectionThreshold(),
 * setTransformationEstimation(), setCorrespondenceEstimation(), addCorrespondenceRejector(),
 * setSearchMethodSource(), registerVisualizationCallback().
 *
 * \note Viewpoints help at low overlap: points that would hide what the other sensor saw count
 * against a pose. setSourceViewpoint() and setTargetViewpoint() set them. Otherwise the input's
 * sensor_origin_ is taken unless it is zero. PCL gives every cloud a zero sensor_origin_, so zero
 * means unknown. For a sensor at the origin call setSourceViewpoint({0, 0, 0}).
 *
 * \note Preprocessing of a cloud is cached until its coordinates change or, for the source, the
 * indices. So one target serves many sources, and one source many targets. The cache keeps a copy
 * of the coordinates.
 *
 * \note User-provided normals, features and correspondences replace computed ones; the setters copy
 * them. They belong to the clouds of setInputSource() and setInputTarget(): one row or index for
 * each point of the whole cloud, whatever setIndices() selects. They stay until they are set again
 * or cleared, for later clouds too. If their number is not the number of points, align() fails. The
 * normals of a PointNormal cloud are not used unless setSourceNormals() provides them.
 *
 * \note Colors (r, g and b of a point type that has them, else intensity) are used as the setting
 * use_colors says: 0 never; 1, the default, where the shape of the clouds leaves the pose open; 2
 * everywhere, and then align() fails for clouds without colors.
 *
 * \note getFitnessScore() is inherited: it takes all source points whatever the indices, compares
 * max_range with squared distances, and needs an input source and one point type for both clouds.
 * Points that are not finite are no neighbors and have none, unless setSearchMethodTarget() sets
 * another tree. The scores of getResult() do not depend on it.
 *
 * \note Other point types with x, y and z (and normal_x, normal_y, normal_z, which are rotated)
 * work as with any class of PCL: define PCL_NO_PRECOMPILE before including PCL.
 *
 * \note Any number of objects may run at once. One object serves one thread at a time.
 *
 * \ingroup registration
 */
template <typename PointSource, typename PointTarget, typename Scalar = float>
class EMTRSSCRegistration : public Registration<PointSource, PointTarget, Scalar> {
 public:
  using Base = Registration<PointSource, PointTarget, Scalar>;
  using Ptr = shared_ptr<EMTRSSCRegistration<PointSource, PointTarget, Scalar>>;
  using ConstPtr = shared_ptr<const EMTRSSCRegistration<PointSource, PointTarget, Scalar>>;
  using Matrix4 = typename Base::Matrix4;
  using PointCloudSource = typename Base::PointCloudSource;
  using PointCloudSourceConstPtr = typename Base::PointCloudSourceConstPtr;
  using PointCloudTarget = typename Base::PointCloudTarget;
  using PointCloudTargetConstPtr = typename Base::PointCloudTargetConstPtr;
  using ResultConstPtr = std::shared_ptr<const emtr_result>;

  /** \brief Gets the progress of a run; returns true to STOP the run, false to go on. */
  using ProgressCallback = std::function<bool(const emtr_progress&)>;

  /** \brief Constructs a registration with preset "default". */
  EMTRSSCRegistration();

  /** \brief Sets the cloud that is moved, and resets the result.
   * \param[in] cloud the source; a null or empty cloud is a PCL_ERROR and leaves no source */
  void setInputSource(const PointCloudSourceConstPtr& cloud) override;

  /** \brief Sets the cloud that the source is moved to, and resets the result.
   * \param[in] cloud the target; a null or empty cloud is a PCL_ERROR and leaves no target */
  void setInputTarget(const PointCloudTargetConstPtr& cloud) override;

  /** \brief Replaces all settings, with seed and threads, by a preset. Keeps the viewpoints and the
   * priors.
   * \param[in] name "default", "fast", "thorough" or "paper"
   * \return false, with a PCL_ERROR and no change, for an unknown name */
  bool setPreset(const std::string& name);

  /** \brief Registers the source to the target.
   *
   * It does the same as align() of the base class, and also works with two point types, for which
   * the base class of PCL 1.13 does not compile.
   * \param[out] output the selected source points, moved by the final transformation, normals
   * rotated; points that are not finite stay as they are
   * \param[in] guess a pose to try, source into target; the identity means none */
  void align(PointCloudSource& output, const Matrix4& guess = Matrix4::Identity());

  /** \brief Returns the estimated probability that the final transformation is right, 0 to 1. NaN
   * before any align(), after a failed one, and without candidates, as in preset "paper". */
  [[nodiscard]] double getConfidence() const;

  /** \brief Returns in a few words why the last align() converged or did not; empty before it. */
  [[nodiscard]] std::string getReasonText() const;

  /** \brief Returns why the last align() gave no pose: names the cloud or the setting and what was
   * expected, or the missing input. Empty if nothing is wrong. */
  [[nodiscard]] std::string getErrorMessage() const;

  /** \brief Returns the whole result of the last align(): verdict, quality, counts, cost, timings,
   * history. Null before it, after a failed one, and after an input setter. */
  [[nodiscard]] ResultConstPtr getResult() const { return result_; }

  /** \brief Measures the distance of each source point to the nearest target point at the final
   * transformation. Every call measures again.
   * \return distances in the clouds' unit, in the order of the output of align(), NaN for points
   * that are not finite; empty, with a PCL_ERROR, if there is no pose */
  [[nodiscard]] std::vector<double> getSourceResiduals() const;

  /** \brief Measures the distance of each target point to the nearest moved source point; see
   * getSourceResiduals(). */
  [[nodiscard]] std::vector<double> getTargetResiduals() const;

  /** \brief Sets the function that gets the progress; an empty function for none.
   *
   * The thread that calls align() calls it. It returns true to STOP the run; the result then has
   * the best pose so far and reason EMTR_REASON_INTERRUPTED. An exception that it throws stops the
   * run, leaves no pose, and comes out of align(). */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** \brief Sets one setting by its name in emtr_settings.
   * \return false, with a PCL_ERROR and no change, if the name is unknown or the value is out of
   * the range that emtr_setting_describe() gives */
  bool setSetting(const std::string& name, double value);

  /** \brief Reads one setting by its name in emtr_settings.
   * \return false, with a PCL_ERROR and \a value unchanged, if the name is unknown */
  bool getSetting(const std::string& name, double& value) const;

  /** \brief Replaces all settings, with the viewpoints and the priors; align() checks them.
   * `iterations` becomes the maximum number of iterations. Ignores the correspondences in
   * \a settings; setCorrespondences() sets them. */
  void setSettings(const emtr_settings& settings);

  /** \brief Returns a copy of the settings; `iterations` is the maximum number of iterations. */
  [[nodiscard]] emtr_settings getSettings() const;

  /** \brief Sets the seed of all random numbers; 0 by default. */
  void setSeed(std::uint64_t seed) { settings_.seed = seed; }

  /** \brief Returns the seed of all random numbers. */
  [[nodiscard]] std::uint64_t getSeed() const { return settings_.seed; }

  /** \brief Sets the number of threads.
   * \param[in] nr_threads 0, the default, for as many as OpenMP would use */
  void setNumberOfThreads(unsigned int nr_threads = 0) {
    settings_.threads = static_cast<std::int32_t>(nr_threads);
  }

  /** \brief Sets the position of the source's sensor, for this source and all later ones. It takes
   * precedence over the cloud's sensor_origin_. align() fails for a position that is not finite.
   * \param[in] viewpoint the position in the source's own frame and unit */
  void setSourceViewpoint(const Eigen::Vector3f& viewpoint) {
    setViewpoint(viewpoint, settings_.has_viewpoint_source, settings_.viewpoint_source);
  }

  /** \brief Sets the position of the target's sensor; see setSourceViewpoint(). */
  void setTargetViewpoint(const Eigen::Vector3f& viewpoint) {
    setViewpoint(viewpoint, settings_.has_viewpoint_target, settings_.viewpoint_target);
  }

  /** \brief Clears the viewpoint of the source: its sensor_origin_ is taken again. */
  void clearSourceViewpoint() { settings_.has_viewpoint_source = 0; }

  /** \brief Clears the viewpoint of the target: its sensor_origin_ is taken again. */
  void clearTargetViewpoint() { settings_.has_viewpoint_target = 0; }

  /** \brief Limits the search to poses near the guess of align(), where the identity counts as a
   * guess too.
   *
   * All priors hold at once, for the final transformation and for the alternatives. If no pose
   * satisfies them, align() fails.
   * \param[in] degrees most angle to the guess's rotation, 0 to 180; 180: any
   * \param[in] distance most distance between where the pose and where the guess put the centroid
   * of the source, 0 to 1e12, in the clouds' unit; 1e12: any */
  void setGuessRadius(double degrees, double distance = 1e12) {
    settings_.guess_rotation = degrees;
    settings_.guess_translation = distance;
  }

  /** \brief Clears the limits of setGuessRadius(). */
  void clearGuessRadius() { setGuessRadius(180); }

  /** \brief Limits the search to rotations about an axis that has the same direction in both
   * clouds' frames; for example "up" for scanners that measure it.
   * \param[in] axis the direction, of any length above 0
   * \param[in] tilt most angle between the axis and the rotated axis, degrees, 0 to 90
   * \param[in] minimum least angle about the axis, degrees, -360 to 360
   * \param[in] maximum largest angle about the axis, degrees, -360 to 360 */
  void setRotationAxis(const Eigen::Vector3d& axis, double tilt = 0, double minimum = -180,
                       double maximum = 180);

  /** \brief Clears the limits of setRotationAxis(). */
  void clearRotationAxis();

  /** \brief Limits the translation of the final transformation.
   * \param[in] minimum least x, y and z, in the clouds' unit
   * \param[in] maximum largest x, y and z, in the clouds' unit */
  void setTranslationBounds(const Eigen::Vector3d& minimum, const Eigen::Vector3d& maximum);

  /** \brief Clears the limits of setTranslationBounds(). */
  void clearTranslationBounds() { settings_.has_translation_bounds = 0; }

  /** \brief Limits the angle of the whole rotation.
   * \param[in] degrees most angle, 0 to 180; 180: any */
  void setMaximumRotation(double degrees) { settings_.maximum_rotation = degrees; }

  /** \brief Searches the scale of the source's lengths too: the final transformation is then a
   * similarity, q = s R p + t, and the priors and the guess speak of its R and t.
   * \param[in] minimum least scale, 1e-6 to 1e6
   * \param[in] maximum largest scale, not below the least; the same for one that is known */
  void setScaleBounds(double minimum, double maximum) {
    settings_.scale = minimum == 1 && maximum == 1 ? EMTR_SCALE_FIXED : EMTR_SCALE_BOUNDED;
    settings_.scale_minimum = minimum;
    settings_.scale_maximum = maximum;
  }

  /** \brief Searches any scale of the source's lengths. */
  void setScaleFree() { searchScale(EMTR_SCALE_FREE); }

  /** \brief Tries factors between units of length: 1, 10, 12, 25.4, 100, 304.8, 1000, and 1 over
   * these. */
  void setScaleToUnits() { searchScale(EMTR_SCALE_UNITS); }

  /** \brief Searches no scale: both clouds have one unit. */
  void clearScale() { searchScale(EMTR_SCALE_FIXED); }

  /** \brief Returns the scale s of the final transformation: 1 unless it was searched, NaN before
   * any align() and after one that failed. */
  [[nodiscard]] double getScale() const {
    return result_ ? result_->scale : std::numeric_limits<double>::quiet_NaN();
  }

  /** \brief Sets descriptors of the source's points, which replace FPFH.
   *
   * Both clouds have descriptors of one type, or neither has any. A point whose descriptor has a
   * NaN is no keypoint.
   * \param[in] features one for each point, of any type that PCL has a
   * DefaultPointRepresentation for, or of any Histogram; null clears them */
  template <typename FeatureCloud>
  void setSourceFeatures(const shared_ptr<FeatureCloud>& features) {
    setFeatures(features, "setSourceFeatures", source_user_input_, source_cache_);
  }

  /** \brief Sets descriptors of the source's points by a representation of the user's own, which
   * may scale or leave out numbers. */
  template <typename FeatureCloud>
  void setSourceFeatures(
      const shared_ptr<FeatureCloud>& features,
      const PointRepresentation<typename FeatureCloud::PointType>& representation) {
    setFeatures(features, representation, source_user_input_, source_cache_);
  }

  /** \brief Sets descriptors of the target's points; see setSourceFeatures(). */
  template <typename FeatureCloud>
  void setTargetFeatures(const shared_ptr<FeatureCloud>& features) {
    setFeatures(features, "setTargetFeatures", target_user_input_, target_cache_);
  }

  /** \brief Sets descriptors of the target's points by a representation of the user's own. */
  template <typename FeatureCloud>
  void setTargetFeatures(
      const shared_ptr<FeatureCloud>& features,
      const PointRepresentation<typename FeatureCloud::PointType>& representation) {
    setFeatures(features, representation, target_user_input_, target_cache_);
  }

  /** \brief Sets normals of the source's points, which replace the estimated ones.
   * \param[in] normals one for each point, of any length, NaN or zero where there is none; null
   * clears them */
  void setSourceNormals(const PointCloud<Normal>::ConstPtr& normals) {
    setNormals(normals, source_user_input_, source_cache_);
  }

  /** \brief Sets normals of the target's points; see setSourceNormals(). */
  void setTargetNormals(const PointCloud<Normal>::ConstPtr& normals) {
    setNormals(normals, target_user_input_, target_cache_);
  }

  /** \brief Sets correspondences, which replace those of the features.
   *
   * At least three different ones of finite points are needed, or align() fails. Those of source
   * points that setIndices() leaves out are left out too.
   * \param[in] correspondences index_query names a source point, index_match a target point;
   * distance and weight are not used; null clears them */
  void setCorrespondences(const CorrespondencesConstPtr& correspondences);

  /** \brief Clears the descriptors of the source's points. */
  void clearSourceFeatures() { clear(source_user_input_.features, source_cache_); }

  /** \brief Clears the descriptors of the target's points. */
  void clearTargetFeatures() { clear(target_user_input_.features, target_cache_); }

  /** \brief Clears the normals of the source's points. */
  void clearSourceNormals() { clear(source_user_input_.normals, source_cache_); }

  /** \brief Clears the normals of the target's points. */
  void clearTargetNormals() { clear(target_user_input_.normals, target_cache_); }

  /** \brief Clears the correspondences. */
  void clearCorrespondences() { setCorrespondences(nullptr); }

 protected:
  using Base::converged_;
  using Base::final_transformation_;
  using Base::getClassName;
  using Base::indices_;
  using Base::input_;
  using Base::max_iterations_;
  using Base::nr_iterations_;
  using Base::reg_name_;
  using Base::target_;
  using Base::target_cloud_updated_;
  using Base::transformation_;
  using Base::tree_;

  /** \brief Registers the points of \a output, the selected source, and moves them. */
  void computeTransformation(PointCloudSource& output, const Matrix4& guess) override;

 private:
  void searchScale(emtr_scale searched) {
    settings_.scale = searched;
    settings_.scale_minimum = settings_.scale_maximum = 1;
  }

  static void setViewpoint(const Eigen::Vector3f& viewpoint, std::int32_t& known,
                           double (&position)[3]);

  /** \brief Takes the sensor_origin_ of a cloud where no viewpoint was set and it is not zero. */
  static void fillViewpoint(const Eigen::Vector4f& sensor_origin, std::int32_t& known,
                            double (&position)[3]);

  static void clear(detail::UserRows& rows, detail::CachedCloud& cache);

  static void setNormals(const PointCloud<Normal>::ConstPtr& normals, detail::UserInput& input,
                         detail::CachedCloud& cache);

  template <typename FeatureCloud>
  void setFeatures(const shared_ptr<FeatureCloud>& features, const char* setter,
                   detail::UserInput& input, detail::CachedCloud& cache);

  template <typename FeatureCloud>
  void setFeatures(const shared_ptr<FeatureCloud>& features,
                   const PointRepresentation<typename FeatureCloud::PointType>& representation,
                   detail::UserInput& input, detail::CachedCloud& cache);

  /** \brief Checks whether setIndices() selects the whole source in its own order. */
  [[nodiscard]] bool selectsAll() const;

  /** \brief Describes what is wrong with the user's input; empty if nothing is. */
  [[nodiscard]] std::string checkUserInput() const;

  /** \brief Preprocesses both clouds with the user's input, unless the cache has them.
   * \param[out] preprocessed the source and the target
   * \return false, with the message kept, on an error */
  bool preprocess(const PointCloudSource& source, std::int32_t threads,
                  std::shared_ptr<const emtr_preprocessed> (&preprocessed)[2]);

  /** \brief Aligns clouds of one point type by the base class. */
  void alignAs(PointCloudSource& output, const Matrix4& guess, std::true_type);

  /** \brief Aligns clouds of two point types. */
  void alignAs(PointCloudSource& output, const Matrix4& guess, std::false_type);

  /** \brief Restores the state before any align(): no result, not converged, no pose. */
  void resetResult();

  /** \brief Runs the library on \a source, the selected points, and keeps its result.
   * \return false, with the message kept, on an error */
  bool solve(const PointCloudSource& source, const Matrix4& guess);

  /** \brief Measures the residuals of either cloud. */
  [[nodiscard]] std::vector<double> measureResiduals(bool of_target) const;

  emtr_settings settings_;
  ProgressCallback progress_;
  ResultConstPtr result_;
  std::string error_message_;
  detail::CachedCloud source_cache_, target_cache_;
  detail::UserInput source_user_input_, target_user_input_;
  std::vector<std::int32_t> pairs_;  ///< the user's correspondences, rows of source and target
  bool has_correspondences_ = false;

 public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace pcl

#include <pcl/registration/impl/emtr_ssc.hpp>
