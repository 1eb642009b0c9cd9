// Whether teams that see through their cameras alone play football: ten whole games of 300 s, some ten minutes.

#include <gtest/gtest.h>

#include "game/program.h"

namespace murosimf::test {
namespace {

struct Tally {
  int games_with_goal = 0, goals_after_kicks = 0;
};

void count(const nlohmann::json& report, Tally& tally) {
  const nlohmann::json& goals = report["goals"];
  if (!goals.empty()) ++tally.games_with_goal;
  for (const nlohmann::json& goal : goals) tally.goals_after_kicks += goal["deliberate_kick"].get<bool>() ? 1 : 0;
}

TEST(TenGames, MostSeeGoalsAfterKicksByRobotsThatKnowWhereTheyAre) {
  Tally tally;
  for (int seed = 1; seed <= 10; ++seed) {
    const nlohmann::json report = playGame(freshFolder("ten_games"), "--duration 300 --seed " + std::to_string(seed));
    count(report, tally);
    const nlohmann::json& all = report["perception"]["all"];
    EXPECT_LT(all["position_error_median"].get<double>(), 0.25) << seed;
    EXPECT_LT(all["heading_error_median_deg"].get<double>(), 15) << seed;
    EXPECT_EQ(report["control"]["failed_programs"].get<int>(), 0) << seed;
  }
  EXPECT_GE(tally.games_with_goal, 8);
  EXPECT_GE(tally.goals_after_kicks, 6);
}

}  // namespace
}  // namespace murosimf::test
