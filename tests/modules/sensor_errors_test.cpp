// Errors of sensors: what is known of each number is what its parameter says.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>

#include "book/page.h"
#include "murosimf/linking/linker.h"
#include "murosimf/linking/outside_access.h"
#include "murosimf/linking/robot_module.h"
#include "murosimf/modules/all_modules.h"
#include "murosimf/modules/sensing/sensor_errors.h"

namespace murosimf::sensing {
namespace {

/// A gyroscope that turns faster and faster about x, evenly about y, and not about z.
class Signal final : public RobotModule {
 public:
  static Vector3 at(long step) { return {0.01 * static_cast<double>(step), 5, 0}; }
  void declare(Declaration& d) const override { d.runsIn(Phase::kSense), d.adds(kGyroscope, subset::kImus); }

 private:
  void bind(Links& links) override { gyroscope_ = links.values(kGyroscope, subset::kImus); }
  void stepRobot(const RobotLane& robot, const StepTime& time) const override {
    robot.set(gyroscope_, at(std::lround(time.t / time.dt)));
  }
  RobotValues<Vector3> gyroscope_;
};

using Parameters = std::map<std::string, double>;

class Bench {
 public:
  /// @param parameters  of gyroscope_errors; "period" [s] holds for the sensor as well
  explicit Bench(const Parameters& parameters, std::vector<std::string> robots = {"robots.red.1"}, int lanes = 1,
                 std::uint64_t seed = 1) {
    static const OutsideAccess reader([](Declaration& d) { d.reads(kGyroscopeReading, subset::kImus); });
    ModuleRegistry registry = allModules();
    registry.add<Signal>("signal", "test", "");
    Linker linker(world_, registry, {1e-3, lanes});
    WrittenParameters written, period;
    for (const auto& [name, value] : parameters) written.emplace(name, WrittenParameter{{{value}, ""}, {}});
    if (parameters.contains("period")) period.emplace("period", written.at("period"));
    for (const std::string& path : robots) {
      robots_.push_back(world_.addPath(path));
      world_.set(robots_.back(), kNoiseKey, noiseKey(seed, path));
      world_.defineSubset(robots_.back(), subset::kImus, {world_.add(robots_.back(), "imu")});
      linker.assign({robots_.back(), "signal", period, {}});
      linker.assign({robots_.back(), "gyroscope_errors", written, {}});
    }
    linker.attach({"reader", &reader, robots_});
    Diagnostics diagnostics;
    linked_ = linker.link(diagnostics);
    if (linked_ == nullptr) throw std::runtime_error(diagnostics.text());
  }
  Vector3 step(std::size_t robot = 0) {
    linked_->runFrame(frame_++);
    return reading(robot);
  }
  Vector3 reading(std::size_t robot) { return linked_->handle(robots_[robot], kGyroscopeReading, subset::kImus).get(); }
  std::vector<Vector3> steps(int count, std::size_t robot = 0) {
    std::vector<Vector3> readings;
    for (int i = 0; i < count; ++i) readings.push_back(step(robot));
    return readings;
  }
  /// All that a checkpoint holds.
  std::vector<double> memory(std::size_t robot = 0) {
    std::vector<double> numbers;
    visit(robot, [&](double value) { numbers.push_back(value); });
    return numbers;
  }
  /// Goes on where another one was.
  void restore(const std::vector<double>& numbers, long frame) {
    std::size_t i = 0;
    visit(0, [&](double& value) { value = numbers[i++]; });
    frame_ = frame;
  }

