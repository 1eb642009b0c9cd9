#include "murosimf-view/script.h"

#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

#include "murosimf-view/viewer.h"

namespace murosimf {

namespace {

/// Commands, and how many words they need behind them.
const std::map<std::string, std::size_t>& commands() {
  static const std::map<std::string, std::size_t> all{
      {"run", 1},    {"key", 1},       {"click", 1},  {"rightclick", 1}, {"doubleclick", 1}, {"drag", 4},
      {"pull", 4},   {"rightdrag", 4}, {"wheel", 1},  {"type", 1},       {"open", 1},        {"close", 1},
      {"select", 1}, {"show", 2},      {"camera", 6}, {"wait", 1},       {"screenshot", 1},  {"expect", 1}};
  return all;
}

const std::map<std::string, int>& keys() {
  static const std::map<std::string, int> all{{"space", GLFW_KEY_SPACE},
                                              {"left", GLFW_KEY_LEFT},
                                              {"right", GLFW_KEY_RIGHT},
                                              {"pageup", GLFW_KEY_PAGE_UP},
                                              {"pagedown", GLFW_KEY_PAGE_DOWN},
                                              {"plus", GLFW_KEY_EQUAL},
                                              {"minus", GLFW_KEY_MINUS},
                                              {"f1", GLFW_KEY_F1},
                                              {"tab", GLFW_KEY_TAB},
                                              {"f", GLFW_KEY_F},
                                              {"escape", GLFW_KEY_ESCAPE},
                                              {"f12", GLFW_KEY_F12}};
  return all;
}

[[noreturn]] void fail(const ScriptLine& line, const std::string& what) {
  throw std::runtime_error(fmt::format("script line {}: {}", line.number, what));
}

double number(const ScriptLine& line, std::size_t word) {
  std::size_t read = 0;
  try {
    const double x = std::stod(line.words[word], &read);
    if (read == line.words[word].size()) return x;
  } catch (const std::exception&) {  // NOLINT: said below
  }
  fail(line, fmt::format("found \"{}\", expected a number", line.words[word]));
}

/// All words from one on, with spaces between them.
std::string rest(const ScriptLine& line, std::size_t from, std::size_t to) {
  std::string text;
  for (std::size_t i = from; i < to; ++i) text += (i == from ? "" : " ") + line.words[i];
  return text;
}
std::string rest(const ScriptLine& line, std::size_t from) { return rest(line, from, line.words.size()); }

ObjectId objectNamed(Viewer& viewer, const ScriptLine& line, const std::string& path) {
  const ObjectId object = viewer.session().world().find(path);
  if (!object.valid()) fail(line, fmt::format("there is no object {}", path));
  return object;
}

void expect(Viewer& viewer, const ScriptLine& line) {
  const Session& session = viewer.session();
  const std::string& what = line.words[1];
  bool holds = false;
  if (what == "running" || what == "paused") {
    holds = session.running == (what == "running");
  } else if (what == "selected" && line.words.size() > 2) {
    holds = session.selected == objectNamed(viewer, line, line.words[2]);
  } else if (what == "frame" && line.words.size() > 2) {
    holds = viewer.session().simulation().frame() == std::lround(number(line, 2));
  } else if (what == "open" && line.words.size() > 2) {
    holds = viewer.panel(line.words[2]) != nullptr && viewer.panel(line.words[2])->open;
  } else if (what == "plots" && line.words.size() > 2) {
    holds = viewer.session().plots().all().size() == static_cast<std::size_t>(number(line, 2));
  } else {
    fail(line, fmt::format("found \"{}\", expected running, paused, selected, frame, open or plots", what));
  }
  if (!holds)
    fail(line,
         fmt::format("expected {}: it is not so (frame {})", rest(line, 1), viewer.session().simulation().frame()));
}

void pressKey(Viewer& viewer, const ScriptLine& line) {
  const auto key = keys().find(line.words[1]);
  if (key == keys().end()) fail(line, fmt::format("there is no key \"{}\"", line.words[1]));
  viewer.press(key->second);
}

void openPanel(Viewer& viewer, const ScriptLine& line) {
  Panel* panel = viewer.panel(line.words[1]);
  if (panel == nullptr) fail(line, fmt::format("there is no panel \"{}\"", line.words[1]));
  panel->open = line.words[0] == "open";
}

/// The renderer's name may have spaces: on or off ends it, and an object may follow.
void showRenderer(Viewer& viewer, const ScriptLine& line) {
  std::size_t end = 1;
  while (end < line.words.size() && line.words[end] != "on" && line.words[end] != "off") ++end;
  if (end == line.words.size()) fail(line, "expected on or off behind the renderer's name");
  const bool one = end + 1 < line.words.size();
  const ObjectId object = one ? objectNamed(viewer, line, line.words[end + 1]) : ObjectId{};
  viewer.session().renderings().show(rest(line, 1, end), line.words[end] == "on", object);
}

void placeCamera(Viewer& viewer, const ScriptLine& line) {
  OrbitCamera& camera = viewer.view().camera;
  camera.azimuth = number(line, 1), camera.elevation = number(line, 2), camera.distance = number(line, 3);
  camera.target_W = {number(line, 4), number(line, 5), number(line, 6)};
}

/// The middle of a widget, or a place in the window.
void aim(const ScriptLine& line, Window::ScriptedMouse& mouse) {
  const std::string name = rest(line, 1);
  const auto place = ui::places().find(name);
  if (place != ui::places().end()) {
    if (place->second.frame < ImGui::GetFrameCount() - 2) fail(line, fmt::format("\"{}\" is not shown now", name));
    if (!place->second.visible) fail(line, fmt::format("\"{}\" is scrolled out of sight", name));
    mouse.u = place->second.u, mouse.v = place->second.v;
  } else if (line.words.size() == 3) {
    mouse.u = static_cast<float>(number(line, 1)), mouse.v = static_cast<float>(number(line, 2));
  } else {
    fail(line, fmt::format("there is no widget \"{}\"", name));
  }
}

constexpr long kFramesAPicture = 40;

}  // namespace

std::vector<ScriptLine> readScript(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream) throw std::runtime_error(fmt::format("{}: cannot be read", file.string()));
  std::vector<ScriptLine> lines;
  std::string text;
  for (int count = 1; std::getline(stream, text); ++count) {
    std::istringstream words(text);
    ScriptLine line{count, {}};
    for (std::string word; words >> word;) line.words.push_back(word);
    if (line.words.empty() || line.words[0][0] == '#') continue;
    const auto known = commands().find(line.words[0]);
    if (known == commands().end()) {
      throw std::runtime_error(fmt::format("{}:{}: unknown command \"{}\"", file.string(), count, line.words[0]));
    }
    if (line.words.size() - 1 < known->second) {
      throw std::runtime_error(fmt::format("{}:{}: {} needs {} words, found {}", file.string(), count, line.words[0],
                                           known->second, line.words.size() - 1));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

void ScriptRunner::click(const ScriptLine& line) {
  const std::string& what = line.words[0];
  const std::size_t button = what.starts_with("right") ? 1 : 0;
  Window::ScriptedMouse to = mouse_;
  aim(line, to);
  moves_.push_back(to);
  for (int i = 0; i < (what == "doubleclick" ? 2 : 1); ++i) {
    for (const bool down : {true, false}) {
      to.down[button] = down;
      moves_.push_back(to);
    }
  }
}

void ScriptRunner::drag(const ScriptLine& line) {
  constexpr int kSteps = 10;  // one a picture
  const std::size_t button = line.words[0] == "rightdrag" ? 1 : 0;
  const double u = number(line, 1), v = number(line, 2), du = number(line, 3) - u, dv = number(line, 4) - v;
  Window::ScriptedMouse to = mouse_;
  for (int i = -1; i <= kSteps; ++i) {
    const double share = std::max(0, i) / static_cast<double>(kSteps);
    to.u = static_cast<float>(u + share * du), to.v = static_cast<float>(v + share * dv);
    to.control = line.words[0] == "pull";
    to.down[button] = i >= 0;
    moves_.push_back(to);
  }
  to.down[button] = to.control = false;
  moves_.push_back(to);
}

void ScriptRunner::act(Viewer& viewer, const ScriptLine& line) {
  Session& session = viewer.session();
  const std::string& what = line.words[0];
  if (what == "run") {
    frames_ = std::lround(number(line, 1) / session.simulation().frameLength());
  } else if (what == "wait") {
    moves_.insert(moves_.end(), static_cast<std::size_t>(number(line, 1)), mouse_);
  } else if (what == "wheel") {
    moves_.push_back(mouse_);
    moves_.back().wheel = static_cast<float>(number(line, 1));
  } else if (what == "type") {
    ImGui::GetIO().AddInputCharactersUTF8(rest(line, 1).c_str());
  } else if (what == "select") {
    session.selected = objectNamed(viewer, line, line.words[1]);
  } else if (what == "screenshot") {
    viewer.screenshot(line.words[1]);
  } else if (what == "expect") {
    expect(viewer, line);
  } else if (what == "key") {
    pressKey(viewer, line);
  } else if (what == "open" || what == "close") {
    openPanel(viewer, line);
  } else if (what == "show") {
    showRenderer(viewer, line);
  } else if (what == "camera") {
    placeCamera(viewer, line);
  } else if (what.ends_with("click")) {
    click(line);
  } else {
    drag(line);
  }
}

bool ScriptRunner::next(Viewer& viewer) {
  mouse_.wheel = 0;
  if (frames_ > 0) {
    const long now = std::min(frames_, kFramesAPicture);
    viewer.session().run(now);
    frames_ -= now;
    return true;
  }
  if (!moves_.empty()) {
    mouse_ = moves_.front();
    moves_.erase(moves_.begin());
    return true;
  }
  if (next_ == lines_.size()) return false;
  act(viewer, lines_[next_++]);
  if (!moves_.empty()) {
    mouse_ = moves_.front();
    moves_.erase(moves_.begin());
  }
  return true;
}

}  // namespace murosimf
