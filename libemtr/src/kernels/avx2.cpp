#define EMTR_KERNEL avx2
#include "kernels/all.inl"

namespace emtr {
extern const Kernels k_avx2;
constexpr Kernels k_avx2 = avx2::all("avx2");
}  // namespace emtr
