#include "murosimf/scene/servo_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string_view>

#include "murosimf/scene/servo_keys.h"

namespace murosimf {

namespace {

using nlohmann::json;
using namespace servo;

constexpr std::size_t kLargestFile = 1U << 20U;

std::vector<std::string> knownKeys() {
  std::vector<std::string> keys{"model",   "actuator",   "vin",         "kp",
                                "max_pwm", "error_gain", "max_current", "error_gain_ratio"};
  for (const Field& field : kFields) keys.emplace_back(field.key);
  for (const std::string_view key : kPassedOver) keys.emplace_back(key);
  return keys;
}

std::vector<std::string> knownActuators() {
  std::vector<std::string> names;
  for (const Drive& drive : kDrives) names.emplace_back(drive.actuator);
  return names;
}

class Reader {
 public:
  Reader(const std::string& text, const std::string& file, Diagnostics& diagnostics)
      : text_(text), file_(file), diagnostics_(diagnostics) {}

  std::optional<std::vector<ServoConstant>> read() {
    const int before = diagnostics_.errorCount();
    if (parse()) {
      const unsigned model = readModel();
      for (const Field& field : kFields) readField(field, model);
      readDrive();
      warnOfUnknownKeys();
    }
    if (diagnostics_.errorCount() != before) return std::nullopt;
    return std::move(constants_);
  }

 private:
  bool parse() {
    try {
      object_ = json::parse(text_);
    } catch (const json::parse_error& fault) {
      error(place(fault.byte > 0 ? fault.byte - 1 : 0), "not JSON: expected an object of keys and numbers");
      return false;
    }
    if (object_.is_object()) return true;
    error(place(0), fmt::format("found {}, expected an object of keys and numbers", object_.type_name()));
    return false;
  }

  /// Bit of the model, all bits when it is not known.
  unsigned readModel() {
    const std::optional<std::string> name = word("model");
    if (!name) return kAll;
    static const std::vector<std::string> kModels{"m1", "m2", "m3", "m4", "m5", "m6"};
    for (std::size_t i = 0; i < kModels.size(); ++i) {
      if (*name == kModels[i]) return 1U << i;
    }
    error(where("model"),
          fmt::format("model is \"{}\", expected m1, m2, m3, m4, m5 or m6{}", *name, didYouMean(*name, kModels)));
    return kAll;
  }

  void readField(const Field& field, unsigned model) {
    const bool known_model = model != kAll, wanted = (field.models & model) != 0;
    if (!object_.contains(field.key)) {
      if (known_model && wanted) {
        error({file_, 0, 0}, fmt::format("{} is missing, expected a number [{}] in a file of model {}", field.key,
                                         field.property->unit, object_["model"].get<std::string>()));
      }
      return;
    }
    const std::optional<double> value = number(field.key, field.positive);
    if (!wanted) {
      diagnostics_.warning(where(field.key), fmt::format("{} is passed over: model {} does not have it", field.key,
                                                         object_["model"].get<std::string>()));
    } else if (value) {
      constants_.push_back({field.property, *value});
      if (field.other != nullptr) constants_.push_back({field.other, *value});
    }
  }

  void readDrive() {
    const bool whole = object_.contains("vin") && object_.contains("kp") && object_.contains("error_gain");
    const std::optional<Drive> drive = namedDrive(whole);
    addDrive("vin", kSupplyVoltage, drive ? drive->supply : 0);
    addDrive("kp", kFirmwareGain, drive ? drive->firmware_gain : 0);
    addDrive("error_gain", kErrorGain, drive ? drive->error_gain : 0);
    addDrive("max_pwm", kLargestDuty, drive ? drive->largest_duty : kDefaultDuty);
    if (object_.contains("max_current")) addDrive("max_current", kLargestCurrent, 0);
  }

