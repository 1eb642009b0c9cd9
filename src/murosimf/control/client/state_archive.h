#pragma once

/// @file The archive that control software writes its state into, under the client's name.

#include "murosimf/math/state_archive.h"

namespace murosimf::client {

using murosimf::StateArchive;

}  // namespace murosimf::client
