#include <fmt/format.h>

#include <algorithm>

#include "murosimf/robot/calibration_file.h"
#include "murosimf/robot/checks.h"
#include "murosimf/robot/mesh_path.h"
#include "murosimf/robot/urdf_parts.h"

namespace murosimf::urdf {
namespace {

constexpr int kLargestPicture = 8192;
/// What a calibration file tells in the place of the robot file.
constexpr const char* kOfFile[] = {"hfov", "fx", "fy", "cx", "cy", "skew", "model", "kc"};

void requirePositive(const XmlElement& element, const char* attribute, double value) {
  if (!(value > 0)) element.errorAt(attribute, fmt::format("is {:g}, expected more than 0", value));
}

/// Focal lengths from fx (and fy), or from the horizontal angle of view of a lens whose numbers are zero: equidistant
/// for a fisheye, straight for others.
void readFocalLength(const XmlElement& element, CameraModel& camera) {
  const int before = element.diagnostics().errorCount();
  if (element.has("hfov") == element.has("fx")) {
    return element.error("expected either \"hfov\" [rad] or \"fx\" [pixels], or \"lens\"");
  }
  if (element.has("hfov")) {
    const double angle = element.number("hfov");
    if (element.diagnostics().errorCount() != before) return;
    if (!(angle > 0 && angle < kPi)) return element.errorAt("hfov", "is not between 0 and pi rad");
    camera.fx = camera.width / (camera.kind == LensKind::kFisheye ? angle : 2 * tan(angle / 2));
  } else {
    camera.fx = element.number("fx");
    if (element.diagnostics().errorCount() == before) requirePositive(element, "fx", camera.fx);
  }
  camera.fy = element.number("fy", camera.fx);
  if (element.has("fy") && element.diagnostics().errorCount() == before) requirePositive(element, "fy", camera.fy);
}

void readDistortion(const XmlElement& element, CameraModel& camera) {
  const std::string model = element.text("model", "");
  const std::vector<std::string> models{"plumb_bob", "rational", "fisheye"};
  if (element.has("model") && std::find(models.begin(), models.end(), model) == models.end()) {
    return element.errorAt("model", fmt::format("is {}, expected plumb_bob, rational or fisheye{}", quoted(model),
                                                nearestName(element.diagnostics(), model, models)));
  }
  if (model == "fisheye") camera.kind = LensKind::kFisheye;
  if (!element.has("kc")) return;
  const int before = element.diagnostics().errorCount();
  const std::vector<double> numbers = element.numbers("kc");
  if (element.diagnostics().errorCount() != before) return;
  const std::string problem = setLens(camera, model, numbers);
  if (!problem.empty()) element.errorAt("kc", problem);
}

void readInlineLens(const XmlElement& element, CameraMount& mount) {
  CameraModel& camera = mount.lens;
  camera.width = element.integer("width", 1, kLargestPicture);
  camera.height = element.integer("height", 1, kLargestPicture);
  readDistortion(element, camera);
  readFocalLength(element, camera);
  camera.cx = element.number("cx", 0.5 * (camera.width - 1));
  camera.cy = element.number("cy", 0.5 * (camera.height - 1));
  camera.skew = element.number("skew", 0);
}

/// Width and height: of the calibration file, or of the robot file where the other tells none; equal where both do.
void settleSize(const XmlElement& element, bool file_tells, CameraModel& camera) {
  const auto settle = [&](const char* attribute, int& size) {
    if (file_tells && !element.has(attribute)) return;
    const int before = element.diagnostics().errorCount();
    const int here = element.integer(attribute, 1, kLargestPicture);
    if (file_tells && here != size && element.diagnostics().errorCount() == before)
      element.errorAt(attribute, fmt::format("is {}, expected {} as in the calibration: a lens is calibrated at the "
                                             "size of its pictures",
                                             here, size));
    if (!file_tells) size = here;
  };
  settle("width", camera.width);
  settle("height", camera.height);
}

void readLensFile(const XmlElement& element, CameraMount& mount) {
  for (const char* attribute : kOfFile) {
    if (element.has(attribute)) element.errorAt(attribute, "stands beside \"lens\", expected one of them");
  }
  const std::string name = element.text("lens");
  if (name.empty()) return;
  const MeshPath path = findMesh(name, element.where().file);  // lenses lie where meshes do
  if (!path.file) return element.errorAt("lens", fmt::format("is {}, {}", quoted(name), path.problem));
  const std::optional<Calibration> calibration = readCalibrationFile(path.file->string(), element.diagnostics());
  if (!calibration) return;
  mount.lens = calibration->camera;
  settleSize(element, calibration->has_size, mount.lens);
}

void readTiming(const XmlElement& element, CameraMount& camera) {
  const int before = element.diagnostics().errorCount();
  camera.period = element.number("period");
  camera.phase = element.number("phase", 0);
  if (element.diagnostics().errorCount() != before) return;
  requirePositive(element, "period", camera.period);
  if (camera.phase < 0) element.errorAt("phase", "is negative, expected the time of the first picture [s]");
}

}  // namespace

CameraPart readCamera(const XmlElement& element, RobotPart& robot) {
  element.accept({"name", "xyz", "rpy", "width", "height", "hfov", "fx", "fy", "cx", "cy", "skew", "model", "kc",
                  "lens", "extrapolate", "period", "phase", "hides"},
                 {"property"});
  CameraPart part;
  CameraMount& camera = part.mount;
  camera.name = readName(element);
  camera.where = element.where();
  const Pose X_BMount = element.pose();
  camera.X_BC = {X_BMount.rotation * kR_MountCamera, X_BMount.translation};
  element.has("lens") ? readLensFile(element, camera) : readInlineLens(element, camera);
  camera.extrapolate = element.truth("extrapolate", false);
  readTiming(element, camera);
  for (const std::string& name : splitWords(element.has("hides") ? element.text("hides") : "")) {
    part.hides.push_back({name, element.where("hides")});
  }
  readProperties(element, camera.name, robot);
  return part;
}

}  // namespace murosimf::urdf
