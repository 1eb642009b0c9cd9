#include "experiment/tailor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

namespace murosimf {

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// Of two samples of the same seeds.
double savedShare(const std::vector<double>& full, const std::vector<double>& cheaper) {
  std::vector<double> shares;
  for (std::size_t i = 0; i < std::min(full.size(), cheaper.size()); ++i)
    shares.push_back(full[i] > 0 ? 1 - cheaper[i] / full[i] : 0);
  return median(shares);
}

}  // namespace

TailorResult Tailor::run() {
  TailorResult result;
  result.choices.assign(details_.size(), 0);
  requirePlayable(play({result.choices}, settings_.first_seed, 1, "a first run").front());
  measurePrices(result);
  measureReference(result);
  descend(result);
  check(result);
  result.constant = !any_difference_ && result.reference.deviation == 0;
  return result;
}

std::vector<Tailor::Sample> Tailor::play(const std::vector<Choices>& all, std::uint64_t first_seed, int count,
                                         const std::string& purpose) {
  std::vector<RunSettings> runs;
  for (int i = 0; i < count; ++i) {
    for (const Choices& choices : all) {
      std::vector<std::string> overrides = settings_.fixed;
      for (const std::string& assignment : overridesOf(details_, choices)) overrides.push_back(assignment);
      runs.push_back({scenario_, overrides, first_seed + static_cast<std::uint64_t>(i)});
    }
  }
  std::vector<Sample> samples(all.size());
  const std::vector<RunResult> results = play_(runs, purpose);
  for (std::size_t i = 0; i < results.size(); ++i) add(results[i], samples[i % all.size()]);
  return samples;
}

void Tailor::add(const RunResult& run, Sample& sample) const {
  if (sample.failure.empty()) sample.failure = run.failure;
  sample.values.push_back(run.failure.empty() ? metric_.read(run.report) : std::nullopt);
  if (!run.failure.empty()) return;
  const double seconds = run.report.value("simulated_seconds", 0.0);
  sample.costs.push_back(seconds > 0 ? run.cpu_seconds / seconds : 0);
  if (sample.problem.empty()) sample.problem = metric_.problem(run.report);
}

std::string Tailor::nameOf(std::size_t detail, std::size_t choice) const {
  return details_[detail].path + "=" + details_[detail].choices[choice];
}

void Tailor::measureReference(TailorResult& result) {
  reference_ = play({result.choices}, settings_.first_seed, settings_.seeds, "full detail").front();
  requirePlayable(reference_);
  std::vector<double> numbers;
  bool verdicts = false;
  for (const std::optional<MetricValue>& value : reference_.values) {
    if (value) numbers.push_back(value->number);
    verdicts = verdicts || (value && value->is_truth);
  }
  if (numbers.size() < 2)
    throw std::runtime_error(fmt::format("full detail measured \"{}\" in {} of {} runs, expected 2 at least",
                                         metric_.text(), numbers.size(), settings_.seeds));
  result.reference =
      verdicts ? estimateRate(numbers, settings_.test.confidence) : estimateMean(numbers, settings_.test.confidence);
}

void Tailor::measurePrices(TailorResult& result) {
  std::vector<Choices> alone(1, result.choices);
  for (std::size_t d = 0; d < details_.size(); ++d) {
    for (std::size_t c = 1; c < details_[d].choices.size(); ++c) {
      alone.push_back(result.choices);
      alone.back()[d] = c;
    }
  }
  const int seeds = std::min(settings_.price_seeds, settings_.seeds);
  const std::vector<Sample> samples = play(alone, settings_.first_seed, seeds, "prices");
  requirePlayable(samples.front());
  std::size_t next = 1;
  for (const Detail& detail : details_) {
    std::vector<double>& saved = result.saved.emplace_back(1, 0.0);
    for (std::size_t c = 1; c < detail.choices.size(); ++c, ++next)
      saved.push_back(samples[next].failure.empty() ? savedShare(samples.front().costs, samples[next].costs) : kNaN);
  }
  // What cannot be played alone may be played later; nobody knows what it saves, so it comes last.
  const auto saving = [&](std::size_t d) {
    return std::isfinite(result.saved[d].back()) ? result.saved[d].back() : -std::numeric_limits<double>::infinity();
  };
  result.order.resize(details_.size());
  std::iota(result.order.begin(), result.order.end(), std::size_t{0});
  std::stable_sort(result.order.begin(), result.order.end(),
                   [&](std::size_t a, std::size_t b) { return saving(a) > saving(b); });
}

