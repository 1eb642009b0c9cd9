#pragma once

/// @file Records a run: every state variable that changed, after every frame, and every intervention.

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "murosimf/simulation/byte_writer.h"
#include "murosimf/simulation/recording.h"
#include "murosimf/simulation/simulation.h"

namespace murosimf {

/// Register with Simulation::observe. Recording begins with the next frame that is run.
class Recorder final : public FrameObserver {
 public:
  /// @throws std::runtime_error naming the file when it cannot be written.
  Recorder(const std::filesystem::path& file, const Simulation& simulation, const std::string& scenario,
           std::uint64_t seed);
  ~Recorder() override;

  /// Cost: a comparison per number; writes go through a buffer of 1 MiB.
  void afterFrame(Simulation& simulation) override;
  /// Marks the end and closes the file. @returns what went wrong, with the file's name (disk full); empty: nothing.
  std::string finish();

 private:
  void begin(const Simulation& simulation);
  void writeHeader();
  void writeInterventions(const Simulation& simulation, long frame);
  void writeFrame(long frame);
  bool writeColumn(std::uint32_t column);
  void flush();

  struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::filesystem::path file_;
  std::unique_ptr<std::FILE, CloseFile> stream_;
  RecordingHeader header_;
  std::vector<std::uint64_t> last_, now_;  // bits of all columns' numbers
  std::uint64_t frames_ = 0;
  bool begun_ = false;
  ByteWriter bytes_;
  std::string error_;
};

}  // namespace murosimf
