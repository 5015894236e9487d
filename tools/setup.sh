# Sourced by tools/quickstart, tools/check, tools/docs and tools/fuzz: packages, build, virtual environment.
# shellcheck shell=bash disable=SC2034 # variables for those who source it

ROOT=$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd -P)
BUILD=$ROOT/build
VENV=$BUILD/venv
NAME=$(basename "$(readlink -f "$0")")
LOG=$BUILD/$NAME.log
EMTR=$BUILD/tools/pcl_emtr # the command, once built
PYTHON=${PYTHON:-/usr/bin/python3}

# The package and the consumers' tests compile what the build has compiled: once is enough.
if command -v ccache >/dev/null; then
  export CMAKE_C_COMPILER_LAUNCHER=${CMAKE_C_COMPILER_LAUNCHER:-ccache}
  export CMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER:-ccache}
  export CCACHE_DIR=${CCACHE_DIR:-$BUILD/ccache}
  # Python sets a locale for what it starts, which would be another compilation.
  export CCACHE_SLOPPINESS=${CCACHE_SLOPPINESS:-pch_defines,time_macros,locale}
fi

fail() {
  printf '%s: error: %s\n' "$NAME" "$*" >&2
  exit 1
}

# step "what it does" command...: one line on the screen, the command's words in the log, and on
# failure their end on the screen too.
step() {
  local what=$1 start=$SECONDS from status=0
  shift
  mkdir -p "$BUILD" || fail "cannot make the folder $BUILD"
  printf '== %s\n' "$what" >>"$LOG" || fail "cannot write the log $LOG"
  printf '%s ... ' "$what"
  from=$(wc -l <"$LOG")
  "$@" >>"$LOG" 2>&1 </dev/null || status=$?
  if ((status != 0)); then
    printf 'FAILED\n'
    tail -n "+$((from + 1))" "$LOG" | tail -n 60 >&2
    fail "$what: failed with status $status; the whole log is in $LOG"
  fi
  printf 'done, %d s\n' "$((SECONDS - start))"
}

# Says what it installs, and touches nothing when all is there.
install_packages() {
  local package missing=() root=()
  command -v dpkg-query >/dev/null || fail "this is no Debian: install the counterparts of" \
    "$* yourself, then run again with --no-packages"
  for package in "$@"; do
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      missing+=("$package")
  done
  ((${#missing[@]})) || { echo "Debian packages: all there"; return; }
  echo "Debian packages to install: ${missing[*]}"
  if ((EUID != 0)); then
    command -v sudo >/dev/null || fail "not root and no sudo; as root run:" \
      "apt-get install --no-install-recommends ${missing[*]}"
    root=(sudo)
    sudo -v || fail "sudo refused; as root run:" \
      "apt-get install --no-install-recommends ${missing[*]}"
  fi
  root+=(env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300)
  step "Updating the package lists" "${root[@]}" update
  step "Installing them" "${root[@]}" install -y --no-install-recommends "${missing[@]}"
}

# configure [cmake option...]
configure() {
  step "Configuring the build in $BUILD" \
    cmake -S "$ROOT" -B "$BUILD" -G Ninja -DCMAKE_BUILD_TYPE=Release "$@"
}

# compile [option of cmake --build...]
# shellcheck disable=SC2120 # tools/fuzz gives some
compile() {
  step "Building with $(nproc) jobs" cmake --build "$BUILD" --parallel "$(nproc)" "$@"
}

# build [cmake option...]
build() {
  configure "$@"
  # shellcheck disable=SC2119
  compile
}

# build_sanitized() needs these packages.
CLANG_PACKAGES=(clang libclang-rt-dev libomp-dev cmake ninja-build pkg-config libpcl-dev libgtest-dev)

# build_sanitized address|thread [target...]: with Clang into a folder of its own. Assertions stay in,
# those of Eigen too. One build with AddressSanitizer serves the tests and the fuzz targets.
build_sanitized() {
  local kind=$1 folder=$ROOT/build/$1 fuzzers=OFF level=-O1
  shift
  [[ $kind != address ]] || fuzzers=ON level=-O2
  step "Configuring the build in $folder" cmake -S "$ROOT" -B "$folder" -G Ninja \
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS_DEBUG=$level -DCMAKE_CXX_FLAGS_DEBUG=$level \
    -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ -DEMTR_WERROR=ON \
    -DEMTR_SANITIZE="$kind" -DEMTR_BUILD_FUZZERS="$fuzzers" -DEMTR_BUILD_TESTS=ON \
    -DEMTR_BUILD_TOOLS=OFF
  step "Building with $(nproc) jobs" \
    cmake --build "$folder" --parallel "$(nproc)" --target "${@:-all}"
}

# Prints a hash of the package's sources; the same hash needs no new installation.
fingerprint() {
  (cd "$ROOT" && find pyproject.toml setup.py CMakeLists.txt libemtr pyemtr -type f \
    -not -path '*/__pycache__/*' -print0 | LC_ALL=C sort -z | xargs -0 sha256sum) | sha256sum
}

# install_pyemtr EXTRA: the package with its extra dependencies, into the virtual environment.
install_pyemtr() {
  local stamp=$VENV/pyemtr.stamp sources
  if ! "$VENV/bin/python" -m pip --version >/dev/null 2>&1; then
    [[ -x $(command -v "$PYTHON") ]] || fail "PYTHON=$PYTHON: no such interpreter"
    step "Making a virtual environment of $PYTHON" "$PYTHON" -m venv --clear "$VENV"
  fi
  sources=$(fingerprint) || fail "cannot read the sources below $ROOT"
  if [[ -f $stamp ]] && grep -qxF "$1 $sources" "$stamp"; then
    echo "pyemtr[$1]: already installed in $VENV"
    return
  fi
  rm -rf "$BUILD"/lib.* # what setuptools left there would go into the package again
  step "Installing pyemtr[$1] into $VENV" "$VENV/bin/python" -m pip install \
    --disable-pip-version-check "${ROOT}[$1]"
  # of the extras, those that were installed with these very sources
  { grep -F " $sources" "$stamp" 2>/dev/null || true; echo "$1 $sources"; } >"$stamp.new"
  mv "$stamp.new" "$stamp"
}

# options USAGE "$@": the options that both commands take; sets PACKAGES.
options() {
  local usage=$1
  shift
  PACKAGES=1
  while (($#)); do
    case $1 in
      -h | --help) printf '%s' "$usage"; exit 0 ;;
      --no-packages) PACKAGES=0 ;;
      *) printf '%s' "$usage" >&2; fail "unknown option: $1" ;;
    esac
    shift
  done
}
