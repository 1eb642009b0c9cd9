#pragma once

/// @file A video of what the window shows: a picture every 1/25 s of simulated time.

#include <memory>
#include <string>

#include "murosimf/algorithms/picture.h"
#include "murosimf/simulation/video_pipe.h"

namespace murosimf {

class FilmStrip {
 public:
  bool isRunning() const { return pipe_ != nullptr; }
  /// Starts a file; width and height are cut to even numbers. @throws std::runtime_error as VideoPipe
  void start(const std::string& file, int width, int height);
  /// Ends it. @returns what went wrong; empty: nothing
  std::string stop();
  /// Whether a picture is due at this simulated time. Going back makes none.
  bool isDue(double time) const;
  /// Sends a picture of the window, of the size that start() was told or larger.
  void add(const Picture& picture, double time);
  const std::string& file() const { return file_; }
  long pictures() const { return pictures_; }

 private:
  static constexpr int kRate = 25;
  std::unique_ptr<VideoPipe> pipe_;
  std::string file_;
  int width_ = 0, height_ = 0;
  long pictures_ = 0;
  double next_ = -1;  // [s]
  std::vector<std::uint8_t> cut_;
};

}  // namespace murosimf
