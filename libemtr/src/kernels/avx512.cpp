#define EMTR_KERNEL avx512
#include "kernels/all.inl"

namespace emtr {
extern const Kernels k_avx512;
constexpr Kernels k_avx512 = avx512::all("avx512");
extern const SearchKernels k_avx512_search;
constexpr SearchKernels k_avx512_search = avx512::search();
}  // namespace emtr
