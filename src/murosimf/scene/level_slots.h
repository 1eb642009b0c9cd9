#pragma once

/// @file The levels of detail that scenarios name: a motion, and the modules that go with it.

#include <span>
#include <string_view>

namespace murosimf {

/// One slot of a level and the module that fills it when nobody chooses another.
struct Slot {
  std::string_view name, module;
  std::span<const std::string_view> others{};  ///< that go with this level too
};

struct LevelSlots {
  std::string_view name, motion;
  std::span<const Slot> slots;
  double period;                                ///< [s]; 0: every frame
  std::span<const std::string_view> further{};  ///< modules outside the slots that need this level
  bool on_wheels = false;                       ///< for robots that stand on wheels
};

/// The first level of that name, for robots on wheels one of theirs where there is one; kinematic where there is none.
const LevelSlots& levelNamed(std::string_view name, bool on_wheels = false);
/// The level that a motion belongs to; `usual` where it belongs to none.
const LevelSlots& levelOfMotion(std::string_view motion, std::string_view usual);
/// Whether the level's slot is known to take the module; any slot takes the empty name.
bool takes(const LevelSlots& level, std::string_view slot, std::string_view module);
/// Whether a module outside the slots is known to need this level.
bool isFurther(const LevelSlots& level, std::string_view module);

}  // namespace murosimf
