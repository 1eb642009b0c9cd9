#include "murosimf/modules/camera/picture_maker.h"

namespace murosimf {

namespace {

class RayCastMaker final : public PictureMaker {
 public:
  explicit RayCastMaker(const PictureWish& wish) : wish_(wish) {}
  void order(const PictureOrder& order) override { order_ = order; }
  void fetch(Picture& picture, LightPicture& light) override;
  bool isPrompt() const override { return true; }
  PictureDrawer drawer() const override { return {}; }

 private:
  PictureWish wish_;
  PictureOrder order_;
  ShutterWork work_;
};

void RayCastMaker::fetch(Picture& picture, LightPicture& light) {
  CastOptions options;
  options.antialias = wish_.antialias;
  options.shadows = wish_.shadows;
  options.lanes = wish_.lanes;
  picture.has_depth = wish_.depth;
  const MovingCamera& place = order_.place;
  if (wish_.light) {
    castThroughShutter(*wish_.rays, *order_.scene, place, wish_.hidden, options, wish_.shutter, work_, picture, light);
    return;
  }
  options.sensor = wish_.sensor;
  options.sensor.key = order_.key;
  castPicture(*wish_.rays, *order_.scene, place.X_WC, wish_.hidden, options, work_.prepared, picture);
}

}  // namespace

const std::shared_ptr<const PictureMakerKind>& rayCasterKind() {
  static const auto kind = std::make_shared<const PictureMakerKind>(
      PictureMakerKind{"ray_caster",
                       {true, true, true, true, true},
                       "",
                       [](const PictureWish& wish, const PaintedGround&) -> std::unique_ptr<PictureMaker> {
                         return std::make_unique<RayCastMaker>(wish);
                       }});
  return kind;
}

PictureMakers rayCasterAlone() { return {{rayCasterKind()->name, rayCasterKind()}}; }

}  // namespace murosimf
