#include "murosimf/scene/motion_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

namespace murosimf {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

/// "NAME" or "NAME@SECONDS".
struct Entry {
  std::string motion;
  std::optional<double> time;
  bool good = true;
};

Entry readEntry(std::string_view text) {
  const std::size_t at = text.find('@');
  Entry entry{std::string(trimmed(text.substr(0, at))), {}, true};
  entry.good = !entry.motion.empty();
  if (at == text.npos) return entry;
  const std::string_view number = trimmed(text.substr(at + 1));
  double seconds = 0;
  const auto [end, problem] = std::from_chars(number.data(), number.data() + number.size(), seconds);
  entry.good =
      entry.good && problem == std::errc{} && end == number.data() + number.size() && seconds >= 0 && seconds <= 1e7;
  entry.time = seconds;
  return entry;
}

}  // namespace

int MotionPlan::levelWith(const std::string& motion) {
  const auto found = std::find(motions.begin(), motions.end(), motion);
  if (found != motions.end()) return static_cast<int>(found - motions.begin());
  motions.push_back(motion);
  return static_cast<int>(motions.size()) - 1;
}

MotionPlan readMotionPlan(const Located<std::string>& text, const std::string& usual, const std::string& robot,
                          Diagnostics& diagnostics) {
  MotionPlan plan;
  const auto refuse = [&](std::string_view found) {
    diagnostics.error(text.where,
                      fmt::format("{}: motion \"{}\": \"{}\" stands wrong there, expected a motion, then others "
                                  "with rising times in seconds, as in \"kinematic_walking, "
                                  "multibody_dynamics@12.5\"",
                                  robot, *text, trimmed(found)));
  };
  std::string_view rest = *text;
  double last = -1;
  for (bool first = true; first || !rest.empty(); first = false) {
    const std::string_view part = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
    if (first && trimmed(part).empty()) continue;
    const Entry entry = readEntry(part);
    if (!entry.good || (!entry.time && !first) || (entry.time && *entry.time <= last)) {
      refuse(part);
      break;
    }
    if (plan.motions.empty()) plan.motions.push_back(entry.time ? usual : entry.motion);
    if (!entry.time) continue;
    last = *entry.time;
    plan.changes.push_back({last, plan.levelWith(entry.motion)});
  }
  if (plan.motions.empty()) plan.motions.push_back(usual);
  return plan;
}

}  // namespace murosimf
