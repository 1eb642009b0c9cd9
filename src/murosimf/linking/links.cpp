#include "murosimf/linking/links.h"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>
#include <stdexcept>

namespace murosimf {

namespace {

constexpr std::size_t kCacheLine = 64, kLargePage = 2UL << 20;  // bytes

/// A thousand robots walk through some ten thousand pages of 4 KB a frame otherwise, more than a processor knows by
/// heart. Only asked for: a system without large pages does as well, slower.
void askForLargePages(void* memory, std::size_t bytes) {
#ifdef MADV_HUGEPAGE
  madvise(memory, bytes, MADV_HUGEPAGE);
#endif
}

}  // namespace

AlignedDoubles::AlignedDoubles(std::size_t count) : size_(count) {
  const std::size_t wanted = std::max<std::size_t>(count, 1) * sizeof(double);
  const std::size_t unit = wanted < kLargePage ? kCacheLine : kLargePage;
  const std::size_t bytes = (wanted + unit - 1) / unit * unit;
  data_.reset(static_cast<double*>(std::aligned_alloc(unit, bytes)));
  if (data_ == nullptr) throw std::bad_alloc();
  if (unit == kLargePage) askForLargePages(data_.get(), bytes);
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
