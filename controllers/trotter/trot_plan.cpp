#include "trot_plan.h"

#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace murosimf::controllers::trotter {

namespace {

[[noreturn]] void refuse(std::string_view order) {
  throw std::invalid_argument("trotter: the role has '" + std::string(order) +
                              "', expected three numbers [m/s, m/s, rad/s] and perhaps @ and a time [s], as in "
                              "'0.4 0 0, 0.3 0 0.5@8'");
}

void skipBlanks(std::string_view& rest) {
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
}

/// Takes a number from the front of `rest`.
double takeNumber(std::string_view& rest, std::string_view order) {
  skipBlanks(rest);
  double number = 0;
  const auto [end, fault] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (fault != std::errc{} || !std::isfinite(number)) refuse(order);
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return number;
}

TrotOrder readOrder(std::string_view order, bool first) {
  std::string_view rest = order;
  TrotOrder read;
  read.command.vx = takeNumber(rest, order);
  read.command.vy = takeNumber(rest, order);
  read.command.omega = takeNumber(rest, order);
  skipBlanks(rest);
  if (rest.empty() && first) return read;
  if (rest.empty() || rest.front() != '@') refuse(order);
  rest.remove_prefix(1);
  read.time = takeNumber(rest, order);
  skipBlanks(rest);
  if (!rest.empty()) refuse(order);
  return read;
}

}  // namespace

std::vector<TrotOrder> readTrotPlan(std::string_view text) {
  std::vector<TrotOrder> plan;
  skipBlanks(text);
  while (!text.empty()) {
    const std::size_t comma = text.find(',');
    const std::string_view order = text.substr(0, comma);
    plan.push_back(readOrder(order, plan.empty()));
    if (plan.size() > 1 && !(plan.back().time > plan[plan.size() - 2].time))
      throw std::invalid_argument("trotter: the role has '" + std::string(order) + "', expected times that rise");
    if (comma == std::string_view::npos) break;
    text.remove_prefix(comma + 1);
    if (text.empty()) refuse(text);
  }
  return plan;
}

TrotCommand orderAt(const std::vector<TrotOrder>& plan, double time) {
  TrotCommand holds;
  for (const TrotOrder& order : plan) {
    if (order.time <= time) holds = order.command;
  }
  return holds;
}

}  // namespace murosimf::controllers::trotter
