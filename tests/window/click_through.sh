#!/usr/bin/env bash
# The window, driven by a script without a screen: click_through.sh PROGRAM. Needs xvfb-run (packages.txt, view).
set -euo pipefail
cd "$(dirname "$0")/../.."
command -v xvfb-run > /dev/null || { echo "skipped: no xvfb-run"; exit 77; }
xvfb-run -a -s "-screen 0 1280x800x24" "$1" scenarios/game_3v3.toml --script tests/window/click_through.txt \
  --set 'robots.red.3.motion="kinematic_walking, multibody_dynamics@1000"'
