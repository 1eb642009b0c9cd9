#include "murosimf/modules/camera/picture_modules.h"

#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/light/light_filters.h"

namespace murosimf {

namespace {

float number(const PictureValues& values, std::string_view name) {
  return static_cast<float>(values.find(name)->second);
}

/// gain, then gamma. With a target the gain follows the picture's mean brightness, as automatic exposure does:
/// log gain goes towards that of the target with a time constant. The first picture is exposed rightly.
class Exposure final : public PictureModule {
 public:
  explicit Exposure(const PictureValues& values)
      : gain_(values.find("gain")->second),
        target_(values.find("target")->second),
        time_constant_(values.find("time_constant")->second) {
    const double gamma = values.find("gamma")->second;
    if (gamma != 1) table_ = gammaTable(gamma);
  }
  void apply(LightPicture& light, const PictureMoment& moment) override {
    if (target_ > 0) follow(meanBrightness(light), moment.since_last);
    const auto gain = static_cast<float>(gain_);
    scaleLight(light, {gain, gain, gain});
    if (!table_.empty()) applyCurve(light, table_);
  }
  void archive(StateArchive& archive) override { archive(gain_); }

 private:
  void follow(double brightness, double since_last) {
    constexpr double kLowest = 0.02, kHighest = 50;  // as a sensor's amplifier and shutter allow
    const double wanted = std::clamp(target_ / std::max(brightness, 1e-6), kLowest, kHighest);
    const double share = since_last > 0 ? 1 - std::exp(-since_last / std::max(time_constant_, 1e-9)) : 1;
    gain_ *= std::pow(wanted / gain_, share);
  }
  double gain_, target_, time_constant_;
  std::vector<float> table_;
};

class WhiteBalance final : public PictureModule {
 public:
  explicit WhiteBalance(const PictureValues& values)
      : factors_{number(values, "red"), number(values, "green"), number(values, "blue")} {}
  void apply(LightPicture& light, const PictureMoment&) override { scaleLight(light, factors_); }

 private:
  std::array<float, 3> factors_;
};

class Vignetting final : public PictureModule {
 public:
  Vignetting(const CameraModel& camera, const PictureValues& values)
      : factors_(naturalVignetting(camera, values.find("strength")->second)) {}
  void apply(LightPicture& light, const PictureMoment&) override { shadeLight(light, factors_); }

 private:
  std::vector<float> factors_;
};

class Defocus final : public PictureModule {
 public:
  explicit Defocus(const PictureValues& values) : weights_(gaussianWeights(values.find("deviation")->second)) {}
  void apply(LightPicture& light, const PictureMoment&) override { blurLight(light, weights_, work_); }

 private:
  std::vector<float> weights_;
  LightPicture work_;
};

class Noise final : public PictureModule {
 public:
  explicit Noise(const PictureValues& values) : read_(number(values, "read")), shot_(number(values, "shot")) {}
  void apply(LightPicture& light, const PictureMoment& moment) override {
    addLightNoise(light, {read_, shot_, moment.key});
  }

 private:
  float read_, shot_;
};

/// One that wants no more than its parameters.
template <class Module>
std::unique_ptr<PictureModule> makeOf(const CameraModel&, const PictureValues& values) {
  return std::make_unique<Module>(values);
}

}  // namespace

const std::vector<PictureModuleKind>& pictureModules() {
  static const std::vector<PictureModuleKind> kinds = {
      {"exposure",
       "brightness of the sensor, fixed or automatic, and its curve",
       {{"gain", "", 0.01, 100, 1, "factor on the light; without effect where there is a target"},
        {"gamma", "", 0.1, 10, 1, "exponent on the light after the gain; 0.45 brightens the dark as sRGB does"},
        {"target", "", 0, 1, 0, "mean brightness that automatic exposure holds; 0: fixed gain"},
        {"time_constant", "s", 0, 60, 0.3, "of automatic exposure"}},
       makeOf<Exposure>},
      {"white_balance",
       "factors on the colours, as of a wrong or warm balance",
       {{"red", "", 0, 10, 1, "factor on red"},
        {"green", "", 0, 10, 1, "factor on green"},
        {"blue", "", 0, 10, 1, "factor on blue"}},
       makeOf<WhiteBalance>},
      {"vignetting",
       "darker corners, by the fourth power of the cosine of the ray's angle",
       {{"strength", "", 0, 1, 1, "share of the ideal lens's shade"}},
       [](const CameraModel& camera, const PictureValues& values) -> std::unique_ptr<PictureModule> {
         return std::make_unique<Vignetting>(camera, values);
       }},
      {"defocus",
       "a lens out of focus: a Gaussian blur, the same at all distances",
       {{"deviation", "px", 0, 50, 1, "standard deviation"}},
       makeOf<Defocus>},
      {"noise",
       "read noise and shot noise, its own for every pixel and picture",
       {{"read", "", 0, 0.5, 0.015, "standard deviation in the dark, 1 is full scale"},
        {"shot", "", 0, 0.1, 0, "variance at full scale; in proportion to the light"}},
       makeOf<Noise>}};
  return kinds;
}

}  // namespace murosimf
