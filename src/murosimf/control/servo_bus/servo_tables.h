#pragma once

/// @file The tables themselves: data of control_table.h.

#include <span>

#include "murosimf/control/servo_bus/control_table.h"

namespace murosimf::servo_bus {

/// What differs between models that share a table.
struct Model {
  const char* name;
  std::int64_t number1, number2;  ///< that they answer to a ping in version 1.0 and 2.0; 0: no such table
  ServoFigures figures;
  std::int64_t largest_voltage1;                           ///< [0.1 V]
  std::int64_t current_limit, velocity_limit, position_p;  ///< of version 2.0
  bool has_current;
  bool is_x;  ///< series X: one table, whichever version it is asked in
};

std::span<const Model> models();
std::span<const Register> registersOfVersion1();
std::span<const Register> currentRegistersOfVersion1();  ///< MX-64, MX-106
std::span<const Register> registersOfVersion2();
std::span<const Register> currentRegistersOfVersion2();  ///< all but MX-28
std::span<const Register> loadRegistersOfVersion2();     ///< MX-28
std::span<const Register> mxRegistersOfVersion2();
std::span<const Register> xRegistersOfVersion2();
std::span<const Register> imuRegisters();

}  // namespace murosimf::servo_bus
