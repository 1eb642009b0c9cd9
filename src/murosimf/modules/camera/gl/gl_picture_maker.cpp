#include "murosimf/modules/camera/gl/gl_picture_maker.h"

#include "murosimf/modules/camera/gl/gl_studio.h"

namespace murosimf {

namespace {

/// The light that bytes stand for.
void setLight(const Picture& picture, LightPicture& light) {
  light.resize(picture.width, picture.height);
  for (std::size_t colour = 0; colour < 3; ++colour) {
    const std::uint8_t* byte = picture.rgb.data() + colour;
    for (std::size_t i = 0; i < light.pixels(); ++i, byte += 3)
      light.plane[colour][i] = static_cast<float>(*byte) / 255.0F;
  }
}

class GlPictureMaker final : public PictureMaker {
 public:
  GlPictureMaker(std::shared_ptr<GlStudio> studio, const PictureWish& wish)
      : studio_(std::move(studio)), camera_(studio_->add(wish)), light_(wish.light) {}

  void order(const PictureOrder& order) override { studio_->order(camera_, order); }
  void start() override { studio_->start(); }
  void settle() override { studio_->settle(camera_); }
  void fetch(Picture& picture, LightPicture& light) override {
    studio_->fetch(camera_, picture);
    if (light_) setLight(picture, light);
  }
  bool isPrompt() const override { return false; }
  PictureDrawer drawer() const override {
    const GlIdentity& identity = studio_->identity();
    return {nameOf(identity), warningOf(identity)};
  }

 private:
  std::shared_ptr<GlStudio> studio_;
  std::size_t camera_;
  bool light_;
};

}  // namespace

std::shared_ptr<const PictureMakerKind> openGlKind() {
  auto kind = std::make_shared<PictureMakerKind>();
  kind->name = "opengl";
  kind->make = [open = std::make_shared<std::weak_ptr<GlStudio>>()](
                   const PictureWish& wish, const PaintedGround& ground) -> std::unique_ptr<PictureMaker> {
    std::shared_ptr<GlStudio> studio = open->lock();
    if (studio == nullptr) *open = studio = std::make_shared<GlStudio>(ground);
    return std::make_unique<GlPictureMaker>(std::move(studio), wish);
  };
  return kind;
}

}  // namespace murosimf
