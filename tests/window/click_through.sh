#!/usr/bin/env bash
# The window, driven by a script without a screen: click_through.sh PROGRAM. Needs xvfb-run (packages.txt, view).
set -euo pipefail
tree=$(cd "$(dirname "$0")/../.." && pwd)
command -v xvfb-run > /dev/null || { echo "skipped: no xvfb-run"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
"$(dirname "$1")/murosimf" run "$tree/scenarios/game_3v3.toml" --duration 0.5 --record out/game.rec --out out > /dev/null 2>&1
xvfb-run -a -s "-screen 0 1280x800x24" "$1" "$tree/scenarios/game_3v3.toml" --script "$tree/tests/window/click_through.txt" \
  --set 'robots.red.3.motion="kinematic_walking, multibody_dynamics@1000"'
for kind in png mp4; do
  ls murosimf_*."$kind" > /dev/null || { echo "error: the window wrote no $kind" >&2; exit 1; }
done
