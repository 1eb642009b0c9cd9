#include "murosimf-view/film_strip.h"

#include <algorithm>

namespace murosimf {

void FilmStrip::start(const std::string& file, int width, int height) {
  VideoFormat format;
  width_ = format.width = width / 2 * 2;
  height_ = format.height = height / 2 * 2;
  format.pictures_per_second = kRate;
  pipe_ = std::make_unique<VideoPipe>(file, format);
  file_ = file;
  pictures_ = 0;
  next_ = -1;
}

std::string FilmStrip::stop() {
  if (pipe_ == nullptr) return "";
  std::string problem = pipe_->finish();
  pipe_.reset();
  return problem;
}

bool FilmStrip::isDue(double time) const { return isRunning() && time >= next_ - 1e-9; }

void FilmStrip::add(const Picture& picture, double time) {
  if (picture.width < width_ || picture.height < height_) return;  // the window was made smaller
  const auto row = static_cast<std::size_t>(3 * width_);
  cut_.resize(row * static_cast<std::size_t>(height_));
  for (int v = 0; v < height_; ++v) {
    const std::size_t from = 3 * picture.index(0, v);
    std::copy_n(picture.rgb.begin() + static_cast<std::ptrdiff_t>(from), row,
                cut_.begin() + static_cast<std::ptrdiff_t>(static_cast<std::size_t>(v) * row));
  }
  next_ = (next_ < 0 ? time : next_) + 1.0 / kRate;
  if (next_ < time) next_ = time + 1.0 / kRate;
  if (pipe_->write(cut_)) ++pictures_;
}

}  // namespace murosimf
