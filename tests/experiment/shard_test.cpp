#include "experiment/shard.h"

#include <gtest/gtest.h>

#include <map>

namespace murosimf {
namespace {

using Variables = std::map<std::string, std::string>;

std::string shardText(const Variables& variables) {
  Diagnostics diagnostics;
  const Environment environment = [&](const char* name) {
    const auto at = variables.find(name);
    return at == variables.end() ? nullptr : at->second.c_str();
  };
  const std::optional<Shard> shard = shardOf(environment, diagnostics);
  EXPECT_EQ(shard.has_value(), !diagnostics.hasErrors());
  return shard ? std::to_string(shard->index) + "/" + std::to_string(shard->count) : diagnostics.text();
}

TEST(Shards, TogetherAreEveryRunOnce) {
  for (std::size_t run = 0; run < 20; ++run) {
    int owners = 0;
    for (int index = 0; index < 3; ++index) owners += Shard{index, 3, ""}.has(run) ? 1 : 0;
    EXPECT_EQ(owners, 1);
  }
}

TEST(Shards, AreReadFromTheCommandLine) {
  Diagnostics diagnostics;
  EXPECT_EQ(readShard("3/4", diagnostics)->index, 3);
  EXPECT_EQ(readShard("0/1", diagnostics)->count, 1);
  EXPECT_FALSE(diagnostics.hasErrors());
  for (const char* text : {"", "/", "1", "a/b", "-1/3", "1/0", "1/2/3", "1/2 "}) {
    Diagnostics wrong;
    EXPECT_FALSE(readShard(text, wrong)) << text;
    EXPECT_TRUE(wrong.hasErrors()) << text;
  }
  Diagnostics past_the_end;
  EXPECT_FALSE(readShard("4/4", past_the_end));
  EXPECT_EQ(past_the_end.text(), "--shard: error: is \"4/4\", expected an INDEX from 0 to 3: parts count from 0\n");
}

TEST(Shards, AreTakenFromBatchSystems) {
  EXPECT_EQ(shardText({}), "0/1");
  EXPECT_EQ(shardText({{"SLURM_ARRAY_TASK_ID", "2"}, {"SLURM_ARRAY_TASK_COUNT", "4"}}), "2/4");
  EXPECT_EQ(shardText({{"SLURM_ARRAY_TASK_ID", "7"},
                       {"SLURM_ARRAY_TASK_COUNT", "3"},
                       {"SLURM_ARRAY_TASK_MIN", "3"},
                       {"SLURM_ARRAY_TASK_STEP", "2"}}),
            "2/3");
  EXPECT_EQ(shardText({{"OMPI_COMM_WORLD_RANK", "1"}, {"OMPI_COMM_WORLD_SIZE", "8"}}), "1/8");
  EXPECT_EQ(shardText({{"PMI_RANK", "0"}, {"PMI_SIZE", "2"}}), "0/2");
  EXPECT_EQ(shardText({{"JOB_COMPLETION_INDEX", "4"}, {"JOB_COMPLETIONS", "5"}}), "4/5");
}

TEST(Shards, OfTasksOfAnArrayAreCutTwice) {
  EXPECT_EQ(shardText({{"SLURM_ARRAY_TASK_ID", "1"},
                       {"SLURM_ARRAY_TASK_COUNT", "2"},
                       {"SLURM_STEP_ID", "0"},
                       {"SLURM_PROCID", "2"},
                       {"SLURM_STEP_NUM_TASKS", "3"}}),
            "5/6");
}

TEST(Shards, AreWholeInABatchScriptThatIsOneProcess) {
  EXPECT_EQ(shardText({{"SLURM_PROCID", "0"}, {"SLURM_NTASKS", "4"}}), "0/1");
}

TEST(Shards, WithoutACountAreRefused) {
  EXPECT_EQ(shardText({{"JOB_COMPLETION_INDEX", "4"}}),
            "JOB_COMPLETIONS: error: is not set, expected a whole number; or say --shard INDEX/COUNT\n");
}

TEST(Shards, ThatContradictThemselvesAreRefused) {
  EXPECT_EQ(shardText({{"PMI_RANK", "2"}, {"PMI_SIZE", "2"}}),
            "PMI_RANK: error: gives part 2 of 2 (PMI_SIZE), expected 0 to 1\n");
  EXPECT_EQ(shardText({{"PMI_RANK", "two"}, {"PMI_SIZE", "2"}}),
            "PMI_RANK: error: is \"two\", expected a whole number from 0\n");
  EXPECT_NE(shardText({{"SLURM_ARRAY_TASK_ID", "9"}, {"SLURM_ARRAY_TASK_COUNT", "3"}, {"SLURM_ARRAY_TASK_MIN", "1"}})
                .find("error"),
            std::string::npos);
  EXPECT_NE(shardText({{"SLURM_ARRAY_TASK_ID", "4"},
                       {"SLURM_ARRAY_TASK_COUNT", "3"},
                       {"SLURM_ARRAY_TASK_MIN", "1"},
                       {"SLURM_ARRAY_TASK_STEP", "2"}})
                .find("error"),
            std::string::npos);
}

}  // namespace
}  // namespace murosimf
