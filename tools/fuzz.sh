#!/usr/bin/env bash
# Lets libFuzzer look for bytes that harm the readers of what clients send: tools/fuzz.sh [SECONDS] [TARGET...]
# What goes wrong stops it and is left in out/fuzz/TARGET; out/fuzz/TARGET/smallest has the smallest set of inputs that
# reaches as much. tests/fuzz/corpus, which `make test` replays, has some of them, and whatever once went wrong.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${1:-60}
shift || true
cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --parallel "$(nproc)" --target murosimf-fuzz
targets=("$@")
[ "${#targets[@]}" -gt 0 ] || mapfile -t targets < <(ls tests/fuzz/corpus)
for target in "${targets[@]}"; do
  echo "== $target: $seconds s"
  found=out/fuzz/$target
  mkdir -p "$found/corpus"
  export MUROSIMF_FUZZ_TARGET=$target
  build/fuzz/murosimf-fuzz -max_total_time="$seconds" -max_len=4096 -rss_limit_mb=1024 -verbosity=0 -print_final_stats=1 \
    -artifact_prefix="$found/" "$found/corpus" "tests/fuzz/corpus/$target"
  rm -rf "$found/smallest" && mkdir -p "$found/smallest"
  build/fuzz/murosimf-fuzz -merge=1 -max_len=256 "$found/smallest" "$found/corpus" "tests/fuzz/corpus/$target" 2>/dev/null
done
