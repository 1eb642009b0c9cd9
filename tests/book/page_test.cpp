// A page of the validation book tells what its test compared, and nothing is written unless somebody asks.
#include "book/page.h"

#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

namespace murosimf::book {
namespace {

Head headOf(const std::string& claim) {
  return {Chapter::kNumbers,    claim, "y = x^2", "by definition", {{"x", "a number", "m"}}, {"number $x$", "m"},
          {"its square", "m^2"}};
}

/// A folder that pages are written to while this lives.
class Folder {
 public:
  Folder() : path_(std::filesystem::temp_directory_path() / ("murosimf_book_" + std::to_string(::getpid()))) {
    ::setenv("MUROSIMF_BOOK", path_.c_str(), 1);
  }
  ~Folder() {
    ::unsetenv("MUROSIMF_BOOK");
    std::filesystem::remove_all(path_);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  std::filesystem::path file(const std::string& name) const { return path_ / (name + ".json"); }
  nlohmann::json read(const std::string& name) const {
    std::ifstream stream(file(name));
    return nlohmann::json::parse(stream);
  }

 private:
  std::filesystem::path path_;
};

TEST(BookPage, HoldsWhatWasComparedAndTheLargestDeviation) {
  const Folder folder;
  {
    Page page(headOf("squares"));
    page.series("by hand").curve(0, 2, [](double x) { return x * x; });
    EXPECT_TRUE(page.near(1, 1.01, 1, 0.1));
    EXPECT_TRUE(page.near(2, 3.96, 4, 0.05));
    EXPECT_TRUE(page.below(2, -0.2, 1));
  }
  const nlohmann::json page = folder.read("BookPage.HoldsWhatWasComparedAndTheLargestDeviation");
  EXPECT_EQ(page["chapter"], "Numbers");
  EXPECT_EQ(page["file"], "tests/book/page_test.cpp");
  EXPECT_TRUE(page["passed"]);
  ASSERT_EQ(page["series"].size(), 2U);
  EXPECT_EQ(page["series"][0]["theory"], (std::vector<double>{1, 4}));
  EXPECT_EQ(page["series"][0]["curve_x"].size(), 200U);
  EXPECT_EQ(page["series"][0]["curve_y"].back(), 4.0);
  EXPECT_TRUE(page["series"][1]["bounded"]);
  EXPECT_EQ(page["series"][1]["name"], "by hand");
  EXPECT_EQ(page["series"][1]["found"], std::vector<double>{0.2});
  EXPECT_NEAR(page["largest"]["share"], 0.8, 1e-12);
  EXPECT_NEAR(page["largest"]["deviation"], 0.04, 1e-12);
  EXPECT_EQ(page["largest"]["tolerance"], 0.05);
}

TEST(BookPage, ComparesAsTheTestsMacrosDo) {
  Page page(headOf("comparison"));
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(page.near(0, 1.5, 1, 0.5)) << "as EXPECT_NEAR, the tolerance itself is allowed";
  EXPECT_FALSE(page.near(0, 1.51, 1, 0.5));
  EXPECT_FALSE(page.near(0, kNone, 1, 0.5));
  EXPECT_FALSE(page.near(0, 1, 1, kNone));
  EXPECT_FALSE(page.below(0, kNone, 1));
  EXPECT_FALSE(page.below(0, -1.1, 1));
  const testing::AssertionResult far = page.near(3, 2, 1, 0.5);
  EXPECT_STREQ(far.message(), "at 3: found 2, theory says 1, they differ by 1 where 0.5 is allowed");
}

TEST(BookPage, IsNotWrittenUnlessAsked) {
  std::filesystem::path file;
  {
    const Folder folder;
    file = folder.file("BookPage.IsNotWrittenUnlessAsked");
  }
  { const Page page(headOf("nothing")); }
  EXPECT_FALSE(std::filesystem::exists(file));
}

TEST(BookPage, WhatIsNoNumberIsTheLargestDeviation) {
  const Folder folder;
  {
    Page page(headOf("no number"));
    EXPECT_FALSE(page.near(0, std::nan(""), 1, 0.5));
    EXPECT_TRUE(page.near(1, 1.4, 1, 0.5));
  }
  EXPECT_TRUE(folder.read("BookPage.WhatIsNoNumberIsTheLargestDeviation")["largest"]["share"].is_null());
}

class Instances : public testing::TestWithParam<int> {};
TEST_P(Instances, WriteAFileEach) {
  const Folder folder;
  { const Page page(headOf("instances")); }
  const nlohmann::json page = folder.read("Instances.WriteAFileEach." + std::to_string(GetParam()));
  EXPECT_EQ(page["test"], "Instances.WriteAFileEach");
  EXPECT_EQ(page["variant"], std::to_string(GetParam()));
}
INSTANTIATE_TEST_SUITE_P(Of, Instances, testing::Values(1, 2),
                         [](const auto& test) { return std::to_string(test.param); });

}  // namespace
}  // namespace murosimf::book
