#include "game/game.h"

#include "all_controllers.h"
#include "game/agent_server_program.h"
#include "game/player_api_program.h"
#include "game/servo_bus_program.h"
#include "murosimf/modules/camera/gl/gl_picture_maker.h"
#include "murosimf/scene/field_texture.h"
#include "murosimf/soccer/field.h"
#include "murosimf/soccer/landmarks.h"

namespace murosimf {

ControlPrograms allPrograms() {
  ControlPrograms all;
  for (const auto& [name, make] : controllers::allControllers()) all.emplace(name, ControlProgram(make));
  all.emplace("agent_server", agentServerProgram());
  all.emplace("player_api", playerApiProgram());
  all.emplace("servo_bus", servoBusProgram());
  return all;
}

PictureMakers allPictureMakers() {
  PictureMakers makers = rayCasterAlone();
  makers.emplace("opengl", openGlKind());
  return makers;
}

std::unique_ptr<Simulation> buildGame(const Scene& scene, Diagnostics& diagnostics, const Watchers& watchers,
                                      const ModuleRegistry& modules, const ControlPrograms& programs) {
  WorldBuilder builder(scene, diagnostics);
  FieldLook look;
  look.brightness = *scene.field.brightness;
  look.carpet = *scene.field.carpet;
  look.texture = readFieldTexture(scene.field, diagnostics);
  look.texture_size = *scene.field.texture_size;
  look.goal_at_plus_x = *scene.field.goal_at_plus_x;
  look.goal_at_minus_x = *scene.field.goal_at_minus_x;
  const client::FieldDescription field = fieldDescription(scene);
  const std::vector<ObjectId> objects = addField(builder.world(), field, look);
  builder.addFixed(objects);
  builder.addLandmarks(fieldLandmarks(objects, field, look));
  if (watchers) {
    for (Attachment& attachment : watchers(builder.participants())) builder.attach(std::move(attachment));
  }
  return builder.link(modules, programs, allPictureMakers());
}

}  // namespace murosimf
