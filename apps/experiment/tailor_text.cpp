#include "experiment/tailor_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace murosimf {

namespace {

using Json = nlohmann::ordered_json;

Json jsonNumber(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

std::string effectText(const Estimate& e) {
  if (e.size == 0) return "";
  return fmt::format("{:+.3g} [{:+.3g}, {:+.3g}]", e.mean, e.interval.low, e.interval.high);
}

class TailorWriter {
 public:
  TailorWriter(const TailorQuestion& question, const std::vector<Detail>& details, const TailorResult& result)
      : question_(question), details_(details), result_(result) {}

  std::string text() const {
    std::string out = fmt::format(
        "Full detail: {0} = {1:.4g} over {2} seeds.\n\n"
        "| detail | cheaper | saves alone | effect on {0} | the detail is |\n|---|---|---:|---|---|\n",
        question_.metric, result_.reference.mean, result_.reference.size);
    for (const std::size_t d : result_.order)
      for (std::size_t c = details_[d].choices.size(); --c > 0;) out += row(d, c);
    return out +
           fmt::format(
               "\nEffects are against full detail, together with what was dropped before, with intervals "
               "of {:.4g} %;\na detail is dropped where they lie within +-{:.4g}.\n",
               100 * (2 * question_.test.confidence - 1), question_.test.tolerance) +
           conclusion();
  }

  Json json() const {
    Json out = {{"scenario", question_.scenario},
                {"metric", question_.metric},
                {"tolerance", question_.test.tolerance},
                {"confidence", question_.test.confidence},
                {"seeds", question_.seeds},
                {"reference", jsonNumber(result_.reference.mean)},
                {"reference_cost", result_.reference_cost},
                {"tailored_cost", result_.tailored_cost},
                {"constant", result_.constant},
                {"check", comparisonJson(result_.check)},
                {"set", overridesOf(details_, result_.choices)},
                {"details", Json::array()}};
    for (const std::size_t d : result_.order) out["details"].push_back(detailJson(d));
    return out;
  }

 private:
  const TailorTrial* lastTrial(std::size_t detail, std::size_t choice) const {
    const auto at = std::find_if(result_.trials.rbegin(), result_.trials.rend(),
                                 [&](const TailorTrial& t) { return t.detail == detail && t.choice == choice; });
    return at == result_.trials.rend() ? nullptr : &*at;
  }

  std::string outcome(std::size_t d, std::size_t c) const {
    const TailorTrial* trial = lastTrial(d, c);
    if (trial == nullptr) {
      if (result_.choices[d] > c) return "not asked: a cheaper choice was taken";
      if (!isMeant(details_, result_.choices, d)) return "not asked: it went with what it belongs to";
      return "kept: that saves nothing";
    }
    if (trial->taken) return provesLittle(*trial) ? "dropped: no seed changed it" : "dropped";
    if (!trial->failure.empty()) return "kept: cannot be played: " + firstLine(trial->failure);
    if (trial->effect.unmatched > 0)
      return fmt::format("kept: {} of {} runs measured nothing", trial->effect.unmatched, trial->seeds);
    if (trial->effect.different) return fmt::format("kept: it matters ({} seeds)", trial->seeds);
    return fmt::format("kept: it may matter ({} seeds)", trial->seeds);
  }

  /// Equal differences of numbers leave their interval without a width, however few the seeds.
  static bool provesLittle(const TailorTrial& trial) {
    return trial.effect.difference.interval.low == trial.effect.difference.interval.high;
  }

  static std::string firstLine(const std::string& text) { return text.substr(0, text.find('\n')); }

  std::string row(std::size_t d, std::size_t c) const {
    const double share = result_.saved[d][c];
    const TailorTrial* trial = lastTrial(d, c);
    return fmt::format("| {} = {} | {} | {} | {} | {} |\n", details_[d].path, details_[d].choices[0],
                       details_[d].choices[c], std::isfinite(share) ? fmt::format("{:.1f} %", 100 * share) : "",
                       trial == nullptr ? "" : effectText(trial->effect.difference), outcome(d, c));
  }

  std::string conclusion() const {
    const double share = result_.reference_cost > 0 ? 1 - result_.tailored_cost / result_.reference_cost : 0;
    std::string out = fmt::format(
        "\nOn {} fresh seeds: {:.3g} ms of processor time a simulated second in the place of {:.3g} ms ({:.1f} % "
        "saved).\n"
        "Effect {}: {}\n",
        result_.check.difference.size, 1e3 * result_.tailored_cost, 1e3 * result_.reference_cost, 100 * share,
        effectText(result_.check.difference),
        result_.check.equivalent
            ? "it holds."
            : "it does not hold there. More seeds tell more; a smaller tolerance keeps more detail.");
    if (result_.constant)
      out += fmt::format("warning: {} was the same in every run: it cannot tell one level of detail from another\n",
                         question_.metric);
    else if (std::any_of(result_.trials.begin(), result_.trials.end(),
                         [](const TailorTrial& t) { return t.taken && provesLittle(t); }))
      out += fmt::format(
          "warning: of some choices no seed changed {}, a number: {} seeds prove little then, and their interval does "
          "not show it; a verdict, true or false or a text with ==, has one that does\n",
          question_.metric, question_.seeds);
    out += "\n";
    for (const std::string& assignment : overridesOf(details_, result_.choices)) out += "--set " + assignment + "\n";
    return out;
  }

  static Json comparisonJson(const Comparison& comparison) {
    return {{"n", comparison.difference.size},
            {"difference", jsonNumber(comparison.difference.mean)},
            {"low", jsonNumber(comparison.difference.interval.low)},
            {"high", jsonNumber(comparison.difference.interval.high)},
            {"equivalent", comparison.equivalent}};
  }

  Json detailJson(std::size_t d) const {
    Json out = {{"detail", details_[d].path},
                {"full", details_[d].choices[0]},
                {"chosen", details_[d].choices[result_.choices[d]]},
                {"choices", Json::array()}};
    for (std::size_t c = 1; c < details_[d].choices.size(); ++c) {
      Json one = {{"choice", details_[d].choices[c]},
                  {"saved_share_alone", jsonNumber(result_.saved[d][c])},
                  {"outcome", outcome(d, c)}};
      if (const TailorTrial* trial = lastTrial(d, c)) one["effect"] = comparisonJson(trial->effect);
      out["choices"].push_back(std::move(one));
    }
    return out;
  }

  const TailorQuestion& question_;
  const std::vector<Detail>& details_;
  const TailorResult& result_;
};

}  // namespace

std::string tailorText(const TailorQuestion& question, const std::vector<Detail>& details, const TailorResult& result) {
  return TailorWriter(question, details, result).text();
}

std::string tailorJson(const TailorQuestion& question, const std::vector<Detail>& details, const TailorResult& result) {
  return TailorWriter(question, details, result).json().dump(2) + "\n";
}

}  // namespace murosimf
