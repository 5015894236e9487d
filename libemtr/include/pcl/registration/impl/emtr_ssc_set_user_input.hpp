#pragma once

#include <pcl/console/print.h>
#include <pcl/registration/emtr_ssc.h>

#include <cstddef>
#include <pcl/registration/impl/emtr_ssc_user_input.hpp>
#include <string>

namespace pcl {

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::clear(detail::UserRows& rows,
                                                                  detail::CachedCloud& cache) {
  rows = detail::UserRows();
  cache.reset();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setNormals(
    const PointCloud<Normal>::ConstPtr& normals, detail::UserInput& input,
    detail::CachedCloud& cache) {
  clear(input.normals, cache);
  if (normals) input.normals = detail::packNormals(*normals);
}

template <typename PointSource, typename PointTarget, typename Scalar>
template <typename FeatureCloud>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setFeatures(
    const shared_ptr<FeatureCloud>& features, const char* setter, detail::UserInput& input,
    detail::CachedCloud& cache) {
  using Default = detail::DefaultFeature<typename FeatureCloud::PointType>;
  if (features && !Default::known()) {
    PCL_ERROR(
        "[pcl::%s::%s] PCL has no representation of this type of features, expected one as second "
        "argument; no features are left.\n",
        getClassName().c_str(), setter);
    clear(input.features, cache);
    return;
  }
  setFeatures(features, Default::make(), input, cache);
}

template <typename PointSource, typename PointTarget, typename Scalar>
template <typename FeatureCloud>
void EMTRSSCRegistration<PointSource, PointTarget, Scalar>::setFeatures(
    const shared_ptr<FeatureCloud>& features,
    const PointRepresentation<typename FeatureCloud::PointType>& representation,
    detail::UserInput& input, detail::CachedCloud& cache) {
  clear(input.features, cache);
  if (features) input.features = detail::packFeatures(*features, representation);
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
std::string EMTRSSCRegistration<PointSource, PointTarget, Scalar>::checkUserInput() const {
  std::string source = source_user_input_.mismatch("source", input_->size());
  if (!source.empty()) return source;
  std::string target = target_user_input_.mismatch("target", target_->size());
  if (!target.empty() || selectsAll()) return target;
  // Only rows of the source can be renumbered; the library checks all that it gets.
  for (std::size_t i = 0; i < pairs_.size(); i += 2)
    if (pairs_[i] < 0 || static_cast<std::size_t>(pairs_[i]) >= input_->size())
      return "correspondences: row " + std::to_string(i / 2) + ": source point " +
             std::to_string(pairs_[i]) + ", expected 0 to " + std::to_string(input_->size() - 1);
  return std::string();
}

}  // namespace pcl
