/** The stage's shaders. World units, right-handed, y up; light is linear until the last line. */

/** Rings in one row of their texture; three texels each. */
export const RINGS_A_ROW = 256;

/** Side of the pictures of shadows, and where time is short. */
export const SHADOW_SIZE = 512;
export const HASTY_SHADOW_SIZE = 256;

/** Vertices that one piece between two rings takes in the strip, with one doubled at either end to part the pieces. */
export const verticesAPiece = (sides: number): number => 2 * sides + 4;

/** Rings from a texture, expanded to a tube: one triangle strip, its vertices known by their number alone. */
export const TUBE_VERTEX = `#version 300 es
precision highp float;
uniform sampler2D rings;      // centre, radius | tangent, tone | normal, lean
uniform mat4 clipFromWorld;
uniform vec3 eye;
uniform float worldPerPixel;  // at distance 1 in perspective, everywhere when it is orthographic
uniform float perspective;
uniform float swell;          // makes up for the flat sides of a coarse tube
uniform int sides;
out vec3 world;
out vec3 normal;
out float tone;
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
  tone = r1.w;
  gl_Position = clipFromWorld * vec4(world, 1.0);
}`;

/** What a shadow is made of: that there is something, and how near to the wall it is, 0 to 1. Drawn with the larger kept. */
export const SHADOW_FRAGMENT = `#version 300 es
precision highp float;
in vec3 world;
uniform vec3 inward;
uniform float away;
out vec4 colour;
void main() { colour = vec4(1.0, clamp(1.0 - (dot(world, inward) + away) / (2.0 * away), 0.02, 1.0), 0.0, 1.0); }`;

/** A triangle over the whole picture. */
export const SOFTEN_VERTEX = `#version 300 es
precision highp float;
out vec2 uv;
void main() {
  uv = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}`;

/** The shadow with soft edges, softer the farther from the wall the wire hangs there. */
export const SOFTEN_FRAGMENT = `#version 300 es
precision highp float;
in vec2 uv;
uniform sampler2D caster;
out vec4 colour;
void main() {
  float dark = 0.0;
  // A much smaller copy says whether there is anything at all, and how near.
  vec2 around = textureLod(caster, uv, 4.0).rg;
  if (around.r > 0.0) {
    float near = around.g / around.r;
    float radius = mix(0.0105, 0.0022, smoothstep(0.15, 0.95, near));
    float level = max(0.4, log2(radius * float(textureSize(caster, 0).x)) - 1.2);
    for (int i = 0; i < 16; i++) {
      float angle = float(i) * 2.39996323;
      dark += textureLod(caster, uv + vec2(cos(angle), sin(angle)) * sqrt((float(i) + 0.5) / 16.0) * radius, level).r;
    }
    dark = smoothstep(0.0, 1.0, dark / 16.0) * mix(0.78, 0.9, near);
  }
  colour = vec4(dark, 0.0, 0.0, 1.0);
}`;

