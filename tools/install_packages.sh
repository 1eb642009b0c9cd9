#!/usr/bin/env bash
# Installs what is missing of packages.txt, and nothing else: install_packages.sh [SECTION...] (default: build).
# Debian and relatives: apt-get, with sudo where not root. Elsewhere: says what is missing and stops.
set -euo pipefail
cd "$(dirname "$0")/.."
sections=("${@:-build}")

# Lines "package probe" of the sections that were asked for.
list() {
  awk -v wanted=" ${sections[*]} " '{ sub(/#.*/, "") } NF == 0 { next }
    /^\[/ { gsub(/[][ \t]/, ""); on = index(wanted, " " $0 " "); next } on { print $1, $2 }' packages.txt
}

# Without dpkg: is there such a program or module of Python, or can the compiler see such a header?
present() {
  case $1 in
    '<'*) echo "#include $1" | "${CXX:-c++}" -std=c++20 -E -x c++ - >/dev/null 2>&1 ;;
    import:*) /usr/bin/python3 -c "import ${1#import:}" >/dev/null 2>&1 ;;
    *) command -v "$1" >/dev/null 2>&1 ;;
  esac
}

missing_on_debian() {
  list | while read -r package _; do
    status=$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null || true)
    [ "$status" = installed ] || echo "$package"
  done
}

missing_elsewhere() {
  list | while read -r package probe; do
    present "$probe" || echo "$probe  (Debian package $package)"
  done
}

if ! command -v dpkg-query >/dev/null 2>&1 || ! command -v apt-get >/dev/null 2>&1; then
  missing=$(missing_elsewhere)
  [ -z "$missing" ] && exit 0
  printf 'error: murosimf installs packages on Debian only, and this machine lacks:\n' >&2
  printf '%s\n' "$missing" | sed 's/^/  /' >&2
  printf 'Install them with the package manager of this system, then run make again.\n' >&2
  exit 1
fi

missing=$(missing_on_debian)
[ -z "$missing" ] && exit 0

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null 2>&1; then
    echo "error: packages are missing, and there is neither root nor sudo to install them. Ask an administrator for:" >&2
    echo "  apt-get install --no-install-recommends ${missing//$'\n'/ }" >&2
    exit 1
  fi
  as_root=(sudo)
fi
as_root+=(env DEBIAN_FRONTEND=noninteractive)

log=$(mktemp)
trap 'rm -f "$log"' EXIT
run() {
  "${as_root[@]}" "$@" >"$log" 2>&1 && return
  cat "$log" >&2
  echo "error: '$*' failed (above). murosimf is built on Debian 12 (bookworm); packages.txt lists what it needs." >&2
  exit 1
}
echo "Installing ${missing//$'\n'/ }"
run apt-get update
# shellcheck disable=SC2086  # one word a package
run apt-get install --yes --no-install-recommends $missing
