#pragma once

/// @file What optics and sensors do to the light of a picture, each in one pass over it.
///
/// Same bits for 1, 8 and 16 lanes and for every compiler: IEEE +, -, *, sqrt on float alone, never fused.
/// Cost: every number of the picture is read and written once, by a blur twice, each weight with some arithmetic. No
/// allocation after the first picture of a size.

#include <cstdint>
#include <span>

#include "murosimf/algorithms/camera_model.h"
#include "murosimf/algorithms/light/light_picture.h"

namespace murosimf {

/// How many pixels are worked on together; the result is the same. kWidest asks the machine.
enum class LightLanes : std::uint8_t { kWidest, kOne, kEight, kSixteen };

/// c = factor c, a factor a colour: white balance, gain.
void scaleLight(LightPicture& light, std::array<float, 3> factors, LightLanes lanes = LightLanes::kWidest);

/// c = factor c, a factor a pixel. factors: paddedPixels() of them.
void shadeLight(LightPicture& light, std::span<const float> factors, LightLanes lanes = LightLanes::kWidest);

/// The shade of a lens: 1 - strength (1 - cos^4 a), a the angle of the pixel's ray from the axis; strength 1 is what an
/// ideal thin lens lets through [Smith 2008, Modern Optical Engineering, 8.7]. One factor a pixel, padded with ones.
std::vector<float> naturalVignetting(const CameraModel& camera, double strength);

/// Weights of a Gaussian blur of this standard deviation [px], from the middle outwards: w[0], w[1] = w[-1], ...; their
/// sum over both sides is 1. Cut where they fall below 1/1000 of the largest. {1} for deviations below 0.1 px.
std::vector<float> gaussianWeights(double deviation);
/// Every pixel becomes the mean of its neighbours with these weights along rows, then along columns; the border is
/// continued with its own pixels, so that nothing grows dark there. work: overwritten.
void blurLight(LightPicture& light, std::span<const float> weights, LightPicture& work,
               LightLanes lanes = LightLanes::kWidest);

/// c = c + sqrt(read^2 + shot max(c, 0)) g, g standard normal for every pixel and colour by its place and the key
/// alone: read noise, and the noise of counting photons, whose variance grows with their number
/// [EMVA 1288, release 3.1, 2.2].
struct LightNoise {
  float read = 0.0F;  ///< standard deviation, 1 = full scale
  float shot = 0.0F;  ///< variance at full scale
  std::uint64_t key = 0;
};
void addLightNoise(LightPicture& light, const LightNoise& noise, LightLanes lanes = LightLanes::kWidest);

/// sum = sum + share other, sizes equal.
void addLight(LightPicture& sum, const LightPicture& other, float share, LightLanes lanes = LightLanes::kWidest);

/// c = c^(1 / gamma) of what lies in [0, 1], from a table of 4096 steps; what is brighter stays cut at 1.
std::vector<float> gammaTable(double gamma);
void applyCurve(LightPicture& light, std::span<const float> table);

/// Mean over the picture of 0.299 red + 0.587 green + 0.114 blue, each cut to [0, 1].
double meanBrightness(const LightPicture& light);

}  // namespace murosimf
