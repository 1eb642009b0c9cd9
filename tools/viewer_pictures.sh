#!/usr/bin/env bash
# Makes the pictures of docs/viewer.md again, without a screen: viewer_pictures.sh [FOLDER OF THE PROGRAMS]
set -euo pipefail
cd "$(dirname "$0")/.."
programs=${1:-build/release} folder=out/viewer_pictures
mkdir -p "$folder"
"$programs/murosimf" run scenarios/game_3v3.toml --duration 20 --out "$folder" --record "$folder/game.rec" >/dev/null

# No noise in robots' pictures: files would be twice the size.
quiet=(--set robots.all.cameras.head.noise=0 --set robots.all.cameras.chest.noise=0)
view() {
  xvfb-run -a -s "-screen 0 1280x800x24" "$programs/murosimf-view" "$@"
}
view scenarios/game_3v3.toml --script tools/viewer_pictures.txt "${quiet[@]}" --set robots.red.2.level=full
view scenarios/game_3v3.toml --script tools/viewer_pictures_oracle.txt --set robots.all.level=oracle
view scenarios/mixed_teams.toml --script tools/viewer_pictures_scans.txt
rm -f murosimf_*s.mp4  # the video that the Pictures panel is seen with
