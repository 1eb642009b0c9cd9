#!/usr/bin/env bash
# Is the battery's green bar in the window, and gone when it is switched off? own_view_test.sh PROGRAM
# Needs xvfb-run and ffmpeg.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
command -v xvfb-run >/dev/null || { echo "skipped: no xvfb-run"; exit 77; }
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
data=$PWD  # has the robot file
cp -r "$data/robots" "$folder"
cd "$folder"
xvfb-run -a -s "-screen 0 1280x800x24" "$1" "$here/scenario.toml" --script "$here/own_view_test.txt"

# Bright green pixels of a picture; the carpet is darker.
green() {
  ffmpeg -loglevel error -i "$1" -f rawvideo -pix_fmt rgb24 - | od -An -v -w3 -tu1 |
    awk '$1 < 90 && $2 > 140 && $3 < 90 { n++ } END { print n + 0 }'
}
off=$(green off.png)
on=$(green on.png)
echo "green pixels: $off without the bar, $on with it"
[ "$on" -gt $((off + 100)) ]
