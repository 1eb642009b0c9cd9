#include "murosimf/simulation/comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "murosimf/simulation/recording_reader.h"

namespace murosimf {

namespace {

using ColumnPair = std::pair<const RecordedColumn*, const RecordedColumn*>;

/// Walks two recordings side by side.
class Walk {
 public:
  Walk(const std::filesystem::path& a, const std::filesystem::path& b) : a_(a), b_(b) {}
  Comparison run();

 private:
  void compareHeaders();
  void pairColumns();
  const RecordedColumn* partnerOf(const RecordedColumn& column, const RecordingHeader& in,
                                  const RecordingHeader& of) const;
  bool advance();
  void compareInterventions();
  void compareState();
  void note(std::string words) { result_.notes.push_back(std::move(words)), result_.equal = false; }

  RecordingReader a_, b_;
  std::vector<ColumnPair> pairs_;
  Comparison result_;
  long frames_ = 0;
  bool interventions_differ_ = false;
};

Comparison Walk::run() {
  compareHeaders();
  pairColumns();
  while (!result_.first && advance()) {
    ++frames_;
    if (!interventions_differ_) compareInterventions();
    compareState();
  }
  result_.compared = fmt::format("{} frames", frames_);
  return std::move(result_);
}

void Walk::compareHeaders() {
  const RecordingHeader &a = a_.header(), &b = b_.header();
  if (a.scenario != b.scenario) {  // for people: another name is no other run
    result_.notes.push_back(fmt::format("scenarios {} and {}", a.scenario, b.scenario));
  }
  if (a.seed != b.seed) note(fmt::format("seeds {} and {}", a.seed, b.seed));
  if (a.frame_length != b.frame_length) note(fmt::format("frames of {} s and {} s", a.frame_length, b.frame_length));
  if (a.first_frame != b.first_frame) {  // one may go on from a checkpoint
    result_.notes.push_back(fmt::format("they begin with frames {} and {}: compared from frame {} on", a.first_frame,
                                        b.first_frame, std::max(a.first_frame, b.first_frame)));
  }
}

const RecordedColumn* Walk::partnerOf(const RecordedColumn& column, const RecordingHeader& in,
                                      const RecordingHeader& of) const {
  const RecordedGroup& group = in.groupOf(column);
  for (const RecordedColumn& other : of.columns) {
    const RecordedGroup& g = of.groupOf(other);
    if (other.property == column.property && g.assembly == group.assembly && g.subset == group.subset &&
        other.components == column.components && g.members == group.members) {
      return &other;
    }
  }
  return nullptr;
}

void Walk::pairColumns() {
  const auto name = [](const RecordingHeader& header, const RecordedColumn& column) {
    const RecordedGroup& group = header.groupOf(column);
    return fmt::format("{} of {} {} ({} x {})", column.property, group.assembly, group.subset, group.members.size(),
                       column.components);
  };
  for (const RecordedColumn& column : a_.header().columns) {
    const RecordedColumn* partner = partnerOf(column, a_.header(), b_.header());
    if (partner != nullptr) pairs_.emplace_back(&column, partner);
    if (partner == nullptr) note("only the first has " + name(a_.header(), column));
  }
  for (const RecordedColumn& column : b_.header().columns) {
    if (partnerOf(column, b_.header(), a_.header()) == nullptr) {
      note("only the second has " + name(b_.header(), column));
    }
  }
}

/// Goes on to the next frame that both have. Notes when one ends before the other.
bool Walk::advance() {
  bool more_a = a_.next(), more_b = b_.next();
  while (more_a && more_b && a_.frame() < b_.frame()) more_a = a_.next();
  while (more_a && more_b && b_.frame() < a_.frame()) more_b = b_.next();
  if (more_a && more_b) return true;
  if (more_a || more_b) {
    const RecordingReader& shorter = more_a ? b_ : a_;
    note(fmt::format("the {} ends after frame {} (t = {:.3f} s), the other one goes on", more_a ? "second" : "first",
                     shorter.frame(), shorter.time()));
  }
  const bool ended[] = {more_a || a_.complete(), more_b || b_.complete()};
  if (!ended[0]) note("the first was cut off: it lacks its end");
  if (!ended[1]) note("the second was cut off: it lacks its end");
  return false;
}

void Walk::compareInterventions() {
  const auto &a = a_.interventions(), &b = b_.interventions();
  interventions_differ_ = a != b;
  if (!interventions_differ_) return;
  std::size_t i = 0;
  while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
  const auto words = [&](const std::vector<RecordedIntervention>& list) {
    if (i >= list.size()) return std::string("none");
    const RecordedIntervention& act = list[i];
    return fmt::format("{} put at ({}, {}), heading {}, height {}", act.object, act.pose.x, act.pose.y,
                       act.pose.heading, act.height);
  };
  note(fmt::format("interventions differ first in frame {}: {}; {}", a_.frame(), words(a), words(b)));
}

void Walk::compareState() {
  for (const auto& [column_a, column_b] : pairs_) {
    const std::span<const double> a = a_.numbers(*column_a), b = b_.numbers(*column_b);
    if (std::memcmp(a.data(), b.data(), a.size_bytes()) == 0) continue;
    for (std::size_t i = 0; i < a.size(); ++i) {
      if (std::memcmp(&a[i], &b[i], sizeof(double)) == 0) continue;
      if (result_.first) {
        ++result_.first->others;
        continue;
      }
      const RecordedGroup& group = a_.header().groupOf(*column_a);
      StateDifference& d = result_.first.emplace();
      d.frame = a_.frame();
      d.time = a_.time();
      d.object = group.members[i / column_a->components];
      d.assembly = group.assembly;
      d.property = column_a->property;
      d.unit = column_a->unit;
      d.component = static_cast<std::uint32_t>(i % column_a->components);
      d.components = column_a->components;
      d.a = a[i], d.b = b[i];
    }
  }
  if (result_.first) result_.equal = false;
}

}  // namespace

Comparison compareRecordings(const std::filesystem::path& a, const std::filesystem::path& b) {
  return Walk(a, b).run();
}

std::string Comparison::text(const std::string& name_a, const std::string& name_b) const {
  std::string out = fmt::format("first:  {}\nsecond: {}\n", name_a, name_b);
  if (first) {
    const std::string of =
        first->components > 1 ? fmt::format(" ({} of {})", first->component + 1, first->components) : "";
    out += fmt::format("They differ first after frame {} (t = {:.3f} s) in {}, {}{} [{}]:\n", first->frame, first->time,
                       first->object, first->property, of, first->unit);
    out += fmt::format("  first   {:.17g}\n  second  {:.17g}\n", first->a, first->b);
    if (first->others > 0) out += fmt::format("  and {} more numbers in that frame\n", first->others);
  } else if (equal) {
    out += fmt::format("The runs are the same, to the last bit ({} compared).\n", compared);
  } else {
    out += fmt::format("The runs differ ({} compared).\n", compared);
  }
  for (const std::string& words : notes) out += "  " + words + "\n";
  return out;
}

}  // namespace murosimf
