#!/usr/bin/env bash
# clang-tidy over .cpp files, several at a time: tidy.sh BUILD_FOLDER FILE... or tidy.sh BUILD_FOLDER --all.
# The build folder must be configured (compile_commands.json); files that it does not compile are left out.
set -euo pipefail
cd "$(dirname "$0")/.."
build=$1
shift
if [ "${1:-}" = --all ]; then
  mapfile -t wanted < <(git ls-files -- '*.cpp')
else
  wanted=("$@")
fi
files=()
for file in "${wanted[@]}"; do
  if grep -qF "\"file\": \"$PWD/$file\"" "$build/compile_commands.json"; then files+=("$file"); fi
done
[ "${#files[@]}" -gt 0 ] || { echo "clang-tidy: no file to check"; exit 0; }
echo "clang-tidy: ${#files[@]} files"
# Its "N warnings generated" counts what the system's headers suppressed; that line is noise.
one='out=$(clang-tidy-14 --quiet -p "$1" "$2" 2>&1) && s=0 || s=$?
     printf "%s\n" "$out" | grep -vE "^[0-9]+ warnings? generated|^$" || true
     exit $s'
printf '%s\0' "${files[@]}" | xargs -0 -P "$(nproc)" -I{} bash -c "$one" _ "$build" {} ||
  { echo "error: clang-tidy found faults (above); .clang-tidy says what is asked" >&2; exit 1; }
