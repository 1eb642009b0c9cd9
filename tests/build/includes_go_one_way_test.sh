#!/usr/bin/env bash
# The check of the layers finds what it is there for: every kind of wrong include, and none in a right tree.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
put() { mkdir -p "$root/$(dirname "$1")" && printf '%s\n' "$2" >"$root/$1"; }
refuses() {
  if "$here/includes_go_one_way.sh" "$root" 2>"$root/log"; then echo "error: accepted $1" >&2; exit 1; fi
  grep -qF "$1" "$root/log" || { cat "$root/log" >&2; echo "error: expected a message with $1" >&2; exit 1; }
}

put src/murosimf/math/a.h '#include <vector>'
put src/murosimf/robot/b.h '#include "murosimf/math/a.h"'
put src/murosimf/control/c.h '#include "murosimf/control/client/d.h"'
put controllers/walk/e.cpp '#include "murosimf/control/client/d.h"'
"$here/includes_go_one_way.sh" "$root"

put src/murosimf/math/up.h '#include "murosimf/robot/b.h"'
refuses 'math/up.h:1: math includes "murosimf/robot/b.h"'
rm "$root/src/murosimf/math/up.h"
put src/murosimf/soccer/sibling.h '#include "murosimf/scene/s.h"'
refuses 'soccer/sibling.h:1: soccer includes'
rm "$root/src/murosimf/soccer/sibling.h"
put src/murosimf/control/client/f.h '#include "murosimf/world/w.h"'
refuses 'client/f.h:1: client includes'
rm "$root/src/murosimf/control/client/f.h"
put controllers/cheat.cpp $'\n#include "murosimf/simulation/truth.h"'
refuses 'controllers/cheat.cpp:2: controllers includes'
rm "$root/controllers/cheat.cpp"
put src/murosimf/math/around.h '#include "../robot/b.h"'
refuses 'write the path from the include root'
rm "$root/src/murosimf/math/around.h"
put src/murosimf/odd/o.h '// nothing'
refuses 'folder "odd" has no place'
