#!/usr/bin/env bash
# Makes the pictures of docs/viewer.md again, without a screen: viewer_pictures.sh [PROGRAM]
set -euo pipefail
cd "$(dirname "$0")/.."
xvfb-run -a -s "-screen 0 1280x800x24" "${1:-build/release/murosimf-view}" scenarios/game_3v3.toml \
  --script tools/viewer_pictures.txt --set robots.red.2.level=full
