#pragma once

/// @file The form of a recording: what every state variable was after every frame, to the last bit.
///
/// All numbers little endian; f64 is the IEEE double, text a u32 length and characters.
///
///     file     magic "MUROREC\n"   u32 version   text scenario   u64 seed   f64 frame length   u64 first frame
///              u32 groups: text assembly, text subset, u32 members: text path
///              u32 columns: u32 group, text property, text unit, u32 components
///              then records until the file ends
///     frame    u8 'F'   u64 frame (one more than the last)   u32 changed columns: u32 column,
///              a bit for every number of the column (member by member, lowest bit first), f64 for every bit set
///     place    u8 'I'   u64 frame in which it acted   u8 kind   text object   8 f64: x y heading height v_x v_y v_z n
///     end      u8 'E'   u64 frames recorded
///
/// n: level of detail (an exchange) or row of the body (a push; v is the force then).
/// Numbers count as +0 before the first frame. Interventions stand before the frame that they acted in.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "murosimf/simulation/interventions.h"

namespace murosimf {

inline constexpr std::string_view kRecordingMagic = "MUROREC\n";
inline constexpr std::uint32_t kRecordingVersion = 1;

/// One subset of one assembly.
struct RecordedGroup {
  std::string assembly, subset;
  std::vector<std::string> members;  ///< paths
};

/// One property of all members of a group.
struct RecordedColumn {
  std::uint32_t group = 0;
  std::string property, unit;
  std::uint32_t components = 0;  ///< numbers a member
  std::size_t first = 0;         ///< place of its numbers among those of all columns; not in the file
};

struct RecordingHeader {
  std::string scenario;
  std::uint64_t seed = 0;
  double frame_length = 0;  ///< [s]
  long first_frame = 0;     ///< the first one recorded
  std::vector<RecordedGroup> groups;
  std::vector<RecordedColumn> columns;

  const RecordedGroup& groupOf(const RecordedColumn& column) const { return groups[column.group]; }
  std::size_t sizeOf(const RecordedColumn& column) const { return column.components * groupOf(column).members.size(); }
  std::size_t numberCount() const { return columns.empty() ? 0 : columns.back().first + sizeOf(columns.back()); }
};

struct RecordedIntervention {
  long frame = 0;
  Intervention::Kind kind = Intervention::Kind::kPlaceRobot;
  std::string object;  ///< path
  PlanarPose pose;
  double height = 0;
  Vector3 velocity;
  int level = 0;
  friend bool operator==(const RecordedIntervention&, const RecordedIntervention&) = default;
};

/// The columns of all state variables of a linked world, in the order of paths, properties and subsets.
RecordingHeader describeState(const World& world, const LinkedWorld& linked);

}  // namespace murosimf
