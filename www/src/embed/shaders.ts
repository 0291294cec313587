/** The stage's shaders. World units, right-handed, y up; light is linear until the last line. */

/** Rings in one row of their texture; three texels each. */
export const RINGS_A_ROW = 256;

/** Vertices that one piece between two rings takes in the strip, with one doubled at either end to part the pieces. */
export const verticesAPiece = (sides: number): number => 2 * sides + 4;

/** Rings from a texture, expanded to a tube: one triangle strip, its vertices known by their number alone. */
export const TUBE_VERTEX = `#version 300 es
precision highp float;
uniform sampler2D rings;      // centre, radius | tangent, parameter | normal, lean
uniform mat4 clipFromWorld;
uniform vec3 eye;
uniform float worldPerPixel;  // at distance 1 in perspective, everywhere when it is orthographic
uniform float perspective;
uniform float swell;          // makes up for the flat sides of a coarse tube
uniform int sides;
out vec3 world;
out vec3 normal;
out float parameter;
void main() {
  int inPiece = gl_VertexID % (2 * sides + 4);
  int corner = clamp(inPiece - 1, 0, 2 * sides + 1);
  int ring = gl_VertexID / (2 * sides + 4) + (corner & 1);
  ivec2 texel = ivec2((ring % ${RINGS_A_ROW}) * 3, ring / ${RINGS_A_ROW});
  vec4 r0 = texelFetch(rings, texel, 0);
  vec4 r1 = texelFetch(rings, texel + ivec2(1, 0), 0);
  vec4 r2 = texelFetch(rings, texel + ivec2(2, 0), 0);
  float lean = r2.w;
  float upright = sqrt(max(0.0, 1.0 - lean * lean));
  float angle = float(corner >> 1) * 6.28318530718 / float(sides);
  vec3 outward = cos(angle) * r2.xyz + sin(angle) * cross(r1.xyz, r2.xyz);
  // Never thinner than what one pixel can show, so that hair lines do not crumble.
  float least = 0.55 * worldPerPixel * mix(1.0, distance(eye, r0.xyz), perspective);
  world = r0.xyz + outward * max(r0.w * swell, least * upright);
  normal = upright * outward + lean * r1.xyz;
  parameter = r1.w;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}`;

/** Flat white: what a shadow is made of. */
export const SHADOW_FRAGMENT = `#version 300 es
precision highp float;
out vec4 colour;
void main() { colour = vec4(1.0); }`;

/** Warm metal under three soft lights: front, side, above. */
export const TUBE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 world;
in vec3 normal;
in float parameter;
uniform vec3 eye;
uniform vec3 metal;
uniform vec3 sky;
uniform vec3 ground;
uniform float byParameter;
out vec4 colour;

float softLight(vec3 d, vec3 towards, float size, float edge) {
  return smoothstep(1.0 - size - edge, 1.0 - size + edge, dot(d, normalize(towards)));
}

// What a ray that leaves the wire meets: a bright room with three soft boxes.
vec3 room(vec3 d, float blur) {
  vec3 base = mix(ground, sky, smoothstep(-0.7, 0.7, d.y));
  float boxes = 2.6 * softLight(d, vec3(0.25, 0.45, 1.0), 0.10, 0.06 + blur)
              + 1.6 * softLight(d, vec3(1.0, 0.35, 0.1), 0.08, 0.06 + blur)
              + 2.2 * softLight(d, vec3(-0.1, 1.0, 0.15), 0.10, 0.08 + blur);
  return base + vec3(1.0, 0.97, 0.92) * boxes;
}

// Colour-blind-safe ramp (after viridis, a quadratic fit), for telling the wire's beginning from its end.
vec3 ramp(float t) {
  return vec3(0.28 - 0.55 * t + 1.22 * t * t, 0.01 + 1.32 * t - 0.45 * t * t, 0.33 + 0.95 * t - 1.15 * t * t);
}

void main() {
  vec3 n = normalize(normal);
  vec3 v = normalize(eye - world);
  vec3 base = mix(metal, ramp(parameter), byParameter);
  float facing = clamp(dot(n, v), 0.0, 1.0);
  vec3 fresnel = base + (1.0 - base) * pow(1.0 - facing, 5.0) * 0.7;
  vec3 mirrored = room(reflect(-v, n), 0.18);
  vec3 diffuse = room(n, 0.9) * base;
  // Nearer the floor and the walls less light arrives.
  float open = 0.72 + 0.28 * smoothstep(-1.1, 0.6, min(world.y, min(world.x, world.z) + 0.5));
  vec3 light = (0.62 * mirrored * fresnel + 0.36 * diffuse) * open;
  light = light / (1.0 + 0.22 * light);
  colour = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
}`;

/** One wall of the room: plain, a soft shadow on it, and gone where the room ends. */
export const WALL_VERTEX = `#version 300 es
precision highp float;
uniform mat4 clipFromWorld;
uniform mat3 axes;      // columns: the wall's right, up and inward normal
uniform float away;     // how far the wall is behind the centre
uniform float extent;   // half of its side
out vec2 onWall;
out vec3 world;
void main() {
  vec2 corner = vec2(float(gl_VertexID & 1), float(gl_VertexID >> 1)) * 2.0 - 1.0;
  onWall = corner * extent;
  world = axes * vec3(onWall, -away);
  gl_Position = clipFromWorld * vec4(world, 1.0);
}`;

export const WALL_FRAGMENT = `#version 300 es
precision highp float;
in vec2 onWall;
in vec3 world;
uniform sampler2D shadow;
uniform mat3 axes;
uniform float away;
uniform float shadowExtent;
uniform vec3 wall;
uniform vec3 shade;
uniform float shown;
uniform float brightness;
out vec4 colour;

float covered(vec2 uv, float level) {
  vec2 inside = step(abs(uv - 0.5), vec2(0.5));
  return textureLod(shadow, uv, level).r * inside.x * inside.y;
}

void main() {
  vec2 uv = onWall / (2.0 * shadowExtent) + 0.5;
  // A soft edge: blurred samples round the middle one, where a much smaller copy says that there is anything at all.
  float dark = 0.0;
  if (covered(uv, 4.0) > 0.0) {
    dark = covered(uv, 0.8) * 0.28;
    for (int i = 0; i < 8; i++) {
      float angle = float(i) * 0.785398;
      dark += covered(uv + vec2(cos(angle), sin(angle)) * (i % 2 == 0 ? 0.0034 : 0.0075), 1.2) * 0.09;
    }
  }
  // Where two walls meet it is a little darker; far out the wall dissolves into the page.
  vec3 depth = max(world + away, 0.0);
  vec3 corner = exp(-depth * 7.0) + 0.5 * exp(-depth * 1.8);
  float meeting = corner.x + corner.y + corner.z - max(corner.x, max(corner.y, corner.z));
  vec3 plain = wall * brightness * (1.0 - 0.045 * meeting);
  vec2 square = onWall * onWall;
  float edge = 1.0 - smoothstep(1.05, 1.8, sqrt(sqrt(dot(square, square))));
  colour = vec4(mix(plain, shade, clamp(dark, 0.0, 1.0) * 0.82), 1.0) * edge * shown;
}`;
