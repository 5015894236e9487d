#pragma once

namespace emtr_test {

/// ThreadSanitizer ends a forked child that makes threads when its parent has more than one, and
/// LLVM's OpenMP, with which it is used, keeps its threads when the process forks.
#if defined(__SANITIZE_THREAD__)
constexpr bool kThreadSanitizer = true;
#elif defined(__has_feature)
constexpr bool kThreadSanitizer = __has_feature(thread_sanitizer);
#else
constexpr bool kThreadSanitizer = false;
#endif

}  // namespace emtr_test
