#!/usr/bin/env bash
# Makes the validation book, out/book/book.html: builds the tests that have a page, runs them, draws what they wrote.
# make_book.sh [BUILD_FOLDER] [OUT_FOLDER]; JOBS compilers at once. Ends with 1 if a test of the book failed.
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build/release}
out=${2:-out/book}
jobs=${JOBS:-$(nproc)}
rm -rf "$out/pages"
mkdir -p "$out/pages"
tools/book_tests.sh >"$out/tests.txt"
mapfile -t folders < <(cut -d ' ' -f 1 "$out/tests.txt" | sort -u)

cmake --build "$build" --parallel "$jobs" --target "${folders[@]/#/test_}"
for folder in "${folders[@]}"; do
  # A test's plain name and, for TEST_P, its instances.
  filter=$(awk -v folder="$folder" '$1 == folder { printf "%s:*/%s/*:", $2, $2 }' "$out/tests.txt")
  echo "running $(grep -c "^$folder " "$out/tests.txt") tests of tests/$folder"
  MUROSIMF_BOOK="$PWD/$out/pages" "$build/tests/test_$folder" --gtest_filter="$filter" --gtest_brief=1 \
    >"$out/test_$folder.log" 2>&1 || { echo "error: tests of tests/$folder failed: $out/test_$folder.log" >&2; }
done
cut -d ' ' -f 2 "$out/tests.txt" | tools/make_book.py "$out/pages" "$out/book.html" --expected -
