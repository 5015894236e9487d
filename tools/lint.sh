# Sourced by tools/check, after setup.sh: what is said of the sources without running them.
# shellcheck shell=bash

# own [find's test...]: the project's files, one a line.
own() {
  find .ci examples libemtr pyemtr tests tools -type f -not -path '*/__pycache__/*' "$@" | sort
}

# Each version lays out in its own way: PyPI has the same one everywhere, see pyproject.toml.
layout_of_c() {
  local files
  mapfile -t files < <(own -regex '.*\.\(c\|cpp\|h\|hpp\|inl\)')
  ((${#files[@]})) || fail "no C or C++ files below $ROOT"
  clang-format --dry-run -Werror "${files[@]}"
}

# The C++ sources that one of the last commits changed, or that no commit has; all without git.
recently_changed() {
  git rev-parse --is-inside-work-tree >/dev/null 2>&1 || { own -name '*.cpp'; return; }
  { git log -n 10 --name-only --format= && git status --porcelain -uall | cut -c4-; } | sort -u |
    while read -r file; do [[ ! -f $file ]] || echo "$file"; done
}

# A module of the command is left out where its library is not: nothing can compile it there.
without_missing_modules() {
  while read -r file; do
    [[ $file != */modules/* ]] || grep -q "$file" "$BUILD/compile_commands.json" || continue
    echo "$file"
  done
}

# clang_tidy [--recent]: the set of checks, and why some are left out: .clang-tidy. The compiler is
# GCC, which needs no -std to read C++17. A file takes many seconds: --recent is for every day.
clang_tidy() {
  local files version
  version=$(clang-tidy --version | sed -nE 's/.*version ([0-9]+).*/\1/p' | head -n 1)
  if [[ $version != 14 ]]; then
    echo "left out: .clang-tidy is written for version 14, and version $version has other checks"
    return
  fi
  if [[ ${1-} == --recent ]]; then mapfile -t files < <(recently_changed); else mapfile -t files < <(own); fi
  mapfile -t files < <(printf '%s\n' "${files[@]}" | grep -E '^(libemtr/src|tools/pcl_emtr)/.*\.cpp$' |
    without_missing_modules)
  echo "${#files[@]} files"
  ((${#files[@]})) || return 0
  printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -n 1 clang-tidy -p "$BUILD" -quiet \
    -extra-arg=-std=c++17 >"$BUILD/clang-tidy.log" 2>&1 || {
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
