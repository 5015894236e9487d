# Sourced by tools/check, after setup.sh: the C and C++ tests under Clang's sanitizers. No code of our
# own is left out; what is known of foreign libraries stands in tests/sanitizers, each with its reason.
# shellcheck shell=bash

# ctest with one of the builds that build_sanitized() makes.
sanitized_tests() {
  (cd "$ROOT" && ctest --test-dir "$ROOT/build/$1" --parallel "$(nproc)" --output-on-failure \
    --no-tests=error)
}

# AddressSanitizer with its leak detector, and UndefinedBehaviorSanitizer.
address_tests() {
  ASAN_OPTIONS=detect_leaks=1:strict_string_checks=1:detect_stack_use_after_return=1:check_initialization_order=1:strict_init_order=1 \
    LSAN_OPTIONS=suppressions=$ROOT/tests/sanitizers/leak.supp \
    UBSAN_OPTIONS=print_stacktrace=1 sanitized_tests address
}

# ThreadSanitizer does not see the barriers of an OpenMP runtime: Archer, a part of LLVM's runtime,
# tells it of them. Without it this would report races that there are none of, so it must be there.
thread_tests() {
  local archer
  archer=$(clang -print-resource-dir)/../../libarcher.so
  [[ -f $archer ]] || fail "no libarcher.so beside Clang's OpenMP runtime (package libomp-dev)"
  OMP_TOOL_LIBRARIES=$archer ARCHER_OPTIONS=verbose=0 \
    TSAN_OPTIONS=ignore_noninstrumented_modules=1:suppressions=$ROOT/tests/sanitizers/thread.supp \
    sanitized_tests thread
}
