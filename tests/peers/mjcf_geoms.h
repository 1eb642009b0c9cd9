#pragma once

/// @file What robots and ground are made of in MuJoCo's model text: geoms, and which of them touch which.
///
/// Two geoms touch where the contype of one and the conaffinity of the other share a bit.

#include <string>
#include <string_view>
#include <vector>

#include "peers/peer_scene.h"

namespace murosimf::peers {

/// `pos` and `xyaxes` of a place.
std::string mjcfPlace(const Pose& X);

/// The geoms of a model text. Robots are numbered from 0.
class MjcfGeoms {
 public:
  virtual ~MjcfGeoms() = default;
  /// Those of the ground.
  virtual std::string ground() const = 0;
  /// Those on a row of a robot.
  virtual std::string onRow(int robot, int row) const = 0;
};

/// Soles on the ground, nothing else.
class SoleGeoms final : public MjcfGeoms {
 public:
  explicit SoleGeoms(const PeerScene& scene) : scene_(scene) {}
  std::string ground() const override;
  std::string onRow(int robot, int row) const override;

 private:
  const PeerScene& scene_;
};

/// All shapes that collide, on grounds and robots.
class HeapGeoms final : public MjcfGeoms {
 public:
  /// @throws std::invalid_argument as mjcfOf() says
  explicit HeapGeoms(const PeerHeap& heap);
  std::string ground() const override;
  std::string onRow(int robot, int row) const override;

 private:
  unsigned groundType(std::string_view surface) const;
  unsigned robotType(int robot) const { return 1U << (surfaces_.size() + static_cast<std::size_t>(robot)); }
  unsigned otherRobots(int robot) const;
  double friction(std::string_view a, std::string_view b) const;
  void requireLargerFrictions() const;

  const PeerHeap& heap_;
  std::vector<std::string> surfaces_;  ///< of shapes that collide
};

}  // namespace murosimf::peers