 private:
  template <class Visitor>
  void visit(std::size_t robot, Visitor&& visitor) {
    for (const Place& place : linked_->places()) {
      if (place.assembly == robots_[robot]) linked_->visitMemory(place, visitor);
    }
  }
  World world_;
  std::vector<ObjectId> robots_;
  std::unique_ptr<LinkedWorld> linked_;
  long frame_ = 0;
};

std::vector<double> numbersOf(const std::vector<Vector3>& readings) {
  std::vector<double> numbers;
  for (const Vector3& r : readings) numbers.insert(numbers.end(), {r.x, r.y, r.z});
  return numbers;
}

std::string problemOf(const Parameters& parameters) {
  try {
    const Bench bench(parameters);
  } catch (const std::runtime_error& problem) {
    return problem.what();
  }
  return "";
}

TEST(SensorErrors, WithoutAnyTheReadingIsTheValue) {
  Bench bench({});
  for (long k = 0; k < 20; ++k) EXPECT_EQ(numbersOf({bench.step()}), numbersOf({Signal::at(k)}));
}

TEST(SensorErrors, NoiseHasItsDeviationAndIsWhiteAndTheAxesAreIndependent) {
  constexpr int kCount = 100'000;
  constexpr double kSigma = 0.2;
  Bench bench({{"noise", kSigma}});
  double sum[3] = {}, square[3] = {}, next[3] = {}, across[3] = {}, fourth = 0;
  std::array<double, 3> last{};
  for (long k = 0; k < kCount; ++k) {
    const Vector3 n = (bench.step() - Signal::at(k)) * (1 / kSigma);
    const std::array<double, 3> now{n.x, n.y, n.z};
    for (std::size_t i = 0; i < 3; ++i) {
      sum[i] += now[i], square[i] += now[i] * now[i];
      next[i] += now[i] * last[i], across[i] += now[i] * now[(i + 1) % 3];
    }
    fourth += n.x * n.x * n.x * n.x;
    last = now;
  }
  const double one = 4 / std::sqrt(kCount);  // four deviations of a mean of kCount numbers
  book::Page page(
      {book::Chapter::kSensors,
       "Noise of sensors is normal and white, and independent on its axes",
       "\\mathrm{E}(n) = 0, \\quad \\mathrm{E}(n^2) = \\sigma^2, \\quad \\mathrm{E}(n_x^4) = 3 \\sigma^4\n"
       R"(\mathrm{E}(n_k n_{k+1}) = 0, \quad \mathrm{E}(n_x n_y) = 0)",
       "White noise: its spectrum is flat, as nothing is correlated from sample to sample; allowed: four deviations",
       {{"n", "noise of a gyroscope, 100 000 samples", "rad/s"}, {"\\sigma", "standard deviation, here 0.2", "rad/s"}},
       {"axis (0: x, 1: y, 2: z)", ""},
       {"mean, in powers of $\\sigma$", ""}});
  for (int i = 0; i < 3; ++i) {
    EXPECT_TRUE(page.series("$n$").near(i, sum[i] / kCount, 0, one));
    EXPECT_TRUE(page.series("$n^2$").near(i, square[i] / kCount, 1, one * std::sqrt(2)));
    EXPECT_TRUE(page.series("$n_k n_{k+1}$").near(i, next[i] / kCount, 0, one));
    EXPECT_TRUE(page.series("$n_x n_y$").near(i, across[i] / kCount, 0, one));
  }
  EXPECT_TRUE(page.series("$n^4$").near(0, fourth / kCount, 3, one * std::sqrt(96)));
}

/// Allan's variance of samples over means of `count` of them: half the mean square of two neighbouring means'
/// difference.
double allanVariance(const std::vector<double>& samples, std::size_t count) {
  const auto mean = [&](std::size_t first) {
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i) sum += samples[i];
    return sum / static_cast<double>(count);
  };
  double squares = 0;
  std::size_t pairs = 0;
  for (std::size_t first = 0; first + 2 * count <= samples.size(); first += count, ++pairs) {
    const double difference = mean(first + count) - mean(first);
    squares += difference * difference;
  }
  return squares / (2 * static_cast<double>(pairs));
}

TEST(SensorErrors, TheAllanDeviationIsThatOfWhiteNoiseAndBiasDoesNotWander) {
  constexpr std::size_t kCount = 200'000;
  constexpr double kSigma = 0.2;
  Bench bench({{"noise", kSigma}, {"bias", 0.3}});
  std::vector<double> samples;
  for (std::size_t k = 0; k < kCount; ++k) samples.push_back(bench.step().y);
  book::Page page({book::Chapter::kSensors,
                   "Means of a gyroscope's readings scatter as white noise does, and its bias does not wander",
                   R"(\sigma_A^2(n) = \frac{1}{2} \mathrm{E} (\bar x_{k+1} - \bar x_k)^2 = \frac{\sigma^2}{n})",
                   "[Allan 1966]; a bias that wanders would bend the line upward; allowed: four deviations",
                   {{"\\sigma_A", "Allan deviation of 200 000 readings at 1 kHz, with a bias", "rad/s"},
                    {"\\bar x_k", "mean of readings k n to (k + 1) n", "rad/s"},
                    {"\\sigma", "deviation of the noise, here 0.2", "rad/s"}},
                   {"readings in a mean $n$", "", true},
                   {"Allan deviation $\\sigma_A$", "rad/s", true}});
  page.curve(1, 2048, [](double n) { return kSigma / std::sqrt(n); });
  for (std::size_t n = 1; n <= 2048; n *= 2) {
    const double theory = kSigma / std::sqrt(static_cast<double>(n));
    // Neighbouring differences share a mean: the variance of m of them scatters by sqrt(3 / m).
    const double scatter = 0.5 * std::sqrt(3 * static_cast<double>(n) / kCount);
    EXPECT_TRUE(page.near(static_cast<double>(n), std::sqrt(allanVariance(samples, n)), theory, 4 * scatter * theory));
  }
}

TEST(SensorErrors, PairsOfNormalNumbersBeginWithThatOfTheStream) {
  const RandomStream stream(0, "", 0);
  const std::uint64_t key = stream.key();
  const NormalPair<double> pair = normalPair<double>(&key, 17);
  EXPECT_EQ(pair.first, stream.normal(17));
  EXPECT_NEAR(squaredNorm(Vector3{pair.first, pair.second, 0}), -2 * std::log(stream.uniform(34) + 0x1.0p-54), 1e-12);
}

TEST(SensorErrors, BiasStaysAndIsDrawnWithItsDeviationForEveryRobotAndAxis) {
  constexpr std::size_t kRobots = 500;
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < kRobots; ++i) paths.push_back("robots.red." + std::to_string(i));
  Bench bench({{"bias", 0.3}, {"offset", 2}}, paths, 0);
  bench.step();
  std::vector<Vector3> bias;
  for (std::size_t i = 0; i < kRobots; ++i) bias.push_back(bench.reading(i) - Signal::at(0));
  bench.step();
  double sum = 0, square = 0;
  std::set<double> all;
  for (std::size_t i = 0; i < kRobots; ++i) {
    EXPECT_LT(norm(bench.reading(i) - Signal::at(1) - bias[i]), 1e-12) << "it is to stay";
    for (const double b : {bias[i].x, bias[i].y, bias[i].z}) {
      sum += b - 2, square += (b - 2) * (b - 2);
      all.insert(b);
    }
  }
  constexpr double kDrawn = 3.0 * kRobots;
  EXPECT_EQ(all.size(), 3 * kRobots);
  EXPECT_NEAR(sum / kDrawn, 0, 4 * 0.3 / std::sqrt(kDrawn));
  EXPECT_NEAR(std::sqrt(square / kDrawn), 0.3, 4 * 0.3 / std::sqrt(2 * kDrawn));
}

