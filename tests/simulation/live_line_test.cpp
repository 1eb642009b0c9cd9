#include "murosimf/simulation/live_line.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

namespace murosimf {
namespace {

/// A line written into a file, and what stands there.
struct Paper {
  std::FILE* file = std::tmpfile();
  LiveLine::Settings settings;
  StageClock stages;
  Paper() { settings.out = file; }
  ~Paper() { std::fclose(file); }
  std::string read() const {
    std::string text(static_cast<std::size_t>(std::ftell(file)), '\0');
    std::rewind(file);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
    return text;
  }
};

TEST(LiveLine, OnATerminalIsRewrittenFiveTimesASecond) {
  Paper paper;
  LiveLine line(paper.settings, true);
  for (int i = 0; i <= 2010; ++i) line.update(0.004 * i, 0.001 * i, paper.stages, "red 1 : 0 blue");  // 4 x
  line.finish();
  const std::string text = paper.read();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 10);
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
  EXPECT_EQ(text.back(), '\n');
  EXPECT_NE(text.find("1.6 s     4.0 x real time  red 1 : 0 blue"), std::string::npos) << text;
}

TEST(LiveLine, ElsewhereIsALineEveryTenSimulatedSeconds) {
  Paper paper;
  LiveLine line(paper.settings);  // a file is no terminal
  for (int i = 0; i <= 35000; ++i) line.update(0.001 * i, 0.0005 * i, paper.stages, "");
  line.finish();
  const std::string text = paper.read();
  EXPECT_EQ(std::count(text.begin(), text.end(), '\r'), 0);
  EXPECT_EQ(text, "    10.0 s     2.0 x real time\n    20.0 s     2.0 x real time\n    30.0 s     2.0 x real time\n");
}

TEST(LiveLine, NamesTheStageThatTookMostSinceTheLastLine) {
  Paper paper;
  LiveLine line(paper.settings, true);
  const auto spend = [&](Stage stage, int milliseconds) {
    paper.stages.start();
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
    paper.stages.lap(stage);
  };
  spend(Stage::kContacts, 60);  // long ago
  line.update(0, 0, paper.stages, "");
  spend(Stage::kAdvance, 20);
  spend(Stage::kPublish, 1);
  line.update(1, 1, paper.stages, "");
  EXPECT_NE(paper.read().find("slowest: advance"), std::string::npos);
}

TEST(LiveLine, AShorterLineLeavesNothingOfALongerOne) {
  Paper paper;
  LiveLine line(paper.settings, true);
  line.update(0, 0, paper.stages, "");
  line.update(1, 1, paper.stages, "a long score");
  line.update(2, 2, paper.stages, "");
  line.finish();
  std::string text = paper.read();
  const std::string last = text.substr(text.rfind('\r') + 1);
  const std::string before = text.substr(1, text.rfind('\r') - 1);
  EXPECT_GE(last.size() - 1, before.size());
}

}  // namespace
}  // namespace murosimf
