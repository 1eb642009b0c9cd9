#include "murosimf/simulation/film.h"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <utility>

namespace murosimf {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

}  // namespace

Film::Film(Simulation& simulation, FilmSettings settings)
    : settings_(std::move(settings)),
      source_(simulation, settings_.tag_text),
      overview_(settings_.format.width, settings_.format.height, simulation.view().initialScene().ground),
      video_(settings_.file, settings_.format),
      rate_(settings_.format.pictures_per_second),
      shots_(std::max<std::size_t>(1, settings_.queue), source_.emptyShot()) {
  for (OverviewShot& shot : shots_) free_.push_back(&shot);
  thread_ = std::thread([this] { renderShots(); });
}

Film::~Film() { finish(); }

bool Film::isDue(const Simulation& simulation) {
  // Picture k belongs to the end of the frame in which k / rate seconds are reached, so rounding never drifts.
  const auto tick = static_cast<long>(std::floor(simulation.time() * static_cast<double>(rate_) + 1e-6));
  return std::exchange(last_tick_, tick) != tick;
}

void Film::afterFrame(Simulation& simulation) {
  if (!thread_.joinable() || !isDue(simulation)) return;
  OverviewShot& shot = emptyShot();
  source_.take(shot);
  shot.caption = settings_.caption ? settings_.caption(simulation.time()) : fmt::format("T {:.2f}", simulation.time());
  const std::lock_guard lock(mutex_);
  waiting_.push_back(&shot);
  changed_.notify_all();
}

OverviewShot& Film::emptyShot() {
  std::unique_lock lock(mutex_);
  if (free_.empty()) {
    const Clock::time_point start = Clock::now();
    changed_.wait(lock, [&] { return !free_.empty(); });
    report_.wait_seconds += secondsSince(start);
  }
  OverviewShot& shot = *free_.front();
  free_.pop_front();
  return shot;
}

bool Film::nextShot(OverviewShot*& shot) {
  std::unique_lock lock(mutex_);
  if (shot != nullptr) free_.push_back(shot);  // the one that was rendered last
  changed_.notify_all();
  changed_.wait(lock, [&] { return ended_ || !waiting_.empty(); });
  if (waiting_.empty()) return false;
  shot = waiting_.front();
  waiting_.pop_front();
  return true;
}

void Film::renderShots() {
  bool alive = true;  // ffmpeg reads; when it has failed, shots are only taken off the queue
  OverviewShot* shot = nullptr;
  while (nextShot(shot)) {
    if (!alive) continue;
    Clock::time_point start = Clock::now();
    const Picture& picture = overview_.render(*shot);
    render_seconds_ += secondsSince(start);
    start = Clock::now();
    alive = video_.write(picture.rgb);
    encode_seconds_ += secondsSince(start);
    pictures_ += alive ? 1 : 0;
  }
}

FilmReport Film::finish() {
  if (!thread_.joinable()) return report_;
  {
    const std::lock_guard lock(mutex_);
    ended_ = true;
    changed_.notify_all();
  }
  thread_.join();
  report_.error = video_.finish();
  report_.pictures = pictures_;
  report_.render_seconds = render_seconds_;
  report_.encode_seconds = encode_seconds_;
  return report_;
}

}  // namespace murosimf
