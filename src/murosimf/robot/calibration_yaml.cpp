#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>

#include "murosimf/robot/calibration_parts.h"
#include "murosimf/robot/checks.h"
#include "murosimf/robot/xml_element.h"

namespace murosimf::calibration {
namespace {

using Names = std::vector<std::string>;
const Names kMatrix{"camera_matrix", "K", "k", "cameraMatrix"};
const Names kDistortion{"distortion_coefficients", "D", "d", "distCoeffs", "dist_coeffs"};
const Names kWidth{"image_width", "width"}, kHeight{"image_height", "height"};
const Names kModel{"distortion_model"};

/// OpenCV begins with "%YAML:1.0", which is no directive of YAML: lines that begin with % become comments.
std::string withoutDirectives(std::string text) {
  bool line_begins = true;
  for (char& c : text) {
    if (line_begins && c == '%') c = '#';
    line_begins = c == '\n';
  }
  return text;
}

class Reader {
 public:
  Reader(const std::string& file, Diagnostics& diagnostics) : file_(file), diagnostics_(diagnostics) {}

  Parts read(const std::string& text) {
    Parts parts;
    YAML::Node root;
    try {
      root = YAML::Load(withoutDirectives(text));
    } catch (const YAML::Exception& fault) {
      diagnostics_.error(place(fault.mark), "not YAML: " + quoted(fault.msg));
      return parts;
    }
    if (!root.IsMap()) {
      diagnostics_.error({file_, 1, 0}, "holds no table of keys, expected camera_matrix and distortion_coefficients");
      return parts;
    }
    for (const auto& entry : root) {
      if (entry.first.IsScalar()) keys_.push_back(entry.first.Scalar());
    }
    parts.matrix = numbers(root, kMatrix, "9 numbers, row by row");
    parts.distortion = numbers(root, kDistortion, "numbers");
    parts.width = number(root, kWidth), parts.height = number(root, kHeight);
    parts.model = model(root);
    refuseSections(root);
    return parts;
  }

 private:
  SourceLocation place(const YAML::Mark& mark) const {
    return mark.is_null() ? SourceLocation{file_, 0, 0} : SourceLocation{file_, mark.line + 1, mark.column + 1};
  }
  void error(const YAML::Node& node, const std::string& name, const std::string& expected) {
    const std::string found = node.IsScalar() ? quoted(node.Scalar()) : node.IsMap() ? "a table" : "a list";
    diagnostics_.error(place(node.Mark()), fmt::format("{} is {}, expected {}", name, found, expected));
  }

  /// The first of the names that the file has.
  std::optional<std::string> nameOf(const Names& names) const {
    for (const std::string& name : names) {
      if (std::find(keys_.begin(), keys_.end(), name) != keys_.end()) return name;
    }
    return std::nullopt;
  }

  std::optional<Numbers> numbers(const YAML::Node& root, const Names& names, const std::string& expected) {
    const std::optional<std::string> name = nameOf(names);
    if (!name) {
      diagnostics_.error({file_, 0, 0}, fmt::format("{} is missing, expected {}{}", names.front(), expected,
                                                    didYouMean(names.front(), keys_)));
      return std::nullopt;
    }
    const YAML::Node value = root[*name], list = value.IsMap() ? value["data"] : value;
    Numbers out{*name, {}, place(value.Mark())};
    if (!list || !list.IsSequence()) {
      error(value, *name, expected + ", or rows, cols and data");
      return std::nullopt;
    }
    for (const YAML::Node& item : list) {  // numbers, or rows of them
      const bool good = item.IsSequence() ? appendRow(item, out, expected) : append(item, out, expected);
      if (!good) return std::nullopt;
    }
    const bool fits = !value.IsMap() || sizeFits(value, out);
    return fits ? std::optional(out) : std::nullopt;
  }

  bool append(const YAML::Node& item, Numbers& out, const std::string& expected) {
    const std::optional<double> x = item.IsScalar() ? parseNumber(item.Scalar()) : std::nullopt;
    if (x) out.values.push_back(*x);
    if (!x) error(item, "a number of " + out.name, expected);
    return x.has_value();
  }
  bool appendRow(const YAML::Node& row, Numbers& out, const std::string& expected) {
    return std::all_of(row.begin(), row.end(), [&](const YAML::Node& item) { return append(item, out, expected); });
  }

  bool sizeFits(const YAML::Node& value, const Numbers& read) {
    const auto of = [&](const char* key) {
      const YAML::Node node = value[key];
      return node && node.IsScalar() ? parseNumber(node.Scalar()).value_or(-1) : -1;
    };
    const double rows = of("rows"), columns = of("cols");
    if (rows * columns == static_cast<double>(read.values.size())) return true;
    diagnostics_.error(
        read.where, fmt::format("{} has {} numbers, expected rows times cols of them", read.name, read.values.size()));
    return false;
  }

  std::optional<Numbers> number(const YAML::Node& root, const Names& names) {
    const std::optional<std::string> name = nameOf(names);
    if (!name) return std::nullopt;
    const YAML::Node value = root[*name];
    const std::optional<double> x = value.IsScalar() ? parseNumber(value.Scalar()) : std::nullopt;
    if (x) return Numbers{*name, {*x}, place(value.Mark())};
    error(value, *name, "a number");
    return std::nullopt;
  }

  /// ROS's distortion_model, or fisheye_model as OpenCV's program of calibration writes it.
  std::optional<Word> model(const YAML::Node& root) {
    if (const std::optional<std::string> name = nameOf(kModel)) {
      const YAML::Node value = root[*name];
      if (value.IsScalar()) return Word{*name, value.Scalar(), place(value.Mark())};
      error(value, *name, "the name of a model");
      return std::nullopt;
    }
    const std::optional<Numbers> fisheye = number(root, {"fisheye_model"});
    if (!fisheye || fisheye->values.front() == 0.0) return std::nullopt;
    return Word{fisheye->name, "fisheye", fisheye->where};
  }

  /// ROS tells here that pictures are a part of the sensor, or several of its pixels in one: K is not theirs then.
  void refuseSections(const YAML::Node& root) {
    for (const char* key : {"binning_x", "binning_y"}) {
      const std::optional<Numbers> binning = number(root, {key});
      if (binning && binning->values.front() > 1.0)
        diagnostics_.error(binning->where, fmt::format("{} is {:g}, expected 0 or 1: a calibration of the picture that "
                                                       "the camera delivers",
                                                       key, binning->values.front()));
    }
  }

  const std::string& file_;
  Diagnostics& diagnostics_;
  Names keys_;
};

}  // namespace

Parts readYaml(const std::string& text, const std::string& file, Diagnostics& diagnostics) {
  return Reader(file, diagnostics).read(text);
}

}  // namespace murosimf::calibration
