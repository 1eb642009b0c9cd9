#!/usr/bin/env bash
# The law of layers, read from the sources: a file of src/murosimf/<folder> includes its own folder and lower ones only,
# control software only control/client, math and itself, and nobody steps around the include root with "../".
# The compiler enforces the same through the include directories of the targets (cmake/layers.cmake); this names the
# line, and also sees files that no target compiles. includes_go_one_way.sh [ROOT]
set -euo pipefail
cd "${1:-$(dirname "$0")/../..}"
folders=$(find src/murosimf controllers -type f \( -name '*.h' -o -name '*.cpp' \) 2>/dev/null | sort)
[ -n "$folders" ] || { echo "error: no sources found in $PWD" >&2; exit 1; }

# shellcheck disable=SC2086  # one word a file: names have no spaces
awk '
  BEGIN {
    count = split("math algorithms world robot linking render modules control simulation soccer", order, " ")
    for (i = 1; i <= count; ++i) rank[order[i]] = i
    rank["scene"] = rank["soccer"]  # siblings: neither sees the other
    rank["client"] = rank["math"] + 0.5
  }
  function layer(path) { return path ~ /^murosimf\/control\/client\// ? "client" : gensub_folder(path) }
  function gensub_folder(path) { sub(/^murosimf\//, "", path); sub(/\/.*/, "", path); return path }
  function fault(text) { print "error: " FILENAME ":" FNR ": " text > "/dev/stderr"; faults = 1 }
  function allowed(from, to) {
    if (from == to) return 1
    if (from == "client") return to == "math"
    if (from == "controllers") return to == "math" || to == "client"
    if (to == "client") return rank[from] >= rank["control"]
    return rank[to] < rank[from]
  }
  FNR == 1 { from = FILENAME ~ /^controllers\// ? "controllers" : layer(substr(FILENAME, 5)) }
  FNR == 1 && from != "controllers" && !(from in rank) { fault("folder \"" from "\" has no place in the order of layers") }
  /^[ \t]*#[ \t]*include[ \t]*["<]/ {
    name = $0; sub(/^[^"<]*["<]/, "", name); sub(/[">].*/, "", name)
    if (name ~ /(^|\/)\.\.\//) fault("include of \"" name "\": write the path from the include root")
    if (name !~ /^murosimf\//) next
    to = layer(name)
    if (!(to in rank)) fault("include of \"" name "\": no such folder")
    else if (!allowed(from, to)) fault(from " includes \"" name "\": " to " is not below " from)
  }
  END { exit faults }' $folders
