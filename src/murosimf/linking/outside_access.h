#pragma once

/// @file What something outside the blocks (a port, a camera, the pair phase) takes and gives, as a declaration.

#include "murosimf/linking/module.h"

namespace murosimf {

/// A module that only declares: its owner reads and writes through handles, in its own place of the frame.
class OutsideAccess final : public Module {
 public:
  using Declare = void (*)(Declaration&);
  explicit OutsideAccess(Declare words) : declare_(words) {}
  void declare(Declaration& declaration) const override { declare_(declaration); }

 private:
  Declare declare_;
};

}  // namespace murosimf
