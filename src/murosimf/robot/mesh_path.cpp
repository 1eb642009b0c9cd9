#include "murosimf/robot/mesh_path.h"

#include <fmt/format.h>

#include <cstdlib>
#include <vector>

#include "murosimf/robot/checks.h"

namespace murosimf {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPackage = "package://", kFile = "file://";

bool isThere(const fs::path& path) {
  std::error_code fault;
  return fs::exists(path, fault);
}

std::vector<fs::path> rosPackagePath() {
  std::vector<fs::path> folders;
  const char* variable = std::getenv("ROS_PACKAGE_PATH");  // NOLINT: nobody sets it meanwhile
  std::string rest = variable == nullptr ? "" : variable;
  while (!rest.empty()) {
    const std::size_t end = rest.find(':');
    if (end != 0) folders.emplace_back(rest.substr(0, end));
    rest = end == std::string::npos ? "" : rest.substr(end + 1);
  }
  return folders;
}

/// @param inside  PACKAGE/REST
MeshPath findInPackages(const std::string& inside, const fs::path& folder) {
  for (fs::path above = folder;; above = above.parent_path()) {
    if (isThere(above / inside)) return {above / inside, ""};
    if (above == above.parent_path()) break;
  }
  const std::vector<fs::path> packages = rosPackagePath();
  const std::size_t slash = inside.find('/');
  for (const fs::path& packages_here : packages) {
    if (isThere(packages_here / inside)) return {packages_here / inside, ""};
    const bool is_it = slash != std::string::npos && packages_here.filename() == inside.substr(0, slash);
    if (is_it && isThere(packages_here / inside.substr(slash + 1)))
      return {packages_here / inside.substr(slash + 1), ""};
  }
  std::string of_variable = packages.empty() ? "ROS_PACKAGE_PATH, which is not set" : "ROS_PACKAGE_PATH:";
  for (const fs::path& each : packages) of_variable += " " + each.string();
  return {std::nullopt, fmt::format("which was not found as {} in {} and the folders above it, nor by {}",
                                    quoted(inside), folder.string(), of_variable)};
}

}  // namespace

MeshPath findMesh(const std::string& name, const fs::path& robot_file) {
  std::error_code fault;
  const fs::path folder = fs::absolute(robot_file, fault).lexically_normal().parent_path();
  if (name.starts_with(kPackage)) return findInPackages(name.substr(kPackage.size()), folder);
  const std::string path = name.starts_with(kFile) ? name.substr(kFile.size()) : name;
  if (path.find("://") != std::string::npos) return {std::nullopt, "expected a path, file:// or package://PACKAGE/..."};
  const fs::path file = (folder / path).lexically_normal();  // an absolute path replaces the folder
  if (isThere(file)) return {file, ""};
  return {std::nullopt, "a file that does not exist: looked for " + file.string()};
}

}  // namespace murosimf