TEST(SensorErrors, ReadingsAreTheNearestMultiplesOfTheQuantum) {
  Bench bench({{"quantum", 0.06}, {"noise", 0.1}});
  Bench exact({{"noise", 0.1}});
  for (int k = 0; k < 1000; ++k) {
    const Vector3 reading = bench.step(), value = exact.step();
    EXPECT_NEAR(reading.x / 0.06, std::round(reading.x / 0.06), 1e-9);
    EXPECT_LE(std::fabs(reading.x - value.x), 0.03 + 1e-12);
  }
}

TEST(SensorErrors, ReadingsStayWithinTheRangeInWholeQuanta) {
  Bench bench({{"range", 0.5}, {"noise", 1}});
  Bench stepped({{"range", 0.5}, {"noise", 1}, {"quantum", 0.2}});
  int ends = 0;
  for (int k = 0; k < 200; ++k) {
    const Vector3 reading = bench.step();
    EXPECT_LE(std::fabs(reading.z), 0.5);
    EXPECT_EQ(reading.y, 0.5);  // of 5
    ends += std::fabs(reading.z) == 0.5 ? 1 : 0;
    EXPECT_DOUBLE_EQ(stepped.step().y, 0.4);
  }
  EXPECT_NEAR(ends, 200 * 0.617, 30);  // beyond half a deviation
}

TEST(SensorErrors, ReadingsComeExactlySoManyStepsLater) {
  for (const int delay : {1, 2, 8, 50}) {
    Bench bench({{"delay", 1e-3 * delay}});
    for (long k = 0; k < 150; ++k) {
      ASSERT_EQ(numbersOf({bench.step()}), numbersOf({Signal::at(std::max(k - delay, 0L))})) << delay << " " << k;
    }
  }
}

