#pragma once

/// @file A video file, written by an ffmpeg process that is fed raw pictures through a pipe.

#include <sys/types.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

namespace murosimf {

/// H.264 in yuv420p, so width and height must be even.
struct VideoFormat {
  int width = 960, height = 540;   ///< [px]
  int pictures_per_second = 25;    ///< of the video
  std::string program = "ffmpeg";  ///< looked for along PATH
};

class VideoPipe {
 public:
  /// Starts the process. @throws std::runtime_error naming the file and the reason: the file cannot be written, the
  /// program cannot be found.
  VideoPipe(const std::filesystem::path& file, const VideoFormat& format);
  /// Closes the pipe and waits for the process.
  ~VideoPipe();
  VideoPipe(const VideoPipe&) = delete;
  VideoPipe& operator=(const VideoPipe&) = delete;

  /// Sends one picture of width * height * 3 bytes; waits while the process is busy. @returns false when the process
  /// does not read any more; SIGPIPE is not raised.
  bool write(std::span<const std::uint8_t> rgb);
  /// Closes the pipe, waits for the process to complete the file. @returns what went wrong, with the exit status and
  /// the process' last words; empty: nothing. Further calls return the same.
  std::string finish();

 private:
  void spawn(const VideoFormat& format, int read_end);
  std::string lastWords() const;

  struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::filesystem::path file_;
  std::string program_, error_;
  std::unique_ptr<std::FILE, CloseFile> messages_;  // what the process writes to stderr
  int pipe_ = -1;
  pid_t process_ = -1;
};

}  // namespace murosimf
