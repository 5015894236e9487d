#pragma once

namespace emtr_test {

/// Whether Debian's PCL rounds once where it multiplies and adds, which the engine never does: so
/// do compilers by default for processors that all have an instruction for both.
#if defined(__aarch64__)
constexpr bool kPclContracts = true;
#else
constexpr bool kPclContracts = false;
#endif
constexpr const char* kNoOracle = "PCL for this processor contracts multiplications and additions";

}  // namespace emtr_test
