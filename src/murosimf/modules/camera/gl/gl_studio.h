#pragma once

/// @file Where the pictures of all cameras that OpenGL draws for are made: one hidden context on one thread.
///
/// What was ordered until start() is drawn together, in one atlas, or in as few as hold it. It comes back while the
/// simulation goes on and, if there is more to do, while the next is drawn. Who draws what, and together with whom,
/// depends on the orders alone, never on how long anything takes.

#include <condition_variable>
#include <deque>
#include <exception>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "murosimf/modules/camera/picture_maker.h"
#include "murosimf/render/gl/gl_camera_renderer.h"
#include "murosimf/render/gl/gl_context.h"

namespace murosimf {

class GlStudio {
 public:
  /// @throws std::runtime_error when there is no OpenGL without display, std::invalid_argument as GlField does
  explicit GlStudio(const PaintedGround& ground);
  ~GlStudio();
  GlStudio(const GlStudio&) = delete;
  GlStudio& operator=(const GlStudio&) = delete;

  const GlIdentity& identity() const { return identity_; }
  /// A camera comes. @return its number. @throws std::invalid_argument when its picture is larger than the driver
  /// allows
  std::size_t add(const PictureWish& wish);

  // As in PictureMaker. One camera's calls come one after another; @throws what happened on the studio's thread.
  void order(std::size_t camera, const PictureOrder& order);
  void start();
  void settle(std::size_t camera);
  void fetch(std::size_t camera, Picture& picture);

 private:
  struct Camera;
  struct Shot {
    enum class State : std::uint8_t { kOrdered, kDrawn, kDone };
    Camera* camera = nullptr;
    PictureOrder order;
    State state = State::kOrdered;
    Picture picture;
  };
  struct Camera {
    PictureWish wish;
    std::vector<Shot> shots;  // a ring
    std::size_t first = 0, count = 0;
    Shot& at(std::size_t i) { return shots[(first + i) % shots.size()]; }
  };
  using Sheet = std::vector<Shot*>;  // what stands together in an atlas
  struct Tools;                      // what lives with the context

  void serve(const PaintedGround& ground);
  void work(Tools& tools);
  static void draw(Tools& tools, const Sheet& sheet, const PictureSize& room);
  static void read(Tools& tools, const Sheet& sheet);
  void checkFault() const;

  GlIdentity identity_;
  int most_rows_ = 0;  // of an atlas, and of its columns
  mutable std::mutex mutex_;
  std::condition_variable for_studio_, for_cameras_;
  // What the mutex guards.
  std::vector<std::unique_ptr<Camera>> cameras_;
  PictureSize room_;  // that all of their pictures need, as far as an atlas may have it
  Sheet ordered_;
  std::deque<Sheet> sheets_;  // that were started and not drawn yet
  std::exception_ptr fault_;
  bool ready_ = false, stops_ = false;

  std::thread thread_;
};

}  // namespace murosimf
