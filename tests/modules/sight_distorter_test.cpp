// What an oracle makes of what could be seen: noise, bias, misses, false percepts and outages have the figures asked
// for.

#include "murosimf/modules/camera/sight_distorter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "book/page.h"
#include "modules/oracle_scene.h"
#include "murosimf/modules/camera/random_events.h"

namespace murosimf::testing {
namespace {

constexpr double kPeriod = 0.05;
const Vector3 kBall{2, 0.3, kOracleBall};

/// A ball seen again and again.
class Told {
 public:
  explicit Told(const SightErrors& ball) : scene_(kBall, {0, 50, 0.25}) {
    errors_[kindIndex(SightKind::kBall)] = ball;
    eye_ = std::make_unique<OracleEye>(oracleLens(), scene_.targets, std::vector<std::uint32_t>{}, errors_);
    distorter_ = std::make_unique<SightDistorter>(*eye_, errors_, 3, "robots.red.1.head", kPeriod);
    const auto seen = eye_->look(scene_.scene, oracleCameraPose());
    seen_.assign(seen.begin(), seen.end());
  }
  const SightingsByKind& at(std::uint64_t number) {
    distorter_->distort(*eye_, seen_, {number, kPeriod * static_cast<double>(number), oracleCameraPose()}, told_);
    return told_;
  }
  const std::vector<Sighting>& balls(std::uint64_t number) { return at(number)[0]; }

 private:
  OracleScene scene_;
  ErrorsByKind errors_;
  std::unique_ptr<OracleEye> eye_;
  std::unique_ptr<SightDistorter> distorter_;
  std::vector<TrueSight> seen_;
  SightingsByKind told_;
};

struct Moments {
  void add(double x) { sum += x, squares += x * x, ++count; }
  double mean() const { return sum / count; }
  double deviation() const { return std::sqrt(squares / count - mean() * mean()); }
  double sum = 0, squares = 0;
  int count = 0;
};

TEST(SightDistorter, WithoutErrorsItTellsTheTruthInTheCamerasFrame) {
  Told told({});
  ASSERT_EQ(told.balls(1).size(), 1U);
  EXPECT_LT(norm(told.balls(1)[0].p_C - applyInverse(oracleCameraPose(), kBall)), 1e-12);
}

TEST(SightDistorter, BearingAndDistanceHaveTheirMeanAndDeviation) {
  SightErrors errors;
  errors.bearing_bias = 0.02, errors.bearing_noise = 0.05, errors.distance_bias = -0.1, errors.distance_noise = 0.08;
  Told told(errors);
  Moments bearing, distance;
  constexpr int kCount = 20000;
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const Vector3 p_W = oracleCameraPose() * told.balls(i).at(0).p_C;
    bearing.add(std::atan2(p_W.y, p_W.x) - std::atan2(kBall.y, kBall.x));
    distance.add(std::hypot(p_W.x, p_W.y) / std::hypot(kBall.x, kBall.y) - 1);
    ASSERT_NEAR(p_W.z, kOracleBall, 1e-12);
  }
  const double four = 4 / std::sqrt(kCount);  // standard errors of a mean; of a deviation 1 / sqrt 2 of it
  EXPECT_NEAR(bearing.mean(), 0.02, four * 0.05);
  EXPECT_NEAR(bearing.deviation(), 0.05, four * 0.05 * 0.71);
  EXPECT_NEAR(distance.mean(), -0.1, four * 0.08);
  EXPECT_NEAR(distance.deviation(), 0.08, four * 0.08 * 0.71);
}

TEST(SightDistorter, MissesHaveTheirProbability) {
  book::Page page({book::Chapter::kSensors,
                   "An oracle's eye misses with the probability that is asked for",
                   R"(\frac{n}{N} = 1 - p)",
                   "Bernoulli trials; allowed: four standard deviations of 20 000 pictures",
                   {{"p", "probability of a miss", ""}, {"n", "times that the ball was seen", ""}},
                   {"probability of a miss $p$", ""},
                   {"share of pictures with the ball", ""}});
  page.curve(0, 1, [](double p) { return 1 - p; });
  for (const double miss : {0.05, 0.3, 0.7}) {
    SightErrors errors;
    errors.miss = miss;
    Told told(errors);
    constexpr int kCount = 20000;
    double seen = 0;
    for (std::uint64_t i = 0; i < kCount; ++i) seen += static_cast<double>(told.balls(i).size());
    EXPECT_TRUE(page.near(miss, seen / kCount, 1 - miss, 4 * std::sqrt(miss * (1 - miss) / kCount)));
  }
}

TEST(SightDistorter, FalsePerceptsAreOfPoissonAndLieInTheirRange) {
  SightErrors errors;
  errors.miss = 1, errors.false_rate = 10, errors.range = 3;  // 0.5 a picture
  Told told(errors);
  constexpr int kCount = 20000;
  std::array<double, 4> pictures{};  // with 0, 1, 2, more of them
  for (std::uint64_t i = 0; i < kCount; ++i) {
    const std::vector<Sighting>& balls = told.balls(i);
    ++pictures[std::min<std::size_t>(balls.size(), 3)];
    for (const Sighting& ball : balls) {
      const Vector3 p_W = oracleCameraPose() * ball.p_C;
      ASSERT_NEAR(p_W.z, kOracleBall, 1e-12);
      ASSERT_GE(std::hypot(p_W.x, p_W.y), 0.3 - 1e-12);
      ASSERT_LE(std::hypot(p_W.x, p_W.y), 3 + 1e-12);
      ASSERT_LT(std::fabs(std::atan2(p_W.y, p_W.x)), 0.7) << "in the direction of some pixel";
    }
  }
  const double none = std::exp(-0.5);
  const std::array<double, 4> shares{none, none / 2, none / 8, 1 - none * 1.625};
  book::Page page({book::Chapter::kSensors,
                   "False percepts of an oracle's eye are of Poisson",
                   R"(P(k) = \frac{\lambda^k}{k!} e^{-\lambda})",
                   "Poisson's distribution; here allowed: five standard deviations of a count",
                   {{"\\lambda", "false percepts a picture, here 0.5", ""}},
                   {"false percepts in a picture $k$ (3: and more)", ""},
                   {"share of pictures $P$", ""}});
  double chi_square = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const double expected = kCount * shares[i], deviation = std::sqrt(shares[i] * (1 - shares[i]) / kCount);
    EXPECT_TRUE(page.near(static_cast<double>(i), pictures[i] / kCount, shares[i], 5 * deviation));
    chi_square += (pictures[i] - expected) * (pictures[i] - expected) / expected;
  }
  EXPECT_LT(chi_square, 21.1) << "of 3 degrees of freedom: one in 10 000";
}

