#include "experiment/result_store.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "experiment/folders.h"

namespace murosimf::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

RunResult exampleResult() {
  RunResult result;
  result.run = {"scenarios/a.toml", {"a=1", "b=\"two\""}, 7};
  result.program = "abc";
  result.report = {{"score", {{"red", 2}}}, {"share", 0.1}, {"none", nullptr}, {"whole", 3.0}};
  result.cpu_seconds = 1.0 / 3;
  return result;
}

TEST(ResultStore, GivesBackWhatWasWritten) {
  const ResultStore store(emptyFolder("store"));
  EXPECT_FALSE(store.read("id"));
  RunResult written = exampleResult();
  written.failure = "half a character: \xc3";
  store.write("id", written, *store.claim("id"));
  const std::optional<RunResult> read = store.read("id");
  ASSERT_TRUE(read);
  EXPECT_EQ(read->run.overrides, written.run.overrides);
  EXPECT_EQ(read->run.seed, 7u);
  EXPECT_EQ(read->report.dump(), written.report.dump());
  EXPECT_EQ(read->cpu_seconds, written.cpu_seconds);
  EXPECT_EQ(read->failure.substr(0, 17), "half a character:");
}

TEST(ResultStore, LeavesNothingButTheResult) {
  const ResultStore store(emptyFolder("store_clean"));
  writeFile(store.folder() / "id.part", "what a killed process had written");
  store.write("id", exampleResult(), *store.claim("id"));
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(store.folder()))
    names.push_back(entry.path().filename().string());
  EXPECT_EQ(names, std::vector<std::string>{"id.json"});
}

TEST(ResultStore, TakesDamagedResultsForAbsent) {
  const ResultStore store(emptyFolder("store_damaged"));
  store.write("id", exampleResult(), *store.claim("id"));
  const std::string whole = readFile(store.fileOf("id"));
  for (std::size_t size = 0; size + 1 < whole.size(); size += 7) {  // the last byte is the end of the line
    writeFile(store.fileOf("id"), whole.substr(0, size));
    EXPECT_FALSE(store.read("id")) << size;
  }
  std::string edited = whole;
  edited[edited.find("0.1")] = '1';
  writeFile(store.fileOf("id"), edited);
  EXPECT_FALSE(store.read("id"));
  for (const char* other : {"[]", "{}", "{\"sha256\": 1, \"result\": {}}"}) {
    writeFile(store.fileOf("id"), other);
    EXPECT_FALSE(store.read("id"));
  }
  writeFile(store.fileOf("id"), whole);
  EXPECT_TRUE(store.read("id"));
}

TEST(ResultStore, GivesARunToOneAtATime) {
  const ResultStore store(emptyFolder("store_claims"));
  std::unique_ptr<RunClaim> first = store.claim("id");
  ASSERT_TRUE(first);
  EXPECT_FALSE(store.claim("id"));
  EXPECT_TRUE(store.claim("other"));
  first.reset();
  EXPECT_TRUE(store.claim("id"));
}

TEST(ResultStore, FreesTheClaimsOfKilledProcesses) {
  const ResultStore store(emptyFolder("store_killed"));
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const std::unique_ptr<RunClaim> held = store.claim("id");
    const ssize_t told = write(ready[1], "x", 1);
    pause();
    _exit(static_cast<int>(told));
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_FALSE(store.claim("id"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_TRUE(store.claim("id"));
}

TEST(ResultStore, NamesAFolderThatCannotBeWritten) {
  const fs::path folder = emptyFolder("store_gone");
  const ResultStore store(folder / "runs");
  fs::remove_all(folder);
  try {
    store.claim("id");
    FAIL();
  } catch (const std::runtime_error& problem) {
    EXPECT_NE(std::string(problem.what()).find("runs/id.lock: cannot be written: No such file"), std::string::npos);
  }
}

TEST(Reports, LoseWhatDependsOnClocksAndThreads) {
  const Json report = {{"scenario", "/home/me/a.toml"},
                       {"seed", 1},
                       {"wall_seconds", 3.4},
                       {"real_time_factor", 2},
                       {"threads", 2},
                       {"state_hash", "00"},
                       {"stages", {{"sense", .2}}},
                       {"control", {{"steps", 5}, {"program_seconds_all_threads", 1.5}}}};
  EXPECT_EQ(withoutClocks(report).dump(), R"({"seed":1,"state_hash":"00","control":{"steps":5}})");
}

}  // namespace
}  // namespace murosimf::test