TEST(SensorErrors, ADelayIsRoundedToWholeSteps) {
  Bench less({{"delay", 0.0034}}), more({{"delay", 0.0036}});
  EXPECT_DOUBLE_EQ(less.steps(20).back().x, 0.16);
  EXPECT_DOUBLE_EQ(more.steps(20).back().x, 0.15);
}

TEST(SensorErrors, SamplesAreHeldAsLongAsTheRateSays) {
  Bench bench({{"rate", 100}, {"noise", 0.1}});
  const std::vector<Vector3> readings = bench.steps(200);
  for (std::size_t k = 1; k < readings.size(); ++k) {
    EXPECT_EQ(readings[k].z != readings[k - 1].z, k % 10 == 0) << k;
  }
}

TEST(SensorErrors, ARateThatIsNoWholeNumberOfStepsHoldsOnTheAverage) {
  Bench bench({{"rate", 300}, {"noise", 0.1}});
  std::set<double> samples;
  for (const Vector3& reading : bench.steps(10'000)) samples.insert(reading.z);
  EXPECT_NEAR(static_cast<double>(samples.size()), 3000, 1);
}

TEST(SensorErrors, RateAndDelayCountStepsOfTheModule) {
  Bench bench({{"period", 0.01}, {"delay", 0.03}, {"rate", 50}});
  const std::vector<Vector3> readings = bench.steps(400);
  for (int k = 5; k < 40; ++k) {  // a step every 10 frames, a sample every second step, three steps late
    const int sampled = (k - 3) / 2 * 2;
    EXPECT_DOUBLE_EQ(readings[static_cast<std::size_t>(10 * k)].x, 0.01 * sampled) << k;
  }
}

const Parameters kAll{{"offset", 0.1}, {"bias", 0.2},    {"noise", 0.3}, {"quantum", 0.01},
                      {"range", 5},    {"delay", 0.004}, {"rate", 300}};

TEST(SensorErrors, LanesGiveTheBitsOfOneRobotAloneWhateverOthersThereAre) {
  std::vector<std::string> paths;
  for (int i = 0; i < 9; ++i) paths.push_back("robots.blue." + std::to_string(i));
  std::vector<std::vector<double>> alone;
  for (const std::string& path : paths) {
    Bench bench(kAll, {path});
    bench.steps(200);
    alone.push_back(bench.memory());
  }
  for (const int lanes : {1, 4, 8}) {
    Bench together(kAll, paths, lanes);
    together.steps(200);
    for (std::size_t i = 0; i < paths.size(); ++i) EXPECT_EQ(together.memory(i), alone[i]) << lanes << " " << i;
  }
}

TEST(SensorErrors, AreTheSameForTheSameSeedAndRobotAndOthersForOthers) {
  Bench first(kAll), again(kAll), other_seed(kAll, {"robots.red.1"}, 1, 2), other_robot(kAll, {"robots.red.2"});
  const std::vector<double> readings = numbersOf(first.steps(100));
  EXPECT_EQ(numbersOf(again.steps(100)), readings);
  EXPECT_NE(numbersOf(other_seed.steps(100)), readings);
  EXPECT_NE(numbersOf(other_robot.steps(100)), readings);
}

TEST(SensorErrors, GoOnAfterACheckpointAsIfThereHadBeenNone) {
  Bench whole(kAll), half(kAll);
  whole.steps(77);
  const std::vector<double> checkpoint = whole.memory();
  half.restore(checkpoint, 77);
  EXPECT_EQ(numbersOf(half.steps(50)), numbersOf(whole.steps(50)));
}

TEST(SensorErrors, WrongNumbersAreRefused) {
  EXPECT_NE(problemOf({{"rate", 2000}}).find("rate is 2000 samples a second; expected at most 1000, one a step of"),
            std::string::npos);
  EXPECT_NE(problemOf({{"range", 0.1}, {"quantum", 0.2}}).find("range is 0.1; expected at least one quantum of 0.2"),
            std::string::npos);
  EXPECT_NE(problemOf({{"noise", -1}}).find("noise of module gyroscope_errors is -1 rad/s; expected 0 to"),
            std::string::npos);
  EXPECT_NE(problemOf({{"delay", 2}}).find("delay of module gyroscope_errors is 2 s; expected 0 to 1"),
            std::string::npos);
  EXPECT_NE(problemOf({{"nois", 1}}).find("did you mean \"noise\""), std::string::npos);
}

}  // namespace
}  // namespace murosimf::sensing
