#include <fmt/format.h>

#include <algorithm>
#include <system_error>

#include "murosimf/scene/robot_reader.h"
#include "murosimf/scene/text_tree.h"

namespace murosimf {

namespace {

namespace fs = std::filesystem;

/// PREFIX/share/murosimf of PREFIX/bin/murosimf.
fs::path installedData() {
  std::error_code failed;
  const fs::path program = fs::read_symlink("/proc/self/exe", failed);
  return failed ? fs::path{} : program.parent_path().parent_path() / "share" / "murosimf";
}

}  // namespace

std::vector<fs::path> dataFolders(const fs::path& scenario) {
  std::error_code failed;
  const fs::path working = fs::current_path(failed);
  const fs::path own = (working / scenario).lexically_normal().parent_path();
  std::vector<fs::path> folders;
  for (const fs::path& folder : {own, own.parent_path(), working, installedData()}) {
    bool known = folder.empty();
    for (const fs::path& other : folders) known = known || other == folder;
    if (!known) folders.push_back(folder);
  }
  return folders;
}

fs::path findDataFile(const std::string& name, const fs::path& scenario) {
  if (name.empty() || name.find('\0') != std::string::npos) return {};
  for (const fs::path& folder : dataFolders(scenario)) {
    std::error_code failed;
    if (fs::is_regular_file(folder / name, failed)) return (folder / name).lexically_normal();
  }
  return {};
}

std::string whereLooked(const std::string& name, const fs::path& scenario) {
  const fs::path wanted(name.substr(0, name.find('\0')));
  std::vector<std::string> folders, neighbours;
  for (const fs::path& folder : dataFolders(scenario)) {
    folders.push_back(folder.string());
    std::error_code failed;
    for (fs::directory_iterator at(folder / wanted.parent_path(), failed), end; !failed && at != end;
         at.increment(failed))
      neighbours.push_back((wanted.parent_path() / at->path().filename()).string());
  }
  std::sort(neighbours.begin(), neighbours.end());
  return fmt::format("\"{}\", looked for from {}{}", printable(name), fmt::join(folders, ", "),
                     didYouMean(name, neighbours));
}

}  // namespace murosimf
