#pragma once

/// @file Finds the cheapest level of detail that leaves a metric unchanged, by experiment.
///
/// 1. One run at full detail: a metric that it does not have is told before anything else is played. Then each cheaper
///    choice of each detail is played alone with a few seeds: its price, the processor time that it saves. A seed's
///    games are played one after the other, full detail first, and compared with each other: what else the machine does
///    then weighs about the same on all of them.
/// 2. Full detail is played with all seeds: the reference.
/// 3. From the reference down: in the order of what they save, each detail gets the cheapest choice with which the
///    metric stays equivalent to the reference's, together with all that was made cheaper before; else it stays as it
///    was. What is plainly different after a quarter of the seeds is not played further. A choice that could not be
///    played is tried again at the end: what it lacked may be gone by then.
/// 4. What was found is compared with full detail on seeds that had no part in the choice.
/// Cost: at most (details x choices) x (seeds + price_seeds) runs.

#include <functional>
#include <string>
#include <vector>

#include "experiment/details.h"
#include "experiment/equivalence.h"
#include "experiment/result_store.h"

namespace murosimf {

struct TailorSettings {
  std::vector<std::string> fixed;  ///< overrides of all runs, PATH=VALUE
  std::uint64_t first_seed = 1;
  int seeds = 20;       ///< as many again check the result
  int price_seeds = 5;  ///< at most `seeds`
  EquivalenceTest test;
};

/// What became of one choice that was tried.
struct TailorTrial {
  std::size_t detail = 0, choice = 0;
  Comparison effect;    ///< on the metric, of this and all that was dropped before, against full detail
  long seeds = 0;       ///< played
  std::string failure;  ///< why it cannot be played; empty: it can
  bool taken = false;
};

struct TailorResult {
  Choices choices;
  double reference_cost = 0, tailored_cost = 0;  ///< on fresh seeds, median: processor time a simulated second [1]
  /// [detail][choice]: share of full detail's processor time that this choice saves alone, the median over the seeds; 0
  /// of choice 0, NaN where it cannot be played alone.
  std::vector<std::vector<double>> saved;
  std::vector<std::size_t> order;   ///< details by what their cheapest choice saves
  std::vector<TailorTrial> trials;  ///< in their order
  Comparison check;                 ///< on fresh seeds
  Estimate reference;               ///< the metric at full detail
  bool constant = false;            ///< the metric was the same in every run: it tells nothing
};

/// Choices that save less than this share of the processor time are not tried: it is within the error of the
/// measurement.
inline constexpr double kLeastSaving = 0.01;

/// Results of runs, in their order. It may throw to end the search.
using PlayMany =
    std::function<std::vector<RunResult>(const std::vector<RunSettings>& runs, const std::string& purpose)>;

class Tailor {
 public:
  Tailor(std::filesystem::path scenario, std::vector<Detail> details, Metric metric, TailorSettings settings,
         PlayMany play)
      : scenario_(std::move(scenario)),
        details_(std::move(details)),
        metric_(std::move(metric)),
        settings_(std::move(settings)),
        play_(std::move(play)) {}

  /// @throws std::runtime_error where full detail cannot be played or does not measure the metric
  TailorResult run();

 private:
  struct Sample {
    Measurements values;
    std::vector<double> costs;  // a seed each [1]
    std::string failure;
    std::string problem;  // why reports lack the metric
  };
  /// One sample for each of the lists of choices; all of them play a seed before the next one is begun.
  std::vector<Sample> play(const std::vector<Choices>& all, std::uint64_t first_seed, int count,
                           const std::string& purpose);
  void add(const RunResult& run, Sample& sample) const;
  void requirePlayable(const Sample& sample) const;
  std::string nameOf(std::size_t detail, std::size_t choice) const;
  void measurePrices(TailorResult& result);
  void measureReference(TailorResult& result);
  bool tryChoices(std::size_t detail, TailorResult& result, std::vector<std::size_t>& impossible);
  TailorTrial tryChoice(std::size_t detail, std::size_t choice, const TailorResult& result);
  void descend(TailorResult& result);
  void check(TailorResult& result);

  std::filesystem::path scenario_;
  std::vector<Detail> details_;
  Metric metric_;
  TailorSettings settings_;
  PlayMany play_;
  Sample reference_;
  bool any_difference_ = false;
};

}  // namespace murosimf
