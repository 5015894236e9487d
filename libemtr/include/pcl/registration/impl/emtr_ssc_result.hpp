#pragma once

#include <emtr/emtr.h>
#include <pcl/common/io.h>
#include <pcl/console/print.h>
#include <pcl/registration/emtr_ssc.h>

#include <limits>
#include <pcl/registration/impl/emtr_ssc_points.hpp>
#include <string>
#include <vector>

namespace pcl {

template <typename PointSource, typename PointTarget, typename Scalar>
double EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getConfidence() const {
  return result_ ? result_->confidence : std::numeric_limits<double>::quiet_NaN();
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::string EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getReasonText() const {
  return result_ ? emtr_reason_text(result_->reason) : error_message_;
}

template <typename PointSource, typename PointTarget, typename Scalar>
std::string EMTRSSCRegistration<PointSource, PointTarget, Scalar>::getErrorMessage() const {
  if (!error_message_.empty()) return error_message_;
  // align() of the base class returns before it calls this class when an input is missing.
  if (!input_) return "source: no cloud, expected one that is not empty";
  if (!target_) return "target: no cloud, expected one that is not empty";
  return std::string();
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
  double* const source_residuals = of_target ? nullptr : residuals.data();
  if (emtr_residuals(&from, &to, result_->transformation, settings_.threads, source_residuals,
                     of_target ? residuals.data() : nullptr) == EMTR_OK)
    return residuals;
  PCL_ERROR("[pcl::%s::measureResiduals] %s\n", getClassName().c_str(), emtr_error_message());
  return {};
}

}  // namespace pcl
