#pragma once

/// @file How the battery is seen: a bar over the robot, as long as it is full, from green to red.

#include "battery.h"
#include "murosimf/render/body_places.h"

class ChargeRenderer final : public murosimf::PropertyRenderer {
 public:
  explicit ChargeRenderer(const murosimf::RenderedObject& object)
      : places_(object), charge_(object.linked.handle(object.object, kBatteryCharge)) {}
  void draw(const murosimf::RenderMoment& now, murosimf::DrawList& list) override {
    if (!charge_.valid()) return;  // not at this level of detail
    const double charge = charge_.get(), length = 0.2;
    const auto left = static_cast<float>(charge);
    const murosimf::Vector3 p_W = places_.pose(0, now.frame).translation + murosimf::Vector3{0, 0, 0.29};
    list.rod(p_W, p_W + murosimf::Vector3{0, 0, length * charge}, 0.01, {1 - left, left, 0.1F});
  }

 private:
  murosimf::BodyPlaces places_;
  murosimf::Handle<double> charge_;
};

/// Every object that has a battery is seen with it from then on.
inline void addChargeRenderer(murosimf::RendererRegistry& renderers) {
  renderers.add<ChargeRenderer>({"charge",
                                 std::string(kBatteryCharge.name),
                                 std::string(murosimf::subset::kSelf),
                                 "how full the battery is",
                                 true,
                                 {}});
}
