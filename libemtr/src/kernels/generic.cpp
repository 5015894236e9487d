#define EMTR_KERNEL generic
#include "kernels/all.inl"

namespace emtr {
extern const Kernels k_generic;
constexpr Kernels k_generic = generic::all("generic");
extern const SearchKernels k_generic_search;
constexpr SearchKernels k_generic_search = generic::search();
}  // namespace emtr
