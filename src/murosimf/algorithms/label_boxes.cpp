#include "murosimf/algorithms/label_boxes.h"

#include <algorithm>
#include <cstring>

namespace murosimf {
namespace {

constexpr int kStride = 16;  ///< pixels that are compared at a time

/// First pixel from `begin` on that shows another label.
int endOfRun(const std::uint16_t* row, int begin, int width) {
  const std::uint16_t label = row[begin];
  int end = begin + 1;
  for (; end + kStride <= width; end += kStride) {
    unsigned other = 0;
    for (int i = 0; i < kStride; ++i) other |= static_cast<unsigned>(row[end + i] ^ label);
    if (other != 0) break;
  }
  while (end < width && row[end] == label) ++end;
  return end;
}

void include(std::uint16_t label, int v, int begin, int end, std::vector<LabelBox>& boxes) {
  auto at = std::lower_bound(boxes.begin(), boxes.end(), label,
                             [](const LabelBox& box, std::uint16_t wanted) { return box.label < wanted; });
  if (at == boxes.end() || at->label != label) at = boxes.insert(at, {label, begin, v, end - 1, v, 0});
  at->u_low = std::min(at->u_low, begin), at->u_high = std::max(at->u_high, end - 1);
  at->v_high = v;
  at->pixels += end - begin;
}

}  // namespace

void findBoxes(Picture& picture) {
  picture.boxes.clear();
  for (int v = 0; v < picture.height; ++v) {
    const std::uint16_t* row = picture.label.data() + picture.index(0, v);
    for (int u = 0; u < picture.width;) {
      const int end = endOfRun(row, u, picture.width);
      const bool thing = row[u] != kGroundLabel && row[u] < kLineLabel;
      if (thing) include(row[u], v, u, end, picture.boxes);
      u = end;
    }
  }
}

}  // namespace murosimf
