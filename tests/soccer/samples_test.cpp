#include "murosimf/soccer/samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace murosimf {
namespace {

TEST(Percentile, LiesLinearlyBetweenOrderStatistics) {
  EXPECT_DOUBLE_EQ(percentile({3, 1, 2}, 0.5), 2);
  EXPECT_DOUBLE_EQ(percentile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(percentile({10, 0}, 0.9), 9);
  EXPECT_DOUBLE_EQ(percentile({7}, 0.9), 7);
  EXPECT_DOUBLE_EQ(percentile({5, 6, 9}, 0), 5);
  EXPECT_DOUBLE_EQ(percentile({5, 6, 9}, 1), 9);
  EXPECT_TRUE(std::isnan(percentile({}, 0.5)));
}

TEST(Samples, KeepEverythingWhileThereIsRoom) {
  Samples samples(100);
  for (int i = 0; i < 100; ++i) samples.add(i);
  EXPECT_EQ(samples.kept().size(), 100U);
  EXPECT_DOUBLE_EQ(percentile(samples.kept(), 0.9), 89.1);
}

TEST(Samples, AFullStoreKeepsEvenlySpreadNumbers) {
  Samples samples(64);
  for (int i = 0; i < 100000; ++i) samples.add(i);
  EXPECT_EQ(samples.seen(), 100000U);
  ASSERT_GT(samples.kept().size(), 30U);
  ASSERT_LE(samples.kept().size(), 64U);
  EXPECT_EQ(samples.kept()[0], 0);
  const float step = samples.kept()[1];
  for (std::size_t i = 1; i < samples.kept().size(); ++i) {
    EXPECT_EQ(samples.kept()[i] - samples.kept()[i - 1], step);
  }
  EXPECT_GT(samples.kept().back(), 100000 - 2 * step);
  EXPECT_NEAR(percentile(samples.kept(), 0.5), 50000, 2 * step);
}

TEST(Samples, NeverAllocateAfterConstruction) {
  Samples samples(10);
  const float* place = samples.kept().data();
  for (int i = 0; i < 1000; ++i) samples.add(i);
  EXPECT_EQ(samples.kept().data(), place);
}

TEST(Samples, GoOnAfterACheckpoint) {
  Samples whole(16), saved(16), continued(16);
  for (int i = 0; i < 1000; ++i) {
    whole.add(i);
    if (i < 421) saved.add(i);
  }
  StateArchive write;
  write(saved);
  StateArchive read(write.bytes());
  read(continued);
  for (int i = 421; i < 1000; ++i) continued.add(i);
  EXPECT_EQ(whole.kept(), continued.kept());
}

}  // namespace
}  // namespace murosimf
