#include "murosimf/algorithms/mesh_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace murosimf {
namespace {

constexpr int kBins = 12;
constexpr int kDeepest = 40;  ///< below this, sets are halved: a tree of 8 * 2^20 boxes has no more than 57 levels

float areaOf(const MeshBox& box) {
  const float x = box.high[0] - box.low[0], y = box.high[1] - box.low[1], z = box.high[2] - box.low[2];
  return x < 0 ? 0.0F : x * y + y * z + z * x;
}

/// A part of the builder's list of boxes.
struct Part {
  int begin, end;
  MeshBox box;
  int count() const { return end - begin; }
};

class Builder {
 public:
  explicit Builder(std::span<const MeshBox> boxes) : boxes_(boxes), order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0);
  }
  MeshTree build() {
    addNode(part(0, static_cast<int>(order_.size())), 0);
    return std::move(tree_);
  }

 private:
  const MeshBox& box(int place) const {
    return boxes_[static_cast<std::size_t>(order_[static_cast<std::size_t>(place)])];
  }
  float middle(int number, int axis) const {
    const MeshBox& b = boxes_[static_cast<std::size_t>(number)];
    const auto a = static_cast<std::size_t>(axis);
    return 0.5F * (b.low[a] + b.high[a]);
  }
  Part part(int begin, int end) const {
    Part out{begin, end, emptyBox()};
    for (int i = begin; i < end; ++i) include(box(i), out.box);
    return out;
  }

  int addNode(const Part& whole, int depth) {
    const auto number = tree_.nodes.size();
    tree_.nodes.emplace_back();
    std::vector<Part> parts{whole};
    while (parts.size() < kMeshWidth) {
      const auto next = std::max_element(parts.begin(), parts.end(),
                                         [](const Part& a, const Part& b) { return weight(a) < weight(b); });
      if (next->count() <= kMeshWidth) break;
      const int cut = split(*next, depth > kDeepest);
      const Part first = part(next->begin, cut), second = part(cut, next->end);
      *next = first;
      parts.push_back(second);
    }
    for (std::size_t k = 0; k < kMeshWidth; ++k) {
      const bool used = k < parts.size();
      const MeshBox box = used ? parts[k].box : emptyBox();
      const int child = used ? addChild(parts[k], depth) : 0;
      CastMeshNode& node = tree_.nodes[number];
      for (std::size_t axis = 0; axis < 3; ++axis)
        node.low[axis][k] = box.low[axis], node.high[axis][k] = box.high[axis];
      node.child[k] = child;
    }
    return static_cast<int>(number);
  }
  int addChild(const Part& part, int depth) {
    if (part.count() > kMeshWidth) return addNode(part, depth + 1);
    tree_.groups.emplace_back(order_.begin() + part.begin, order_.begin() + part.end);
    return ~static_cast<int>(tree_.groups.size() - 1);
  }
  /// What is split first: large surfaces of many; small groups last, even those without area.
  static float weight(const Part& part) {
    return part.count() <= kMeshWidth ? -1.0F : areaOf(part.box) * static_cast<float>(part.count());
  }

  /// Sorts a part into two; @returns where the second begins.
  int split(const Part& part, bool halve) {
    MeshBox middles = emptyBox();
    for (int i = part.begin; i < part.end; ++i) {
      std::array<float, 3> m{};
      for (int axis = 0; axis < 3; ++axis)
        m[static_cast<std::size_t>(axis)] = middle(order_[static_cast<std::size_t>(i)], axis);
      include({m, m}, middles);
    }
    const auto begin = order_.begin() + part.begin, end = order_.begin() + part.end;
    if (!halve) {
      const Cut cut = bestCut(part, middles);
      if (cut.axis >= 0) {
        const auto second =
            std::partition(begin, end, [&](int number) { return binOf(number, cut.axis, middles) < cut.bin; });
        return static_cast<int>(second - order_.begin());
      }
    }
    int axis = 0;
    for (int k = 1; k < 3; ++k) {
      const auto a = static_cast<std::size_t>(axis), b = static_cast<std::size_t>(k);
      if (middles.high[b] - middles.low[b] > middles.high[a] - middles.low[a]) axis = k;
    }
    const auto half = begin + (end - begin) / 2;
    std::nth_element(begin, half, end, [&](int a, int b) {
      return middle(a, axis) != middle(b, axis) ? middle(a, axis) < middle(b, axis) : a < b;
    });
    return static_cast<int>(half - order_.begin());
  }

  struct Cut {
    int axis = -1, bin = 0;
  };
  int binOf(int number, int axis, const MeshBox& middles) const {
    const auto a = static_cast<std::size_t>(axis);
    const float share = (middle(number, axis) - middles.low[a]) / (middles.high[a] - middles.low[a]);
    return std::clamp(static_cast<int>(share * kBins), 0, kBins - 1);
  }
  /// Least sum of area times count of the two sides; none where all middles are one.
  Cut bestCut(const Part& part, const MeshBox& middles) const {
    Cut best;
    float least = std::numeric_limits<float>::max();
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      if (!(middles.high[a] - middles.low[a] > 1e-12F)) continue;
      Part bins[kBins];
      for (Part& bin : bins) bin = {0, 0, emptyBox()};
      for (int i = part.begin; i < part.end; ++i) {
        Part& bin = bins[binOf(order_[static_cast<std::size_t>(i)], axis, middles)];
        include(box(i), bin.box), ++bin.end;
      }
      float right_cost[kBins];
      Part right{0, 0, emptyBox()};
      for (int k = kBins - 1; k > 0; --k) {
        include(bins[k].box, right.box), right.end += bins[k].end;
        right_cost[k] = areaOf(right.box) * static_cast<float>(right.end);
      }
      Part left{0, 0, emptyBox()};
      for (int k = 1; k < kBins; ++k) {
        include(bins[k - 1].box, left.box), left.end += bins[k - 1].end;
        if (left.end == 0 || left.end == part.count()) continue;
        const float cost = areaOf(left.box) * static_cast<float>(left.end) + right_cost[k];
        if (cost < least) least = cost, best = {axis, k};
      }
    }
    return best;
  }

  std::span<const MeshBox> boxes_;
  std::vector<int> order_;
  MeshTree tree_;
};

}  // namespace

MeshBox emptyBox() {
  constexpr float kHuge = std::numeric_limits<float>::max();
  return {{kHuge, kHuge, kHuge}, {-kHuge, -kHuge, -kHuge}};
}

void include(const MeshBox& other, MeshBox& box) {
  for (std::size_t i = 0; i < 3; ++i) {
    box.low[i] = std::min(box.low[i], other.low[i]);
    box.high[i] = std::max(box.high[i], other.high[i]);
  }
}

MeshTree buildMeshTree(std::span<const MeshBox> boxes) { return Builder(boxes).build(); }

}  // namespace murosimf
