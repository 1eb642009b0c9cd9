#pragma once

/// @file A script that drives the window as a person would: for tests and for the pictures of the documentation.
///
///     run 2.5                  simulated seconds, as fast as they go
///     key space                as docs/viewer.md lists: space, left, right, pageup, pagedown, plus, minus, f1 ...
///     click Simulation/run     the widget of that name, with the mouse; `rightclick`, `doubleclick` likewise
///     click 400 300            a place in the window
///     drag 400 300 500 300     with the left mouse button; `rightdrag`, `pull` (with Ctrl) likewise
///     wheel 2                  where the mouse is
///     type base_pose p         into the field that was clicked
///     open Plots               a panel; `close Plots`
///     select robots.red.1      an object
///     show frames on           a renderer, on all objects; `show frames on robots.red.1` on one
///     camera -1.2 0.5 4 0 0 0.2    azimuth, elevation, distance, target
///     wait 3                   pictures
///     screenshot FILE          of the window
///     expect running|paused    and more: see script_commands.cpp
///     # words                  are not read

#include <filesystem>
#include <string>
#include <vector>

#include "murosimf-view/window.h"

namespace murosimf {

class Viewer;

struct ScriptLine {
  int number = 0;
  std::vector<std::string> words;
};

/// @throws std::runtime_error naming file and line for a command that is not known or has too few words
std::vector<ScriptLine> readScript(const std::filesystem::path& file);

/// What a script's person is about to do.
struct ScriptHand {
  Window::ScriptedMouse mouse;
  std::vector<Window::ScriptedMouse> moves;  ///< one a picture, still to come
  long frames = 0;                           ///< still to be run
};

class ScriptRunner {
 public:
  explicit ScriptRunner(std::vector<ScriptLine> lines) : lines_(std::move(lines)) {}
  /// What the mouse does in the next picture.
  const Window::ScriptedMouse& mouse() const { return hand_.mouse; }
  /// Between two pictures: does what comes next. False when all is done.
  /// @throws std::runtime_error naming the line for something that is not there or not as expected
  bool next(Viewer& viewer);

 private:
  std::vector<ScriptLine> lines_;
  std::size_t next_ = 0;
  ScriptHand hand_;
};

}  // namespace murosimf
