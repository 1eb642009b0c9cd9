#!/usr/bin/env bash
# Names the C++ files that clang-format would change, and fails if there are any; --fix formats them.
set -euo pipefail
cd "$(dirname "$0")/.."
mapfile -t files < <(git ls-files --cached --others --exclude-standard -- '*.cpp' '*.h' | while read -r f; do
  [ -f "$f" ] && echo "$f"
done)
[ "${#files[@]}" -gt 0 ] || exit 0
if [ "${1:-}" = --fix ]; then
  clang-format-14 -i "${files[@]}"
  exit 0
fi
wrong=$(printf '%s\n' "${files[@]}" | xargs -P "$(nproc)" -I{} sh -c 'clang-format-14 "$1" | cmp -s - "$1" || echo "$1"' _ {} | sort)
[ -z "$wrong" ] && exit 0
echo "error: not formatted; 'make format' mends it:" >&2
printf '%s\n' "$wrong" | sed 's/^/  /' >&2
exit 1
