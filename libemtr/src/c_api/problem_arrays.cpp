#include "c_api/problem_arrays.h"

#include "util/error.h"

namespace emtr {

ProblemArrays::View ProblemArrays::interleaved(emtr_array which, const Cloud& cloud) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::vector<float>& rows = rows_[which];
  if (rows.empty()) {
    rows.reserve(3 * cloud.size());
    for (std::size_t i = 0; i < cloud.size(); ++i)
      rows.insert(rows.end(), {cloud.x[i], cloud.y[i], cloud.z[i]});
  }
  return {rows.data(), cloud.size(), 3};
}

ProblemArrays::View ProblemArrays::view(emtr_array which) const {
  const auto plain = [](const std::vector<float>& values, std::size_t columns) {
    return View{values.data(), values.size() / columns, columns};
  };
  const auto features = [&](const Features& dense, const Keypoints* keypoints) {
    return keypoints && keypoints->dimension ? plain(keypoints->descriptors, keypoints->dimension)
                                             : plain(dense.descriptors, kFeatureSize);
  };
  const auto rows = [](const Keypoints* keypoints) {
    return keypoints ? View{keypoints->rows.data(), keypoints->rows.size(), 1}
                     : View{nullptr, 0, 1};
  };
  const Problem& p = problem_;
  const Keypoints* source_keypoints = p.user_keypoints ? &p.user_keypoints->source : nullptr;
  const Keypoints* target_keypoints = p.user_keypoints ? &p.user_keypoints->target : nullptr;
  switch (which) {
    case EMTR_SOURCE_SPARSE:
      return interleaved(which, p.downsampled.source_sparse);
    case EMTR_TARGET_SPARSE:
      return interleaved(which, p.downsampled.target_sparse);
    case EMTR_SOURCE_DENSE:
      return interleaved(which, p.downsampled.source_dense);
    case EMTR_TARGET_DENSE:
      return interleaved(which, p.downsampled.target_dense);
    case EMTR_SOURCE_NORMALS:
      return plain(p.source_features->normals, 3);
    case EMTR_TARGET_NORMALS:
      return plain(p.target_features->normals, 3);
    case EMTR_SOURCE_FEATURES:
      return features(*p.source_features, source_keypoints);
    case EMTR_TARGET_FEATURES:
      return features(*p.target_features, target_keypoints);
    case EMTR_CORRESPONDENCES:
      return {p.correspondences.data(), p.correspondences.size(), 2};
    case EMTR_TIM_SOURCE:
      return interleaved(which, p.tims.source);
    case EMTR_TIM_TARGET:
      return interleaved(which, p.tims.target);
    case EMTR_SOURCE_FEATURE_POINTS:
      return interleaved(which, p.matched_source());
    case EMTR_TARGET_FEATURE_POINTS:
      return interleaved(which, p.matched_target());
    case EMTR_SOURCE_FEATURE_ROWS:
      return rows(source_keypoints);
    case EMTR_TARGET_FEATURE_ROWS:
      return rows(target_keypoints);
  }
  throw Error(EMTR_ERROR_ARGUMENT, "array: there is none of that number");
}

}  // namespace emtr
