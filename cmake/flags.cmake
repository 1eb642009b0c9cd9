# Compiler flags. Results are the same bits for g++ and clang, scalar and lanes, so nothing here may let a compiler
# change arithmetic: no fast-math, no contraction, and g++ 12's SLP vectorizer is off because it fuses
# a*b-c, a*b+c into vfmaddsub in spite of -ffp-contract=off.
if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Release or Debug" FORCE)
endif()
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-Og -g -fno-omit-frame-pointer")

set(murosimf_warnings -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor
    -Wold-style-cast -Wno-psabi -Werror)
# Templates over scalar and lanes write a & b where a and b may be plain bool: no branch, on purpose.
set(murosimf_clang_warnings -Wno-bitwise-instead-of-logical)
# What whoever includes our headers needs as well, for the same bits and the same layout of lanes.
set(murosimf_public_flags -march=x86-64-v3 -ffp-contract=off -fno-tree-slp-vectorize)
set(murosimf_kernel_flags -O3 -fno-tree-slp-vectorize -fno-math-errno)
# g++ keeps structures of more bytes than this in memory and copies them as a whole; inertias of 8 lanes have 1344.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT MUROSIMF_KERNEL_COMPILER MATCHES "clang")
  list(APPEND murosimf_kernel_flags --param=sra-max-scalarization-size-Ospeed=2048)
endif()

if(MUROSIMF_SANITIZE)
  add_compile_options(-fsanitize=${MUROSIMF_SANITIZE} -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${MUROSIMF_SANITIZE})
  if(MUROSIMF_SANITIZE MATCHES "thread")
    include_directories(BEFORE "${PROJECT_SOURCE_DIR}/cmake/tsan")  # the sanitizer cannot see into libtbb.so
  endif()
endif()

unset(murosimf_kernel_compiler)
if(MUROSIMF_KERNEL_COMPILER)
  find_program(murosimf_kernel_compiler ${MUROSIMF_KERNEL_COMPILER} NO_CACHE)
  if(NOT murosimf_kernel_compiler)
    message(FATAL_ERROR "MUROSIMF_KERNEL_COMPILER: found no program ${MUROSIMF_KERNEL_COMPILER}.\n"
            "`make deps` installs clang++-14 on Debian; the preset `gcc` does without.")
  endif()
endif()

# ccache, where there is one; its base directory lets all build folders of one checkout share entries.
find_program(MUROSIMF_CCACHE ccache)
if(MUROSIMF_CCACHE AND (NOT CMAKE_CXX_COMPILER_LAUNCHER OR CMAKE_CXX_COMPILER_LAUNCHER STREQUAL "ccache"))
  set(CMAKE_CXX_COMPILER_LAUNCHER env "CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}" "${MUROSIMF_CCACHE}")
endif()

# murosimf_flags(target): what every target of ours is compiled with.
function(murosimf_flags target)
  target_compile_options(${target} PRIVATE ${murosimf_warnings} $<$<CXX_COMPILER_ID:Clang>:${murosimf_clang_warnings}>)
endfunction()
