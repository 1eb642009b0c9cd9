#include "murosimf/scene/picture_chain.h"

#include <fmt/format.h>

#include <algorithm>

#include "murosimf/scene/module_choice.h"

namespace murosimf {

namespace {

constexpr std::string_view kChain = "chain", kFormat = "format";

std::vector<const PictureModuleKind*> allKinds() {
  std::vector<const PictureModuleKind*> kinds;
  for (const auto* list : {&timingModules(), &pictureModules()}) {
    for (const PictureModuleKind& kind : *list) kinds.push_back(&kind);
  }
  return kinds;
}

std::string parameterName(const PictureModuleKind& kind, const PictureParameter& parameter) {
  return fmt::format("{}_{}", kind.name, parameter.name);
}

/// Which module's parameter has this name; nulls: none's.
std::pair<const PictureModuleKind*, const PictureParameter*> find(std::string_view name) {
  for (const PictureModuleKind* kind : allKinds()) {
    for (const PictureParameter& parameter : kind->parameters)
      if (parameterName(*kind, parameter) == name) return {kind, &parameter};
  }
  return {};
}

bool isGathering(std::string_view name) { return name == "rolling_shutter" || name == "motion_blur"; }

}  // namespace

const std::vector<PictureModuleKind>& timingModules() {
  static const std::vector<PictureModuleKind> kinds = {
      {"rolling_shutter",
       "rows are exposed one after another",
       {{"readout", "s", 0, 1, 0.02, "from the end of the first row's exposure to that of the last row's"}},
       {}},
      {"motion_blur",
       "light is gathered over a time",
       {{"exposure", "s", 0, 1, 0.01, "length of the exposure"},
        {"samples", "", 1, 256, 8, "moments whose mean the picture is; each costs a picture"}},
       {}},
      {"latency",
       "pictures arrive late",
       {{"delay", "s", 0, 10, 0.03, "from the end of the exposure to the arrival"}},
       {}}};
  return kinds;
}

void PictureChainReader::read(RobotCameraSettings& settings) {
  for (const NamedValue& parameter : camera_.parameters)
    if (parameter.name == kChain) readNames(parameter);
  for (const NamedValue& parameter : camera_.parameters) {
    if (parameter.name == kFormat) readFormat(parameter, settings.format);
    if (const auto [kind, known] = find(parameter.name); kind != nullptr) readValue(parameter, *kind, *known);
  }
  if (!named_.empty()) fill(settings);
}

bool PictureChainReader::owns(const NamedValue& parameter) {
  return parameter.name == kChain || parameter.name == kFormat || find(parameter.name).first != nullptr;
}

std::vector<std::string> PictureChainReader::knownParameters() {
  std::vector<std::string> known{std::string(kChain), std::string(kFormat)};
  for (const PictureModuleKind* kind : allKinds()) {
    for (const PictureParameter& parameter : kind->parameters) known.push_back(parameterName(*kind, parameter));
  }
  return known;
}

void PictureChainReader::readNames(const NamedValue& chain) {
  std::vector<std::string> known;
  for (const PictureModuleKind* kind : allKinds()) known.emplace_back(kind->name);
  const auto* names = std::get_if<std::vector<std::string>>(&*chain.value);
  if (names == nullptr) {
    diagnostics_.error(chain.value.where, fmt::format("chain is no list of names, expected some of {}, as in "
                                                      "chain = [\"vignetting\", \"noise\"]",
                                                      fmt::join(known, ", ")));
    return;
  }
  for (const std::string& name : *names) {
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) {
      diagnostics_.error(chain.value.where, fmt::format("unknown picture module \"{}\"; expected one of {}{}", name,
                                                        fmt::join(known, ", "), didYouMean(name, known)));
      continue;
    }
    checkPlace(chain, name);
    const PictureModuleKind* kind = allKinds()[static_cast<std::size_t>(found - known.begin())];
    PictureValues& values = values_.emplace_back();
    for (const PictureParameter& parameter : kind->parameters) values.emplace(parameter.name, parameter.value);
    named_.push_back(kind);
  }
}

/// @param name  comes behind those that are in named_
void PictureChainReader::checkPlace(const NamedValue& chain, const std::string& name) {
  const auto named = [&](std::string_view other) {
    return std::any_of(named_.begin(), named_.end(), [&](const PictureModuleKind* k) { return k->name == other; });
  };
  const bool late = std::any_of(named_.begin(), named_.end(), [](const auto* k) { return !isGathering(k->name); });
  if (named(name)) {
    diagnostics_.error(chain.value.where, fmt::format("\"{}\" stands twice in the chain", name));
  } else if (isGathering(name) && late) {
    diagnostics_.error(chain.value.where, fmt::format("\"{}\" stands behind \"{}\", expected first: it tells how the "
                                                      "light is gathered that others change",
                                                      name, named_.back()->name));
  } else if (named("latency")) {
    diagnostics_.error(chain.value.where,
                       fmt::format("\"{}\" stands behind \"latency\", expected before it: the picture is finished "
                                   "when it is sent",
                                   name));
  }
}

void PictureChainReader::readFormat(const NamedValue& format, PixelFormat& out) {
  const auto* name = std::get_if<std::string>(&*format.value);
  const std::optional<PixelFormat> found = name == nullptr ? std::nullopt : pixelFormatOf(*name);
  if (found) {
    out = *found;
    return;
  }
  const std::vector<std::string> known{"rgb", "bgr", "yuyv"};
  diagnostics_.error(format.value.where,
                     fmt::format("format is {}, expected one of {}{}", name == nullptr ? "no name" : '"' + *name + '"',
                                 fmt::join(known, ", "), name == nullptr ? "" : didYouMean(*name, known)));
}

void PictureChainReader::readValue(const NamedValue& parameter, const PictureModuleKind& kind,
                                   const PictureParameter& known) {
  const auto place = std::find(named_.begin(), named_.end(), &kind);
  if (place == named_.end()) {
    diagnostics_.error(parameter.name_where, fmt::format("{} belongs to the picture module {}, which is not in the "
                                                         "camera's chain",
                                                         parameter.name, kind.name));
    return;
  }
  const auto* number = std::get_if<double>(&*parameter.value);
  if (number == nullptr || !(*number >= known.lowest && *number <= known.highest)) {
    diagnostics_.error(parameter.value.where,
                       fmt::format("{} is {}, expected a number from {} to {}{}{}", parameter.name,
                                   number == nullptr ? "no number" : fmt::format("{}", *number), known.lowest,
                                   known.highest, known.unit.empty() ? "" : " ", known.unit));
    return;
  }
  values_[static_cast<std::size_t>(place - named_.begin())].find(known.name)->second = *number;
}

void PictureChainReader::fill(RobotCameraSettings& settings) const {
  settings.gain = 1, settings.noise = 0;
  for (std::size_t i = 0; i < named_.size(); ++i) {
    const auto value = [&](std::string_view name) { return values_[i].find(name)->second; };
    const std::string_view name = named_[i]->name;
    if (name == "rolling_shutter") {
      settings.shutter.readout = value("readout");
    } else if (name == "motion_blur") {
      settings.shutter.exposure = value("exposure");
      settings.shutter.samples = static_cast<int>(value("samples"));
    } else if (name == "latency") {
      settings.latency = value("delay");
    } else {
      settings.chain.push_back({named_[i], values_[i]});
    }
  }
}

}  // namespace murosimf
