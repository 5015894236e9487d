#pragma once

#include <emtr/emtr.h>
#include <pcl/memory.h>
#include <pcl/pcl_macros.h>
#include <pcl/registration/registration.h>

#include <cstdint>
#include <functional>
#include <memory>
#include <pcl/registration/impl/emtr_ssc_user_input.hpp>
#include <pcl/registration/impl/emtr_ssc_cached_cloud.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl {

/** \brief @b EMTRSSCRegistration aligns two partially overlapping clouds from any start: global
 * registration by evolutionary multitasking with solution space cutting.
 *
 * Two swarms search at once, one for the pose that brings the clouds together, one for the
 * rotation that most pairs of feature matches agree on, and teach each other as they go. By the
 * preset "default" poses that consistent matches agree on join them, the best of all are ranked on
 * the surfaces, and the answer is refined; "paper" is the method as published.
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
 * No length needs tuning: all of them are derived from the clouds, in any unit. The same clouds,
 * settings and seed give the same bits, however many threads there are.
 *
 * \note Of the inherited settings these act:
 * - setMaximumIterations(): the number of generations of the evolution, 25 by default and 100 in
 *   preset "paper". All are run, there is no stopping rule; getResult()->iterations tells how many
 *   were done.
 * - setIndices(): only these source points are registered and put out.
 * - the guess of align(): unless it is the identity, it is tried as one hypothesis among the
 *   particles; it is not a start that the search stays near, unless setGuessRadius() says how near.
 *   The final transformation maps the original source into the target, with a guess or without.
 * - setSearchMethodTarget(), setPointRepresentation(): only for getFitnessScore().
 *
 * These do not act: setMaxCorrespondenceDistance(), the transformation, rotation and fitness
 * epsilons, setRANSACIterations(), setRANSACOutlierRejectionThreshold(),
 * setTransformationEstimation(), setCorrespondenceEstimation(), addCorrespondenceRejector(),
 * setSearchMethodSource(), registerVisualizationCallback().
 *
 * \note Where each sensor stood helps at low overlap: points that would hide what the other sensor
 * saw count against a pose. It is what setSourceViewpoint() and setTargetViewpoint() say, else the
 * input's sensor_origin_ unless that is zero, which PCL gives every cloud and which here means
 * unknown. A sensor that stood at the origin is told by setSourceViewpoint({0, 0, 0}).
 *
 * \note What can be made ready of a cloud by itself is made once and used again by the next align()
 * as long as its coordinates, and for the source the indices, stay the same: so one target serves
 * many sources, and one source many targets. A copy of the coordinates is kept for that.
 *
 * \note Normals, features and correspondences that were computed elsewhere can be handed in; the
 * setters copy them. They belong to the clouds of setInputSource() and setInputTarget(), a row or
 * an index a point of the whole cloud whatever setIndices() selects, and stay until they are set
 * anew or cleared, for clouds to come as well. When they are not as many as the points, align()
 * fails. The normals of a PointNormal cloud are not used by themselves.
 *
 * \note hasConverged() means that the pose is held to be right, not that the loop ended. An input
 * that cannot be registered is reported by PCL_ERROR and getErrorMessage(), hasConverged() is
 * false, the final transformation is NaN, as it is before any align(), and the output is the
 * source where it was. A setter that is given a null or empty cloud drops the one it had.
 *
 * \note getFitnessScore() is inherited: it takes all source points whatever the indices, compares
 * max_range with squared distances, and needs an input source and one point type for both clouds.
 * Points that are not finite are no neighbors and have none, unless setSearchMethodTarget() has
 * put another tree in place. getResult() has scores that do not depend on it.
 *
 * \note Other point types with x, y and z (and normal_x, normal_y, normal_z, which are rotated)
 * work as with any class of PCL: define PCL_NO_PRECOMPILE before including PCL.
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

  /** \brief Told of the progress; returns true to go on, false to stop the run. */
  using ProgressCallback = std::function<bool(const emtr_progress&)>;

  /** \brief Starts from the preset "default". */
  EMTRSSCRegistration();

  /** \brief Sets the cloud to be moved and forgets the last result. A null or empty cloud is
   * reported and leaves no source. */
  void setInputSource(const PointCloudSourceConstPtr& cloud) override;

  /** \brief Sets the cloud to be met and forgets the last result. A null or empty cloud is
   * reported and leaves no target. */
  void setInputTarget(const PointCloudTargetConstPtr& cloud) override;

  /** \brief Registers the source to the target; \a output is the selected source points where the
   * final transformation puts them, normals rotated, points that are not finite as they were.
   *
   * The same as in the base class, but also for two point types, with which align() of the base
   * class does not compile in PCL 1.13. */
  void align(PointCloudSource& output, const Matrix4& guess = Matrix4::Identity());

  /** \brief Replaces all settings, seed and threads too but not the viewpoints and priors, by a
   * preset of emtr_preset_name(): "default", "fast", "thorough" or "paper". \return false, with a
   * PCL_ERROR and no change, when there is none of that name */
  bool setPreset(const std::string& name);

  /** \brief Sets one setting by the name that it has in emtr_settings.
   * \return false, with a PCL_ERROR and no change, when the name is unknown or the value is out
   * of the range that emtr_setting_describe() gives */
  bool setSetting(const std::string& name, double value);

  /** \brief Reads one setting by its name.
   * \return false, with a PCL_ERROR and \a value as it was, when the name is unknown */
  bool getSetting(const std::string& name, double& value) const;

  /** \brief Replaces all settings at once, the viewpoints and priors too but not the
   * correspondences, see setCorrespondences(); they are checked by align(). `iterations` becomes
   * the maximum number of iterations. */
  void setSettings(const emtr_settings& settings);

  /** \brief A copy of the settings, `iterations` being the maximum number of iterations. */
  [[nodiscard]] emtr_settings getSettings() const;

  /** \brief Sets the seed of all random numbers; 0 by default. */
  void setSeed(std::uint64_t seed) { settings_.seed = seed; }

  [[nodiscard]] std::uint64_t getSeed() const { return settings_.seed; }

  /** \brief Sets the number of threads; 0, the default, is as many as OpenMP
   * would use. */
  void setNumberOfThreads(unsigned int nr_threads = 0) {
    settings_.threads = static_cast<std::int32_t>(nr_threads);
  }

  /** \brief Says where the sensor of the source stood, in the source's own frame and unit, for this
   * source and all to come; it goes before the cloud's sensor_origin_. A position that is not
   * finite makes align() fail, wherever it comes from. */
  void setSourceViewpoint(const Eigen::Vector3f& viewpoint) {
    setViewpoint(viewpoint, settings_.has_viewpoint_source, settings_.viewpoint_source);
  }

  /** \brief Says where the sensor of the target stood; as setSourceViewpoint(). */
  void setTargetViewpoint(const Eigen::Vector3f& viewpoint) {
    setViewpoint(viewpoint, settings_.has_viewpoint_target, settings_.viewpoint_target);
  }

  /** \brief Takes back setSourceViewpoint(): the sensor_origin_ of the source decides again. */
  void clearSourceViewpoint() { settings_.has_viewpoint_source = 0; }

  /** \brief Takes back setTargetViewpoint(): the sensor_origin_ of the target decides again. */
  void clearTargetViewpoint() { settings_.has_viewpoint_target = 0; }

  /** \brief Only poses near the guess of align(), which the identity then is too. All priors hold
   * at once, for the final transformation and for the alternatives; when no pose satisfies them,
   * align() fails.
   * \param degrees how far the rotation may be from the guess's, 0 to 180; 180: any
   * \param distance how far the centroid of the source may end from where the guess puts it, 0 to
   * 1e12, in the clouds' unit; 1e12: anywhere */
  void setGuessRadius(double degrees, double distance = 1e12) {
    settings_.guess_rotation = degrees;
    settings_.guess_translation = distance;
  }

  /** \brief Takes back setGuessRadius(). */
  void clearGuessRadius() { setGuessRadius(180); }

  /** \brief Only rotations about a direction that is the same in both clouds' frames: up, say, for
   * scanners that know where down is.
   * \param axis the direction, of any length above 0
   * \param tilt how far the rotated axis may lean from itself, degrees, 0 to 90
   * \param minimum, maximum limits of the angle about it, degrees, -360 to 360 */
  void setRotationAxis(const Eigen::Vector3d& axis, double tilt = 0, double minimum = -180,
                       double maximum = 180);

  /** \brief Takes back setRotationAxis(). */
  void clearRotationAxis();

  /** \brief Only translations of the final transformation between these, in the clouds' unit. */
  void setTranslationBounds(const Eigen::Vector3d& minimum, const Eigen::Vector3d& maximum);

  /** \brief Takes back setTranslationBounds(). */
  void clearTranslationBounds() { settings_.has_translation_bounds = 0; }

  /** \brief Only rotations of no more degrees than these, 0 to 180; 180: any. */
  void setMaximumRotation(double degrees) { settings_.maximum_rotation = degrees; }

  /** \brief Hands in descriptors of the source's points, of any type that PCL has a
   * DefaultPointRepresentation for, or of any Histogram; both clouds or none, of one type. They are
   * matched in the place of our own FPFH. A point whose descriptor has a NaN has none. */
  template <typename FeatureCloud>
  void setSourceFeatures(const shared_ptr<FeatureCloud>& features) {
    setFeatures(features, "setSourceFeatures", source_user_input_, preprocessed_source_);
  }

  /** \brief The same by a representation of your own, which may scale or leave out numbers. */
  template <typename FeatureCloud>
  void setSourceFeatures(
      const shared_ptr<FeatureCloud>& features,
      const PointRepresentation<typename FeatureCloud::PointType>& representation) {
    setFeatures(features, representation, source_user_input_, preprocessed_source_);
  }

  /** \brief Hands in descriptors of the target's points; as setSourceFeatures(). */
  template <typename FeatureCloud>
  void setTargetFeatures(const shared_ptr<FeatureCloud>& features) {
    setFeatures(features, "setTargetFeatures", target_user_input_, preprocessed_target_);
  }
  template <typename FeatureCloud>
  void setTargetFeatures(
      const shared_ptr<FeatureCloud>& features,
      const PointRepresentation<typename FeatureCloud::PointType>& representation) {
    setFeatures(features, representation, target_user_input_, preprocessed_target_);
  }

  /** \brief Hands in normals of the source's points, in the place of the estimated ones; of any
   * length, NaN or zero where there is none. Null takes them back. */
  void setSourceNormals(const PointCloud<Normal>::ConstPtr& normals) {
    setNormals(normals, source_user_input_, preprocessed_source_);
  }

  /** \brief Hands in normals of the target's points; as setSourceNormals(). */
  void setTargetNormals(const PointCloud<Normal>::ConstPtr& normals) {
    setNormals(normals, target_user_input_, preprocessed_target_);
  }

  /** \brief Hands in matches in the place of our own: index_query of the source, index_match of the
   * target; distance and weight are not used. At least three different ones of finite points, else
   * align() fails; those of source points that setIndices() leaves out are left out too. Null takes
   * them back. */
  void setCorrespondences(const CorrespondencesConstPtr& correspondences);

  /** \brief Take back what was handed in. */
  void clearSourceFeatures() { clear(source_user_input_.features, preprocessed_source_); }
  void clearTargetFeatures() { clear(target_user_input_.features, preprocessed_target_); }
  void clearSourceNormals() { clear(source_user_input_.normals, preprocessed_source_); }
  void clearTargetNormals() { clear(target_user_input_.normals, preprocessed_target_); }
  void clearCorrespondences() { setCorrespondences(nullptr); }

  /** \brief Sets what is told of the progress, on the thread that calls align(); an empty function
   * for nothing. What it throws stops the run and comes out of align(), which then has no pose. */
  void setProgressCallback(ProgressCallback callback) { progress_ = std::move(callback); }

  /** \brief The whole result of the last align(): verdict, quality, counts, cost, timings, history.
   * Null when it failed, before it, and after an input setter. */
  [[nodiscard]] ResultConstPtr getResult() const { return result_; }

  /** \brief How probable it is held that the final transformation is right, 0 to 1. NaN before any
   * align(), when it failed, and without candidates, as in preset "paper". */
  [[nodiscard]] double getConfidence() const;

  /** \brief How far each point of the source (of the indices, if they are set; in the order of the
   * output of align()) is from the nearest point of the target at the final transformation, in the
   * clouds' unit; NaN for points that are not finite. Measured anew with each call.
   * \return empty, with a PCL_ERROR, when there is no pose */
  [[nodiscard]] std::vector<double> getSourceResiduals() const;

  /** \brief How far each point of the target is from the nearest of the moved source points; as
   * getSourceResiduals(). */
  [[nodiscard]] std::vector<double> getTargetResiduals() const;

  /** \brief Why the last align() did or did not converge, in a few words; empty before it. */
  [[nodiscard]] std::string getReasonText() const;

  /** \brief Why the last align() gave no pose, naming the cloud or the setting and what was
   * expected, or which input is missing; empty when nothing is wrong. */
  [[nodiscard]] std::string getErrorMessage() const;

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
  static void setViewpoint(const Eigen::Vector3f& viewpoint, std::int32_t& known,
                           double (&position)[3]);

  /** \brief The sensor_origin_ of a cloud, where none was set and it is not zero. */
  static void fillViewpoint(const Eigen::Vector4f& sensor_origin, std::int32_t& known,
                            double (&position)[3]);

  static void clear(detail::UserRows& handed, detail::CachedCloud& preprocessed);

  static void setNormals(const PointCloud<Normal>::ConstPtr& normals, detail::UserInput& handed,
                         detail::CachedCloud& preprocessed);

  template <typename FeatureCloud>
  void setFeatures(const shared_ptr<FeatureCloud>& features, const char* setter,
                   detail::UserInput& handed, detail::CachedCloud& preprocessed);

  template <typename FeatureCloud>
  void setFeatures(const shared_ptr<FeatureCloud>& features,
                   const PointRepresentation<typename FeatureCloud::PointType>& representation,
                   detail::UserInput& handed, detail::CachedCloud& preprocessed);

  /** \brief Whether setIndices() selects the source as it is. */
  [[nodiscard]] bool selectsAll() const;

  /** \brief Makes the clouds ready with what was handed in, and \a pairs of the correspondences.
   * \return false, with the message kept, on an error */
  bool prepare(const PointCloudSource& source, std::int32_t threads,
               std::shared_ptr<const emtr_preprocessed> (&preprocessed)[2],
               std::vector<std::int32_t>& pairs);

  /** \brief Of one point type: by the base class. */
  void alignAs(PointCloudSource& output, const Matrix4& guess, std::true_type);

  /** \brief Of two point types. */
  void alignAs(PointCloudSource& output, const Matrix4& guess, std::false_type);

  /** \brief The state before any align(): no result, not converged, no pose. */
  void forgetResult();

  /** \brief Runs the library on \a source, the selected points, and keeps its result.
   * \return false, with the message kept, on an error */
  bool solve(const PointCloudSource& source, const Matrix4& guess);

  /** \brief The residuals of either cloud. */
  std::vector<double> measureResiduals(bool of_target) const;

  emtr_settings settings_;
  ProgressCallback progress_;
  ResultConstPtr result_;
  std::string error_message_;
  detail::CachedCloud preprocessed_source_, preprocessed_target_;
  detail::UserInput source_user_input_, target_user_input_;
  std::vector<std::int32_t> pairs_;  // of the correspondences
  bool has_correspondences_ = false;

 public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

}  // namespace pcl

#include <pcl/registration/impl/emtr_ssc.hpp>
