#!/usr/bin/env bash
# The check of objects finds what it is there for: check_objects_test.sh COMPILER (g++ or clang++).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
compiler=$1
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
compile() {  # compile FILE SOURCE FLAGS...
  rm -rf "$root/CMakeFiles" && mkdir -p "$root/CMakeFiles/murosimf_x.dir"
  printf '%s\n' "$2" >"$root/source.cpp"
  "$compiler" -std=c++20 -O2 "${@:3}" -c "$root/source.cpp" -o "$root/CMakeFiles/murosimf_x.dir/$1.o"
}
refuses() {
  if "$here/../../tools/check_objects.sh" "$root" 2>"$root/log"; then echo "error: accepted $1" >&2; exit 1; fi
  grep -qF "$1" "$root/log" || { cat "$root/log" >&2; echo "error: expected a message with: $1" >&2; exit 1; }
}

compile sum.cpp '#include <immintrin.h>
namespace isa_v4 { void add(double* a) { _mm512_storeu_pd(a, _mm512_add_pd(_mm512_loadu_pd(a), _mm512_set1_pd(1))); } }' \
  -march=x86-64-v4
refuses '512-bit register'
mv "$root/CMakeFiles/murosimf_x.dir/sum.cpp.o" "$root/CMakeFiles/murosimf_x.dir/sum_v4.cpp.o"
"$here/../../tools/check_objects.sh" "$root"
compile inline_v4.cpp 'inline __attribute__((noinline)) double twice(double x) { return 2 * x; } double f(double x) { return twice(x); }' \
  -march=x86-64-v4
refuses 'shared function outside isa_v4'
compile fused.cpp '#include <immintrin.h>
__m256d f(__m256d a, __m256d b, __m256d c) { return _mm256_fmaddsub_pd(a, b, c); }' -march=x86-64-v3
refuses 'fused'
