#define EMTR_KERNEL avx2
#include "kernels/all.inl"

namespace emtr {
extern const Kernels k_avx2;
constexpr Kernels k_avx2 = avx2::all("avx2");
extern const SearchKernels k_avx2_search;
constexpr SearchKernels k_avx2_search = avx2::search();
}  // namespace emtr
