#pragma once

/// @file Films a run from above: a picture every 1/25 s of simulated time, rendered and encoded beside the frame.
///
/// The frame thread copies poses into a shot (some 10 us) and goes on; another thread renders the shots in order and
/// feeds ffmpeg. It waits only when all shots of the queue are still to be rendered. Physics does not notice.

#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "murosimf/simulation/overview.h"
#include "murosimf/simulation/video_pipe.h"

namespace murosimf {

struct FilmSettings {
  std::filesystem::path file;
  VideoFormat format;
  std::function<std::string(double time)> caption;  ///< asked on the frame thread; empty: the time alone
  TagText tag_text;                                 ///< may be empty
  std::size_t queue = 4;                            ///< shots that may wait to be rendered, > 0
};

struct FilmReport {
  long pictures = 0;          ///< rendered and sent
  double render_seconds = 0;  ///< on the film's thread
  double encode_seconds = 0;  ///< on the film's thread, waiting for ffmpeg
  double wait_seconds = 0;    ///< of the frame thread, for room in the queue
  std::string error;          ///< empty: the file is complete
};

class Film final : public FrameObserver {
 public:
  /// Starts ffmpeg. The first picture shows the end of the next frame. @throws std::runtime_error as VideoPipe.
  Film(Simulation& simulation, FilmSettings settings);
  ~Film() override;

  void afterFrame(Simulation& simulation) override;
  /// Renders what is waiting, completes the file. A failure of ffmpeg is in the report; the run went on without it.
  FilmReport finish();

 private:
  bool isDue(const Simulation& simulation);
  OverviewShot& emptyShot();
  void renderShots();
  bool nextShot(OverviewShot*& shot);

  FilmSettings settings_;
  OverviewSource source_;
  Overview overview_;
  VideoPipe video_;
  long rate_, last_tick_ = -1;  // of pictures: number of the last one since the world began
  FilmReport report_;           // the frame thread's
  long pictures_ = 0;           // the film thread's, as the next line
  double render_seconds_ = 0, encode_seconds_ = 0;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<OverviewShot> shots_;
  std::deque<OverviewShot*> free_, waiting_;  // guarded by mutex_, as is ended_
  bool ended_ = false;
  std::thread thread_;
};

}  // namespace murosimf
