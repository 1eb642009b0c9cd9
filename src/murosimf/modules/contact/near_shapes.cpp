#include "murosimf/modules/contact/near_shapes.h"

#include <utility>

namespace murosimf {

void NearShapes::reserve(std::size_t robots) {
  constexpr std::size_t kNeighbours = 8, kPairs = 32;
  for (Lists* lists : {&now_, &last_}) {
    lists->lists.reserve(robots * kNeighbours);
    lists->pairs.reserve(robots * kPairs);
  }
}

void NearShapes::beginFrame() {
  std::swap(now_, last_);
  now_.lists.clear(), now_.pairs.clear();
  next_ = 0;
}

const NearShapes::List* NearShapes::lastOf(int a, int b) {
  const auto isBefore = [&](const List& list) { return std::pair(list.a, list.b) < std::pair(a, b); };
  while (next_ < last_.lists.size() && isBefore(last_.lists[next_])) ++next_;
  const bool known = next_ < last_.lists.size() && last_.lists[next_].a == a && last_.lists[next_].b == b;
  return known ? &last_.lists[next_] : nullptr;
}

bool NearShapes::keep(int a, int b, const ShapeTravel& travel_a, const ShapeTravel& travel_b) {
  const List* last = lastOf(a, b);
  if (last == nullptr || !(travel_a.longest().now + travel_b.longest().now < last->until)) return false;
  List list = *last;
  list.first = now_.pairs.size();
  const auto first = last_.pairs.begin() + static_cast<std::ptrdiff_t>(last->first);
  now_.pairs.insert(now_.pairs.end(), first, first + static_cast<std::ptrdiff_t>(last->count));
  now_.lists.push_back(list);
  return true;
}

void NearShapes::list(int a, int b, const Robot& of_a, const Robot& of_b) {
  List list{a, b, 0, now_.pairs.size(), 0};
  const double apart = of_a.placed.box().distance(of_b.placed.box());
  if (apart < kMargin) listNear(of_a, of_b);
  list.until = of_a.travel.longest().before + of_b.travel.longest().before + max(apart, kMargin) - kSlack;
  list.count = now_.pairs.size() - list.first;
  now_.lists.push_back(list);
}

void NearShapes::listNear(const Robot& of_a, const Robot& of_b) {
  const PlacedShapes &a = of_a.placed, &b = of_b.placed;
  for (std::size_t i = 0; i < a.count(); ++i) {
    const double reach = a.reach(i) + kMargin;
    BoundingBox box;
    box.hold(a.centre(i), reach);
    if (!box.overlaps(b.box())) continue;
    b.forNear(a.centre(i), reach, [&](std::size_t j) {
      Pair& pair = now_.pairs.emplace_back();
      pair.i = static_cast<int>(i), pair.j = static_cast<int>(j);
      const double apart = norm(a.centre(i) - b.centre(j)) - a.reach(i) - b.reach(j);
      pair.note(max(apart, 0.0), of_a.travel, of_b.travel);
    });
  }
}

}  // namespace murosimf
