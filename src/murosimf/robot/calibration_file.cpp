#include "murosimf/robot/calibration_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "murosimf/robot/calibration_parts.h"
#include "murosimf/robot/checks.h"

namespace murosimf {
namespace {

using calibration::Numbers;
using calibration::Parts;

constexpr std::size_t kLargestFile = 1U << 20U;
constexpr double kLargestPicture = 8192;

/// Counts of numbers that a model may have, and the words for them.
struct ModelOfLens {
  const char* name;
  LensKind kind;
  std::vector<std::size_t> counts;
  const char* expected;
};
const std::vector<ModelOfLens> kModels{
    {"plumb_bob", LensKind::kRational, {0, 4, 5}, "4 or 5: k1 k2 p1 p2 k3"},
    {"rational", LensKind::kRational, {8, 12, 14}, "8 or 12: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4"},
    {"rational_polynomial", LensKind::kRational, {8, 12, 14}, "8 or 12: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4"},
    {"fisheye", LensKind::kFisheye, {4}, "4: k1 k2 k3 k4"},
    {"equidistant", LensKind::kFisheye, {4}, "4: k1 k2 k3 k4"},
    {"", LensKind::kRational, {0, 4, 5, 8, 12, 14}, "4, 5, 8 or 12: k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4"}};

const ModelOfLens* findModel(const std::string& name) {
  const auto found =
      std::find_if(kModels.begin(), kModels.end(), [&](const auto& model) { return name == model.name; });
  return found == kModels.end() ? nullptr : &*found;
}

class Assembler {
 public:
  /// @param whole  nothing in the file was unreadable: what is missing was left out
  Assembler(const Parts& parts, bool whole, Diagnostics& diagnostics)
      : parts_(parts), whole_(whole), diagnostics_(diagnostics) {}

  Calibration assemble() {
    if (parts_.matrix) readMatrix(*parts_.matrix);
    if (parts_.focal) camera_.fx = parts_.focal->values[0], camera_.fy = parts_.focal->values[1];
    if (parts_.centre) camera_.cx = parts_.centre->values[0], camera_.cy = parts_.centre->values[1];
    if (parts_.skew) camera_.skew = parts_.skew->values[0];
    checkFocalLengths();
    if (parts_.distortion) readDistortion(*parts_.distortion);
    readSize();
    return {camera_, parts_.width.has_value()};
  }

 private:
  /// fx, fx skew, cx; 0, fy, cy; 0, 0, 1.
  void readMatrix(const Numbers& matrix) {
    const std::vector<double>& m = matrix.values;
    const bool whole = m.size() == 9 && m[3] == 0 && m[6] == 0 && m[7] == 0 && m[8] == 1;
    if (!whole) {
      return error(matrix, m.size() == 9 ? "is no such matrix" : fmt::format("has {} numbers", m.size()),
                   "9: fx s cx  0 fy cy  0 0 1");
    }
    camera_.fx = m[0], camera_.cx = m[2], camera_.fy = m[4], camera_.cy = m[5];
    camera_.skew = m[1] / m[0];
  }

  void checkFocalLengths() {
    const std::optional<Numbers>& source = parts_.matrix ? parts_.matrix : parts_.focal;
    if (source && !(camera_.fx > 0 && camera_.fy > 0)) {
      error(*source, fmt::format("has the focal lengths {:g} and {:g}", camera_.fx, camera_.fy), "positive ones");
    }
  }

  void readDistortion(const Numbers& numbers) {
    const std::string model = parts_.model ? parts_.model->text : "";
    if (findModel(model) == nullptr) {
      std::vector<std::string> known;
      for (const ModelOfLens& each : kModels) known.emplace_back(each.name);
      known.pop_back();
      diagnostics_.error(parts_.model->where,
                         fmt::format("{} is {}, expected {}{}", parts_.model->name, quoted(model),
                                     fmt::join(known, ", "), didYouMean(model.substr(0, 60), known)));
      return;
    }
    const std::string problem = setLens(camera_, model, numbers.values);
    if (!problem.empty()) diagnostics_.error(numbers.where, numbers.name + " " + problem);
  }

  void readSize() {
    if (whole_ && parts_.width.has_value() != parts_.height.has_value()) {
      const Numbers& given = parts_.width ? *parts_.width : *parts_.height;
      return diagnostics_.error(given.where, given.name + " stands alone, expected width and height of the picture");
    }
    if (!parts_.width || !parts_.height) return;
    camera_.width = size(*parts_.width), camera_.height = size(*parts_.height);
  }
  int size(const Numbers& number) {
    const double x = number.values[0];
    if (x >= 1 && x <= kLargestPicture && x == std::floor(x)) return static_cast<int>(x);
    error(number, fmt::format("is {:g}", x), fmt::format("a whole number from 1 to {:g}", kLargestPicture));
    return 1;
  }

  void error(const Numbers& numbers, const std::string& found, const std::string& expected) {
    diagnostics_.error(numbers.where, fmt::format("{} {}, expected {}", numbers.name, found, expected));
  }

  const Parts& parts_;
  bool whole_;
  Diagnostics& diagnostics_;
  CameraModel camera_;
};

}  // namespace

std::string setLens(CameraModel& camera, const std::string& model, const std::vector<double>& numbers) {
  const ModelOfLens* wanted = findModel(model);
  if (wanted == nullptr) return "belong to no model " + quoted(model) + ", expected plumb_bob, rational or fisheye";
  if (std::find(wanted->counts.begin(), wanted->counts.end(), numbers.size()) == wanted->counts.end())
    return fmt::format("has {} numbers, expected {}", numbers.size(), wanted->expected);
  if (numbers.size() == 14 && (numbers[12] != 0 || numbers[13] != 0)) {
    return fmt::format("has a tilted sensor, tau = {:g}, {:g}, expected none: calibrate with 12 numbers", numbers[12],
                       numbers[13]);
  }
  camera.kind = wanted->kind;
  camera.kc = {};
  std::copy_n(numbers.begin(), std::min(numbers.size(), camera.kc.size()), camera.kc.begin());
  return "";
}

std::optional<Calibration> readCalibrationText(const std::string& text, const std::string& file,
                                               Diagnostics& diagnostics) {
  const int before = diagnostics.errorCount();
  if (text.find('\0') != std::string::npos) {
    diagnostics.error({file, 0, 0}, "not a text file: it holds a zero byte, expected a calibration");
    return std::nullopt;
  }
  const bool matlab = std::filesystem::path(file).extension() == ".m";
  const Parts parts =
      matlab ? calibration::readMatlab(text, file, diagnostics) : calibration::readYaml(text, file, diagnostics);
  const Calibration calibration = Assembler(parts, diagnostics.errorCount() == before, diagnostics).assemble();
  return diagnostics.errorCount() == before ? std::optional(calibration) : std::nullopt;
}

std::optional<Calibration> readCalibrationFile(const std::string& path, Diagnostics& diagnostics) {
  std::ifstream in(path, std::ios::binary);
  std::string text(kLargestFile + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (!in.eof() || text.size() > kLargestFile) {
    diagnostics.error({path, 0, 0}, "cannot be read, expected a file of at most 1 MiB");
    return std::nullopt;
  }
  return readCalibrationText(text, path, diagnostics);
}

}  // namespace murosimf
