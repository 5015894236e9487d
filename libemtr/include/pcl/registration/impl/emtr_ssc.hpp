#pragma once

#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <pcl/registration/impl/emtr_ssc_points.hpp>
#include <pcl/registration/impl/emtr_ssc_priors.hpp>
#include <pcl/registration/impl/emtr_ssc_progress.hpp>
#include <pcl/registration/impl/emtr_ssc_tree.hpp>
#include <pcl/registration/impl/emtr_ssc_user_input.hpp>
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
  resetResult();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setInputSource(
    const PointCloudSourceConstPtr& cloud) {
  resetResult();
  if (cloud && !cloud->empty()) {
    Base::setInputSource(cloud);
    return;
  }
  PCL_ERROR("[pcl::%s::setInputSource] Null or empty cloud given, no source is left.\n",
            getClassName().c_str());
  input_.reset();
  source_cache_.reset();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setInputTarget(
    const PointCloudTargetConstPtr& cloud) {
  resetResult();
  if (cloud && !cloud->empty()) {
    Base::setInputTarget(cloud);
    return;
  }
  PCL_ERROR("[pcl::%s::setInputTarget] Null or empty cloud given, no target is left.\n",
            getClassName().c_str());
  target_.reset();
  target_cloud_updated_ = true;
  target_cache_.reset();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::resetResult() {
  result_.reset();
  error_message_.clear();
  converged_ = false;
  nr_iterations_ = 0;
  // An unknown pose must not look like one.
  final_transformation_.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
  transformation_ = final_transformation_;
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
  if (!PCLBase<PointSource>::initCompute()) return;  // fills the indices if none were set
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
  resetResult();
  if (!solve(output, guess)) {
    PCL_ERROR("[pcl::%s::align] %s\n", getClassName().c_str(), error_message_.c_str());
    return;
  }
  for (Eigen::Index i = 0; i < 16; ++i)
    final_transformation_(i / 4, i % 4) = static_cast<Scalar>(result_->transformation[i]);
  transformation_ = final_transformation_;
  converged_ = result_->registered != 0;
  nr_iterations_ = static_cast<int>(result_->iterations);
  // A run that is stopped early has no pose to move the points by.
  if (final_transformation_.allFinite())
    detail::transformPoints(output, final_transformation_.template cast<double>().eval(),
                            result_->scale);
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::selectsAll() const {
  if (indices_->size() != input_->size()) return false;
  for (std::size_t i = 0; i < indices_->size(); ++i)
    if (static_cast<std::size_t>((*indices_)[i]) != i) return false;
  return true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::preprocess(
    const PointCloudSource& source, std::int32_t threads,
    std::shared_ptr<const emtr_preprocessed> (&preprocessed)[2]) {
  const bool keep = has_correspondences_, colors = settings_.use_colors != EMTR_OFF;
  if (selectsAll() || source_user_input_.empty())
    preprocessed[0] =
        source_cache_.get(source, "source", threads, source_user_input_, keep, colors);
  else  // not cached: other points with other rows may have the same coordinates
    preprocessed[0] = detail::CachedCloud().get(source, "source", threads,
                                                source_user_input_.select(*indices_), keep, colors);
  if (preprocessed[0])
    preprocessed[1] =
        target_cache_.get(*target_, "target", threads, target_user_input_, keep, colors);
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
  error_message_ = checkUserInput();
  if (!error_message_.empty()) return false;
  std::shared_ptr<const emtr_preprocessed> preprocessed[2];
  if (!preprocess(source, settings.threads, preprocessed)) return false;
  std::vector<std::int32_t> pairs;
  if (has_correspondences_) {
    pairs = selectsAll() ? pairs_ : detail::renumber(pairs_, *indices_, input_->size());
    settings.correspondence_count = pairs.size() / 2;
    pairs.push_back(0);  // an empty list needs an address too: null means none
    settings.correspondences = pairs.data();
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;

  // The preprocessing counts against the limit; a limit of 0 would mean none.
  if (settings.time_limit > 0)
    settings.time_limit = std::max(settings.time_limit - seconds.count(), 1e-9);

  detail::ProgressRelay relay(progress_);
  emtr_result* result = nullptr;
  const emtr_status status = emtr_register_preprocessed(
      preprocessed[0].get(), preprocessed[1].get(), &settings, relay.function(), &relay, &result);
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

#include <pcl/registration/impl/emtr_ssc_result.hpp>
#include <pcl/registration/impl/emtr_ssc_set_user_input.hpp>
#include <pcl/registration/impl/emtr_ssc_settings.hpp>

// After all definitions: the instantiations need them.
#include <pcl/registration/impl/emtr_ssc_instantiations.hpp>
