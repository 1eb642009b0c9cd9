#include "murosimf/control/wire/delay_budget.h"

#include <algorithm>

namespace murosimf {

double DelayBudget::allowance(double now) {
  if (lost_) return 0;
  while (!charges_.empty() && charges_.front().first <= now - limits_.window) charges_.pop_front();
  double spent = 0;
  for (const auto& [when, seconds] : charges_) spent += seconds;
  return limits_.patience + std::max(0.0, limits_.budget - spent);
}

void DelayBudget::charge(double now, double waited) {
  if (waited > limits_.patience) charges_.emplace_back(now, waited - limits_.patience);
}

void DelayBudget::answered(double now, double waited) {
  charge(now, waited);
  lost_ = false;
}

void DelayBudget::missed(double now, double waited) {
  charge(now, waited);
  ++misses_;
  lost_ = true;
}

}  // namespace murosimf
