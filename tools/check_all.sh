#!/usr/bin/env bash
# Everything that is checked before a release or before an issue is called resolved; takes its time.
set -euo pipefail
cd "$(dirname "$0")/.."
jobs=${JOBS:-$(nproc)}

build() {
  echo "== $1: build"
  cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" --parallel "$jobs"
}
tests() {
  echo "== $1: tests"
  ctest --preset "$1" --parallel "$jobs"
}

echo "== format"
tools/check_format.sh
for preset in release gcc clang; do
  build $preset
  tests $preset
done
echo "== release: slow tests"
ctest --test-dir build/release --output-on-failure --label-regex slow
echo "== same bits"
tools/compare_compilers.sh build/release build/gcc build/clang
for preset in asan tsan; do
  build $preset
  tests $preset
done
echo "== clang-tidy"
tools/tidy.sh build/release --all
echo "== all good"