  /// The drive of the actuator that the file names. @param whole the file says itself all that is needed
  std::optional<Drive> namedDrive(bool whole) {
    if (whole && !object_.contains("actuator")) return std::nullopt;
    const std::optional<std::string> name = word("actuator");
    if (!name) return std::nullopt;
    for (const Drive& drive : kDrives) {
      if (drive.actuator == *name) return drive;
    }
    for (const std::string_view other : kOtherDrives) {
      if (other != *name) continue;
      error(where("actuator"), fmt::format("actuator \"{}\" is driven by current, expected one that is driven by "
                                           "voltage, as {}",
                                           *name, fmt::join(knownActuators(), ", ")));
      return std::nullopt;
    }
    if (!whole) {
      error(where("actuator"),
            fmt::format("actuator \"{}\" is not known, expected {}, or vin [V], kp and error_gain [1/rad] in the "
                        "file{}",
                        *name, fmt::join(knownActuators(), ", "), didYouMean(*name, knownActuators())));
    }
    return std::nullopt;
  }

  void addDrive(std::string_view key, const Constant<double>& property, double otherwise) {
    std::optional<double> value = otherwise;
    if (object_.contains(key)) value = number(key, true);
    if (&property == &kErrorGain && object_.contains("error_gain_ratio")) {
      const std::optional<double> ratio = number("error_gain_ratio", true);
      if (value && ratio) value = *value * *ratio;
    }
    if (value) constants_.push_back({&property, *value});
  }

  void warnOfUnknownKeys() {
    const std::vector<std::string> known = knownKeys();
    for (const auto& [key, value] : object_.items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      diagnostics_.warning(where(key), fmt::format("unknown key \"{}\" is passed over{}", key.substr(0, 60),
                                                   didYouMean(key.substr(0, 60), known)));
    }
  }

  std::optional<double> number(std::string_view key, bool positive) {
    const json& value = object_[std::string(key)];
    const double x = value.is_number() ? value.get<double>() : std::nan("");
    if (std::isfinite(x) && x <= 1e9 && (positive ? x > 0 : x >= 0)) return x;
    error(where(key), fmt::format("{} is {}, expected a number {}", key,
                                  value.is_number() ? fmt::format("{:g}", x) : value.type_name(),
                                  positive ? "greater than 0" : "of 0 or more"));
    return std::nullopt;
  }

  std::optional<std::string> word(const char* key) {
    if (!object_.contains(key)) {
      error({file_, 0, 0}, fmt::format("{} is missing, expected a text", key));
    } else if (!object_[key].is_string()) {
      error(where(key), fmt::format("{} is {}, expected a text", key, object_[key].type_name()));
    } else {
      return object_[key].get<std::string>().substr(0, 60);
    }
    return std::nullopt;
  }

  void error(SourceLocation at, std::string message) { diagnostics_.error(std::move(at), std::move(message)); }

  /// Where the key stands: JSON readers keep no places, so it is looked for in the text.
  SourceLocation where(std::string_view key) const {
    const std::size_t at = text_.find(fmt::format("\"{}\"", key));
    return at == std::string::npos ? SourceLocation{file_, 0, 0} : place(at);
  }
  SourceLocation place(std::size_t at) const {
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at, text_.size()));
    const auto line = 1 + std::count(text_.begin(), end, '\n');
    const std::size_t start = text_.rfind('\n', at == 0 ? 0 : at - 1);
    const std::size_t column = start == std::string::npos || at == 0 ? at + 1 : at - start;
    return {file_, static_cast<int>(line), static_cast<int>(column)};
  }

  const std::string& text_;
  const std::string& file_;
  Diagnostics& diagnostics_;
  json object_;
  std::vector<ServoConstant> constants_;
};

}  // namespace

std::optional<std::vector<ServoConstant>> readServoText(const std::string& text, const std::string& file,
                                                        Diagnostics& diagnostics) {
  return Reader(text, file, diagnostics).read();
}

std::optional<std::vector<ServoConstant>> readServoFile(const std::string& path, Diagnostics& diagnostics) {
  std::ifstream in(path, std::ios::binary);
  std::string text(kLargestFile + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (!in.eof() || text.size() > kLargestFile) {
    diagnostics.error({path, 0, 0}, "cannot be read, expected a file of at most 1 MiB");
    return std::nullopt;
  }
  return readServoText(text, path, diagnostics);
}

}  // namespace murosimf
