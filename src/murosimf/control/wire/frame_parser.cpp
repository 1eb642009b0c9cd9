#include "murosimf/control/wire/frame_parser.h"

namespace murosimf {

void FrameParser::reset() {
  announced_ = header_bytes_ = 0;
  whole_ = lost_ = false;
  frame_.clear();
}

bool FrameParser::takeHeader(std::span<const std::uint8_t>& bytes) {
  while (header_bytes_ < kHeader && !bytes.empty()) {
    announced_ = (announced_ << 8) | bytes.front();
    bytes = bytes.subspan(1);
    ++header_bytes_;
  }
  if (header_bytes_ < kHeader) return false;
  lost_ = announced_ > largest_;
  return !lost_;
}

bool FrameParser::take(std::span<const std::uint8_t>& bytes) {
  if (lost_) {
    bytes = {};
    return false;
  }
  if (whole_) reset();
  if (header_bytes_ < kHeader && !takeHeader(bytes)) return false;
  const std::size_t wanted = std::min(announced_ - frame_.size(), bytes.size());
  frame_.insert(frame_.end(), bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(wanted));
  bytes = bytes.subspan(wanted);
  whole_ = frame_.size() == announced_;
  return whole_;
}

}  // namespace murosimf
