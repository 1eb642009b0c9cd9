// Our distorted picture against MuJoCo's undistorted one of the same scene, drawn by its own renderer on a software
// OpenGL without a display. MuJoCo draws in one thread, with 16 x 10 facets, no shadows, no reflections, no samples but
// one a pixel, and reads colour and depth back; ours brings labels as well. Its lines are slabs, the circle of 40.

#include "camera_peer.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "camera_views.h"

namespace murosimf::bench {
namespace {

constexpr int kRounds = 31;
constexpr std::size_t kMessage = 500;

/// An OpenGL context of this thread without a window.
class SurfacelessContext {
 public:
  SurfacelessContext() {
    setenv("LP_NUM_THREADS", "0", 1);  // NOLINT: before the first thread. 0: llvmpipe draws in the calling thread
    setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);  // NOLINT
    const auto display_of =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (display_of == nullptr) throw std::runtime_error("no EGL without a display");
    display_ = display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config{};
    EGLint count = 0;
    if (!eglInitialize(display_, nullptr, nullptr) || !eglChooseConfig(display_, wanted, &config, 1, &count) ||
        count < 1 || !eglBindAPI(EGL_OPENGL_API))
      throw std::runtime_error("no software OpenGL");
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, nullptr);
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      throw std::runtime_error("no OpenGL context");
  }
  ~SurfacelessContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }
  SurfacelessContext(const SurfacelessContext&) = delete;
  SurfacelessContext& operator=(const SurfacelessContext&) = delete;

 private:
  EGLDisplay display_ = nullptr;
  EGLContext context_ = nullptr;
};

std::string colourText(const Colour& c) { return fmt::format("{} {} {} 1", c.red, c.green, c.blue); }

std::string geomText(const Drawable& d) {
  const Vector3 &h = d.shape.half_size, &p = d.X_WS.translation;
  const Rotation3& r = d.X_WS.rotation;
  const char* type = d.shape.kind == ShapeKind::kBox         ? "box"
                     : d.shape.kind == ShapeKind::kEllipsoid ? "ellipsoid"
                                                             : "cylinder";
  const std::string size =
      d.shape.kind == ShapeKind::kCylinder ? fmt::format("{} {}", h.x, h.z) : fmt::format("{} {} {}", h.x, h.y, h.z);
  return fmt::format("<geom type='{}' size='{}' pos='{} {} {}' xyaxes='{} {} {} {} {} {}' rgba='{}'/>\n", type, size,
                     p.x, p.y, p.z, r.x.x, r.x.y, r.x.z, r.y.x, r.y.y, r.y.z, colourText(d.colour));
}

/// Lines lie on the ground as slabs of a millimetre.
std::string lineText(const PaintedLine& line, const Colour& paint) {
  const double dx = line.b_x - line.a_x, dy = line.b_y - line.a_y;
  const Drawable slab{
      makeBox({std::hypot(dx, dy), line.width, 0.001}),
      {rotationZ(std::atan2(dy, dx)), {0.5 * (line.a_x + line.b_x), 0.5 * (line.a_y + line.b_y), 0.0005}},
      paint};
  return geomText(slab);
}

/// A ring of straight pieces.
std::string circleText(const PaintedCircle& c, const Colour& paint) {
  constexpr int kPieces = 40;
  std::string text;
  for (int k = 0; k < kPieces; ++k) {
    const double a = 2 * kPi * k / kPieces, b = 2 * kPi * (k + 1) / kPieces;
    text += lineText({c.x + c.radius * std::cos(a), c.y + c.radius * std::sin(a), c.x + c.radius * std::cos(b),
                      c.y + c.radius * std::sin(b), c.width},
                     paint);
  }
  return text;
}

std::string modelText(const RayScene& scene, const CameraModel& camera) {
  const PaintedGround& g = scene.ground;
  std::string text =
      "<mujoco><compiler angle='radian'/><visual><quality offsamples='0' numslices='16' numstacks='10' "
      "numquads='4'/><map znear='0.02' zfar='20'/><headlight active='0'/></visual><worldbody>\n";
  text += fmt::format("<light directional='true' pos='0 0 3' dir='{} {} {}' ambient='.4 .4 .4'/>\n", -scene.light_W.x,
                      -scene.light_W.y, -scene.light_W.z);
  text +=
      fmt::format("<geom type='plane' size='{} {} 1' rgba='{}'/>\n", g.half_length, g.half_width, colourText(g.carpet));
  for (const PaintedLine& line : g.lines) text += lineText(line, g.paint);
  for (const PaintedCircle& circle : g.circles) text += circleText(circle, g.paint);
  for (const Drawable& d : scene.drawables) text += geomText(d);
  return text + fmt::format("<camera name='eye' fovy='{}'/></worldbody></mujoco>",
                            180 / kPi * 2 * std::atan(0.5 * camera.height / camera.fy));
}

