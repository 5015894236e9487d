#pragma once

#include <emtr/emtr.h>
#include <pcl/console/print.h>
#include <pcl/registration/emtr_ssc.h>

#include <algorithm>
#include <pcl/registration/impl/emtr_ssc_priors.hpp>
#include <string>

namespace pcl {

template <typename PointSource, typename PointTarget, typename Scalar>
bool EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setPreset(const std::string& name) {
  emtr_settings settings;
  if (emtr_settings_init(&settings, sizeof(settings), name.c_str()) != EMTR_OK) {
    PCL_ERROR("[pcl::%s::setPreset] %s\n", getClassName().c_str(), emtr_error_message());
    return false;
  }
  // Viewpoints and priors belong to the clouds, not to the method.
  settings.has_viewpoint_source = settings_.has_viewpoint_source;
  settings.has_viewpoint_target = settings_.has_viewpoint_target;
  std::copy_n(settings_.viewpoint_source, 3, settings.viewpoint_source);
  std::copy_n(settings_.viewpoint_target, 3, settings.viewpoint_target);
  detail::copyPriors(settings_, settings);
  setSettings(settings);
  return true;
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

}  // namespace pcl
