#include "book/page.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace murosimf::book {
namespace {

using Json = nlohmann::ordered_json;

const char* titleOf(Chapter chapter) {
  switch (chapter) {
    case Chapter::kRestAndImpact:
      return "Rest and impact";
    case Chapter::kFriction:
      return "Friction";
    case Chapter::kRolling:
      return "Rolling";
    case Chapter::kCollisions:
      return "Collisions";
    case Chapter::kMechanisms:
      return "Mechanisms";
    case Chapter::kFlight:
      return "Free flight";
    case Chapter::kOnTheGround:
      return "Robots on the ground";
    case Chapter::kIntegrators:
      return "Integrators";
    case Chapter::kServos:
      return "Servos and joints";
    case Chapter::kSensors:
      return "Sensors";
    case Chapter::kLenses:
      return "Lenses";
    case Chapter::kPictures:
      return "Pictures";
    case Chapter::kRobots:
      return "Robots and walking";
    case Chapter::kNumbers:
      return "Numbers";
  }
  throw std::logic_error("a chapter without a title");
}

/// Of Ways/Suite.Name/variant: the test as it is written in its file, and the variant ("" for a plain TEST).
struct Names {
  std::string test, variant;
};
Names namesOf(const testing::TestInfo& info) {
  std::string suite = info.test_suite_name(), name = info.name(), variant;
  if (info.value_param() != nullptr) {
    suite.erase(0, suite.find('/') + 1);
    variant = name.substr(name.find('/') + 1);
    name.erase(name.find('/'));
  }
  return {suite + "." + name, variant};
}

Json axis(const Axis& a) { return {{"name", a.name}, {"unit", a.unit}, {"logarithmic", a.logarithmic}}; }

const testing::TestInfo& currentTest() {
  const testing::TestInfo* info = testing::UnitTest::GetInstance()->current_test_info();
  if (info == nullptr) throw std::logic_error("a page of the book belongs into a test's body");
  return *info;
}

std::string pathFromRoot(const std::string& file) {
  const std::size_t at = file.rfind("tests/");
  return at == std::string::npos ? file : file.substr(at);
}

}  // namespace

Page::Page(Head head) : head_(std::move(head)) {
  const char* folder = std::getenv("MUROSIMF_BOOK");
  if (folder != nullptr) folder_ = folder;
  static_cast<void>(currentTest());
}

Page::~Page() {
  if (folder_.empty()) return;
  try {
    write();
  } catch (const std::exception& error) {
    ADD_FAILURE() << "the page of the book was not written: " << error.what();
  }
}

Page& Page::series(const std::string& name) {
  name_ = name;
  return *this;
}

Page& Page::series(const std::string& name, double number) {
  std::ostringstream text;
  text << name << " " << number;
  return series(text.str());
}

Page::Series& Page::current(bool bounded) {
  const auto found = std::find_if(series_.begin(), series_.end(),
                                  [&](const Series& s) { return s.name == name_ && s.bounded == bounded; });
  if (found != series_.end()) return *found;
  series_.push_back({name_, bounded, {}, {}, {}, {}, {}, {}});
  return series_.back();
}

testing::AssertionResult Page::near(double x, double found, double theory, double tolerance) {
  if (!folder_.empty()) {
    Series& s = current(false);
    s.x.push_back(x), s.found.push_back(found), s.theory.push_back(theory), s.tolerance.push_back(tolerance);
  }
  const double deviation = std::fabs(found - theory);
  if (deviation <= tolerance) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "at " << x << ": found " << found << ", theory says " << theory
                                     << ", they differ by " << deviation << " where " << tolerance << " is allowed";
}

testing::AssertionResult Page::below(double x, double found, double bound) {
  if (!folder_.empty()) {
    Series& s = current(true);
    s.x.push_back(x), s.found.push_back(std::fabs(found)), s.theory.push_back(0), s.tolerance.push_back(bound);
  }
  if (std::fabs(found) <= bound) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "at " << x << ": found " << found << " where " << bound << " is allowed";
}

void Page::curve(double low, double high, const std::function<double(double)>& theory) {
  if (folder_.empty()) return;
  Series& s = current(false);
  s.curve_x.clear(), s.curve_y.clear();
  constexpr int kValues = 200;
  for (int i = 0; i < kValues; ++i) {
    const double share = i / (kValues - 1.0);
    const double x = head_.x.logarithmic ? low * std::pow(high / low, share) : low + (high - low) * share;
    s.curve_x.push_back(x), s.curve_y.push_back(theory(x));
  }
}

void Page::write() const {
  const testing::TestInfo& info = currentTest();
  const auto [test, variant] = namesOf(info);
  Json page{{"test", test},
            {"variant", variant},
            {"file", pathFromRoot(info.file())},
            {"line", info.line()},
            {"chapter", titleOf(head_.chapter)},
            {"chapter_number", static_cast<int>(head_.chapter) + 1},
            {"claim", head_.claim},
            {"formula", head_.formula},
            {"source", head_.source},
            {"symbols", Json::array()},
            {"x", axis(head_.x)},
            {"y", axis(head_.y)},
            {"passed", !testing::Test::HasFailure() && std::uncaught_exceptions() == 0},
            {"series", Json::array()}};
  for (const Symbol& s : head_.symbols)
    page["symbols"].push_back({{"symbol", s.symbol}, {"meaning", s.meaning}, {"unit", s.unit}});
  double deviation = 0, tolerance = 0, share = -1;
  for (const Series& s : series_) {
    page["series"].push_back({{"name", s.name},
                              {"bounded", s.bounded},
                              {"x", s.x},
                              {"found", s.found},
                              {"theory", s.theory},
                              {"tolerance", s.tolerance},
                              {"curve_x", s.curve_x},
                              {"curve_y", s.curve_y}});
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      const double d = std::fabs(s.found[i] - s.theory[i]), part = d == 0 ? 0 : d / s.tolerance[i];
      if (!std::isnan(share) && !(part <= share)) deviation = d, tolerance = s.tolerance[i], share = part;
    }
  }
  page["largest"] = {{"deviation", deviation}, {"tolerance", tolerance}, {"share", std::max(share, 0.0)}};
  std::filesystem::create_directories(folder_);
  const std::filesystem::path path =
      std::filesystem::path(folder_) / (test + (variant.empty() ? "" : "." + variant) + ".json");
  std::ofstream file(path);
  file << page.dump(1) << "\n";
  if (!file.flush()) throw std::runtime_error("cannot write " + path.string());
}

}  // namespace murosimf::book
