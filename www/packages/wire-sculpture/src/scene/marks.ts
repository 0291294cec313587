/** Rings round places of the wire, as large wherever they are and never hidden. Loaded when there are any. */

import { Program, shown } from "./gl";
import type { Mat4, Vec3 } from "./matrix";

/** Across, in CSS pixels. */
const SIZE = 22;

const VERTEX = `#version 300 es
layout(location = 0) in vec3 place;
uniform mat4 clipFromWorld;
uniform float size;
void main() {
  gl_Position = clipFromWorld * vec4(place, 1.0);
  gl_PointSize = size;
}`;

const FRAGMENT = `#version 300 es
precision highp float;
uniform vec3 ring;
uniform vec3 halo;
uniform float size;
out vec4 colour;
void main() {
  float off = abs(length(gl_PointCoord - 0.5) - 0.38) * size;
  float line = size * 0.055;
  float alpha = 0.8 * clamp(2.0 * line - off + 0.5, 0.0, 1.0);
  float inked = clamp(line - off + 0.5, 0.0, 1.0);
  colour = mix(vec4(halo, 1.0) * alpha, vec4(ring, 1.0), inked);
}`;

export class Marks {
  private readonly program: Program;
  private readonly places: WebGLVertexArrayObject;
  private readonly buffer: WebGLBuffer;
  private count = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = new Program(gl, VERTEX, FRAGMENT);
    this.places = gl.createVertexArray();
    this.buffer = gl.createBuffer();
  }

  load(places: readonly Vec3[]): void {
    const { gl } = this;
    this.count = places.length;
    gl.bindVertexArray(this.places);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(places.flat()), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindVertexArray(null);
  }

  /** Over all that is drawn; `density` is the picture's pixels to one of CSS, `halo` the walls' colour. */
  paint(clipFromWorld: Mat4, density: number, ring: string, halo: string): void {
    const { gl, program } = this;
    if (this.count === 0) return;
    program.use();
    gl.uniformMatrix4fv(program.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform1f(program.at("size"), SIZE * density);
    gl.uniform3fv(program.at("ring"), shown(ring));
    gl.uniform3fv(program.at("halo"), shown(halo));
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.bindVertexArray(this.places);
    gl.drawArrays(gl.POINTS, 0, this.count);
    gl.bindVertexArray(null);
    gl.disable(gl.BLEND);
  }
}