/** Metal or enamel under three soft lights: front, side, above. */
export const TUBE_FRAGMENT = `#version 300 es
precision highp float;
in vec3 world;
in vec3 normal;
in float tone;
uniform vec3 eye;
uniform vec3 ramp[5];
uniform vec3 sky;
uniform vec3 ground;
uniform float gloss;
out vec4 colour;

float softBox(vec3 d, vec3 towards, float size, float edge) {
  return smoothstep(1.0 - size - edge, 1.0 - size + edge, dot(d, normalize(towards)));
}

// What a ray that leaves the wire meets: a quiet room with three soft boxes.
vec3 room(vec3 d, float blur) {
  vec3 base = mix(ground, sky, smoothstep(-0.65, 0.75, d.y)) * 0.72;
  float boxes = 3.8 * softBox(d, vec3(0.25, 0.45, 1.0), 0.07, 0.04 + blur)
              + 2.4 * softBox(d, vec3(1.0, 0.4, 0.1), 0.06, 0.04 + blur)
              + 3.2 * softBox(d, vec3(-0.15, 1.0, 0.1), 0.08, 0.05 + blur);
  return base + vec3(1.0, 0.97, 0.92) * boxes;
}

void main() {
  vec3 n = normalize(normal);
  vec3 v = normalize(eye - world);
  float place = clamp(tone, 0.0, 1.0) * 3.999;
  int stop = int(place);
  vec3 base = mix(ramp[stop], ramp[stop + 1], place - float(stop));
  float facing = clamp(dot(n, v), 0.0, 1.0);
  float grazing = pow(1.0 - facing, 5.0);
  // Metal tints what it mirrors; enamel mirrors a little white and shows its own colour below.
  vec3 mirror = mix(vec3(0.045), base, smoothstep(0.3, 0.7, gloss));
  mirror += (1.0 - mirror) * (0.05 + 0.55 * grazing);
  vec3 mirrored = room(reflect(-v, n), mix(0.2, 0.07, gloss)) * mirror * mix(0.9, 0.72, gloss);
  vec3 own = room(n, 0.9) * base * mix(0.62, 0.16, gloss);
  // Rounder to the eye: the rim turns away from the light. And nearer the walls less of it arrives.
  float rim = mix(0.6, 1.0, smoothstep(0.0, 0.6, facing));
  float open = 0.74 + 0.26 * smoothstep(-1.1, 0.6, min(world.y, min(world.x, world.z) + 0.5));
  vec3 light = (mirrored + own) * rim * open;
  light = light / (1.0 + 0.2 * light);
  colour = vec4(pow(light, vec3(1.0 / 2.2)), 1.0);
}`;

/** A solid's surface, a little farther away than it is. */
export const BODY_VERTEX = `#version 300 es
precision highp float;
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 corner;
uniform mat4 clipFromWorld;
uniform vec3 eye;
uniform float behind;
out vec3 normal;
out vec3 towards;
void main() {
  towards = normalize(eye - position);
  normal = corner;
  gl_Position = clipFromWorld * vec4(position - towards * behind, 1.0);
}`;

/** Clay in the tone of the walls, darker where it turns away. */
export const BODY_FRAGMENT = `#version 300 es
precision highp float;
in vec3 normal;
in vec3 towards;
uniform vec3 lit;
uniform vec3 wall;
uniform vec3 shadow;
out vec4 colour;
void main() {
  vec3 v = normalize(towards);
  vec3 n = normalize(normal + vec3(0.0, 0.0, 1e-9));
  n = dot(n, v) < 0.0 ? -n : n;
  float above = 0.5 + 0.5 * dot(n, normalize(vec3(0.25, 0.8, 0.5)));
  float facing = smoothstep(0.0, 0.75, dot(n, v));
  vec3 clay = mix(mix(wall, shadow, 0.2), mix(lit, wall, 0.35), above * above);
  clay = mix(mix(clay, shadow, 0.22), clay, facing);
  colour = vec4(pow(clay, vec3(1.0 / 2.2)), 1.0);
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
uniform vec3 lit;
uniform vec3 shade;
uniform float shown;
uniform float brightness;
out vec4 colour;

void main() {
  vec2 uv = onWall / (2.0 * shadowExtent) + 0.5;
  vec2 inside = step(abs(uv - 0.5), vec2(0.5));
  float dark = texture(shadow, uv).r * inside.x * inside.y;
  // Light pools where its lamp points; where two walls meet it is a little darker; far out the wall becomes the page.
  float pool = exp(-1.1 * dot(onWall, onWall));
  vec3 depth = max(world + away, 0.0);
  vec3 corner = exp(-depth * 7.0) + 0.6 * exp(-depth * 1.7);
  float meeting = corner.x + corner.y + corner.z - max(corner.x, max(corner.y, corner.z));
  vec3 plain = mix(wall, lit, pool) * brightness * (1.0 - vec3(0.050, 0.054, 0.060) * meeting);
  vec2 square = onWall * onWall;
  float edge = 1.0 - smoothstep(1.0, 1.75, sqrt(sqrt(dot(square, square))));
  vec3 seen = mix(plain, mix(shade, plain * shade, 0.35), dark);
  // Less than a step of the screen's: the long gradients show no bands, and the room's end no line.
  float grain = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  colour = vec4(seen, 1.0) * edge * shown + grain / 255.0;
}`;
