#include "preprocessing/normalization.h"

#include <Eigen/Core>
#include <algorithm>
#include <memory>
#include <utility>

namespace emtr {

Cloud scale_cloud(const Cloud& cloud, double factor) {
  Cloud out = cloud;
  if (factor == 1) return out;
  for (auto* axis : {&out.x, &out.y, &out.z})
    for (float& v : *axis) v = static_cast<float>(v * factor);
  return out;
}

double spacing(const PreprocessedCloud& cloud, const Normalization& normalization) {
  return cloud.spacing() * (cloud.radius / normalization.scale);
}

NormalizedPair normalize(PreprocessedCloudPtr source, PreprocessedCloudPtr target, bool ladder) {
  NormalizedPair pair;
  const double radius = std::max(source->radius, target->radius);
  pair.ladder = ladder;
  pair.normalization.scale = ladder ? Ladder::above(radius) : radius;
  std::copy_n(source->center, 3, pair.normalization.center_source);
  std::copy_n(target->center, 3, pair.normalization.center_target);
  pair.source = scale_cloud(source->base, source->radius / pair.normalization.scale);
  pair.target = scale_cloud(target->base, target->radius / pair.normalization.scale);
  pair.preprocessed_source = std::move(source);
  pair.preprocessed_target = std::move(target);
  return pair;
}

double NormalizedPair::leaf_of_radii(double leaf) const {
  if (!ladder) return leaf;
  const double radius = std::max(preprocessed_source->radius, preprocessed_target->radius);
  return Ladder::nearest(leaf * (radius / normalization.scale));
}

bool trust_normals(const NormalizedPair& pair) {
  return pair.preprocessed_source->normals.size() && pair.preprocessed_target->normals.size();
}

NormalizedPair normalize(const emtr_cloud& source, const emtr_cloud& target, int threads) {
  auto preprocessed_source = std::make_shared<const PreprocessedCloud>(source, "source", threads);
  auto preprocessed_target = std::make_shared<const PreprocessedCloud>(target, "target", threads);
  return normalize(std::move(preprocessed_source), std::move(preprocessed_target));
}

Rigid Normalization::to_user(const Rigid& pose) const {
  Rigid out = pose;
  out.t = scale * pose.t + Eigen::Vector3d::Map(center_target) -
          pose.rotate(Eigen::Vector3d::Map(center_source));
  return out;
}

Similarity Normalization::to_user(const Similarity& similarity) const {
  Similarity out = similarity;
  out.pose.t = scale * similarity.pose.t + Eigen::Vector3d::Map(center_target) -
               similarity.scale * similarity.rotate(Eigen::Vector3d::Map(center_source));
  return out;
}

Rigid Normalization::to_normalized(const Rigid& pose) const {
  Rigid out = pose;
  out.t = (pose.t + pose.rotate(Eigen::Vector3d::Map(center_source)) -
           Eigen::Vector3d::Map(center_target)) /
          scale;
  return out;
}

}  // namespace emtr
