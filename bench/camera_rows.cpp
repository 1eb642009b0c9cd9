// Rows about the ray caster: what the lens costs, what more robots cost, and what six cameras take of a core. Six
// cameras in turn, 640 x 480, colour, depth and labels, one thread.

#include <fmt/format.h>

#include "camera_views.h"
#include "paired_ratio.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 61;

/// Time of `first` over time of `second`, a picture each.
Row pictureRow(const std::string& name, CastLanes lanes, CameraFrames& first, CameraFrames& second,
               const std::string& words) {
  // Blocks of six pictures: every block sees all six views.
  const auto six = [](CameraFrames& frames) {
    return [&frames] {
      for (int i = 0; i < 6; ++i) frames.frame();
    };
  };
  const Comparison c = compareFrames({six(second)}, six(first), kRounds).front();
  Row row{
      name, c.ratio, 1e3 * c.peer / 6, 1e3 * c.ours / 6, "ms/picture", lanes == CastLanes::kSixteen ? "avx512" : "avx2",
      ""};
  row.text = fmt::format("{:28} {:7} {:6.3f} times {} ({:.3f} ms, {:.3f} ms a picture)", row.name, row.isa, row.ratio,
                         words, row.ours, row.peer);
  return row;
}

std::vector<Row> distortedOverPlain(CastLanes lanes) {
  CameraFrames lens(lensOfViews(), 6, lanes), straight(straightCameraOfViews(), 6, lanes);
  return {pictureRow("camera_distorted_over_plain", lanes, lens, straight, "a picture without distortion")};
}

std::vector<Row> manyOverSix(CastLanes lanes) {
  CameraFrames many(lensOfViews(), 22, lanes), six(lensOfViews(), 6, lanes);
  return {pictureRow("camera_22_over_6", lanes, many, six, "a picture of 6 robots")};
}

/// Processor time of the pictures of a simulated second.
std::vector<Row> sixAtThirtyHertz(CastLanes lanes) {
  constexpr int kPictures = 6 * 30, kSeconds = 13;
  CameraFrames frames(lensOfViews(), 6, lanes);
  std::vector<double> shares;
  for (int second = 0; second <= kSeconds; ++second) {
    const double begin = threadTime();
    for (int i = 0; i < kPictures; ++i) frames.frame();
    if (second > 0) shares.push_back(threadTime() - begin);  // the first one warms caches up
  }
  const double share = median(shares);
  Row row{"camera_6_at_30hz", share, share, 1, "share of a core", lanes == CastLanes::kSixteen ? "avx512" : "avx2", ""};
  row.text = fmt::format("{:28} {:7} {:6.3f} of a core ({:.3f} ms a picture)", row.name, row.isa, share,
                         1e3 * share / kPictures);
  return {row};
}

}  // namespace

std::vector<Part> cameraParts() {
  std::vector<Part> parts;
  for (const CastLanes lanes : {CastLanes::kEight, CastLanes::kSixteen}) {
    if (!isSupported(lanes)) continue;
    parts.emplace_back([lanes] { return distortedOverPlain(lanes); });
    parts.emplace_back([lanes] { return manyOverSix(lanes); });
    parts.emplace_back([lanes] { return sixAtThirtyHertz(lanes); });
  }
  return parts;
}

}  // namespace murosimf::bench
