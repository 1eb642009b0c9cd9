#!/bin/sh
# Compiles one kernel with another compiler than the rest of the build. CMake calls launchers as
#   compile_kernel.sh KERNEL_COMPILER USUAL_COMPILER [LAUNCHER...] USUAL_COMPILER ARGUMENTS...
# and this runs LAUNCHER... KERNEL_COMPILER ARGUMENTS...: the first argument equal to USUAL_COMPILER is replaced.
set -eu
kernel_compiler=$1
usual_compiler=$2
shift 2
left=$#
replaced=no
while [ "$left" -gt 0 ]; do
  argument=$1
  shift
  if [ "$replaced" = no ] && [ "$argument" = "$usual_compiler" ]; then
    argument=$kernel_compiler
    replaced=yes
  fi
  set -- "$@" "$argument"
  left=$((left - 1))
done
exec "$@"
