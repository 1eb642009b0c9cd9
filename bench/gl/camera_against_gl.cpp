// Our ray caster against our own OpenGL renderer on the same processor: pictures through the same lens, colour, depth
// and labels of six robots, primitives, no shadows, all three read back. llvmpipe draws in the calling thread. And
// pictures of many cameras by one atlas against one by one.

#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "camera_views.h"
#include "murosimf/render/gl/gl_camera_renderer.h"
#include "murosimf/render/gl/gl_context.h"
#include "paired_ratio.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 31, kManyCameras = 14;
constexpr double kLeastAgreement = 0.99;  // of labels

std::unique_ptr<GlContext> softwareContext() {
  setenv("LP_NUM_THREADS", "0", 1);         // NOLINT: before the first thread. 0: llvmpipe draws in the calling thread
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // NOLINT
  return makeHiddenContext();
}

/// Makes the pictures of the six cameras in turn, so many at a time.
class GlFrames {
 public:
  explicit GlFrames(std::size_t at_once)
      : views_(makeCameraViews(6)),
        rays_(lensOfViews()),
        lens_(rays_),
        renderer_(views_.scene.ground),
        atlas_(std::vector<PictureSize>(at_once, {rays_.camera().width, rays_.camera().height})),
        pictures_(at_once) {
    for (Picture& p : pictures_) wanted_.push_back(&p);
  }
  void frame() {
    atlas_.clear(views_.scene.sky);
    for (std::size_t i = 0; i < pictures_.size(); ++i) {
      renderer_.draw(lens_, views_.scene, views_.X_WC[next_], views_.hidden[next_], atlas_, i);
      next_ = (next_ + 1) % views_.X_WC.size();
    }
    atlas_.beginReading();
    atlas_.finishReading(wanted_);
  }
  const Picture& picture() const { return pictures_.back(); }

 private:
  CameraViews views_;
  RayTable rays_;
  GlLens lens_;
  GlCameraRenderer renderer_;
  GlAtlas atlas_;
  std::vector<Picture> pictures_;
  std::vector<Picture*> wanted_;
  std::size_t next_ = 0;
};

/// @throws std::runtime_error when both do not show the same
double requireAgreement(const Picture& ours, const Picture& theirs) {
  std::size_t equal = 0;
  for (std::size_t i = 0; i < ours.label.size(); ++i) equal += ours.label[i] == theirs.label[i] ? 1U : 0U;
  const double share = static_cast<double>(equal) / static_cast<double>(ours.label.size());
  if (share < kLeastAgreement) throw std::runtime_error(fmt::format("only {} of labels agree with OpenGL's", share));
  return share;
}

template <class Frames>
std::function<void()> sixOf(Frames& frames) {
  return [&frames] {
    for (int i = 0; i < 6; ++i) frames.frame();
  };
}

std::vector<Row> againstGl() {
  const std::unique_ptr<GlContext> context = softwareContext();
  GlFrames peer(1);
  std::vector<CastLanes> lanes{CastLanes::kEight};
  if (isSupported(CastLanes::kSixteen)) lanes.push_back(CastLanes::kSixteen);
  std::vector<std::unique_ptr<CameraFrames>> ours;
  std::vector<std::function<void()>> frames;
  for (const CastLanes l : lanes)
    frames.push_back(sixOf(*ours.emplace_back(std::make_unique<CameraFrames>(lensOfViews(), 6, l))));
  const auto results = compareFrames(frames, sixOf(peer), kRounds);
  const double agreement = requireAgreement(ours.front()->picture(), peer.picture());
  std::vector<Row> rows;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    Row& row =
        rows.emplace_back(Row{"camera_vs_gl", results[i].ratio, 1e3 * results[i].ours / 6, 1e3 * results[i].peer / 6,
                              "ms/picture", lanes[i] == CastLanes::kSixteen ? "avx512" : "avx2", ""});
    row.text = fmt::format(
        "{:28} {:7} {:6.2f} times our OpenGL by {} ({:.3f} ms, {:.2f} ms a picture; {:.2f} % of labels agree)",
        row.name, row.isa, row.ratio, identifyGl().renderer, row.ours, row.peer, 100 * agreement);
  }
  return rows;
}

std::vector<Row> atlasAgainstOneByOne() {
  const std::unique_ptr<GlContext> context = softwareContext();
  GlFrames atlas(kManyCameras), single(1);
  const auto many = [&single] {
    for (int i = 0; i < kManyCameras; ++i) single.frame();
  };
  const Comparison c = compareFrames({[&atlas] { atlas.frame(); }}, many, kRounds).front();
  Row row{"camera_gl_atlas_14", c.ratio, 1e3 * c.ours / kManyCameras, 1e3 * c.peer / kManyCameras, "ms/picture",
          "software",           ""};
  row.text = fmt::format("{:28} {:7} {:6.2f} times one by one ({:.2f} ms, {:.2f} ms a picture)", row.name, row.isa,
                         row.ratio, row.ours, row.peer);
  return {row};
}

}  // namespace

std::vector<Part> glParts() { return {againstGl, atlasAgainstOneByOne}; }

}  // namespace murosimf::bench
