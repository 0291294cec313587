/** A solid that a wire covers: a matte body in the room's tone, which hides what of the wire is behind it. */

import { linear, Program } from "./gl";
import type { Look } from "./looks";
import type { Camera } from "./orbit";
import { BODY_FRAGMENT, BODY_VERTEX } from "./shaders";

/** Triangles, counter-clockwise from outside. */
export interface BodyShape {
  /** x, y, z for each corner, world units. */
  readonly positions: ArrayLike<number>;
  readonly indices: ArrayLike<number>;
}

/** How far behind its surface the body begins to hide, world units: a wire on it is half in it, and strays a little. */
const BEHIND = 0.05;

/** What lives of it on the graphics card. */
export class Body {
  private readonly program: Program;
  private readonly corners: WebGLVertexArrayObject;
  private readonly buffers: readonly WebGLBuffer[];
  private count = 0;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = new Program(gl, BODY_VERTEX, BODY_FRAGMENT);
    this.corners = gl.createVertexArray();
    this.buffers = [gl.createBuffer(), gl.createBuffer(), gl.createBuffer()];
  }

  load(shape: BodyShape | null): void {
    const { gl } = this;
    this.count = shape?.indices.length ?? 0;
    if (!shape || this.count === 0) return;
    const [positions, normals, indices] = this.buffers;
    gl.bindVertexArray(this.corners);
    [new Float32Array(shape.positions), normalsOf(shape)].forEach((numbers, place) => {
      gl.bindBuffer(gl.ARRAY_BUFFER, [positions!, normals!][place]!);
      gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, gl.FLOAT, false, 0, 0);
    });
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, indices!);
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, new Uint32Array(shape.indices), gl.STATIC_DRAW);
    gl.bindVertexArray(null);
  }

  /** `through`: the wire behind it is to be seen, so it is drawn below all of the wire. Wants the depth test. */
  paint({ clipFromWorld, eye }: Camera, look: Look, through: boolean): void {
    const { gl, program } = this;
    if (this.count === 0) return;
    program.use();
    gl.uniformMatrix4fv(program.at("clipFromWorld"), false, clipFromWorld);
    gl.uniform3fv(program.at("eye"), eye);
    gl.uniform1f(program.at("behind"), BEHIND);
    gl.uniform3fv(program.at("lit"), linear(look.lit));
    gl.uniform3fv(program.at("wall"), linear(look.wall));
    gl.uniform3fv(program.at("shadow"), linear(look.shadow));
    gl.bindVertexArray(this.corners);
    // Open meshes show their inside, too.
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_INT, 0);
    gl.bindVertexArray(null);
    if (through) gl.clear(gl.DEPTH_BUFFER_BIT);
  }
}

/** One a corner: the mean of its triangles', weighted by area. */
export function normalsOf({ positions, indices }: BodyShape): Float32Array<ArrayBuffer> {
  const normals = new Float32Array(positions.length);
  for (let at = 0; at + 2 < indices.length; at += 3) {
    const [a, b, c] = [3 * indices[at]!, 3 * indices[at + 1]!, 3 * indices[at + 2]!];
    const [ux, uy, uz] = [positions[b]! - positions[a]!, positions[b + 1]! - positions[a + 1]!, positions[b + 2]! - positions[a + 2]!];
    const [vx, vy, vz] = [positions[c]! - positions[a]!, positions[c + 1]! - positions[a + 1]!, positions[c + 2]! - positions[a + 2]!];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    for (const corner of [a, b, c]) {
      normals[corner]! += nx;
      normals[corner + 1]! += ny;
      normals[corner + 2]! += nz;
    }
  }
  return normals;
}

/** The box round it: its least and its most corner. */
export function boundsOf({ positions }: BodyShape): [[number, number, number], [number, number, number]] {
  const low: [number, number, number] = [Infinity, Infinity, Infinity];
  const high: [number, number, number] = [-Infinity, -Infinity, -Infinity];
  for (let at = 0; at < positions.length; at++) {
    const c = at % 3;
    low[c] = Math.min(low[c]!, positions[at]!);
    high[c] = Math.max(high[c]!, positions[at]!);
  }
  return [low, high];
}