void Tailor::requirePlayable(const Sample& sample) const {
  if (!sample.failure.empty())
    throw std::runtime_error(fmt::format("full detail cannot be played: {}", sample.failure));
  if (!sample.problem.empty()) throw std::runtime_error(sample.problem);
  const bool verdicts = std::any_of(sample.values.begin(), sample.values.end(),
                                    [](const std::optional<MetricValue>& value) { return value && value->is_truth; });
  const double least = settings_.test.leastTolerance(settings_.seeds);
  if (verdicts && settings_.test.tolerance <= least)
    throw std::runtime_error(
        fmt::format("with {} seeds verdicts that all agree still leave a difference of {:.3f} open, expected a "
                    "tolerance above that, or more seeds",
                    settings_.seeds, least));
}

void Tailor::descend(TailorResult& result) {
  std::vector<std::size_t> waiting = result.order;
  for (bool changed = true; changed && !waiting.empty();) {
    changed = false;
    std::vector<std::size_t> impossible;
    for (const std::size_t detail : waiting) changed = tryChoices(detail, result, impossible) || changed;
    waiting = impossible;
  }
}

/// From the cheapest choice up to the one that stands. @return whether one was taken
bool Tailor::tryChoices(std::size_t detail, TailorResult& result, std::vector<std::size_t>& impossible) {
  if (!isMeant(details_, result.choices, detail)) return false;
  bool failed = false;
  for (std::size_t choice = details_[detail].choices.size(); --choice > result.choices[detail];) {
    if (result.saved[detail][choice] < kLeastSaving) continue;  // but not where it is unknown
    result.trials.push_back(tryChoice(detail, choice, result));
    failed = failed || !result.trials.back().failure.empty();
    if (!result.trials.back().taken) continue;
    result.choices[detail] = choice;
    return true;
  }
  if (failed) impossible.push_back(detail);
  return false;
}

TailorTrial Tailor::tryChoice(std::size_t detail, std::size_t choice, const TailorResult& result) {
  TailorTrial trial;
  trial.detail = detail;
  trial.choice = choice;
  Choices choices = result.choices;
  choices[detail] = choice;
  const int quarter = std::max(2, (settings_.seeds + 3) / 4);
  for (const int seeds : {std::min(quarter, settings_.seeds), settings_.seeds}) {
    const Sample sample = play({choices}, settings_.first_seed, seeds, "trying " + nameOf(detail, choice)).front();
    trial.seeds = seeds;
    trial.failure = sample.failure;
    if (!trial.failure.empty()) return trial;
    trial.effect = settings_.test.compare(reference_.values, sample.values);
    any_difference_ = any_difference_ || trial.effect.difference.mean != 0 || trial.effect.difference.deviation != 0;
    if (trial.effect.different || trial.effect.unmatched > 0) return trial;
  }
  trial.taken = trial.effect.equivalent;
  return trial;
}

void Tailor::check(TailorResult& result) {
  const std::uint64_t fresh = settings_.first_seed + static_cast<std::uint64_t>(settings_.seeds);
  const Choices all_full(details_.size(), 0);
  const std::vector<Sample> samples = play({all_full, result.choices}, fresh, settings_.seeds, "check on fresh seeds");
  const Sample &full = samples[0], &tailored = samples[1];
  for (const Sample& sample : samples)
    if (!sample.failure.empty()) throw std::runtime_error(fmt::format("the check failed: {}", sample.failure));
  result.check = settings_.test.compare(full.values, tailored.values);
  any_difference_ = any_difference_ || result.check.difference.mean != 0;
  result.reference_cost = median(full.costs);
  result.tailored_cost = (1 - savedShare(full.costs, tailored.costs)) * result.reference_cost;
}

}  // namespace murosimf
