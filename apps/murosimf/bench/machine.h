#pragma once

/// @file The machine that is measured on, and the width of its registers.

#include <string>

namespace murosimf {

/// Robots a block for "avx2", "avx512" or "auto"; -1 when the machine has no such registers.
int lanesOf(const std::string& isa);

/// Processor, threads, lanes and compiler, in one line.
std::string machineLine(int lanes);

}  // namespace murosimf
