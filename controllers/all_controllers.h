#pragma once

/// @file The reference control software by name.

#include <functional>
#include <map>
#include <memory>
#include <string>

#include "murosimf/control/client/control_software.h"

namespace murosimf::controllers {

using MakeController = std::function<std::unique_ptr<client::ControlSoftware>()>;
/// cart, player, trotter.
const std::map<std::string, MakeController>& allControllers();

}  // namespace murosimf::controllers
