#include "pipeline/input_cloud.h"

#include <exception>
#include <memory>

#include "preprocessing/base_points.h"
#include "util/error.h"
#include "util/thread_team.h"

namespace emtr {
namespace {

void preprocess(InputCloud& input, const char* name, const Settings& user) {
  if (input.preprocessed) return;
  emtr_cloud cloud = *input.cloud;
  if (user.correspondences) cloud.keep_points = 1;  // they name rows of it
  input.preprocessed = std::make_shared<const PreprocessedCloud>(cloud, name, thread_count(user));
}

bool is_small(const InputCloud& input) {
  return !input.preprocessed && input.cloud->count <= kDownsampledAbove;
}

/// Each by one thread. Whichever is done first, a fault of the source leaves the target alone.
void preprocess_side_by_side(InputCloud& source, InputCloud& target, const Settings& user) {
  std::exception_ptr failures[2];
  parallel_for(2, thread_count(user), [&](std::size_t i) {
    try {
      i == 0 ? preprocess(source, "source", user) : preprocess(target, "target", user);
    } catch (const Error&) {
      failures[i] = std::current_exception();
    }
  });
  if (failures[0]) target.preprocessed = nullptr;
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace

void preprocess(InputCloud& source, InputCloud& target, const Settings& user) {
  if (is_small(source) && is_small(target)) return preprocess_side_by_side(source, target, user);
  preprocess(source, "source", user);
  preprocess(target, "target", user);
}

NormalizedPair normalize(InputCloud& source, InputCloud& target, const Settings& user) {
  preprocess(source, target, user);
  return normalize(source.preprocessed, target.preprocessed, user.leaf_ladder != 0);
}

}  // namespace emtr
