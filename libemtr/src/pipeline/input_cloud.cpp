#include "pipeline/input_cloud.h"

#include <memory>

namespace emtr {
namespace {

void preprocess(InputCloud& input, const char* name, const Settings& user) {
  if (input.preprocessed) return;
  emtr_cloud cloud = *input.cloud;
  if (user.correspondences) cloud.keep_points = 1;  // they name rows of it
  input.preprocessed = std::make_shared<const PreprocessedCloud>(cloud, name, thread_count(user));
}

}  // namespace

void preprocess(InputCloud& source, InputCloud& target, const Settings& user) {
  preprocess(source, "source", user);
  preprocess(target, "target", user);
}

NormalizedPair normalize(InputCloud& source, InputCloud& target, const Settings& user) {
  preprocess(source, target, user);
  return normalize(source.preprocessed, target.preprocessed, user.leaf_ladder != 0);
}

}  // namespace emtr
