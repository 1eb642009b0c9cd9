#include "murosimf/soccer/label_blob.h"

#include <cmath>
#include <cstring>

#include "murosimf/math/elementary.h"

namespace murosimf {

namespace {

constexpr std::uint64_t kOnes = 0x0001000100010001U, kTops = 0x8000800080008000U;
constexpr std::size_t kStretch = 16;  // labels looked at before asking whether one matched

struct Sums {
  long pixels = 0, u = 0, v = 0;
};

/// Bits that are set when one of four labels is the one wanted (then its word of the difference is zero); which one is
/// not told: a borrow may mark its upper neighbour as well.
std::uint64_t matches(const std::uint16_t* labels, std::uint64_t wanted) {
  std::uint64_t four;
  std::memcpy(&four, labels, sizeof(four));
  const std::uint64_t difference = four ^ wanted;
  return (difference - kOnes) & ~difference & kTops;
}

void addPixels(const Picture& picture, std::size_t from, std::size_t to, std::uint16_t label, Sums& sums) {
  for (std::size_t i = from; i < to; ++i) {
    if (picture.label[i] != label) continue;
    const auto width = static_cast<std::size_t>(picture.width);
    ++sums.pixels;
    sums.u += static_cast<long>(i % width);
    sums.v += static_cast<long>(i / width);
  }
}

}  // namespace

double LabelBlob::radius() const { return sqrt(static_cast<double>(pixels) / kPi); }

LabelBlob findLabel(const Picture& picture, std::uint16_t label) {
  Sums sums;
  const std::uint64_t wanted = kOnes * label;
  const std::size_t count = picture.label.size(), whole = count - count % kStretch;
  const std::uint16_t* labels = picture.label.data();
  for (std::size_t i = 0; i < whole; i += kStretch) {
    const std::uint64_t any = matches(labels + i, wanted) | matches(labels + i + 4, wanted) |
                              matches(labels + i + 8, wanted) | matches(labels + i + 12, wanted);
    if (any != 0) addPixels(picture, i, i + kStretch, label, sums);
  }
  addPixels(picture, whole, count, label, sums);
  if (sums.pixels == 0) return {};
  const auto n = static_cast<double>(sums.pixels);
  return {sums.pixels, static_cast<double>(sums.u) / n, static_cast<double>(sums.v) / n};
}

}  // namespace murosimf
