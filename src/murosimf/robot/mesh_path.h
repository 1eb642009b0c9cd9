#pragma once

/// @file Where the file of a mesh lies that a robot file names.

#include <filesystem>
#include <optional>
#include <string>

namespace murosimf {

struct MeshPath {
  std::optional<std::filesystem::path> file;  ///< that exists
  std::string problem;                        ///< why there is none, and where it was looked for
};

/// @param name  a path, absolute or from the robot file's folder; the same behind file://; or package://PACKAGE/REST:
///              PACKAGE/REST in the nearest folder above the robot file that has it, else in one of ROS_PACKAGE_PATH,
///              which may also be the package itself
MeshPath findMesh(const std::string& name, const std::filesystem::path& robot_file);

}  // namespace murosimf
