#pragma once

namespace devo_evo
{
// The programs that OpenGL runs for every corner and every pixel.

/// Bodies: light from the sky, light from a lamp, darker outlines.
constexpr const char* BODY_VERTEX_SHADER = R"(#version 330
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 color;
layout(location = 3) in vec3 edges;
uniform mat4 projection;
out vec3 shown_normal;
out vec3 shown_color;
out vec3 edge_distance;
out float height;
void main()
{
  shown_normal = normal;
  shown_color = color;
  edge_distance = edges;
  height = position.z;
  gl_Position = projection * vec4(position, 1.0);
})";

constexpr const char* BODY_FRAGMENT_SHADER = R"(#version 330
in vec3 shown_normal;
in vec3 shown_color;
in vec3 edge_distance;
in float height;
uniform vec3 to_light;
uniform vec3 to_eye;
uniform float body_size;
out vec4 result;
void main()
{
  vec3 n = normalize(shown_normal);
  float sky = 0.5 + 0.5 * n.z;
  float lamp = max(dot(n, to_light), 0.0);
  float gloss = pow(max(dot(n, normalize(to_light + to_eye)), 0.0), 40.0);
  float near_floor = clamp(height / (0.3 * body_size), 0.0, 1.0);
  vec3 paint = mix(shown_color, vec3(0.5), 0.10);
  vec3 lit = paint * (mix(0.46, 0.66, sky) * mix(0.8, 1.0, near_floor) + 0.46 * lamp) + 0.10 * gloss;
  vec3 pixels = edge_distance / max(fwidth(edge_distance), vec3(1e-6));
  float outline = 1.0 - smoothstep(0.5, 1.7, min(min(pixels.x, pixels.y), pixels.z));
  result = vec4(mix(lit, 0.30 * lit, 0.85 * outline), 1.0);
})";

/// Bodies as they lie in the way of the light: red, where the lamp is hidden; green, the closer the body to the floor.
constexpr const char* SHADOW_VERTEX_SHADER = R"(#version 330
layout(location = 0) in vec3 position;
uniform vec3 to_light;
uniform vec2 shadow_center;
uniform vec2 shadow_extent;
uniform bool from_above;
out float height;
void main()
{
  vec2 foot = from_above ? position.xy : position.xy - to_light.xy * (position.z / to_light.z);
  height = position.z;
  gl_Position = vec4((foot - shadow_center) / shadow_extent, 0.0, 1.0);
})";

constexpr const char* SHADOW_FRAGMENT_SHADER = R"(#version 330
in float height;
uniform bool from_above;
uniform float body_size;
out vec4 result;
void main()
{
  result = from_above ? vec4(0.0, exp(-max(height, 0.0) / (0.25 * body_size)), 0.0, 1.0) : vec4(1.0, 0.0, 0.0, 1.0);
})";

/// The floor: lines, shadows, and fading into the background.
constexpr const char* FLOOR_VERTEX_SHADER = R"(#version 330
layout(location = 0) in vec2 position;
uniform mat4 projection;
out vec2 place;
void main()
{
  place = position;
  gl_Position = projection * vec4(position, 0.0, 1.0);
})";

constexpr const char* FLOOR_FRAGMENT_SHADER = R"(#version 330
in vec2 place;
uniform vec3 floor_color;
uniform vec3 line_color;
uniform vec3 background;
uniform vec2 target;
uniform vec2 fade;
uniform float line_distance;
uniform vec2 line_origin;
uniform vec2 shadow_center;
uniform vec2 shadow_extent;
uniform sampler2D shadow;
out vec4 result;
void main()
{
  float away = distance(place, target);
  float visible = 1.0 - smoothstep(fade.x, fade.y, away);
  vec3 color = floor_color;
  if (line_distance > 0.0)
  {
    vec2 cell = (place - line_origin) / line_distance;
    vec2 width = max(fwidth(cell), vec2(1e-6));
    vec2 to_line = abs(fract(cell - 0.5) - 0.5) / width;
    vec2 thick = 1.0 - smoothstep(0.4, 1.4, to_line);
    float line = max(thick.x, thick.y) * (1.0 - smoothstep(0.15, 0.5, max(width.x, width.y)));
    color = mix(color, line_color, line);
  }
  vec2 in_shadow = (place - shadow_center) / shadow_extent;
  if (max(abs(in_shadow.x), abs(in_shadow.y)) < 1.0)
  {
    vec2 dark = texture(shadow, 0.5 + 0.5 * in_shadow).rg;
    color *= (1.0 - dark.r * vec3(0.40, 0.37, 0.32)) * (1.0 - 0.45 * dark.g);
  }
  result = vec4(mix(background, color, visible), 1.0);
})";

/// Lines on the floor.
constexpr const char* LINE_VERTEX_SHADER = R"(#version 330
layout(location = 0) in vec2 position;
layout(location = 1) in vec4 color;
layout(location = 2) in vec3 edges;
uniform mat4 projection;
out vec4 shown_color;
out vec3 edge_distance;
void main()
{
  shown_color = color;
  edge_distance = edges;
  gl_Position = projection * vec4(position, 0.0002, 1.0);
})";

constexpr const char* LINE_FRAGMENT_SHADER = R"(#version 330
in vec4 shown_color;
in vec3 edge_distance;
out vec4 result;
void main()
{
  vec3 pixels = edge_distance / max(fwidth(edge_distance), vec3(1e-6));
  float inside = clamp(min(min(pixels.x, pixels.y), pixels.z), 0.0, 1.0);
  result = vec4(shown_color.rgb, shown_color.a * inside);
})";
}  // namespace devo_evo
