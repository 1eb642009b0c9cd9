#pragma once

/// @file What cameras see: a flat ground with painted lines, and coloured shapes and meshes, under one lamp.
///
/// Positions are in world frame W: z up, ground at z = 0, field centre at the origin, x towards a goal.
/// A surface of colour c and normal n appears as c (ambient + (1 - ambient) max(0, n . light)).

#include <memory>
#include <vector>

#include "murosimf/algorithms/ground_texture.h"
#include "murosimf/algorithms/picture.h"
#include "murosimf/algorithms/shape.h"
#include "murosimf/algorithms/triangle_mesh.h"
#include "murosimf/math/spatial.h"

namespace murosimf {

/// A painted straight line: a rectangle about the centre line from a to b, which it does not exceed. Lines that meet at
/// a corner must therefore be drawn half a width longer.
struct PaintedLine {
  double a_x{}, a_y{}, b_x{}, b_y{};  ///< ends of the centre line [m]
  double width = 0.05;                ///< [m]
};

/// A painted ring: all points between radius - width / 2 and radius + width / 2 from the centre.
struct PaintedCircle {
  double x{}, y{};      ///< centre [m]
  double radius{};      ///< of the ring's middle [m]
  double width = 0.05;  ///< [m]
};

struct PaintedGround {
  double half_length = 2.75, half_width = 2.0;  ///< carpet: |x| <= half_length, |y| <= half_width [m]
  Colour carpet{0.10F, 0.45F, 0.15F};
  Colour surroundings{0.35F, 0.32F, 0.30F};
  Colour paint{0.95F, 0.95F, 0.95F};
  float brightness = 1.0F;  ///< factor on all colours of the ground, >= 0
  /// Laid on the carpet in the place of its colour, its upper edge towards +y; none: the colour.
  std::shared_ptr<const GroundTexture> texture;
  double texture_size = 0;  ///< edge of the square that it covers and is repeated in [m]; 0: it covers the carpet once
  std::vector<PaintedLine> lines;
  std::vector<PaintedCircle> circles;
};

struct Drawable {
  Shape shape;  ///< any but a convex hull, which is drawn as a mesh; of no meaning where there is a mesh
  Pose X_WS;
  Colour colour;
  std::uint16_t label = 1;  ///< what the label picture shows; 0 is the ground, 65535 the sky
  std::uint32_t owner = 0;  ///< body that it is a part of: cameras name the owners they do not draw. 0: nobody's
  std::shared_ptr<const TriangleMesh> mesh = nullptr;  ///< drawn in the shape's place, its frame at X_WS
};

/// What bounds a drawable: its shape, or a box about its mesh.
inline Shape outlineOf(const Drawable& d) { return d.mesh ? Shape{ShapeKind::kBox, d.mesh->halfSize()} : d.shape; }

struct RayScene {
  PaintedGround ground;
  Vector3 light_W{0.3, 0.2, 0.93};  ///< from surfaces towards the lamp; need not be of unit length
  float ambient = 0.55F;            ///< share of light that comes from everywhere, in [0, 1]
  Colour sky{0.62F, 0.68F, 0.74F};  ///< walls and sky: whatever is seen above the horizon
  bool ground_shadows = false;      ///< soft dark patches on the ground beneath drawables
  std::vector<Drawable> drawables;
  /// How drawables move: twist (w; v) of the origin of each one's frame, world axes. As many as drawables, or none.
  std::vector<SpatialMotion<double>> motions;
};

}  // namespace murosimf
