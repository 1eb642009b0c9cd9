#include "experiment/sweep_plan.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

#include "experiment/folders.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;

const fs::path kPlan = fs::path(MUROSIMF_SOURCE_DIR) / "scenarios" / "sweeps" / "plan.toml";

struct Reading {
  std::optional<SweepPlan> plan;
  std::string messages;  ///< without the folder of the plan
};

Reading readText(const std::string& text) {
  Diagnostics diagnostics;
  Reading reading;
  reading.plan = readSweepPlanText(text, kPlan, diagnostics);
  reading.messages = diagnostics.text();
  const std::string folder = kPlan.parent_path().string() + "/";
  for (std::size_t at = reading.messages.find(folder); at != std::string::npos; at = reading.messages.find(folder))
    reading.messages.erase(at, folder.size());
  return reading;
}

const std::string kHead = "scenario = \"game_3v3.toml\"\nseeds = [1, 2]\nmetrics = [\"score.red\"]\n";

std::vector<std::string> changesOf(const SweepCase& one) {
  std::vector<std::string> texts;
  for (const Located<std::string>& change : one.changes) texts.push_back(*change);
  return texts;
}

TEST(SweepPlans, AreCasesTimesParametersTimesSeeds) {
  const Reading reading = readText(kHead + R"(
confidence = 0.9
[set]
simulation.duration = 2
ball.radius = 0.1
[[cases]]
name = "first"
[[cases]]
name = "second"
set = {robots.red.1.pose = [-1, 0, {deg = 90}]}
[parameters]
robots.all.level = ["oracle", "kinematic"]
field.brightness = [0.5, 1]
)");
  ASSERT_TRUE(reading.plan) << reading.messages;
  const SweepPlan& plan = *reading.plan;
  EXPECT_EQ(plan.axes, (std::vector<std::string>{"case", "robots.all.level", "field.brightness"}));
  ASSERT_EQ(plan.cases.size(), 8u);
  EXPECT_EQ(plan.cases[0].name(), "first, oracle, 0.5");
  EXPECT_EQ(plan.cases[1].name(), "first, oracle, 1");
  EXPECT_EQ(plan.cases[7].name(), "second, kinematic, 1");
  EXPECT_EQ(
      changesOf(plan.cases[7]),
      (std::vector<std::string>{"simulation.duration=2", "ball.radius=0.1", "robots.red.1.pose=[-1, 0, {deg = 90}]",
                                "robots.all.level=\"kinematic\"", "field.brightness=1"}));
  EXPECT_EQ(plan.confidence, .9);
  EXPECT_EQ(plan.directory, fs::path("out/sweeps/plan"));
  RunIdentifier identifier("program");
  const std::vector<BatchRun> runs = runsOf(plan, identifier);
  ASSERT_EQ(runs.size(), 16u);
  EXPECT_EQ(runs[15].label, "second, kinematic, 1, seed 2");
  std::set<std::string> identities;
  for (const BatchRun& run : runs) identities.insert(run.identity);
  EXPECT_EQ(identities.size(), 16u);
}

TEST(SweepPlans, CountSeedsFromAnyNumber) {
  const Reading reading =
      readText("scenario = \"game_3v3.toml\"\nseeds = {from = 5, count = 3}\nmetrics = [\"score.red\"]\n");
  ASSERT_TRUE(reading.plan) << reading.messages;
  EXPECT_EQ(reading.plan->seeds, (std::vector<std::uint64_t>{5, 6, 7}));
  ASSERT_EQ(reading.plan->cases.size(), 1u);
  EXPECT_EQ(reading.plan->cases[0].name(), "all");
}

TEST(SweepPlans, OfTheExamplesAreRight) {
  for (const fs::directory_entry& entry : fs::directory_iterator(kPlan.parent_path())) {
    Diagnostics diagnostics;
    EXPECT_TRUE(readSweepPlan(entry.path(), diagnostics)) << diagnostics.text();
  }
}

struct Mistake {
  const char* name;
  std::string text, message;
};

class BrokenPlans : public testing::TestWithParam<Mistake> {};

