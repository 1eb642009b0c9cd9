#pragma once

/// @file Which instruction set a translation unit is compiled for.
///
/// Kernels are compiled twice, for x86-64-v3 (AVX2) and x86-64-v4 (AVX-512), and live in one program. An inline
/// function of the same name in both versions would be merged by the linker, and a machine without AVX-512 could then
/// meet a 512-bit instruction anywhere. So everything in math/ stands in an inline namespace named after the
/// instruction set: the two versions have different names for the linker, and the same name for the reader.
/// Everything that is not a `*_v4.cpp` file is built for the baseline, isa_v3.

#ifndef MUROSIMF_ISA
#define MUROSIMF_ISA isa_v3
#endif
