#!/usr/bin/env bash
# What a user of the framework does: installs it into a folder, builds each of examples/* outside the tree against it
# with nothing but find_package(murosimf), and runs it: examples_build_and_run.sh BUILD COMPILER
# An example is run by its own ctest entries, of which it must have one at least.
set -euo pipefail
build=$(cd "$1" && pwd)
compiler=$2
source=$(cd "$(dirname "$0")/../.." && pwd)
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT

quiet() {  # runs a command, shows what it wrote only if it fails
  "$@" >"$root/log" 2>&1 && return
  cat "$root/log" >&2
  echo "error: '$*' failed (above)" >&2
  exit 1
}

quiet cmake --install "$build" --prefix "$root/installed"
launcher=$(command -v ccache || true)
for example in "$source"/examples/*/CMakeLists.txt; do
  [ -f "$example" ] || continue
  name=$(basename "$(dirname "$example")")
  cp -r "$(dirname "$example")" "$root/$name"  # away from this tree, so that no path leads back into it
  quiet cmake -S "$root/$name" -B "$root/$name/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" -DCMAKE_PREFIX_PATH="$root/installed"
  quiet cmake --build "$root/$name/build"
  quiet ctest --test-dir "$root/$name/build" --output-on-failure --no-tests=error
  echo "examples/$name: built against the installed package and run"
done
