# Sourced by tools/check, after setup.sh: what is said of the sources without running them.
# shellcheck shell=bash

# own [find's test...]: the project's files, one a line.
own() {
  find .ci libemtr pyemtr tests tools -type f -not -path '*/__pycache__/*' "$@" | sort
}

layout_of_c() {
  local files
  mapfile -t files < <(own -regex '.*\.\(c\|cpp\|h\|hpp\|inl\)')
  ((${#files[@]})) || fail "no C or C++ files below $ROOT"
  clang-format --dry-run -Werror "${files[@]}"
}

# The set of checks, and why some are left out: .clang-tidy. The compiler is GCC, which needs no
# -std to read C++17.
clang_tidy() {
  run-clang-tidy -p "$BUILD" -j "$(nproc)" -quiet -extra-arg=-std=c++17 \
    "^$ROOT/(libemtr/src|tools/pcl_emtr)/.*\\.cpp$" >"$BUILD/clang-tidy.log" 2>&1 || {
    grep -E -A 4 '(warning|error):' "$BUILD/clang-tidy.log" || tail -n 20 "$BUILD/clang-tidy.log"
    return 1
  }
}

shell_scripts() {
  local files
  mapfile -t files < <(own | xargs -d '\n' grep -lE '^#!.*bash$|^# shellcheck shell=bash')
  ((${#files[@]})) || fail "no shell scripts below $ROOT"
  shellcheck -x "${files[@]}"
}
