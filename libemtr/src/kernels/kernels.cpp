#include "kernels/kernels.h"

#include <cstdlib>
#include <iterator>
#include <string>

#include "kernels/search_kernels.h"
#include "util/error.h"

namespace emtr {

extern const Kernels k_generic, k_avx2, k_avx512;
extern const SearchKernels k_generic_search, k_avx2_search, k_avx512_search;

namespace {

// Lists the slowest first.
const Kernels* const kAll[] = {
    &k_generic,
#if defined(__x86_64__)
    &k_avx2,
    &k_avx512,
#endif
};

}  // namespace

const Kernels* kernels_at(std::size_t index) {
  return index < std::size(kAll) ? kAll[index] : nullptr;
}

bool can_run(const Kernels& kernels) {
#if defined(__x86_64__)
  if (&kernels == &k_avx2) return __builtin_cpu_supports("avx2");
  if (&kernels == &k_avx512)
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq");
#endif
  return &kernels == &k_generic;
}

const SearchKernels& search_kernels([[maybe_unused]] const Kernels& kernels) {
#if defined(__x86_64__)
  if (&kernels == &k_avx2) return k_avx2_search;
  if (&kernels == &k_avx512) return k_avx512_search;
#endif
  return k_generic_search;
}

const Kernels& select_kernels() {
  const char* wanted = std::getenv("EMTR_KERNEL");
  const Kernels* best = &k_generic;
  std::string here;
  for (const Kernels* kernels : kAll) {
    if (!can_run(*kernels)) continue;
    best = kernels;
    if (wanted && std::string(wanted) == kernels->name) return *kernels;
    here += (here.empty() ? "" : ", ") + std::string(kernels->name);
  }
  if (wanted && *wanted)
    throw Error(EMTR_ERROR_SETTING, "the variable EMTR_KERNEL is '" + std::string(wanted) +
                                        "', expected one that this machine can run: " + here);
  return *best;
}

}  // namespace emtr
