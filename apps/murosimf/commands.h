#pragma once

/// @file The commands of the command line. Each returns the exit code of the program.

#include <string>
#include <vector>

namespace murosimf {

inline constexpr int kFault = 1;       ///< something of ours went wrong
inline constexpr int kDifferent = 1;   ///< two runs are not the same
inline constexpr int kWrongInput = 2;  ///< something in what people wrote is wrong

struct RunArguments {
  std::string scenario;
  std::vector<std::string> overrides;  ///< PATH=VALUE
  std::string out, record, video;      ///< empty: as the scenario says
  std::string checkpoint, from;        ///< files; empty: none
  double checkpoint_time = -1;         ///< [s]; below 0: at the end
  bool report_only = false;            ///< writes and prints nothing; the caller asks for the report
};

/// Plays a scenario and writes report, pictures and film.
int runScenario(const RunArguments& arguments);
struct RenderArguments {
  std::string scenario;
  std::vector<std::string> overrides;  ///< PATH=VALUE
  std::vector<std::string> cameras;    ///< paths; none: all
  double at = 0;                       ///< time of the picture, of a dataset's first ones [s]
  std::string as = "colour";           ///< colour, depth, labels or boxes
  std::string out = "picture.png";
  double every = 0;     ///< time between pictures of a dataset [s]
  std::string dataset;  ///< folder; empty: one picture
};
/// Plays a scenario and writes a picture of a robot's camera, or a set of them with what is seen in them.
int renderPictures(const RenderArguments& arguments);
struct LevelsArguments {
  int robots = 24;
  double seconds = 10, speed = 0.15;  ///< of the walk [s], [m/s]
};
/// Walks at every level of detail and prints a table: way, torques, cost of a robot a simulated second.
int printLevels(const LevelsArguments& arguments);

struct TableArguments {
  std::vector<std::string> rows;  ///< names; none: all
  std::vector<int> threads{1};
  std::string isa = "auto";  ///< avx2, avx512, or the widest
  std::string json;          ///< file; empty: none
  bool processor = false;    ///< counts processor time in the place of the wall clock's: one thread alone
  int robots = 0;            ///< tries this number alone; 0: looks for the largest
  bool quick = false;        ///< a try-out: short runs, large steps
};
/// Prints the largest numbers of walking robots that this machine simulates in real time.
int printTable(const TableArguments& arguments);

struct GameArguments {
  double seconds = 10;       ///< simulated
  int threads = 0;           ///< 0: all
  std::string isa = "auto";  ///< as in TableArguments
};
/// Prints how many times faster than real time a game of 7 against 7 is, with and without pictures.
int printGameSpeed(const GameArguments& arguments);

/// Prints every mistake in scenarios and robot files.
int checkFiles(const std::vector<std::string>& files);
/// Prints modules and properties, or the schedule of a scenario.
int printModules(const std::string& scenario);
/// Prints the first difference of two runs; 0 when there is none, 1 when there is one.
int printComparison(const std::string& a, const std::string& b);

}  // namespace murosimf
