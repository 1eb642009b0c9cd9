#include "murosimf/render/all_renderers.h"

#include "murosimf/render/shape_renderers.h"

namespace murosimf {

namespace {

std::string self() { return std::string(subset::kSelf); }

}  // namespace

RendererRegistry allRenderers() {
  RendererRegistry all;
  all.add<GroundRenderer>({"ground", std::string(kGround.name), self(), "carpet and painted lines", true, {}});
  all.add<DrawnShapeRenderer>({"shape", std::string(kShapes.name), self(), "what cameras see", true, {}});
  all.add<CollisionShapeRenderer>({"collision shape", std::string(kShapes.name), self(), "what touches", false, {}});
  return all;
}

}  // namespace murosimf