TEST_P(BrokenPlans, AreToldWhereAndHow) {
  const Reading reading = readText(GetParam().text);
  EXPECT_FALSE(reading.plan);
  EXPECT_NE(reading.messages.find(GetParam().message), std::string::npos) << reading.messages;
}

const Mistake kMistakes[] = {
    {"Empty", "", "plan.toml: error: scenario is missing, expected the file of a scenario"},
    {"Scenario", "[robots.red.1]\n",
     "plan.toml: error: this is a scenario, expected the plan of a sweep, which names one: scenario = \"plan.toml\""},
    {"NoSeeds", "scenario = \"game_3v3.toml\"\n", "seeds is missing, expected a list such as [1, 2, 3]"},
    {"Syntax", "scenario = \n", "plan.toml:1:12: error: this is not TOML"},
    {"UnknownKey", kHead + "confidense = 0.9\n",
     "plan.toml:4:1: error: unknown key \"confidense\", expected scenario, directory, seeds, metrics, confidence, set, "
     "parameters, cases (did you mean \"confidence\"?)"},
    {"NoSuchScenario", "scenario = \"game_3v4.toml\"\nseeds = [1]\nmetrics = [\"a\"]\n",
     "plan.toml:1:12: error: there is no scenario \"game_3v4.toml\", looked for from"},
    {"SeedTwice", "scenario = \"game_3v3.toml\"\nseeds = [1, 1]\nmetrics = [\"a\"]\n",
     "plan.toml:2:13: error: seed 1 is there twice"},
    {"NegativeSeed", "scenario = \"game_3v3.toml\"\nseeds = [-1]\nmetrics = [\"a\"]\n",
     "plan.toml:2:10: error: a seed is -1, expected a whole number from 0"},
    {"BadMetric", "scenario = \"game_3v3.toml\"\nseeds = [1]\nmetrics = [\"score..red\"]\n",
     "plan.toml:3:12: error: \"score..red\" has an empty part"},
    {"BadConfidence", kHead + "confidence = 95\n", "plan.toml:4:14: error: confidence is 95, expected a number of"},
    {"UnknownPath", kHead + "[parameters]\nrobots.all.levle = [\"fast\"]\n",
     "plan.toml:5:21: error: unknown key \"levle\""},
    {"BadValue", kHead + "[parameters]\nrobots.all.level = [\"fast\", \"fsat\"]\n",
     "plan.toml:5:29: error: level is text \"fsat\", expected"},
    {"NoList", kHead + "[parameters]\nfield.brightness = 0.5\n",
     "plan.toml:5:20: error: field.brightness is 0.5, expected a list of values"},
    {"ValueTwice", kHead + "[parameters]\nfield.brightness = [1, 0.5, 1]\n",
     "plan.toml:5:29: error: field.brightness has the value 1 twice"},
    {"Seed", kHead + "[set]\nsimulation.seed = 4\n",
     "plan.toml:5:12: error: simulation.seed stands here, expected the key seeds of the plan"},
    {"Paced", kHead + "[set]\nsimulation.pace = 1\n", "pace is 1, expected 0: results must not depend on"},
    {"CaseWithoutName", kHead + "[[cases]]\nset = {}\n", "plan.toml:4:1: error: name is missing in [[cases]]"},
    {"CaseTwice", kHead + "[[cases]]\nname = \"a\"\n[[cases]]\nname = \"a\"\n",
     "plan.toml:7:8: error: there are two cases \"a\""},
    {"NoSuchRobot", kHead + "[[cases]]\nname = \"a\"\nset = {robots.red.7.level = \"full\"}\n",
     "the scenario has no robots.red.7"},
    {"TooMany",
     "scenario = \"game_3v3.toml\"\nseeds = {count = 600000}\nmetrics = [\"a\"]\n[parameters]\n"
     "field.brightness = [1, 2]\n",
     "these are 2 cases with 600000 seeds each, expected at most 1000000 runs"},
};

INSTANTIATE_TEST_SUITE_P(All, BrokenPlans, testing::ValuesIn(kMistakes),
                         [](const auto& instance) { return std::string(instance.param.name); });

}  // namespace
}  // namespace murosimf::test
