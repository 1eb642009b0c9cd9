#include "murosimf-view/script.h"

#include <fmt/format.h>

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "murosimf-view/script_commands.h"
#include "murosimf-view/viewer.h"

namespace murosimf {

namespace {

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
    const auto known = scriptCommands().find(line.words[0]);
    if (known == scriptCommands().end()) {
      throw std::runtime_error(fmt::format("{}:{}: unknown command \"{}\"", file.string(), count, line.words[0]));
    }
    if (line.words.size() - 1 < known->second.words) {
      throw std::runtime_error(fmt::format("{}:{}: {} needs {} words, found {}", file.string(), count, line.words[0],
                                           known->second.words, line.words.size() - 1));
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

bool ScriptRunner::next(Viewer& viewer) {
  hand_.mouse.wheel = 0;
  if (hand_.frames > 0) {
    const long now = std::min(hand_.frames, kFramesAPicture);
    viewer.session().run(now);
    hand_.frames -= now;
    return true;
  }
  if (!hand_.moves.empty()) {
    hand_.mouse = hand_.moves.front();
    hand_.moves.erase(hand_.moves.begin());
    return true;
  }
  if (next_ == lines_.size()) return false;
  const ScriptLine& line = lines_[next_++];
  scriptCommands().at(line.words[0]).act(hand_, viewer, line);
  if (!hand_.moves.empty()) {
    hand_.mouse = hand_.moves.front();
    hand_.moves.erase(hand_.moves.begin());
  }
  return true;
}

}  // namespace murosimf
