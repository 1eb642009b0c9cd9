#pragma once

/// @file A variable that tells others which method a module is: it holds one value while the module is linked.

#include "murosimf/linking/links.h"
#include "murosimf/linking/module.h"

namespace murosimf {

/// Belongs to the module; its functions are called in those of the same names.
template <class T>
class FixedValue {
 public:
  FixedValue(const Variable<T>& property, const T& value)
      : property_(property), numbers_(Declaration::numbersOf(value)) {}
  void declare(Declaration& d) const { d.adds(property_); }
  void link(const Links& links) {
    column_ = links.column(property_);
    width_ = links.width();
  }
  void initialise(const BlockMemory& block) const { set(block, width_); }
  /// Two levels of detail may hold different values: a robot that changes between them must not keep the old one.
  void adopt(const BlockMemory& one) const { set(one, 1); }

 private:
  void set(const BlockMemory& block, int width) const {
    double* number = block.piece[static_cast<int>(column_.memory)] + column_.offset * width;
    for (const double value : numbers_) {
      for (int lane = 0; lane < width; ++lane) *number++ = value;
    }
  }

  Variable<T> property_;
  std::vector<double> numbers_;
  ColumnRef column_;
  int width_ = 1;
};

}  // namespace murosimf