TEST(SightDistorter, OutagesTakeTheirShareOfTimeAndLast) {
  SightErrors errors;
  errors.outage_rate = 0.4, errors.outage_length = 0.5, errors.false_rate = 1;
  Told told(errors);
  double blind = 0, count = 0;
  for (std::uint64_t i = 0; i < 600000; i += 30, ++count) blind += told.balls(i).empty() ? 1 : 0;  // 1.5 s apart
  const double share = 1 - std::exp(-0.2);
  EXPECT_NEAR(blind, share * count, 4 * std::sqrt(count * share * (1 - share)));
  int run = 0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const bool out = told.balls(i).empty();
    ASSERT_TRUE(out || run == 0 || run >= 9) << "an outage of " << run << " pictures, picture " << i;
    run = out ? run + 1 : 0;
  }
}

TEST(SightDistorter, AnyPictureCanBeAskedForInAnyOrder) {
  SightErrors errors;
  errors.bearing_noise = 0.1, errors.miss = 0.2, errors.false_rate = 20;
  Told told(errors), again(errors);
  std::vector<std::vector<Sighting>> forward;
  for (std::uint64_t i = 0; i < 50; ++i) forward.push_back(told.balls(i));
  for (std::uint64_t i = 50; i-- > 0;) {
    const std::vector<Sighting>& balls = again.balls(i);
    ASSERT_EQ(balls.size(), forward[i].size());
    for (std::size_t k = 0; k < balls.size(); ++k) EXPECT_EQ(balls[k].p_C, forward[i][k].p_C);
  }
}

TEST(RandomEvents, PoissonCountsInvertTheDistribution) {
  EXPECT_EQ(poissonCount(0, 0), 0);
  EXPECT_EQ(poissonCount(0.99, 0), 0);
  EXPECT_EQ(poissonCount(std::exp(-2.0) - 1e-12, 2), 0);
  EXPECT_EQ(poissonCount(std::exp(-2.0) + 1e-12, 2), 1);
  EXPECT_EQ(poissonCount(3 * std::exp(-2.0) + 1e-12, 2), 2);
}

}  // namespace
}  // namespace murosimf::testing
