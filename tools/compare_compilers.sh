#!/usr/bin/env bash
# Plays a few seconds of the game with the programs of several build folders and compares the hash of their final
# states, which must be equal to the last bit: compare_compilers.sh BUILD...
# SECONDS_TO_PLAY and SCENARIO in the environment change what is played.
set -euo pipefail
cd "$(dirname "$0")/.."
seconds=${SECONDS_TO_PLAY:-5}
scenario=${SCENARIO:-scenarios/game_3v3.toml}
out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
first=
for build in "$@"; do
  "$build/murosimf" run "$scenario" --duration "$seconds" --video none --out "$out/$(basename "$build")" >"$out/log" 2>&1 ||
    { cat "$out/log" >&2; echo "error: $build/murosimf failed (above)" >&2; exit 1; }
  hash=$(sed -n 's/.*"state_hash": *"\{0,1\}\([0-9a-fA-Fx]*\).*/\1/p' "$out/$(basename "$build")/report.json" | head -n 1)
  [ -n "$hash" ] || { echo "error: no state_hash in the report of $build" >&2; exit 1; }
  echo "$hash  $build"
  if [ -n "$first" ] && [ "$hash" != "$first" ]; then
    echo "error: $build and $1 end in different states after $seconds s of $scenario" >&2
    exit 1
  fi
  first=${first:-$hash}
done
