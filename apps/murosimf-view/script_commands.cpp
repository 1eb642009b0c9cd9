#include "murosimf-view/script_commands.h"

#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cmath>
#include <stdexcept>

#include "murosimf-view/viewer.h"

namespace murosimf {

namespace {

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
  } else if (what == "refused") {
    holds = !session.pull_refused.empty();
  } else {
    fail(line, fmt::format("found \"{}\", expected running, paused, selected, frame, open, plots or refused", what));
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

void typeText(Viewer&, const ScriptLine& line) { ImGui::GetIO().AddInputCharactersUTF8(rest(line, 1).c_str()); }

void selectObject(Viewer& viewer, const ScriptLine& line) {
  viewer.session().selected = objectNamed(viewer, line, line.words[1]);
}

void takeScreenshot(Viewer& viewer, const ScriptLine& line) { viewer.screenshot(line.words[1]); }

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

void run(ScriptHand& hand, Viewer& viewer, const ScriptLine& line) {
  hand.frames = std::lround(number(line, 1) / viewer.session().simulation().frameLength());
}

void wait(ScriptHand& hand, Viewer&, const ScriptLine& line) {
  hand.moves.insert(hand.moves.end(), static_cast<std::size_t>(number(line, 1)), hand.mouse);
}

void wheel(ScriptHand& hand, Viewer&, const ScriptLine& line) {
  hand.moves.push_back(hand.mouse);
  hand.moves.back().wheel = static_cast<float>(number(line, 1));
}

void click(ScriptHand& hand, Viewer&, const ScriptLine& line) {
  const std::string& what = line.words[0];
  const std::size_t button = what.starts_with("right") ? 1 : 0;
  Window::ScriptedMouse to = hand.mouse;
  aim(line, to);
  hand.moves.push_back(to);
  for (int i = 0; i < (what == "doubleclick" ? 2 : 1); ++i) {
    for (const bool down : {true, false}) {
      to.down[button] = down;
      hand.moves.push_back(to);
    }
  }
}

void drag(ScriptHand& hand, Viewer&, const ScriptLine& line) {
  constexpr int kSteps = 10;  // one a picture
  const std::size_t button = line.words[0] == "rightdrag" ? 1 : 0;
  const double u = number(line, 1), v = number(line, 2), du = number(line, 3) - u, dv = number(line, 4) - v;
  Window::ScriptedMouse to = hand.mouse;
  for (int i = -1; i <= kSteps; ++i) {
    const double share = std::max(0, i) / static_cast<double>(kSteps);
    to.u = static_cast<float>(u + share * du), to.v = static_cast<float>(v + share * dv);
    to.control = line.words[0] == "pull";
    to.down[button] = i >= 0;
    hand.moves.push_back(to);
  }
  to.down[button] = to.control = false;
  hand.moves.push_back(to);
}

/// A command that leaves the mouse alone.
template <void (*kAct)(Viewer&, const ScriptLine&)>
void withoutHand(ScriptHand&, Viewer& viewer, const ScriptLine& line) {
  kAct(viewer, line);
}

}  // namespace

const std::map<std::string, ScriptCommand>& scriptCommands() {
  static const std::map<std::string, ScriptCommand> all{{"run", {1, run}},
                                                        {"wait", {1, wait}},
                                                        {"wheel", {1, wheel}},
                                                        {"click", {1, click}},
                                                        {"rightclick", {1, click}},
                                                        {"doubleclick", {1, click}},
                                                        {"drag", {4, drag}},
                                                        {"rightdrag", {4, drag}},
                                                        {"pull", {4, drag}},
                                                        {"key", {1, withoutHand<pressKey>}},
                                                        {"type", {1, withoutHand<typeText>}},
                                                        {"open", {1, withoutHand<openPanel>}},
                                                        {"close", {1, withoutHand<openPanel>}},
                                                        {"select", {1, withoutHand<selectObject>}},
                                                        {"show", {2, withoutHand<showRenderer>}},
                                                        {"camera", {6, withoutHand<placeCamera>}},
                                                        {"screenshot", {1, withoutHand<takeScreenshot>}},
                                                        {"expect", {1, withoutHand<expect>}}};
  return all;
}

}  // namespace murosimf
