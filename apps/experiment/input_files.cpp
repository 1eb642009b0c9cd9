#include "experiment/input_files.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <tuple>

#include "experiment/content_hash.h"
#include "murosimf/robot/mesh_path.h"
#include "murosimf/scene/override.h"
#include "murosimf/scene/robot_reader.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongestName = 1024;

class FileSearch {
 public:
  explicit FileSearch(const fs::path& scenario) : scenario_(scenario) {}

  void searchTree(const TextNode& node) {
    if (node.kind == TextNode::Kind::kText) take(std::get<std::string>(node.scalar), scenario_);
    if (!node.raw.empty()) take(node.raw, scenario_);
    for (const TextNode& child : node.children) searchTree(child);
  }

  std::vector<InputFile> result() {
    for (std::size_t i = 0; i < found_.size(); ++i) searchFile(fs::path(found_[i].file));
    std::sort(found_.begin(), found_.end(), [](const InputFile& a, const InputFile& b) {
      return std::tie(a.name, a.file) < std::tie(b.name, b.file);
    });
    return found_;
  }

 private:
  /// @param namer  the file in which the name is written
  void take(const std::string& name, const fs::path& namer) {
    if (name.empty() || name.size() > kLongestName || name.find('\n') != name.npos) return;
    fs::path file = findDataFile(name, scenario_);
    if (file.empty() && namer != scenario_) file = findMesh(name, namer).file.value_or(fs::path{});
    std::error_code failed;
    if (file.empty() || !fs::is_regular_file(file, failed)) return;
    if (known_.insert({name, file.string()}).second) found_.push_back({name, file});
  }

  /// Names between quotes of robot files, calibrations and servo files; materials of OBJ meshes stand without quotes.
  void searchFile(const fs::path& file) {
    if (!searched_.insert(file.string()).second) return;
    const std::string text = readWholeFile(file);
    if (text.find('\0') != text.npos) return;
    for (const char quote : {'"', '\''}) {
      std::size_t begin = text.find(quote);
      while (begin != text.npos) {
        const std::size_t end = text.find(quote, begin + 1);
        if (end == text.npos) break;
        take(text.substr(begin + 1, end - begin - 1), file);
        begin = end;  // a closing quote may as well have opened: an apostrophe in a comment shifts the pairs
      }
    }
    if (file.extension() == ".obj" || file.extension() == ".OBJ") searchMaterials(text, file);
  }

  void searchMaterials(std::string_view text, const fs::path& file) {
    constexpr std::string_view kKey = "mtllib ";
    for (std::size_t at = text.find(kKey); at != text.npos; at = text.find(kKey, at + 1)) {
      std::string_view name = text.substr(at + kKey.size());
      name = name.substr(0, name.find_first_of("\r\n"));
      take(std::string(name), file);
    }
  }

  const fs::path& scenario_;
  std::vector<InputFile> found_;
  std::set<std::pair<std::string, std::string>> known_;
  std::set<std::string> searched_;
};

}  // namespace

std::vector<InputFile> inputFiles(const fs::path& scenario, const std::vector<std::string>& overrides) {
  Diagnostics told_elsewhere;
  FileSearch search(scenario);
  TextNode changes;
  for (const std::string& assignment : overrides) applyOverride(changes, assignment, told_elsewhere);
  search.searchTree(changes);
  if (const std::optional<TextNode> tree = parseToml(readWholeFile(scenario), scenario.string(), told_elsewhere)) {
    search.searchTree(*tree);
  }
  return search.result();
}

}  // namespace murosimf
