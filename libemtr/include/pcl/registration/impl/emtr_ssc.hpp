#pragma once

#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <pcl/registration/impl/emtr_ssc_points.hpp>
#include <pcl/registration/impl/emtr_ssc_priors.hpp>
#include <pcl/registration/impl/emtr_ssc_progress.hpp>
#include <pcl/registration/impl/emtr_ssc_tree.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl {

template <typename PointSource, typename PointTarget, typename Scalar>
EMTRSSCRegistration<PointSource, PointTarget, Scalar>::EMTRSSCRegistration() : settings_() {
  reg_name_ = "EMTRSSCRegistration";
  tree_.reset(new detail::FiniteKdTree<PointTarget>);
  emtr_settings_init(&settings_, sizeof(settings_), "default");
  setPreset("default");
  forgetResult();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setInputSource(
    const PointCloudSourceConstPtr& cloud) {
  forgetResult();
  if (cloud && !cloud->empty()) {
    Base::setInputSource(cloud);
    return;
  }
  PCL_ERROR("[pcl::%s::setInputSource] Null or empty cloud given, no source is left.\n",
            getClassName().c_str());
  input_.reset();
  preprocessed_source_.forget();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setInputTarget(
    const PointCloudTargetConstPtr& cloud) {
  forgetResult();
  if (cloud && !cloud->empty()) {
    Base::setInputTarget(cloud);
    return;
  }
  PCL_ERROR("[pcl::%s::setInputTarget] Null or empty cloud given, no target is left.\n",
            getClassName().c_str());
  target_.reset();
  target_cloud_updated_ = true;
  preprocessed_target_.forget();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::forgetResult() {
  result_.reset();
  error_message_.clear();
  converged_ = false;
  nr_iterations_ = 0;
  // A pose that is not known must not look like one.
  final_transformation_.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
  transformation_ = final_transformation_;
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setPreset(const std::string& name) {
  emtr_settings settings;
  if (emtr_settings_init(&settings, sizeof(settings), name.c_str()) != EMTR_OK) {
    PCL_ERROR("[pcl::%s::setPreset] %s\n", getClassName().c_str(), emtr_error_message());
    return false;
  }
  // They belong to the clouds, not to the method.
  settings.has_viewpoint_source = settings_.has_viewpoint_source;
  settings.has_viewpoint_target = settings_.has_viewpoint_target;
  std::copy_n(settings_.viewpoint_source, 3, settings.viewpoint_source);
  std::copy_n(settings_.viewpoint_target, 3, settings.viewpoint_target);
  detail::copyPriors(settings_, settings);
  setSettings(settings);
  return true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setRotationAxis(
    const Eigen::Vector3d& axis, double tilt, double minimum, double maximum) {
  settings_.has_axis = 1;
  Eigen::Vector3d::Map(settings_.axis) = axis;
  settings_.axis_tilt = tilt;
  settings_.axis_angle_minimum = minimum;
  settings_.axis_angle_maximum = maximum;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::clearRotationAxis() {
  setRotationAxis(Eigen::Vector3d::Zero());
  settings_.has_axis = 0;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setTranslationBounds(
    const Eigen::Vector3d& minimum, const Eigen::Vector3d& maximum) {
  settings_.has_translation_bounds = 1;
  Eigen::Vector3d::Map(settings_.translation_minimum) = minimum;
  Eigen::Vector3d::Map(settings_.translation_maximum) = maximum;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setViewpoint(
    const Eigen::Vector3f& viewpoint, std::int32_t& known, double (&position)[3]) {
  known = 1;
  Eigen::Vector3d::Map(position) = viewpoint.cast<double>();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::fillViewpoint(
    const Eigen::Vector4f& sensor_origin, std::int32_t& known, double (&position)[3]) {
  const Eigen::Vector3f origin = sensor_origin.head<3>();
  if (!known && !origin.isZero(0)) setViewpoint(origin, known, position);
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setSetting(const std::string& name,
                                                                       double value) {
  emtr_settings settings = getSettings();
  if (emtr_setting_set(&settings, name.c_str(), value) != EMTR_OK) {
    PCL_ERROR("[pcl::%s::setSetting] %s\n", getClassName().c_str(), emtr_error_message());
    return false;
  }
  setSettings(settings);
  return true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getSetting(const std::string& name,
                                                                       double& value) const {
  const emtr_settings settings = getSettings();
  if (emtr_setting_get(&settings, name.c_str(), &value) == EMTR_OK) return true;
  PCL_ERROR("[pcl::%s::getSetting] %s\n", getClassName().c_str(), emtr_error_message());
  return false;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setSettings(
    const emtr_settings& settings) {
  settings_ = settings;
  settings_.correspondences = nullptr;  // the caller's memory; setCorrespondences() keeps a copy
  settings_.correspondence_count = 0;
  max_iterations_ = settings.iterations;
}

template <typename PointSource, typename PointTarget, typename Scalar>
emtr_settings EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getSettings() const {
  emtr_settings settings = settings_;
  settings.iterations = max_iterations_;
  return settings;
}

template <typename PointSource, typename PointTarget, typename Scalar>
double EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getConfidence() const {
  return result_ ? result_->confidence : std::numeric_limits<double>::quiet_NaN();
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::vector<double> EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getSourceResiduals()
    const {
  return measureResiduals(false);
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::vector<double> EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getTargetResiduals()
    const {
  return measureResiduals(true);
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::vector<double> EMTRSSCRegistration<PointSource, PointTarget, Scalar>::measureResiduals(
    bool of_target) const {
  if (!result_ || !final_transformation_.allFinite()) {
    PCL_ERROR("[pcl::%s::measureResiduals] There is no pose.\n", getClassName().c_str());
    return {};
  }
  PointCloudSource selected;
  copyPointCloud(*input_, *indices_, selected);
  const std::vector<float> source = detail::packPoints(selected);
  const std::vector<float> target = detail::packPoints(*target_);
  const emtr_cloud from = {source.data(), selected.size(), 0, EMTR_FLOAT32};
  const emtr_cloud to = {target.data(), target_->size(), 0, EMTR_FLOAT32};
  std::vector<double> residuals(of_target ? to.count : from.count);
  double* const of_source = of_target ? nullptr : residuals.data();
  if (emtr_residuals(&from, &to, result_->transformation, settings_.threads, of_source,
                     of_target ? residuals.data() : nullptr) == EMTR_OK)
    return residuals;
  PCL_ERROR("[pcl::%s::measureResiduals] %s\n", getClassName().c_str(), emtr_error_message());
  return {};
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::string EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getReasonText() const {
  return result_ ? emtr_reason_text(result_->reason) : error_message_;
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::string EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getErrorMessage() const {
  if (!error_message_.empty()) return error_message_;
  // align() of the base class returns before it asks us when an input is missing.
  if (!input_) return "source: no cloud, expected one that is not empty";
  if (!target_) return "target: no cloud, expected one that is not empty";
  return std::string();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::align(PointCloudSource& output,
                                                                  const Matrix4& guess) {
  alignAs(output, guess, std::is_same<PointSource, PointTarget>());
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::alignAs(PointCloudSource& output,
                                                                    const Matrix4& guess,
                                                                    std::true_type) {
  Base::align(output, guess);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::alignAs(PointCloudSource& output,
                                                                    const Matrix4& guess,
                                                                    std::false_type) {
  if (!input_ || !target_) {
    PCL_ERROR("[pcl::%s::align] %s\n", getClassName().c_str(), getErrorMessage().c_str());
    return;
  }
  if (!PCLBase<PointSource>::initCompute()) return;  // fills the indices where none were given
  PointCloudSource selected;                         // the output may be the source itself
  copyPointCloud(*input_, *indices_, selected);
  if (selected.size() == input_->size()) {
    selected.width = input_->width;
    selected.height = input_->height;
  }
  output = std::move(selected);
  computeTransformation(output, guess);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::computeTransformation(
    PointCloudSource& output, const Matrix4& guess) {
  forgetResult();
  if (!solve(output, guess)) {
    PCL_ERROR("[pcl::%s::align] %s\n", getClassName().c_str(), error_message_.c_str());
    return;
  }
  for (Eigen::Index i = 0; i < 16; ++i)
    final_transformation_(i / 4, i % 4) = static_cast<Scalar>(result_->transformation[i]);
  transformation_ = final_transformation_;
  converged_ = result_->registered != 0;
  nr_iterations_ = static_cast<int>(result_->iterations);
  // Stopped before any pose was known, there is none to move the points by.
  if (final_transformation_.allFinite())
    detail::transformPoints(output, final_transformation_.template cast<double>().eval());
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::clear(detail::UserRows& handed,
                                                                  detail::CachedCloud& preprocessed) {
  handed = detail::UserRows();
  preprocessed.forget();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setNormals(
    const PointCloud<Normal>::ConstPtr& normals, detail::UserInput& handed,
    detail::CachedCloud& preprocessed) {
  clear(handed.normals, preprocessed);
  if (normals) handed.normals = detail::packNormals(*normals);
}

template <typename PointSource, typename PointTarget, typename Scalar>
template <typename FeatureCloud>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setFeatures(
    const shared_ptr<FeatureCloud>& features, const char* setter, detail::UserInput& handed,
    detail::CachedCloud& preprocessed) {
  using Default = detail::DefaultFeature<typename FeatureCloud::PointType>;
  if (features && !Default::known()) {
    PCL_ERROR(
        "[pcl::%s::%s] PCL knows no representation of this type of features, give one; no "
        "features are left.\n",
        getClassName().c_str(), setter);
    clear(handed.features, preprocessed);
    return;
  }
  setFeatures(features, Default::make(), handed, preprocessed);
}

template <typename PointSource, typename PointTarget, typename Scalar>
template <typename FeatureCloud>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setFeatures(
    const shared_ptr<FeatureCloud>& features,
    const PointRepresentation<typename FeatureCloud::PointType>& representation,
    detail::UserInput& handed, detail::CachedCloud& preprocessed) {
  clear(handed.features, preprocessed);
  if (features) handed.features = detail::packFeatures(*features, representation);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setCorrespondences(
    const CorrespondencesConstPtr& correspondences) {
  pairs_.clear();
  has_correspondences_ = correspondences != nullptr;
  if (!correspondences) return;
  for (const Correspondence& pair : *correspondences) {
    pairs_.push_back(detail::rowNumber(pair.index_query));
    pairs_.push_back(detail::rowNumber(pair.index_match));
  }
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::selectsAll() const {
  if (indices_->size() != input_->size()) return false;
  for (std::size_t i = 0; i < indices_->size(); ++i)
    if (static_cast<std::size_t>((*indices_)[i]) != i) return false;
  return true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::prepare(
    const PointCloudSource& source, std::int32_t threads,
    std::shared_ptr<const emtr_preprocessed> (&preprocessed)[2], std::vector<std::int32_t>& pairs) {
  error_message_ = source_user_input_.mismatch("source", input_->size());
  if (error_message_.empty()) error_message_ = target_user_input_.mismatch("target", target_->size());
  const bool all = selectsAll();
  pairs = pairs_;
  if (!all)
    for (std::size_t i = 0; i < pairs.size() && error_message_.empty(); i += 2)
      if (pairs[i] < 0 || static_cast<std::size_t>(pairs[i]) >= input_->size())
        error_message_ = "correspondences: row " + std::to_string(i / 2) + ": source point " +
                         std::to_string(pairs[i]) + ", expected 0 to " +
                         std::to_string(input_->size() - 1);
  if (!error_message_.empty()) return false;
  if (!all) pairs = detail::renumbered(pairs_, *indices_, input_->size());

  const bool keep = has_correspondences_;
  if (all || source_user_input_.empty())
    preprocessed[0] = preprocessed_source_.of(source, "source", threads, source_user_input_, keep);
  else  // made anew: other points may have the same coordinates
    preprocessed[0] = detail::CachedCloud().of(source, "source", threads,
                                             source_user_input_.selected(*indices_), keep);
  if (preprocessed[0])
    preprocessed[1] = preprocessed_target_.of(*target_, "target", threads, target_user_input_, keep);
  if (preprocessed[1]) return true;
  error_message_ = emtr_error_message();
  return false;
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::solve(const PointCloudSource& source,
                                                                  const Matrix4& guess) {
  emtr_settings settings = getSettings();
  if (guess != Matrix4::Identity() || detail::limitsGuess(settings)) {
    settings.has_guess = 1;
    for (Eigen::Index i = 0; i < 16; ++i)
      settings.guess[i] = static_cast<double>(guess(i / 4, i % 4));
  }
  fillViewpoint(input_->sensor_origin_, settings.has_viewpoint_source, settings.viewpoint_source);
  fillViewpoint(target_->sensor_origin_, settings.has_viewpoint_target, settings.viewpoint_target);
  const auto start = std::chrono::steady_clock::now();
  std::shared_ptr<const emtr_preprocessed> preprocessed[2];
  std::vector<std::int32_t> pairs;
  if (!prepare(source, settings.threads, preprocessed, pairs)) return false;
  if (has_correspondences_) {
    settings.correspondence_count = pairs.size() / 2;
    pairs.push_back(0);  // an empty list has an address too
    settings.correspondences = pairs.data();
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  // What has gone by counts; a limit of 0 would be none.
  if (settings.time_limit > 0)
    settings.time_limit = std::max(settings.time_limit - seconds.count(), 1e-9);

  detail::ProgressRelay relay(progress_);
  emtr_result* result = nullptr;
  const emtr_status status = emtr_register_preprocessed(preprocessed[0].get(), preprocessed[1].get(), &settings,
                                                    relay.function(), &relay, &result);
  if (status != EMTR_OK) error_message_ = emtr_error_message();
  ResultConstPtr owned(result,
                       [](const emtr_result* r) { emtr_result_free(const_cast<emtr_result*>(r)); });
  if (relay.thrown()) {
    error_message_ = "the progress callback threw an exception";
    std::rethrow_exception(relay.thrown());
  }
  if (result) {
    result->seconds_normalization += seconds.count();
    result->seconds_total += seconds.count();
  }
  result_ = std::move(owned);
  return status == EMTR_OK;
}

}  // namespace pcl

#include <pcl/registration/impl/emtr_ssc_instantiations.hpp>
