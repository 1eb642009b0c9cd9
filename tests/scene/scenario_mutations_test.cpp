// Whatever bytes a file holds, reading it ends with a scene or with an error that has a place.
#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "scene/scenario_for_test.h"

namespace murosimf::test {
namespace {

std::string contentsOf(const std::filesystem::path& file) {
  std::ostringstream stream;
  stream << std::ifstream(file, std::ios::binary).rdbuf();
  return stream.str();
}

/// Small changes of the kind that people and broken disks make.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string mutate(std::string text) {
    const std::size_t changes = 1 + below(4);
    for (std::size_t i = 0; i < changes; ++i) change(text);
    return text;
  }

 private:
  std::size_t below(std::size_t limit) { return limit == 0 ? 0 : random_() % limit; }

  void change(std::string& text) {
    static const std::string kPieces[] = {"=",          "[",       "]",   "{",     "}",    "\"", ".",
                                          "\n",         "-",       "nan", "1e999", "'''",  "#",  "9223372036854775808",
                                          "1979-05-27", "\\u0000", ",",   "[[",    "true", "0x"};
    const std::size_t at = below(text.size() + 1);
    switch (below(6)) {
      case 0:
        text.erase(at, 1 + below(3));
        break;
      case 1:
        text.insert(at, 1, static_cast<char>(below(256)));
        break;
      case 2:
        text.insert(at, kPieces[below(std::size(kPieces))]);
        break;
      case 3:
        text.erase(at, below(200));
        break;
      case 4:
        text.insert(at, text.substr(below(text.size() + 1), below(80)));
        break;
      default:
        swapLines(text);
        break;
    }
  }

  void swapLines(std::string& text) {
    const std::size_t first = text.find('\n', below(text.size() + 1));
    if (first == text.npos) return;
    const std::size_t second = text.find('\n', first + 1);
    if (second == text.npos) return;
    const std::string line = text.substr(first, second - first);
    text.erase(first, second - first);
    text.insert(below(text.size() + 1), line);
  }

  std::mt19937 random_;
};

void readAnything(const std::string& text, const std::vector<std::string>& overrides) {
  Diagnostics diagnostics;
  const std::optional<Scene> scene = readScenarioText(text, kPlace, overrides, diagnostics);
  EXPECT_EQ(scene.has_value(), !diagnostics.hasErrors());
  for (const Diagnostic& d : diagnostics.all()) {
    EXPECT_TRUE(d.where.line > 0 || startsWith(d.where.file, "--set ")) << d.message << "\n" << text;
    EXPECT_EQ(d.message.find('\n'), std::string::npos);
  }
  if (!scene || !diagnostics.all().empty()) return;
  EXPECT_EQ(writeScenario(readGood(writeScenario(*scene))), writeScenario(*scene)) << text;
}

TEST(ScenarioMutations, NeverCrashAndAlwaysNameAPlace) {
  const std::string game = contentsOf(kRoot / "scenarios/game_3v3.toml");
  ASSERT_FALSE(game.empty());
  for (unsigned seed = 0; seed < 600; ++seed) readAnything(Mutator(seed).mutate(game), {});
}

TEST(ScenarioMutations, ShortTextsOfEverySort) {
  const std::string seedling = kTwoRobots +
                               "control = {program = \"player\", a = [1, {deg = 2}]}\nproperties.trunk.mass = 1\n"
                               "cameras.head = {noise = 1}\nmodules.wind = {}\n[surfaces.ball-turf]\nlaw = \"paper\"\n";
  for (unsigned seed = 0; seed < 3000; ++seed) readAnything(Mutator(seed).mutate(seedling), {});
}

TEST(ScenarioMutations, OverridesOfEverySort) {
  for (unsigned seed = 0; seed < 3000; ++seed)
    readAnything(kTwoRobots, {Mutator(seed).mutate("robots.red.1.motion={module=\"walk\", period=0.02}")});
}

TEST(ScenarioMutations, ALongChainOfDotsIsAnErrorAndNoOverflow) {
  std::string path = "a";
  for (int i = 0; i < 3000; ++i) path += ".a";
  EXPECT_FALSE(complaints("[" + path + "]\n").empty());
  EXPECT_FALSE(complaints("", {path + "=1"}).empty());
}

}  // namespace
}  // namespace murosimf::test
