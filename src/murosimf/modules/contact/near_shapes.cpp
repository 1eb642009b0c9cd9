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

std::span<NearShapes::Pair> NearShapes::between(int a, int b, const PlacedShapes& of_a, const PlacedShapes& of_b) {
  const List* last = lastOf(a, b);
  List list{a, b, 0, now_.pairs.size(), 0};
  if (last != nullptr && of_a.longestTravel().now + of_b.longestTravel().now < last->until) {
    const auto first = last_.pairs.begin() + static_cast<std::ptrdiff_t>(last->first);
    now_.pairs.insert(now_.pairs.end(), first, first + static_cast<std::ptrdiff_t>(last->count));
    list.until = last->until;
  } else {
    list.until = listAnew(of_a, of_b);
  }
  list.count = now_.pairs.size() - list.first;
  now_.lists.push_back(list);
  return std::span(now_.pairs).subspan(list.first);
}

/// @return the sum of longest travels up to which the list is right
double NearShapes::listAnew(const PlacedShapes& of_a, const PlacedShapes& of_b) {
  for (std::size_t i = 0; i < of_a.count(); ++i) {
    const double reach = of_a.reach(i) + kMargin;
    BoundingBox box;
    box.hold(of_a.centre(i), reach);
    if (!box.overlaps(of_b.box())) continue;
    of_b.forNear(of_a.centre(i), reach, [&](std::size_t j) {
      Pair& pair = now_.pairs.emplace_back();
      pair.i = static_cast<int>(i), pair.j = static_cast<int>(j);
      const double apart = norm(of_a.centre(i) - of_b.centre(j)) - of_a.reach(i) - of_b.reach(j);
      pair.note(max(apart, 0.0), of_a, of_b);
    });
  }
  return of_a.longestTravel().before + of_b.longestTravel().before + kMargin - kSlack;
}

}  // namespace murosimf
