#include "murosimf/render/all_renderers.h"

#include "murosimf/render/force_renderers.h"
#include "murosimf/render/mass_renderers.h"
#include "murosimf/render/motion_renderers.h"
#include "murosimf/render/shape_renderers.h"

namespace murosimf {

namespace {

/// A line of the list: name, property, where it must be, meaning.
template <class Property>
RendererEntry line(std::string name, const Property& property, std::string_view of, std::string meaning,
                   bool shown = false) {
  return {std::move(name), std::string(property.name), std::string(of), std::move(meaning), shown, {}};
}

template <class Renderer, class Property>
void addReader(RendererRegistry& all, std::string name, const Property& property, std::string_view of,
               std::string meaning) {
  RendererEntry entry = line(std::move(name), property, of, std::move(meaning));
  entry.reads = &Renderer::reads();
  all.add<Renderer>(std::move(entry));
}

}  // namespace

RendererRegistry allRenderers() {
  using namespace subset;
  RendererRegistry all;
  all.add<GroundRenderer>(line("ground", kGround, kSelf, "carpet and painted lines", true));
  all.add<DrawnShapeRenderer>(line("shape", kShapes, kSelf, "what cameras see", true));
  all.add<CollisionShapeRenderer>(line("collision shape", kShapes, kSelf, "what touches; yellow: felt by a sensor"));
  all.add<NameRenderer>(line("name", kBasePose, kSelf, "path of the object"));
  all.add<FramesRenderer>(line("frames", kBasePose, kSelf, "axes of all bodies: x red, y green, z blue"));
  all.add<TrajectoryRenderer>(line("trajectory", kBasePose, kSelf, "way of the base, last 10 s that were shown"));
  all.add<CentreOfMassRenderer>(
      line("centre of mass", kBodyInertia, kBodies, "of the bodies, and of all on the ground"));
  all.add<InertiaRenderer>(line("inertia", kBodyInertia, kBodies, "homogeneous boxes of equal mass and inertia"));
  all.add<PairForceRenderer>(line("pair force", kPairForce, kBodies, "of robots, balls, posts and people; 1 m: 100 N"));
  addReader<SolePressureRenderer>(all, "sole pressure", kSolePressure, subset::kSoles,
                                  "on the soles' corners; 1 m: 100 N");
  all.add<SupportPolygonRenderer>(
      line("support polygon", murosimf::kSoles, kSelf, "about the soles' corners on the ground"));
  addReader<IntegrationErrorRenderer>(all, "integration error", kIntegrationError, kSelf, "where steps are chosen");
  all.add<CameraRenderer>(line("camera", kCameraModel, kSelf, "edges of its picture"));
  return all;
}

}  // namespace murosimf
