#include "murosimf/modules/camera/gl/gl_studio.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace murosimf {

namespace {

constexpr int kMostRows = 8192;  // of an atlas: 17 pictures of 480 rows

PictureSize sizeOf(const PictureWish& wish) { return {wish.rays->camera().width, wish.rays->camera().height}; }

}  // namespace

/// The studio's thread makes, uses and destroys it.
struct GlStudio::Tools {
  explicit Tools(const PaintedGround& ground) : context(makeHiddenContext()), renderer(ground) {}
  const GlLens& lensOf(const RayTable& rays) {
    std::unique_ptr<GlLens>& lens = lenses[&rays];
    if (lens == nullptr) lens = std::make_unique<GlLens>(rays);
    return *lens;
  }
  bool hasRoom(const PictureSize& room) const {
    return atlas != nullptr && has.width >= room.width && has.height >= room.height;
  }

  std::unique_ptr<GlContext> context;
  GlCameraRenderer renderer;
  std::map<const RayTable*, std::unique_ptr<GlLens>> lenses;
  std::unique_ptr<GlAtlas> atlas;
  PictureSize has;  // the atlas
  std::vector<PictureSize> sizes;
  std::vector<Picture*> pictures;
  std::deque<Sheet> reading;
};

GlStudio::GlStudio(const PaintedGround& ground) : thread_([this, &ground] { serve(ground); }) {
  std::unique_lock lock(mutex_);
  for_cameras_.wait(lock, [this] { return ready_ || fault_ != nullptr; });
  if (fault_ == nullptr) return;
  lock.unlock();
  thread_.join();
  std::rethrow_exception(fault_);
}

GlStudio::~GlStudio() {
  {
    const std::lock_guard lock(mutex_);
    stops_ = true;
  }
  for_studio_.notify_all();
  thread_.join();
}

std::size_t GlStudio::add(const PictureWish& wish) {
  const PictureSize size = sizeOf(wish);
  if (size.width > most_rows_ || size.height > most_rows_)
    throw std::invalid_argument(fmt::format("{} x {} pixels, expected at most {} x {} of what OpenGL draws", size.width,
                                            size.height, most_rows_, most_rows_));
  const std::lock_guard lock(mutex_);
  Camera& camera = *cameras_.emplace_back(std::make_unique<Camera>());
  camera.wish = wish;
  camera.shots.resize(std::max<std::size_t>(wish.most, 1));
  room_ = {std::max(room_.width, size.width), std::min(room_.height + size.height, most_rows_)};
  return cameras_.size() - 1;
}

void GlStudio::order(std::size_t camera, const PictureOrder& order) {
  const std::lock_guard lock(mutex_);
  checkFault();
  Camera& taker = *cameras_[camera];
  if (taker.count == taker.shots.size()) throw std::logic_error("a camera orders more pictures than it fetches");
  Shot& shot = taker.at(taker.count++);
  shot.camera = &taker, shot.order = order, shot.state = Shot::State::kOrdered;
  shot.picture.has_depth = taker.wish.depth;
  ordered_.push_back(&shot);
}

void GlStudio::start() {
  const std::lock_guard lock(mutex_);
  int rows = 0;
  for (Shot* shot : ordered_) {
    const int height = sizeOf(shot->camera->wish).height;
    if (rows == 0 || rows + height > most_rows_) sheets_.emplace_back(), rows = 0;
    sheets_.back().push_back(shot);
    rows += height;
  }
  ordered_.clear();
  for_studio_.notify_one();
}

void GlStudio::settle(std::size_t camera) {
  std::unique_lock lock(mutex_);
  Camera& taker = *cameras_[camera];
  const auto drawn = [&] { return taker.count == 0 || taker.at(taker.count - 1).state != Shot::State::kOrdered; };
  for_cameras_.wait(lock, [&] { return drawn() || fault_ != nullptr; });
  checkFault();
}

void GlStudio::fetch(std::size_t camera, Picture& picture) {
  std::unique_lock lock(mutex_);
  Camera& taker = *cameras_[camera];
  if (taker.count == 0) throw std::logic_error("a camera fetches a picture that it has not ordered");
  Shot& shot = taker.at(0);
  for_cameras_.wait(lock, [&] { return shot.state == Shot::State::kDone || fault_ != nullptr; });
  checkFault();
  std::swap(shot.picture, picture);
  taker.first = (taker.first + 1) % taker.shots.size();
  --taker.count;
}

void GlStudio::checkFault() const {
  if (fault_ != nullptr) std::rethrow_exception(fault_);
}

void GlStudio::serve(const PaintedGround& ground) {
  try {
    Tools tools(ground);
    identity_ = identifyGl();
    GLint most = 0;
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    most_rows_ = std::min(most, kMostRows);
    {
      const std::lock_guard lock(mutex_);
      ready_ = true;
    }
    for_cameras_.notify_all();
    work(tools);
  } catch (...) {
    const std::lock_guard lock(mutex_);
    fault_ = std::current_exception();
    for_cameras_.notify_all();
  }
}

/// Draws while it may; what was drawn first comes back when nothing waits, or there is no room for more.
void GlStudio::work(Tools& tools) {
  std::unique_lock lock(mutex_);
  for (;;) {
    for_studio_.wait(lock, [&] { return stops_ || !sheets_.empty() || !tools.reading.empty(); });
    if (stops_) return;
    const PictureSize room = room_;
    const bool may_draw = tools.reading.empty() || (tools.hasRoom(room) && tools.reading.size() < GlAtlas::kUnderWay);
    const bool draws = !sheets_.empty() && may_draw;
    std::deque<Sheet>& from = draws ? sheets_ : tools.reading;
    Sheet sheet = std::move(from.front());
    from.pop_front();
    lock.unlock();
    if (draws)
      draw(tools, sheet, room);
    else
      read(tools, sheet);
    lock.lock();
    for (Shot* shot : sheet) shot->state = draws ? Shot::State::kDrawn : Shot::State::kDone;
    if (draws) tools.reading.push_back(std::move(sheet));
    for_cameras_.notify_all();
  }
}

void GlStudio::draw(Tools& tools, const Sheet& sheet, const PictureSize& room) {
  if (!tools.hasRoom(room)) {
    tools.atlas = std::make_unique<GlAtlas>(std::vector<PictureSize>{room});
    tools.has = room;
  }
  tools.sizes.clear();
  bool depths = false;
  for (const Shot* shot : sheet) {
    tools.sizes.push_back(sizeOf(shot->camera->wish));
    depths = depths || shot->camera->wish.depth;
  }
  tools.atlas->arrange(tools.sizes);
  tools.atlas->clear(sheet.front()->order.scene->sky);
  for (std::size_t i = 0; i < sheet.size(); ++i) {
    const PictureWish& wish = sheet[i]->camera->wish;
    const PictureOrder& order = sheet[i]->order;
    tools.renderer.draw(tools.lensOf(*wish.rays), *order.scene, order.place.X_WC, wish.hidden, *tools.atlas, i);
  }
  tools.atlas->beginReading(depths);
}

void GlStudio::read(Tools& tools, const Sheet& sheet) {
  tools.pictures.clear();
  for (Shot* shot : sheet) tools.pictures.push_back(&shot->picture);
  tools.atlas->finishReading(tools.pictures);
}

}  // namespace murosimf
