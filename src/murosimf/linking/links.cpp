#include "murosimf/linking/links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <new>
#include <stdexcept>

namespace murosimf {

AlignedDoubles::AlignedDoubles(std::size_t count, double value) : size_(count) {
  const std::size_t bytes = (std::max<std::size_t>(count, 1) * sizeof(double) + 63) / 64 * 64;
  data_.reset(static_cast<double*>(std::aligned_alloc(64, bytes)));
  if (data_ == nullptr) throw std::bad_alloc();
  std::fill_n(data_.get(), count, value);
}

const ColumnLayout* Batch::column(std::string_view property, std::string_view subset) const {
  for (const ColumnLayout& layout : columns) {
    if (layout.property == property && layout.subset == subset) return &layout;
  }
  return nullptr;
}

ColumnRef Links::find(std::string_view property, std::string_view of) const {
  const ColumnLayout* layout = batch_.column(property, of);
  if (layout == nullptr) {
    throw std::logic_error(fmt::format("a module links property \"{}\" of {} that it has not declared", property, of));
  }
  return layout->ref;
}

}  // namespace murosimf
