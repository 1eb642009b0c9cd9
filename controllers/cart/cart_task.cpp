#include "cart_task.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "murosimf/math/elementary.h"

namespace murosimf::controllers::cart {

namespace {

constexpr double kReached = 0.003, kTurned = 0.004;  // [m], [rad]
constexpr double kGain = 5, kTurnGain = 6;           // [1/s]
constexpr double kSlowest = 0.02, kSlowestTurn = 0.05, kFastestTurn = 1.8;
constexpr double kDeceleration = 0.5, kTurnDeceleration = 3;  // before corners [m/s^2, rad/s^2]

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  while (!text.empty()) {
    const std::size_t begin = text.find_first_not_of(' ');
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    words.push_back(text.substr(0, text.find(' ')));
    text.remove_prefix(words.back().size());
  }
  return words;
}

double numberAt(const std::vector<std::string_view>& words, std::size_t i, double largest) {
  double value = 0;
  const std::string_view word = words[i];
  const auto [end, problem] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (problem == std::errc{} && end == word.data() + word.size() && std::fabs(value) <= largest) return value;
  throw std::invalid_argument("cart: role has \"" + std::string(word) + "\", expected a number of at most " +
                              std::to_string(static_cast<int>(largest)) + " behind \"" + std::string(words[0]) + "\"");
}

void requireCount(const std::vector<std::string_view>& words, std::size_t least, std::size_t most, const char* form) {
  if (words.size() >= least && words.size() <= most) return;
  throw std::invalid_argument("cart: role has " + std::to_string(words.size() - 1) + " numbers behind \"" +
                              std::string(words[0]) + "\", expected " + form);
}

/// As fast as it can still stop within a way.
double speedFor(double way, double fastest, double deceleration, double gain, double slowest) {
  const double size = std::fabs(way);
  const double speed = std::min({fastest, std::sqrt(2 * deceleration * size), gain * size + slowest});
  return std::copysign(speed, way);
}

}  // namespace

double wrapped(double angle) { return angle - 2 * kPi * std::round(angle / (2 * kPi)); }

CartPlan readCartPlan(std::string_view role) {
  CartPlan plan;
  const std::vector<std::string_view> words = wordsOf(role);
  if (words.empty()) return plan;
  if (words[0] == "rest") plan.task = CartTask::kRest;
  if (words[0] == "square") {
    requireCount(words, 1, 3, "edge [m] and speed [m/s]");
    plan.task = CartTask::kSquare;
    if (words.size() > 1) plan.edge = numberAt(words, 1, 100);
    if (words.size() > 2) plan.speed = numberAt(words, 2, 10);
    if (!(plan.edge > 0.05 && plan.speed > 0.02))
      throw std::invalid_argument("cart: role \"" + std::string(role) +
                                  "\", expected an edge above 0.05 m and a speed above 0.02 m/s");
  }
  if (words[0] == "drive") {
    requireCount(words, 4, 4, "three: forward and to the left [m/s], turning [rad/s]");
    plan.task = CartTask::kDrive;
    plan.velocity = {numberAt(words, 1, 10), numberAt(words, 2, 10), numberAt(words, 3, 50)};
  }
  return plan;
}

void Place::advance(const BaseMotion& way) {
  const double half = 0.5 * way.turn;
  const double chord = std::fabs(half) > 1e-9 ? sin(half) / half : 1.0;
  const SinCos<double> a = sincos(heading + half);
  x += chord * (a.cos * way.x - a.sin * way.y);
  y += chord * (a.sin * way.x + a.cos * way.y);
  heading += way.turn;
}

SquareDriver::SquareDriver(double edge, double speed, bool omnidirectional)
    : edge_(edge), speed_(speed), omnidirectional_(omnidirectional) {}

BaseMotion SquareDriver::velocityAt(const Place& place) {
  constexpr int kX[] = {0, 1, 1, 0, 0}, kY[] = {0, 0, 1, 1, 0};
  if (done()) return {};
  if (turning_) {
    const double left = corner_ * kPi / 2 - place.heading;  // headings go on beyond pi
    if (std::fabs(left) > kTurned)
      return {0, 0, speedFor(left, kFastestTurn, kTurnDeceleration, kTurnGain, kSlowestTurn)};
    turning_ = false;
    if (done()) return {};
  }
  const int next = corner_ + 1;
  const double x = edge_ * kX[next], y = edge_ * kY[next];
  const double along = (x - place.x) * (kX[next] - kX[corner_]) + (y - place.y) * (kY[next] - kY[corner_]);
  if (along < kReached) {
    corner_ = next;
    turning_ = !omnidirectional_;
    return {};
  }
  return towards(place, x, y, omnidirectional_ ? 0 : corner_ * kPi / 2);
}

/// Along the edge, back onto it where the robot is beside it.
BaseMotion SquareDriver::towards(const Place& place, double x, double y, double heading) const {
  const SinCos<double> a = sincos(place.heading);
  const double dx = x - place.x, dy = y - place.y;
  const double ahead = a.cos * dx + a.sin * dy, left = a.cos * dy - a.sin * dx;
  const double off = heading - place.heading;
  if (!omnidirectional_) {
    // Beside the line by `beside` [m] it aims back at it.
    const SinCos<double> line = sincos(heading);
    const double beside = line.cos * dy - line.sin * dx;
    return {speedFor(ahead, speed_, kDeceleration, kGain, kSlowest), 0, kTurnGain * (off + 4 * beside)};
  }
  const double way = std::sqrt(ahead * ahead + left * left);
  const double speed = speedFor(way, speed_, kDeceleration, kGain, kSlowest);
  return {speed * ahead / way, speed * left / way, kTurnGain * off};
}

}  // namespace murosimf::controllers::cart
