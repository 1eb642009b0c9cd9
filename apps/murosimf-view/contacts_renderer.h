#pragma once

/// @file Draws what the pair phase found in the last frame: where things touch, and the mean force there.

#include "murosimf/render/property_renderer.h"
#include "murosimf/simulation/simulation.h"
#include "murosimf/world/vocabulary.h"

namespace murosimf {

/// Contacts of balls, robots and posts with one another and of balls with the ground. Arrows: 1 m for 100 N.
class ContactsRenderer final : public PropertyRenderer {
 public:
  explicit ContactsRenderer(Simulation& simulation) : simulation_(simulation) {}
  void draw(const RenderMoment&, DrawList& list) override {
    constexpr double kMetresANewton = 0.01;
    for (const ContactPair& pair : simulation_.pairs().contacts().pairs) {
      if (!pair.touched) continue;
      const Vector3& p_W = pair.contact.point;
      list.sphere(p_W, 0.008, {1.0F, 0.1F, 0.1F});
      list.arrow(p_W, p_W + pair.impulse * (kMetresANewton / simulation_.frameLength()), 0.004, {1.0F, 0.3F, 0.1F});
    }
  }
  /// A line of the list, matched with the world's root by the table of surfaces.
  static RendererEntry entry(Simulation& simulation) {
    return {"contacts",
            std::string(kSurfaceTable.name),
            std::string(subset::kSelf),
            "points and forces; 1 m: 100 N",
            false,
            [&simulation](const RenderedObject&) { return std::make_unique<ContactsRenderer>(simulation); }};
  }

 private:
  Simulation& simulation_;
};

}  // namespace murosimf
