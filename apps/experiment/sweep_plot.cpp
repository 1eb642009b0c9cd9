#include "experiment/sweep_plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "experiment/plot_scale.h"

namespace murosimf {

namespace {

constexpr double kWidth = 760, kLeft = 250, kRight = 730, kRow = 22, kHead = 34, kFoot = 44;
constexpr double kLineHeight = 240, kLegend = 18;
/// Told apart by people who do not see all colours [Okabe & Ito 2008].
const char* const kColours[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"};

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c);
  return out;
}

std::optional<double> numberOf(const std::string& label) {
  double value = 0;
  const auto [end, failed] = std::from_chars(label.data(), label.data() + label.size(), value);
  if (failed != std::errc{} || end != label.data() + label.size()) return std::nullopt;
  return value;
}

/// Ends of the interval, or the mean twice where there is none.
Interval spanOf(const Estimate& e) { return std::isfinite(e.interval.low) ? e.interval : Interval{e.mean, e.mean}; }

Interval spanOf(const SweepTable& table, std::size_t metric) {
  Interval all{INFINITY, -INFINITY};
  for (const SweepRow& row : table.rows) {
    const Estimate& e = row.cells[metric].estimate;
    if (e.size == 0) continue;
    all.low = std::min(all.low, spanOf(e).low);
    all.high = std::max(all.high, spanOf(e).high);
  }
  return all;
}

class PlotWriter {
 public:
  PlotWriter(const SweepPlan& plan, const SweepTable& table) : plan_(plan), table_(table), x_axis_(findNumericAxis()) {}

