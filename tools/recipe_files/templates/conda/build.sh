#!/usr/bin/env bash
# Builds the package emtr @VERSION@; conda sets the variables.
set -euo pipefail
# shellcheck disable=SC2086 # CMAKE_ARGS is a list of words
cmake -S "$SRC_DIR" -B build -G Ninja ${CMAKE_ARGS:-} \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$PREFIX" -DCMAKE_INSTALL_LIBDIR=lib
cmake --build build --parallel "${CPU_COUNT:-2}"
cmake --install build
