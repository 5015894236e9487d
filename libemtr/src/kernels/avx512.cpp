#define EMTR_KERNEL avx512
#include "kernels/all.inl"

namespace emtr {
extern const Kernels k_avx512;
constexpr Kernels k_avx512 = avx512::all("avx512");
}  // namespace emtr