  std::string write() {
    for (std::size_t m = 0; m < plan_.metrics.size(); ++m) {
      text(kLeft, top_ + 20, "start", plan_.metrics[m]->text(), "font-weight=\"bold\"");
      const Interval span = spanOf(table_, m);
      if (!(span.low <= span.high)) {
        text(kLeft, top_ + 42, "start", "nothing was measured");
        top_ += 60;
      } else {
        x_axis_ ? drawLines(m, span) : drawRows(m, span);
      }
    }
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:g}\" height=\"{1:g}\" viewBox=\"0 0 {0:g} {1:g}\" "
               "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
               kWidth, top_ + 4) +
           body_ + "</svg>\n";
  }

 private:
  std::optional<std::size_t> findNumericAxis() const {
    for (std::size_t axis = plan_.axes.size(); axis-- > 0;) {
      const bool all = std::all_of(table_.rows.begin(), table_.rows.end(),
                                   [&](const SweepRow& row) { return numberOf(row.labels[axis]).has_value(); });
      if (all && table_.rows.front().labels[axis] != table_.rows.back().labels[axis]) return axis;
    }
    return std::nullopt;
  }

  void text(double x, double y, const char* anchor, const std::string& words, const std::string& more = "") {
    body_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\"{}{}>{}</text>\n", x, y, anchor,
                         more.empty() ? "" : " ", more, escaped(words));
  }

  void line(double x1, double y1, double x2, double y2, const char* colour, double width = 1) {
    body_ += fmt::format(
        "<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"{}\" "
        "stroke-width=\"{:g}\"/>\n",
        x1, y1, x2, y2, colour, width);
  }

  void dot(double x, double y, const char* colour) {
    body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\" fill=\"{}\"/>\n", x, y, colour);
  }

  void drawAcross(const PlotScale& x, double top, double bottom) {
    for (const double tick : x.ticks()) {
      line(x.pixel(tick), top, x.pixel(tick), bottom, "#dddddd");
      text(x.pixel(tick), bottom + 16, "middle", x.text(tick));
    }
  }

  void drawRows(std::size_t metric, const Interval& span) {
    const double top = top_ + kHead, bottom = top + kRow * static_cast<double>(table_.rows.size());
    const PlotScale x(span.low, span.high, kLeft, kRight);
    drawAcross(x, top, bottom);
    double y = top + kRow / 2;
    for (std::size_t c = 0; c < table_.rows.size(); ++c, y += kRow) {
      const Estimate& e = table_.rows[c].cells[metric].estimate;
      text(kLeft - 10, y + 4, "end", plan_.cases[c].name());
      if (e.size == 0) continue;
      line(x.pixel(spanOf(e).low), y, x.pixel(spanOf(e).high), y, kColours[0], 2);
      dot(x.pixel(e.mean), y, kColours[0]);
    }
    top_ = bottom + kFoot;
  }

  /// What the other axes say, in the order of the table's rows.
  std::vector<std::string> seriesNames() const {
    std::vector<std::string> names;
    for (const SweepRow& row : table_.rows) {
      std::vector<std::string> labels = row.labels;
      labels.erase(labels.begin() + static_cast<std::ptrdiff_t>(*x_axis_));
      names.push_back(fmt::format("{}", fmt::join(labels, ", ")));
    }
    return names;
  }

  void drawLines(std::size_t metric, const Interval& span) {
    Interval across{INFINITY, -INFINITY};
    for (const SweepRow& row : table_.rows) {
      across.low = std::min(across.low, *numberOf(row.labels[*x_axis_]));
      across.high = std::max(across.high, *numberOf(row.labels[*x_axis_]));
    }
    const double top = top_ + kHead, bottom = top + kLineHeight;
    const PlotScale x(across.low, across.high, kLeft, kRight), y(span.low, span.high, bottom, top);
    drawAcross(x, top, bottom);
    for (const double tick : y.ticks()) {
      line(kLeft, y.pixel(tick), kRight, y.pixel(tick), "#dddddd");
      text(kLeft - 8, y.pixel(tick) + 4, "end", y.text(tick));
    }
    text((kLeft + kRight) / 2, bottom + 34, "middle", plan_.axes[*x_axis_]);
    drawSeries(metric, x, y, top);
    top_ = bottom + kFoot + 6;
  }

  void drawSeries(std::size_t metric, const PlotScale& x, const PlotScale& y, double top) {
    const std::vector<std::string> names = seriesNames();
    std::vector<std::string> known;
    std::map<std::string, std::vector<std::size_t>> rows;
    for (std::size_t c = 0; c < names.size(); ++c) {
      if (rows.find(names[c]) == rows.end()) known.push_back(names[c]);
      rows[names[c]].push_back(c);
    }
    for (std::size_t i = 0; i < known.size(); ++i) {
      const char* colour = kColours[i % std::size(kColours)];
      const double y_legend = top + 12 + kLegend * static_cast<double>(i);
      if (known.size() > 1) {
        dot(14, y_legend - 4, colour);
        text(24, y_legend, "start", known[i]);
      }
      std::vector<std::size_t>& members = rows[known[i]];
      const auto place = [&](std::size_t c) { return *numberOf(table_.rows[c].labels[*x_axis_]); };
      std::stable_sort(members.begin(), members.end(),
                       [&](std::size_t a, std::size_t b) { return place(a) < place(b); });
      drawOneSeries(metric, members, x, y, colour);
    }
  }

  void drawOneSeries(std::size_t metric, const std::vector<std::size_t>& members, const PlotScale& x,
                     const PlotScale& y, const char* colour) {
    std::optional<std::pair<double, double>> last;
    for (const std::size_t c : members) {
      const Estimate& e = table_.rows[c].cells[metric].estimate;
      if (e.size == 0) continue;
      const double px = x.pixel(*numberOf(table_.rows[c].labels[*x_axis_])), py = y.pixel(e.mean);
      if (last) line(last->first, last->second, px, py, colour);
      line(px, y.pixel(spanOf(e).low), px, y.pixel(spanOf(e).high), colour, 2);
      dot(px, py, colour);
      last = {px, py};
    }
  }

  const SweepPlan& plan_;
  const SweepTable& table_;
  std::optional<std::size_t> x_axis_;
  double top_ = 4;
  std::string body_;
};

}  // namespace

std::string sweepPlot(const SweepPlan& plan, const SweepTable& table) { return PlotWriter(plan, table).write(); }

}  // namespace murosimf