class MujocoPictures {
 public:
  MujocoPictures(const CameraViews& views, const CameraModel& camera) : views_(views) {
    const std::string text = modelText(views.scene, camera);
    const auto files = std::make_unique<mjVFS>();
    mj_defaultVFS(files.get());
    mj_makeEmptyFileVFS(files.get(), "game.xml", static_cast<int>(text.size()));
    std::copy(text.begin(), text.end(), static_cast<char*>(files->filedata[0]));
    char fault[kMessage] = "";
    model_.reset(mj_loadXML("game.xml", files.get(), fault, static_cast<int>(kMessage)));
    mj_deleteVFS(files.get());
    if (!model_) throw std::runtime_error(fmt::format("MuJoCo does not take the scene: {}", fault));
    model_->vis.global.offwidth = camera.width, model_->vis.global.offheight = camera.height;
    data_.reset(mj_makeData(model_.get()));
    mj_forward(model_.get(), data_.get());
    mjv_defaultScene(&scene_), mjv_makeScene(model_.get(), &scene_, 2000);
    mjr_defaultContext(&context_), mjr_makeContext(model_.get(), &context_, mjFONTSCALE_50);
    mjr_setBuffer(mjFB_OFFSCREEN, &context_);
    for (const int flag : {mjRND_SHADOW, mjRND_REFLECTION, mjRND_SKYBOX, mjRND_HAZE, mjRND_FOG}) scene_.flags[flag] = 0;
    mjv_defaultOption(&option_), mjv_defaultCamera(&camera_);
    camera_.type = mjCAMERA_FIXED, camera_.fixedcamid = 0;
    rectangle_ = {0, 0, camera.width, camera.height};
    colour_.resize(static_cast<std::size_t>(3 * camera.width * camera.height));
    depth_.resize(static_cast<std::size_t>(camera.width * camera.height));
  }
  ~MujocoPictures() { mjr_freeContext(&context_), mjv_freeScene(&scene_); }
  MujocoPictures(const MujocoPictures&) = delete;
  MujocoPictures& operator=(const MujocoPictures&) = delete;

  void frame() {
    const Pose& X_WC = views_.X_WC[next_];
    next_ = (next_ + 1) % views_.X_WC.size();
    for (int i = 0; i < 3; ++i) {  // MuJoCo's cameras have y up and look along -z
      data_->cam_xpos[i] = X_WC.translation[i];
      data_->cam_xmat[3 * i] = X_WC.rotation.x[i];
      data_->cam_xmat[3 * i + 1] = -X_WC.rotation.y[i];
      data_->cam_xmat[3 * i + 2] = -X_WC.rotation.z[i];
    }
    mjv_updateScene(model_.get(), data_.get(), &option_, nullptr, &camera_, mjCAT_ALL, &scene_);
    mjr_render(rectangle_, &scene_, &context_);
    mjr_readPixels(colour_.data(), depth_.data(), rectangle_, &context_);
  }
  /// Colours of the last picture, row 0 on top.
  Picture picture() const {
    Picture out;
    out.has_depth = out.has_label = false;
    out.resize(rectangle_.width, rectangle_.height);
    const auto row = static_cast<std::ptrdiff_t>(3 * rectangle_.width);
    for (int v = 0; v < rectangle_.height; ++v)
      std::copy_n(colour_.begin() + (rectangle_.height - 1 - v) * row, row, out.rgb.begin() + v * row);
    return out;
  }

 private:
  struct Free {
    void operator()(mjModel* m) const { mj_deleteModel(m); }
    void operator()(mjData* d) const { mj_deleteData(d); }
  };
  const CameraViews& views_;
  std::unique_ptr<mjModel, Free> model_;
  std::unique_ptr<mjData, Free> data_;
  mjvScene scene_{};
  mjrContext context_{};
  mjvOption option_{};
  mjvCamera camera_{};
  mjrRect rectangle_{};
  std::vector<unsigned char> colour_;
  std::vector<float> depth_;
  std::size_t next_ = 0;
};

}  // namespace

std::vector<Row> cameraAgainstMujoco() {
  const SurfacelessContext context;
  const CameraViews views = makeCameraViews(6);
  MujocoPictures peer(views, straightCameraOfViews());
  std::vector<CastLanes> lanes{CastLanes::kEight};
  if (isSupported(CastLanes::kSixteen)) lanes.push_back(CastLanes::kSixteen);
  std::vector<std::unique_ptr<CameraFrames>> ours;
  std::vector<std::function<void()>> frames;
  for (const CastLanes l : lanes) {
    CameraFrames* const camera = ours.emplace_back(std::make_unique<CameraFrames>(lensOfViews(), 6, l)).get();
    frames.emplace_back([camera] {
      for (int i = 0; i < 6; ++i) camera->frame();
    });
  }
  const auto results = compareFrames(
      frames,
      [&peer] {
        for (int i = 0; i < 6; ++i) peer.frame();
      },
      kRounds);
  std::vector<Row> rows;
  for (std::size_t i = 0; i < lanes.size(); ++i) {
    Row& row = rows.emplace_back(Row{"camera_vs_mujoco", results[i].ratio, 1e3 * results[i].ours / 6,
                                     1e3 * results[i].peer / 6, "ms/picture",
                                     lanes[i] == CastLanes::kSixteen ? "avx512" : "avx2", ""});
    row.text = fmt::format("{:28} {:7} {:6.1f} times MuJoCo {} without distortion ({:.3f} ms, {:.2f} ms a picture)",
                           row.name, row.isa, row.ratio, mj_versionString(), row.ours, row.peer);
  }
  return rows;
}

}  // namespace murosimf::bench
