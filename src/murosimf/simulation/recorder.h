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

/// Register with Simulation::observe; where other observers change nothing between frames the order does not matter.
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
  void writeHeader();
  void writeInterventions(const Simulation& simulation);
  void writeColumn(std::uint32_t column, const double* now);
  void flush(std::size_t at_least);

  struct CloseFile {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };
  std::filesystem::path file_;
  std::unique_ptr<std::FILE, CloseFile> stream_;
  RecordingHeader header_;
  std::vector<double> last_, now_;  // numbers of all columns
  std::size_t logged_ = 0;          // interventions written
  std::uint64_t frames_ = 0;
  ByteWriter bytes_;
  std::string error_;
};

}  // namespace murosimf
