#include "murosimf/algorithms/light/light_filters.h"

#include <algorithm>
#include <cmath>

#include "murosimf/algorithms/light/light_kernel.h"
#include "murosimf/algorithms/ray_caster.h"

namespace murosimf {

// The kernels of the two instruction sets: light_filters_v3.cpp, light_filters_v4.cpp.
inline namespace isa_v3 {
LightPasses lightPassesInLanes();
}
namespace isa_v4 {
LightPasses lightPassesInLanes();
}

namespace {

LightPasses passesOf(LightLanes lanes) {
  const LightLanes widest = isSupported(CastLanes::kSixteen) ? LightLanes::kSixteen : LightLanes::kEight;
  const LightLanes wanted = lanes == LightLanes::kWidest ? widest : lanes;
  if (wanted == LightLanes::kSixteen) return isa_v4::lightPassesInLanes();
  return wanted == LightLanes::kEight ? isa_v3::lightPassesInLanes() : lightPasses<float>();
}

LightJob jobOn(LightPicture& light, std::size_t colour) {
  LightJob job;
  job.plane = light.plane[colour].data();
  job.count = light.paddedPixels();
  return job;
}

}  // namespace

void scaleLight(LightPicture& light, std::array<float, 3> factors, LightLanes lanes) {
  const LightPasses passes = passesOf(lanes);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    LightJob job = jobOn(light, colour);
    job.factor = factors[colour];
    passes.scale(job);
  }
}

void shadeLight(LightPicture& light, std::span<const float> factors, LightLanes lanes) {
  const LightPasses passes = passesOf(lanes);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    LightJob job = jobOn(light, colour);
    job.other = factors.data();
    passes.shade(job);
  }
}

std::vector<float> naturalVignetting(const CameraModel& camera, double strength) {
  std::vector<float> factors;
  const double valid_radius = validRadius(camera);
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      const RaySlopes ray = unproject(camera, {static_cast<double>(u), static_cast<double>(v)}, valid_radius);
      const double squared_cosine = 1 / (1 + ray.x * ray.x + ray.y * ray.y);
      factors.push_back(static_cast<float>(1 - strength * (1 - squared_cosine * squared_cosine)));
    }
  }
  while (factors.size() % LightPicture::kTogether != 0) factors.push_back(1.0F);
  return factors;
}

std::vector<float> gaussianWeights(double deviation) {
  constexpr double kNone = 0.1, kCut = 1e-3;
  if (deviation < kNone) return {1.0F};
  std::vector<double> weights;
  double sum = 0;
  for (int k = 0; weights.empty() || weights.back() > kCut; ++k) {
    weights.push_back(std::exp(-0.5 * (k / deviation) * (k / deviation)));
    sum += (k == 0 ? 1 : 2) * weights.back();
  }
  std::vector<float> normed;
  for (const double weight : weights) normed.push_back(static_cast<float>(weight / sum));
  return normed;
}

namespace {

/// One plane that is blurred along its rows and then along its columns. Rows of the work plane are padded to whole
/// registers, and continued above and below by copies of the outermost ones.
class PlaneBlur {
 public:
  PlaneBlur(const LightPasses& passes, std::span<const float> weights, int width, int height, std::vector<float>& work)
      : passes_(passes),
        width_(static_cast<std::size_t>(width)),
        height_(static_cast<std::size_t>(height)),
        work_(work) {
    reach_ = weights.size() - 1;
    job_.weights = weights.data(), job_.reach = static_cast<int>(reach_);
    stride_ = (width_ + LightPicture::kTogether - 1) / LightPicture::kTogether * LightPicture::kTogether;
    job_.count = stride_;
    work_.resize((height_ + 2 * reach_) * stride_ + 2 * reach_ + stride_);
    margin_ = work_.data() + (height_ + 2 * reach_) * stride_;
  }
  void run(std::vector<float>& plane) {
    for (std::size_t v = 0; v < height_; ++v) alongRow(plane.data() + v * width_, row(v + reach_));
    for (std::size_t k = 0; k < reach_; ++k) {
      std::copy_n(row(reach_), stride_, row(k));
      std::copy_n(row(reach_ + height_ - 1), stride_, row(reach_ + height_ + k));
    }
    for (std::size_t v = 0; v < height_; ++v) {
      job_.plane = margin_, job_.other = row(v + reach_), job_.step = static_cast<std::ptrdiff_t>(stride_);
      passes_.blurAlong(job_);
      std::copy_n(margin_, width_, plane.data() + v * width_);
    }
  }

 private:
  float* row(std::size_t v) { return work_.data() + v * stride_; }
  void alongRow(const float* source, float* target) {
    std::fill_n(margin_, reach_, source[0]);
    std::copy_n(source, width_, margin_ + reach_);
    std::fill(margin_ + reach_ + width_, margin_ + 2 * reach_ + stride_, source[width_ - 1]);
    job_.plane = target, job_.other = margin_ + reach_, job_.step = 1;
    passes_.blurAlong(job_);
  }

  const LightPasses& passes_;
  std::size_t width_, height_, reach_ = 0, stride_ = 0;
  std::vector<float>& work_;
  float* margin_ = nullptr;  // one row, continued on both sides
  LightJob job_;
};

}  // namespace

void blurLight(LightPicture& light, std::span<const float> weights, LightPicture& work, LightLanes lanes) {
  if (weights.size() < 2) return;
  const LightPasses passes = passesOf(lanes);
  for (std::vector<float>& plane : light.plane)
    PlaneBlur(passes, weights, light.width, light.height, work.plane[0]).run(plane);
}

void addLightNoise(LightPicture& light, const LightNoise& noise, LightLanes lanes) {
  const LightPasses passes = passesOf(lanes);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    LightJob job = jobOn(light, colour);
    job.read_squared = noise.read * noise.read, job.shot = noise.shot;
    job.key_low = static_cast<std::uint32_t>(noise.key), job.key_high = static_cast<std::uint32_t>(noise.key >> 32);
    job.channel = static_cast<std::uint32_t>(colour);
    passes.noise(job);
  }
}

void addLight(LightPicture& sum, const LightPicture& other, float share, LightLanes lanes) {
  const LightPasses passes = passesOf(lanes);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    LightJob job = jobOn(sum, colour);
    job.other = other.plane[colour].data(), job.factor = share;
    passes.add(job);
  }
}

std::vector<float> gammaTable(double gamma) {
  constexpr std::size_t kSteps = 4096;
  std::vector<float> table;
  for (std::size_t i = 0; i < kSteps; ++i)
    table.push_back(static_cast<float>(std::pow(static_cast<double>(i) / (kSteps - 1), gamma)));
  return table;
}

void applyCurve(LightPicture& light, std::span<const float> table) {
  const float last = static_cast<float>(table.size() - 1);
  for (std::vector<float>& plane : light.plane) {
    for (float& c : plane) c = table[static_cast<std::size_t>(std::clamp(c, 0.0F, 1.0F) * last + 0.5F)];
  }
}

double meanBrightness(const LightPicture& light) {
  constexpr double kShares[3] = {0.299, 0.587, 0.114};
  double sum = 0;
  for (std::size_t colour = 0; colour < 3; ++colour) {
    double of_colour = 0;
    for (std::size_t i = 0; i < light.pixels(); ++i)
      of_colour += static_cast<double>(std::clamp(light.plane[colour][i], 0.0F, 1.0F));
    sum += kShares[colour] * of_colour;
  }
  return sum / static_cast<double>(std::max<std::size_t>(light.pixels(), 1));
}

}  // namespace murosimf
