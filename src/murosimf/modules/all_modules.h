#pragma once

/// @file The one list of the modules that this library brings.

#include "murosimf/linking/module.h"

namespace murosimf {

ModuleRegistry allModules();

}  // namespace murosimf
