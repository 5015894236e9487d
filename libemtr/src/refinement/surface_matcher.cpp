#include "refinement/surface_matcher.h"

#include <algorithm>
#include <utility>

namespace emtr {

void SurfaceMatcher::Scratch::grow(std::size_t size) {
  for (auto* v : {&x, &y, &z, &squared}) v->resize(std::max(v->size(), size));
  index.resize(std::max(index.size(), size));
}

SurfaceMatcher::SurfaceMatcher(QueryPoints source, QueryPoints target, const Neighbors* near_source,
                               const Neighbors* near_target, const Kernels& kernels)
    : source_(std::move(source)),
      target_(std::move(target)),
      near_source_(near_source),
      near_target_(near_target),
      kernels_(kernels) {}

}  // namespace emtr
