#!/usr/bin/env bash
# Looks into the program's and libraries' objects in a build folder for what would spoil "same bits everywhere":
# check_objects.sh BUILD
#  - vfmaddsub/vfmsubadd: the compiler fused a multiplication and an addition that nobody wrote as fma;
#  - 512-bit registers outside kernels *_v4.cpp: would stop the program on a machine without AVX-512;
#  - functions of kernels *_v4.cpp outside namespace isa_v4 that the linker may share with other files: the same.
set -euo pipefail
build=$1
faults=$(mktemp)
trap 'rm -f "$faults"' EXIT

# shellcheck disable=SC2317  # called by the shells of xargs
look() {
  local object=$1 v4=$2
  objdump --disassemble --no-show-raw-insn "$object" | awk -v object="$object" -v v4="$v4" '
    /^[0-9a-f]+ <.*>:$/ { name = $0; sub(/^[0-9a-f]+ </, "", name); sub(/>:$/, "", name) }
    /\tvfm(addsub|subadd)/ { print object ": " name ": fused: " $2; exit }
    /%zmm/ && !v4 { print object ": " name ": 512-bit register"; exit }'
  if [ "$v4" = 1 ]; then
    nm --defined-only "$object" | awk -v object="$object" '
      ($2 == "W" || $2 == "V" || $2 == "u") && !/isa_v4/ { $1 = $2 = ""; print object ":" $0 ": shared function outside isa_v4" }'
  fi
}
export -f look

find "$build"/CMakeFiles/murosimf* -name '*.cpp.o' -print0 | sort -z |
  xargs -0 -r -P "$(nproc)" -I{} bash -c 'case {} in *_v4.cpp.o) look {} 1 ;; *) look {} 0 ;; esac' >"$faults"
[ ! -s "$faults" ] && exit 0
sed 's/^/error: /' "$faults" | c++filt >&2
exit 1
