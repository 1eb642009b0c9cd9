#pragma once

/// @file Two ways of doing the same work, compared by the ratio of their times.
///
/// Machines slow down and speed up by factors while others use them, so times of different sittings do not compare.
/// All ways run in turns, a few milliseconds each; the median of the ratios of the rounds is the result. Every block is
/// long against what the one before it leaves behind: caches, and the lower clock after wide registers.

#include <functional>
#include <string>
#include <vector>

namespace murosimf::bench {

/// One row of the report.
struct Row {
  std::string name;
  double ratio = 0;           ///< peer over ours, how many times faster ours is; or as the text says
  double ours = 0, peer = 0;  ///< medians
  std::string unit;           ///< of `ours` and `peer`
  std::string isa;            ///< instruction set of ours: scalar, avx2, avx512
  std::string text;           ///< for people
};

/// Seconds of a clock that is cheap to read. What interrupts a round is an outlier that the median drops.
double now();
/// Processor time of this thread [s]: does not run while others have the processor.
double threadTime();

double median(std::vector<double> values);
/// Medians over rounds.
struct Comparison {
  double ratio = 0, ours = 0, peer = 0;
};
/// Each of `ours` and `peer` does one round's work and returns the seconds that count.
Comparison compare(const std::function<double()>& ours, const std::function<double()>& peer, int rounds);
/// Each of `ours`, and `peer`, makes one frame. They run in blocks of so many frames that a block takes about 5 ms; all
/// of `ours` and the peer share a round. Results are in seconds a frame.
std::vector<Comparison> compareFrames(const std::vector<std::function<void()>>& ours, const std::function<void()>& peer,
                                      int rounds);

/// The lane widths that this machine can run, 1 first, and the instruction set that each takes.
std::vector<int> laneWidths();
std::string isaOf(int lanes);
int widestLanes();
std::string widestIsa();

/// Comparisons that belong together. Throws std::runtime_error when there is nothing to compare: a robot has fallen.
using Part = std::function<std::vector<Row>()>;
/// The parts of the report, in its order. One function a file of bench/.
std::vector<Part> peerParts();  ///< MuJoCo and ODE; where these are missing, a line that says so
std::vector<Part> growthParts();
std::vector<Part> fieldParts();
std::vector<Part> fullDynamicsParts();
std::vector<Part> passParts();
std::vector<Part> kinematicParts();
std::vector<Part> collisionParts();
std::vector<Part> cameraParts();
std::vector<Part> glParts();  ///< pictures through OpenGL; where that is not built, a line that says so

}  // namespace murosimf::bench
