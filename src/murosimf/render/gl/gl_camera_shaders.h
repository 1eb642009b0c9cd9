#pragma once

/// @file Shaders of robots' cameras: meshes through a lens, and the field by the ray of each pixel. Every pixel gets a
/// colour, a label and a depth along the optical axis.

namespace murosimf {

/// See gl_lens.h. Light is computed by corner, as is what lies under the ground.
inline constexpr const char* kLensVertexShader = R"(#version 330 core
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 row_x;   // of the pose in the world
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec4 tint;
layout(location = 6) in uint id;
uniform mat4 camera_from_world;
uniform vec3 light;         // towards the lamp, unit length, in W
uniform int fisheye;
uniform vec4 numerator;
uniform vec3 denominator;
uniform vec3 curve_beyond;  // times Z, times R, from this slope
uniform vec3 tangential;    // p1, p2
uniform vec4 prism_x, prism_y;  // of r^2, of r^4; beyond: times Z, times R
uniform vec3 clip_x, clip_y;    // of Z xd, of Z yd, of Z
uniform vec2 clip_z;            // of Z, of 1
out float lamp;
out vec3 place;             // in C
flat out vec3 colour;
flat out uint label;
float curve(float r) {
  float s = r * r;
  if (fisheye != 0) {
    float angle = atan(r), q = angle * angle;
    return angle * (1.0 + q * (numerator.x + q * (numerator.y + q * (numerator.z + q * numerator.w))));
  }
  return r * (1.0 + s * (numerator.x + s * (numerator.y + s * numerator.z))) /
         (1.0 + s * (denominator.x + s * (denominator.y + s * denominator.z)));
}
vec2 distorted(vec3 p) {      // Z times the slopes after the lens
  float R = length(p.xy), a = curve_beyond.z, radial, square;
  vec2 c = R > 0.0 ? p.xy / R : vec2(0.0), prism;
  if (R > a * p.z) {
    radial = curve_beyond.x * p.z + curve_beyond.y * R;
    square = a * (2.0 * R - a * p.z);
    prism = vec2(dot(prism_x.zw, vec2(p.z, R)), dot(prism_y.zw, vec2(p.z, R)));
  } else {
    float r = R / p.z, s = r * r;
    radial = p.z * curve(r);
    square = R * r;
    prism = p.z * vec2(dot(prism_x.xy, vec2(s, s * s)), dot(prism_y.xy, vec2(s, s * s)));
  }
  float cross_term = 2.0 * c.x * c.y;
  return c * radial + prism + square * vec2(tangential.x * cross_term + tangential.y * (1.0 + 2.0 * c.x * c.x),
                                            tangential.x * (1.0 + 2.0 * c.y * c.y) + tangential.y * cross_term);
}
void main() {
  vec4 p = vec4(position, 1.0);
  vec4 world = vec4(dot(row_x, p), dot(row_y, p), dot(row_z, p), 1.0);
  lamp = dot(vec3(dot(row_x.xyz, normal), dot(row_y.xyz, normal), dot(row_z.xyz, normal)), light);
  colour = tint.rgb;
  label = id;
  vec3 seen = (camera_from_world * world).xyz;
  place = seen;
  vec3 slopes = vec3(distorted(seen), seen.z);
  gl_ClipDistance[0] = world.z;  // the ground hides what lies below
  gl_Position = vec4(dot(clip_x, slopes), dot(clip_y, slopes), clip_z.x * seen.z + clip_z.y, seen.z);
}
)";

/// Inverse depth is even over a triangle without a lens alone. But any mean of its corners lies in its plane, whose
/// normal n is found from neighbouring pixels, and the pixel's ray (x, y, 1) meets that plane where
///   z n . ray = n . place.
inline constexpr const char* kLensFragmentShader = R"(#version 330 core
in float lamp;
in vec3 place;
flat in vec3 colour;
flat in uint label;
uniform float ambient;
uniform sampler2D rays;
uniform vec3 corner;          // of the viewport
layout(location = 0) out vec4 shown;
layout(location = 1) out uint shown_label;
layout(location = 2) out float depth;
void main() {
  float facing = gl_FrontFacing ? lamp : -lamp;
  shown = vec4(colour * (ambient + (1.0 - ambient) * max(0.0, facing)), 1.0);
  shown_label = label;
  vec3 ray = vec3(texelFetch(rays, ivec2(gl_FragCoord.xy - corner.xy), 0).xy, 1.0);
  vec3 n = cross(dFdx(place), dFdy(place));
  float change = dot(n, place - place.z * ray) / dot(n, ray);
  depth = place.z + (abs(change) < 0.25 * place.z ? change : 0.0);  // else the ray all but misses the plane
}
)";

