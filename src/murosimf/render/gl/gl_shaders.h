#pragma once

/// @file The shaders. Light as the ray caster's: a surface of colour c and normal n appears as
/// c (ambient + (1 - ambient) max(0, n . light) lit), where lit is 0 in a shadow and 1 outside.

namespace murosimf {

inline constexpr const char* kMeshVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row_x;   // of the affine map into the world
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec4 tint;
layout(location = 6) in uint id;
uniform mat4 clip_from_world;
out vec3 world;
out vec3 world_normal;
out vec4 colour;
flat out uint label;
void main() {
  vec4 p = vec4(position, 1.0);
  world = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
  mat3 linear = transpose(mat3(row_x.xyz, row_y.xyz, row_z.xyz));
  vec3 squares = vec3(dot(linear[0], linear[0]), dot(linear[1], linear[1]), dot(linear[2], linear[2]));
  world_normal = linear * (normal / squares);  // a rotation and a stretch: the inverse transposed
  colour = tint;
  label = id;
  gl_Position = clip_from_world * vec4(world, 1.0);
}
)";

inline constexpr const char* kFlatVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec4 tint;
uniform mat4 clip_from_world;
out vec3 world;
out vec3 world_normal;
out vec4 colour;
flat out uint label;
void main() {
  world = position;
  world_normal = vec3(0.0, 0.0, 1.0);
  colour = tint;
  label = 0u;
  gl_Position = clip_from_world * vec4(position, 1.0);
}
)";

inline constexpr const char* kLitFragmentShader = R"(#version 330 core
in vec3 world;
in vec3 world_normal;
in vec4 colour;
uniform vec3 light;       // towards the lamp, unit length
uniform float ambient;    // 1: as painted
uniform int shadows;
uniform mat4 shadow_from_world;
uniform sampler2DShadow shadow_map;
out vec4 shown;
float lit() {
  if (shadows == 0) return 1.0;
  vec3 place = (shadow_from_world * vec4(world, 1.0)).xyz * 0.5 + 0.5;
  if (any(lessThan(place, vec3(0.0))) || any(greaterThan(place, vec3(1.0)))) return 1.0;
  return texture(shadow_map, place);
}
void main() {
  float lamp = max(0.0, dot(normalize(world_normal), light));
  if (lamp > 0.0) lamp *= lit();
  shown = vec4(colour.rgb * (ambient + (1.0 - ambient) * lamp), colour.a);
}
)";

inline constexpr const char* kLabelFragmentShader = R"(#version 330 core
flat in uint label;
out uint shown;
void main() { shown = label; }
)";

/// For depth alone.
inline constexpr const char* kEmptyFragmentShader = R"(#version 330 core
void main() {}
)";

}  // namespace murosimf
