#include "murosimf/linking/links.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>

namespace murosimf {

AlignedDoubles::AlignedDoubles(std::size_t count) : size_(count) {
  const std::size_t bytes = (std::max<std::size_t>(count, 1) * sizeof(double) + 63) / 64 * 64;
  data_.reset(static_cast<double*>(std::aligned_alloc(64, bytes)));
  if (data_ == nullptr) throw std::bad_alloc();
  std::fill_n(data_.get(), count, std::numeric_limits<double>::quiet_NaN());
}

const ColumnLayout* Batch::column(std::string_view property, std::string_view subset) const {
  for (const ColumnLayout& layout : columns) {
    if (layout.property == property && layout.subset == subset) return &layout;
  }
  return nullptr;
}

const DeclaredProperty& Links::declared(std::string_view property, std::string_view of) const {
  for (const DeclaredProperty& line : declaration_.properties()) {
    if (line.name == property && line.subset == of) return line;
  }
  throw std::logic_error(fmt::format("a module links property \"{}\" of {} that it has not declared", property, of));
}

const ColumnLayout& Links::find(std::string_view property, std::string_view of) const {
  declared(property, of);
  if (const ColumnLayout* layout = batch_.column(property, of)) return *layout;
  throw std::logic_error(
      fmt::format("a module links property \"{}\" of {}, which is no column of numbers here", property, of));
}

ObjectId Links::object(std::string_view of, int number) const {
  return world_.members(batch_.members.front(), of)[static_cast<std::size_t>(number)];
}

}  // namespace murosimf