/// Tiles of the picture, behind everything.
inline constexpr const char* kFieldVertexShader = R"(#version 330 core
layout(location = 0) in vec3 tile;
flat out float on_carpet;
void main() {
  gl_Position = vec4(tile.xy, 1.0, 1.0);
  on_carpet = tile.z;
}
)";

/// Ground without paint.
inline constexpr const char* kBareFragmentShader = R"(#version 330 core
flat in float on_carpet;
uniform sampler2D rays;
uniform vec3 corner;
uniform vec3 inverse_depth;  // of slopes and 1
uniform vec3 carpet, surroundings;
layout(location = 0) out vec4 shown;
layout(location = 1) out uint label;
layout(location = 2) out float depth;
void main() {
  vec2 slopes = texelFetch(rays, ivec2(gl_FragCoord.xy - corner.xy), 0).xy;
  shown = vec4(on_carpet > 0.5 ? carpet : surroundings, 1.0);
  label = 0u;
  depth = 1.0 / dot(inverse_depth, vec3(slopes, 1.0));
}
)";

/// Ground, paint and sky, by the formulas of cast_paint.h.
inline constexpr const char* kPaintFragmentShader = R"(#version 330 core
uniform sampler2D rays;
uniform vec3 corner;          // of the viewport
uniform mat4 world_from_camera;
uniform samplerBuffer marks;  // two texels a mark: middle, direction; half length, half width, radius of a ring
uniform usampler2D cells;     // where the marks near a place of the ground begin in `marks`, and how many
uniform vec4 grid;            // its low corner, cells a metre, footprint that its cells allow for
uniform int count;            // of all marks, which stand first in `marks`
uniform float w_far;
uniform vec3 half_carpet, carpet, surroundings, paint, sky;
uniform int line_label, sky_label;
layout(location = 0) out vec4 shown;
layout(location = 1) out uint label;
layout(location = 2) out float depth;
float share(float s, float half_size, vec2 change) {
  float inverse = inversesqrt(max(dot(change, change), 1e-30));
  return max(min(min(1.0, 2.0 * half_size * inverse), (half_size - abs(s)) * inverse + 0.5), 0.0);
}
float shareOfMark(int place, vec2 p, vec2 p_u, vec2 p_v) {
  vec4 at = texelFetch(marks, 2 * place), size = texelFetch(marks, 2 * place + 1);
  vec2 d = p - at.xy;
  if (size.z > 0.0) {
    float radius = max(length(d), 1e-9);
    vec2 m = d / radius;
    return share(radius - size.z, size.y, vec2(dot(m, p_u), dot(m, p_v)));
  }
  vec2 along = at.zw, across = vec2(-along.y, along.x);
  return share(dot(d, across), size.y, vec2(dot(p_u, across), dot(p_v, across))) *
         share(dot(d, along), size.x, vec2(dot(p_u, along), dot(p_v, along)));
}
void main() {
  vec2 slopes = texelFetch(rays, ivec2(gl_FragCoord.xy - corner.xy), 0).xy;
  vec3 ray = mat3(world_from_camera) * vec3(slopes, 1.0), eye = world_from_camera[3].xyz;
  float w = -ray.z / eye.z;
  vec2 p = eye.xy + ray.xy / max(w, 1e-9);
  vec2 p_u = dFdx(p), p_v = dFdy(p);
  bool ground = w > 0.0;
  label = ground ? 0u : uint(sky_label);
  depth = ground ? 1.0 / w : uintBitsToFloat(0x7f800000u);
  vec3 seen = ground ? surroundings : sky;
  if (w >= w_far) {
    float inside = share(p.x, half_carpet.x, vec2(p_u.x, p_v.x)) * share(p.y, half_carpet.y, vec2(p_u.y, p_v.y));
    seen = mix(seen, carpet, inside);
    uvec2 near = uvec2(0u, uint(count));
    if (max(dot(p_u, p_u), dot(p_v, p_v)) <= grid.w * grid.w) {
      ivec2 cell = ivec2(floor((p - grid.xy) * grid.z)), size = textureSize(cells, 0);
      near = all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, size)) ? texelFetch(cells, cell, 0).xy
                                                                                : uvec2(0u);
    }
    float painted = 0.0;
    for (uint i = 0u; i < near.y; ++i) painted += shareOfMark(int(near.x + i), p, p_u, p_v);
    seen = mix(seen, paint, min(painted, 1.0));
    if (line_label >= 0 && painted >= 0.5) label = uint(line_label);
  }
  shown = vec4(seen, 1.0);
}
)";

}  // namespace murosimf
