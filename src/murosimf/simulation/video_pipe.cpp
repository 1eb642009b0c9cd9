#include "murosimf/simulation/video_pipe.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <vector>

extern char** environ;

namespace murosimf {

namespace {

/// ffmpeg's arguments: raw pictures from stdin, H.264 out, nothing asked.
std::vector<std::string> argumentsOf(const std::filesystem::path& file, const VideoFormat& format) {
  const std::string output = file.is_absolute() ? file.string() : "./" + file.string();  // never read as an option
  return {format.program, "-loglevel",
          "error",        "-y",
          "-f",           "rawvideo",
          "-pix_fmt",     "rgb24",
          "-video_size",  fmt::format("{}x{}", format.width, format.height),
          "-framerate",   std::to_string(format.pictures_per_second),
          "-i",           "-",
          "-an",          "-c:v",
          "libx264",      "-preset",
          "veryfast",     "-pix_fmt",
          "yuv420p",      output};
}

std::string howItEnded(int status) {
  if (WIFEXITED(status)) return fmt::format("ended with exit status {}", WEXITSTATUS(status));
  return fmt::format("was ended by signal {}", WTERMSIG(status));
}

/// SIGPIPE is kept from the calling thread while this lives, and taken off it where it came.
class WithoutSigpipe {
 public:
  WithoutSigpipe() {
    sigemptyset(&set_);
    sigaddset(&set_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &set_, &before_);
  }
  ~WithoutSigpipe() {
    if (sigismember(&before_, SIGPIPE) == 0) {
      const timespec at_once{0, 0};
      while (sigtimedwait(&set_, nullptr, &at_once) > 0) {
      }
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }
  WithoutSigpipe(const WithoutSigpipe&) = delete;
  WithoutSigpipe& operator=(const WithoutSigpipe&) = delete;

 private:
  sigset_t set_, before_;
};

}  // namespace

VideoPipe::VideoPipe(const std::filesystem::path& file, const VideoFormat& format)
    : file_(file), program_(format.program) {
  if (format.width < 2 || format.height < 2 || format.width % 2 != 0 || format.height % 2 != 0) {
    throw std::runtime_error(fmt::format("{}: cannot film in {} x {} pixels: width and height must be even",
                                         file_.string(), format.width, format.height));
  }
  // Opened to append, so that an earlier film stays until ffmpeg has started.
  if (!std::ofstream(file_, std::ios::binary | std::ios::app)) {
    throw std::runtime_error(fmt::format("{}: cannot write the video: {}", file_.string(), std::strerror(errno)));
  }
  messages_.reset(std::tmpfile());
  int ends[2];
  if (messages_ == nullptr || pipe2(ends, O_CLOEXEC) != 0) {
    throw std::runtime_error(fmt::format("{}: cannot start {}: {}", file_.string(), program_, std::strerror(errno)));
  }
  pipe_ = ends[1];
  spawn(format, ends[0]);
}

void VideoPipe::spawn(const VideoFormat& format, int read_end) {
  std::vector<std::string> arguments = argumentsOf(file_, format);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, read_end, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(messages_.get()), STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&files, fileno(messages_.get()), STDERR_FILENO);
  // A group of its own: an interrupt from the keyboard ends the run, and the video then ends where the pipe does.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  posix_spawnattr_setpgroup(&attributes, 0);
  const int error = posix_spawnp(&process_, program_.c_str(), &files, &attributes, pointers.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  close(read_end);
  if (error == 0) return;
  close(pipe_);
  std::error_code failed;
  const auto size = std::filesystem::file_size(file_, failed);
  if (!failed && size == 0) std::filesystem::remove(file_, failed);  // of the constructor's trial
  throw std::runtime_error(
      error == ENOENT
          ? fmt::format(
                "{}: cannot film: found no program {} (on Debian: apt install ffmpeg; or film nothing: --video none)",
                file_.string(), program_)
          : fmt::format("{}: cannot film: {} does not start: {}", file_.string(), program_, std::strerror(error)));
}

VideoPipe::~VideoPipe() { finish(); }

bool VideoPipe::write(std::span<const std::uint8_t> rgb) {
  const WithoutSigpipe guard;
  while (!rgb.empty() && pipe_ >= 0) {
    const ssize_t written = ::write(pipe_, rgb.data(), rgb.size());
    if (written > 0) rgb = rgb.subspan(static_cast<std::size_t>(written));
    if (written < 0 && errno != EINTR) return false;
  }
  return pipe_ >= 0;
}

std::string VideoPipe::finish() {
  if (pipe_ >= 0) close(pipe_);
  pipe_ = -1;
  if (process_ < 0) return error_;
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (status != 0) {
    error_ = fmt::format("{}: the video is not complete: {} {}{}", file_.string(), program_, howItEnded(status),
                         lastWords());
  }
  return error_;
}

std::string VideoPipe::lastWords() const {
  constexpr long kMost = 400;
  std::fseek(messages_.get(), 0, SEEK_END);
  const long size = std::ftell(messages_.get());
  std::fseek(messages_.get(), std::max(0L, size - kMost), SEEK_SET);
  std::string words(static_cast<std::size_t>(std::min(size, kMost)), '\0');
  words.resize(std::fread(words.data(), 1, words.size(), messages_.get()));
  while (!words.empty() && words.back() == '\n') words.pop_back();
  return words.empty() ? "" : ": " + words;
}

}  // namespace murosimf
