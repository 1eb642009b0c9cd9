#pragma once

/// @file What one picture shows, in the words of a graphics card: instances of meshes, lines, paint on the ground.
///
/// Filled by property renderers between two frames, then drawn while the simulation may go on: it holds copies, no
/// reference into the world. Everything in world frame W [m].

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "murosimf/algorithms/shape.h"
#include "murosimf/render/mesh.h"

namespace murosimf {

/// A colour and how much it covers: 1 hides what lies behind.
struct Tint {
  float red = 1, green = 1, blue = 1, cover = 1;
  Tint() = default;
  Tint(float r, float g, float b, float c = 1) : red(r), green(g), blue(b), cover(c) {}
  Tint(const Colour& c, float covers = 1) : red(c.red), green(c.green), blue(c.blue), cover(covers) {}  // NOLINT
};

/// One instance of a mesh, laid out as shaders read it.
struct MeshInstance {
  std::array<std::array<float, 4>, 3> X_WM;  ///< rows of the affine map from the mesh into W
  Tint tint;
  std::uint32_t id = 0;  ///< what a label picture shows
};

struct LineVertex {
  std::array<float, 3> p_W;
  Tint tint;
};

/// A word at a place of the world.
struct TextMark {
  Vector3 p_W;
  std::string text;
  Tint tint;
};

class DrawList {
 public:
  explicit DrawList(MeshLibrary& meshes) : meshes_(meshes) {}
  /// Forgets everything but the memory.
  void clear();

  MeshLibrary& meshes() { return meshes_; }
  const MeshLibrary& meshes() const { return meshes_; }

  /// A mesh at X_WM, stretched along its own axes.
  void mesh(int number, const Pose& X_WM, const Vector3& stretch, const Tint& tint, std::uint32_t id = 0);
  /// Any shape; `hull` of a kConvex one. A capsule is a cylinder and two spheres.
  void shape(const Shape& shape, const std::shared_ptr<const ConvexHull>& hull, const Pose& X_WS, const Tint& tint,
             std::uint32_t id = 0);
  void sphere(const Vector3& p_W, double radius, const Tint& tint, std::uint32_t id = 0);
  /// A rod between two places.
  void rod(const Vector3& a_W, const Vector3& b_W, double radius, const Tint& tint);
  /// An arrow from a to b whose shaft has this radius.
  void arrow(const Vector3& a_W, const Vector3& b_W, double radius, const Tint& tint);
  /// Axes x, y, z in red, green, blue.
  void frame(const Pose& X_WF, double length);
  /// A line of one pixel.
  void line(const Vector3& a_W, const Vector3& b_W, const Tint& tint);
  /// A triangle on the ground (z = 0), over what has been painted before and under everything else.
  void paint(const Vector3& a_W, const Vector3& b_W, const Vector3& c_W, const Tint& tint);
  /// Lets one see through everything solid that has an id: shapes, not marks.
  void seeThrough(float cover);
  void text(const Vector3& p_W, std::string words, const Tint& tint);

  /// By mesh number. Those that cover all, and those that let see through.
  const std::vector<std::vector<MeshInstance>>& solid() const { return solid_; }
  const std::vector<std::vector<MeshInstance>>& clearTinted() const { return clear_tinted_; }
  const std::vector<LineVertex>& lines() const { return lines_; }      ///< two vertices each
  const std::vector<LineVertex>& painted() const { return painted_; }  ///< three vertices each
  const std::vector<TextMark>& texts() const { return texts_; }

 private:
  MeshLibrary& meshes_;
  std::vector<std::vector<MeshInstance>> solid_, clear_tinted_;
  std::vector<LineVertex> lines_, painted_;
  std::vector<TextMark> texts_;
};

}  // namespace murosimf
